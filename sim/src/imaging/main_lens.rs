//! Main lens and aperture stop: maps rays of a point to the microlens plane.

use lfpiv_hw::{CameraPoint, Optics};

use super::flaws::{CameraFlaws, Distortion, SecondAperture};

/// The rays of one point, identified by their position on the stop.
pub(super) trait RayBundle {
    /// Position on the microlens plane of the ray through `stop_mm`, in mm.
    fn on_microlenses_mm(&self, stop_mm: [f64; 2]) -> [f64; 2];
}

/// A thin lens with a stop at a given distance.
#[derive(Debug, Clone)]
pub(super) struct MainLens {
    pub(super) object_distance_mm: f64,
    pub(super) focal_length_mm: f64,
    /// Distance from the lens to the microlens plane.
    pub(super) image_distance_mm: f64,
    /// Distance of the stop behind the lens.
    pub(super) stop_mm: f64,
    pub(super) stop_radius_mm: f64,
    distortion: Distortion,
    half_diagonal_mm: f64,
    second_aperture: Option<SecondAperture>,
}

impl MainLens {
    pub(super) fn new(optics: &Optics, flaws: &CameraFlaws) -> Self {
        let image_distance_mm = optics.image_distance_mm();
        let stop_mm = flaws.exit_pupil_mm;
        // For the point in focus on the axis, the marginal rays equal those of a stop in the lens.
        let nearer = (image_distance_mm - stop_mm) / image_distance_mm;
        let (columns, rows) = (optics.sensor.columns as f64, optics.sensor.rows as f64);
        Self {
            object_distance_mm: optics.object_distance_mm,
            focal_length_mm: optics.focal_length_mm,
            image_distance_mm,
            stop_mm,
            stop_radius_mm: optics.pupil_diameter_mm() / 2.0 * nearer / flaws.f_number_scale,
            distortion: flaws.distortion.clone(),
            half_diagonal_mm: columns.hypot(rows) * optics.pixel_pitch_mm() / 2.0,
            second_aperture: flaws.vignetting.clone(),
        }
    }

    /// Distance from the stop to the microlens plane.
    pub(super) fn stop_to_microlenses_mm(&self) -> f64 {
        self.image_distance_mm - self.stop_mm
    }

    /// The rays of a point in air; `None` for a point that is not in front of the lens.
    pub(super) fn bundle(&self, seen: CameraPoint) -> Option<ImagedPoint> {
        let object_distance_mm = self.object_distance_mm - seen.depth_mm;
        if object_distance_mm.is_nan() || object_distance_mm <= 0.0 {
            return None;
        }
        let inverse_conjugate = 1.0 / self.focal_length_mm - 1.0 / object_distance_mm;
        let towards_image =
            self.stop_to_microlenses_mm() / (1.0 - self.stop_mm * inverse_conjugate);
        let magnification = -towards_image / object_distance_mm;
        let chief_mm = [magnification * seen.xi_mm, magnification * seen.eta_mm];
        let displacement_mm = self.displacement_mm(chief_mm);
        Some(ImagedPoint {
            stop_factor: 1.0 - towards_image * inverse_conjugate,
            centre_mm: std::array::from_fn(|axis| chief_mm[axis] + displacement_mm[axis]),
        })
    }

    /// Displacement by distortion of the rays of a point on the microlens plane; `chief_mm` is the
    /// undistorted position of its chief ray.
    pub(super) fn displacement_mm(&self, chief_mm: [f64; 2]) -> [f64; 2] {
        let [x, y] = chief_mm.map(|place_mm| place_mm / self.half_diagonal_mm);
        let Distortion { radial, tangential: [p1, p2] } = self.distortion;
        let square = x * x + y * y;
        [
            radial * x * square + 2.0 * p1 * x * y + p2 * (square + 2.0 * x * x),
            radial * y * square + p1 * (square + 2.0 * y * y) + 2.0 * p2 * x * y,
        ]
        .map(|relative| relative * self.half_diagonal_mm)
    }

    /// Whether the second aperture transmits the ray through `stop_mm` and `plane_mm` on the
    /// microlens plane.
    #[inline]
    pub(super) fn lets_pass(&self, plane_mm: [f64; 2], stop_mm: [f64; 2]) -> bool {
        let Some(aperture) = &self.second_aperture else { return true };
        let [x, y] = std::array::from_fn(|axis| {
            let slope = (plane_mm[axis] - stop_mm[axis]) / self.stop_to_microlenses_mm();
            let on_lens_mm = plane_mm[axis] - slope * self.image_distance_mm;
            // In front of the lens the ray is not refracted yet.
            let bent = if aperture.behind_lens_mm < 0.0 { on_lens_mm } else { 0.0 };
            on_lens_mm + aperture.behind_lens_mm * (slope + bent / self.focal_length_mm)
        });
        x * x + y * y <= aperture.radius_mm * aperture.radius_mm
    }
}

/// The rays of a point that the lens images sharply: x = a u + b.
///
/// A point at distance s is imaged to s' with 1/s' = 1/F − 1/s and ξ' = −ξ s'/s. The ray through u
/// on a stop at distance d behind the lens meets the microlens plane at x = u + (ξ' − u) (s_i −
/// d)/(s' − d). With g = (s_i − d)/(1 − d/s') this gives a = 1 − g/s' and b = −ξ g/s, which also
/// hold for points inside the focal length. For d = 0 they are the formulas of docs/theory.md,
/// section 2. The displacement by distortion is part of b.
#[derive(Debug, Clone)]
pub(super) struct ImagedPoint {
    stop_factor: f64,
    centre_mm: [f64; 2],
}

impl RayBundle for ImagedPoint {
    #[inline]
    fn on_microlenses_mm(&self, stop_mm: [f64; 2]) -> [f64; 2] {
        std::array::from_fn(|axis| self.stop_factor * stop_mm[axis] + self.centre_mm[axis])
    }
}
