//! Main lens and aperture stop: where the rays of a point meet the microlens plane.

use lfpiv_hw::{CameraPoint, Optics};

use super::flaws::{CameraFlaws, Distortion, SecondAperture};

/// The rays of one point, told apart by where they pass the stop.
pub(super) trait RayBundle {
    /// Where the ray through `stop_mm` meets the microlens plane, in mm.
    fn on_microlenses_mm(&self, stop_mm: [f64; 2]) -> [f64; 2];
}

/// A thin lens with a stop in its plane or beside it.
#[derive(Debug, Clone)]
pub(super) struct MainLens {
    pub(super) object_distance_mm: f64,
    pub(super) focal_length_mm: f64,
    /// From the lens to the microlens plane.
    pub(super) image_distance_mm: f64,
    /// How far the stop stands behind the lens.
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
        // The marginal rays of the point in focus on the axis are those of a stop in the lens.
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

    /// From the stop to the microlens plane.
    pub(super) fn stop_to_microlenses_mm(&self) -> f64 {
        self.image_distance_mm - self.stop_mm
    }

    /// The rays of a point in air, or `None` for a point not in front of the lens.
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

    /// How far distortion moves the rays of a point on the microlens plane, from where its chief
    /// ray would meet it.
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

    /// Whether the second aperture lets the ray pass that goes through `stop_mm` and meets the
    /// microlens plane at `plane_mm`.
    #[inline]
    pub(super) fn lets_pass(&self, plane_mm: [f64; 2], stop_mm: [f64; 2]) -> bool {
        let Some(aperture) = &self.second_aperture else { return true };
        let [x, y] = std::array::from_fn(|axis| {
            let slope = (plane_mm[axis] - stop_mm[axis]) / self.stop_to_microlenses_mm();
            let on_lens_mm = plane_mm[axis] - slope * self.image_distance_mm;
            // In front of the lens the ray has not been bent yet.
            let bent = if aperture.behind_lens_mm < 0.0 { on_lens_mm } else { 0.0 };
            on_lens_mm + aperture.behind_lens_mm * (slope + bent / self.focal_length_mm)
        });
        x * x + y * y <= aperture.radius_mm * aperture.radius_mm
    }
}

/// The rays of a point that the lens images sharply: x = a u + b.
///
/// A point at distance s is imaged to s' with 1/s' = 1/F − 1/s and ξ' = −ξ s'/s. Its ray through u
/// on a stop that stands d behind the lens meets the microlens plane at
/// x = u + (ξ' − u) (s_i − d)/(s' − d). With g = (s_i − d)/(1 − d/s') this is a = 1 − g/s' and
/// b = −ξ g/s, which hold for points inside the focal length, too; without d, they are the formulas
/// of docs/theory.md, section 2. The displacement by distortion is part of b.
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
