//! What a calibration of the volume cannot vouch for.

use std::fmt;

use lfpiv_hw::CameraName;
use serde::Serialize;

/// Doubt about a calibration that was made.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub enum VolumeWarning {
    /// Held-out marks are far from where they should be.
    HeldOutFar {
        /// Root mean square of one coordinate, in microlenses.
        microlenses: f64,
        /// What a good card on a good stage stays below.
        usual: f64,
    },
    /// The card fits nearly as well a spacing away.
    Ambiguous {
        /// Which camera.
        camera: CameraName,
    },
    /// The volume reaches beyond where marks were seen.
    BeyondMarks {
        /// Along which axis of the world: 0 for x.
        axis: usize,
        /// By how much, in mm.
        by_mm: f64,
    },
    /// A parameter is far from what was expected of it.
    FarFromDrawing {
        /// Which camera.
        camera: CameraName,
        /// Which parameter.
        parameter: &'static str,
        /// In prior standard deviations.
        deviations: f64,
    },
}

impl fmt::Display for VolumeWarning {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::HeldOutFar { microlenses, usual } => write!(
                f,
                "marks of positions left out of the fit are {microlenses:.3} microlenses rms beside their \
                 places, more than the {usual} of a flat card on a good stage: check flatness, the stage's \
                 steps, and whether the card stands in the fluid; --stage-uncertainty-um takes an \
                 uncertain stage into account"
            ),
            Self::Ambiguous { camera } => write!(
                f,
                "{camera} fits the card nearly as well a spacing away: its fiducial is hardly seen, and all of \
                 the calibration may be off by that"
            ),
            Self::BeyondMarks { axis, by_mm } => write!(
                f,
                "the volume reaches {by_mm:.1} mm farther along {} than marks were seen: there the map \
                 continues by the model alone",
                ["x", "y", "z"].get(*axis).unwrap_or(&"an axis")
            ),
            Self::FarFromDrawing { camera, parameter, deviations } => write!(
                f,
                "{camera}: {parameter} is {deviations:.1} prior standard deviations from the drawing: \
                 compare the configuration with the bench"
            ),
        }
    }
}
