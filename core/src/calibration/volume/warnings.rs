//! Warnings of a volume calibration.

use std::fmt;

use lfpiv_hw::CameraName;
use serde::Serialize;

/// Reasons to doubt a calibration.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub enum VolumeWarning {
    /// Held-out marks are far from their predicted places.
    HeldOutFar {
        /// Root-mean-square error of one coordinate, in microlenses.
        microlenses: f64,
        /// Largest value for a flat card on an accurate stage.
        usual: f64,
    },
    /// The card fits nearly as well when shifted by a spacing.
    Ambiguous {
        /// The camera.
        camera: CameraName,
    },
    /// The volume extends beyond the marks.
    BeyondMarks {
        /// Axis of the world: 0 for x.
        axis: usize,
        /// Distance beyond the marks, in mm.
        by_mm: f64,
    },
    /// A parameter is far from its nominal value.
    FarFromDrawing {
        /// The camera.
        camera: CameraName,
        /// Name of the parameter.
        parameter: &'static str,
        /// Distance in prior standard deviations.
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
