//! Mechanical vignetting: a second aperture that cuts the stop's disc in micro-images.

use serde::{Deserialize, Serialize};

/// Image of an aperture that is not in the plane of the stop: a second disc in every micro-image. The intersection
/// of both discs is lit ("cat's eye"). The displacement of the second disc is proportional to the position in the
/// field, because lines from a microlens through the centres of both apertures diverge accordingly.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct SecondAperture {
    /// Radius of its disc, in pixels.
    pub radius_px: f64,
    /// Outward displacement of its disc from the stop's disc at the sensor's corner, in pixels; negative: inward.
    pub shift_at_corner_px: f64,
    /// Displacement of its disc from the stop's disc in the sensor's middle, column and row, in pixels.
    pub offset_px: [f64; 2],
}

/// Middle and half diagonal of the sensor, in pixels.
#[derive(Debug, Clone, Copy)]
pub(super) struct Field {
    pub middle_px: [f64; 2],
    pub half_diagonal_px: f64,
}

impl Field {
    pub fn of(columns: usize, rows: usize) -> Self {
        let size = [columns, rows].map(|pixels| pixels as f64);
        Self {
            middle_px: size.map(|pixels| (pixels - 1.0) / 2.0),
            half_diagonal_px: size[0].hypot(size[1]) / 2.0,
        }
    }

    /// Position relative to the middle, as a share of the half diagonal.
    pub fn share(&self, place_px: [f64; 2]) -> [f64; 2] {
        [0, 1].map(|axis| (place_px[axis] - self.middle_px[axis]) / self.half_diagonal_px)
    }
}

impl SecondAperture {
    /// Centre of its disc in the micro-image with the stop's disc at `stop_px`, in pixels.
    pub(super) fn centre_px(&self, stop_px: [f64; 2], field: &Field) -> [f64; 2] {
        let share = field.share(stop_px);
        [0, 1].map(|axis| {
            stop_px[axis] + self.shift_at_corner_px * share[axis] + self.offset_px[axis]
        })
    }
}
