//! The parameters of a camera and their priors.

use serde::Serialize;

/// Number of parameters of one camera.
pub const PARAMETERS: usize = 17;

/// Name, unit and prior standard deviation of each parameter; the prior mean is zero, the nominal
/// camera. Focal lengths are not included: images hardly distinguish them from focus and magnification
/// (docs/calibration.md).
pub(super) const DESCRIPTIONS: [(&str, &str, f64); PARAMETERS] = [
    ("shift along right", "mm", 3.0),
    ("shift along up", "mm", 3.0),
    ("shift along the axis", "mm", 3.0),
    ("turn about right", "rad", 0.03),
    ("turn about up", "rad", 0.03),
    ("turn about the axis", "rad", 0.03),
    ("magnification", "relative", 0.02),
    ("parallax slope", "relative", 0.05),
    ("focus: image distance", "relative", 0.01),
    ("principal point along right", "mm", 0.3),
    ("principal point along up", "mm", 0.3),
    ("radial distortion", "at the half diagonal", 0.02),
    ("tangential distortion p1", "at the half diagonal", 0.005),
    ("tangential distortion p2", "at the half diagonal", 0.005),
    ("exit pupil behind the lens", "mm", 50.0),
    ("wall tilt about right", "rad", 0.15),
    ("wall tilt about up", "rad", 0.15),
];

/// Deviations of a camera from its nominal values, in the units of [`DESCRIPTIONS`].
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub(super) struct CameraParameters(pub(super) [f64; PARAMETERS]);

impl CameraParameters {
    pub(super) fn shift_mm(&self) -> [f64; 3] {
        [self.0[0], self.0[1], self.0[2]]
    }

    pub(super) fn turn_rad(&self) -> [f64; 3] {
        [self.0[3], self.0[4], self.0[5]]
    }

    pub(super) fn magnification(&self) -> f64 {
        1.0 + self.0[6]
    }

    pub(super) fn parallax_slope(&self) -> f64 {
        1.0 + self.0[7]
    }

    pub(super) fn image_distance(&self) -> f64 {
        1.0 + self.0[8]
    }

    pub(super) fn principal_point_mm(&self) -> [f64; 2] {
        [self.0[9], self.0[10]]
    }

    /// k, p₁, p₂.
    pub(super) fn distortion(&self) -> [f64; 3] {
        [self.0[11], self.0[12], self.0[13]]
    }

    pub(super) fn exit_pupil_mm(&self) -> f64 {
        self.0[14]
    }

    pub(super) fn wall_tilt_rad(&self) -> [f64; 2] {
        [self.0[15], self.0[16]]
    }
}

/// Estimate of a parameter.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct ParameterEstimate {
    /// Name of the parameter.
    pub name: &'static str,
    /// Its unit.
    pub unit: &'static str,
    /// Deviation from the nominal value.
    pub value: f64,
    /// Posterior standard deviation.
    pub standard_deviation: f64,
    /// Prior standard deviation.
    pub prior_standard_deviation: f64,
}
