//! A second aperture, which cuts micro-images away from the stop's disc: mechanical vignetting.

use serde::{Deserialize, Serialize};

/// The image of an aperture in another plane than the stop's: a second disc on every micro-image. What
/// both discs cover is lit, the "cat's eye". It is displaced in proportion to the place in the field, because
/// lines from a microlens through both apertures' centres diverge by that.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct SecondAperture {
    /// Radius of its disc, in pixels.
    pub radius_px: f64,
    /// How far its disc lies outwards of the stop's at the sensor's corner, in pixels; negative: inwards.
    pub shift_at_corner_px: f64,
    /// Where it lies in the sensor's middle relative to the stop's disc, column and row, in pixels.
    pub offset_px: [f64; 2],
}

/// The field's middle and half diagonal, to which displacements refer.
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

    /// A place relative to the middle, as a share of the half diagonal.
    pub fn share(&self, place_px: [f64; 2]) -> [f64; 2] {
        [0, 1].map(|axis| (place_px[axis] - self.middle_px[axis]) / self.half_diagonal_px)
    }
}

impl SecondAperture {
    /// Centre of its disc for the lens whose stop's disc is centred at `stop_px`.
    pub(super) fn centre_px(&self, stop_px: [f64; 2], field: &Field) -> [f64; 2] {
        let share = field.share(stop_px);
        [0, 1].map(|axis| {
            stop_px[axis] + self.shift_at_corner_px * share[axis] + self.offset_px[axis]
        })
    }
}
