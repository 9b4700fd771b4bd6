//! Calibration of a camera.

use serde::{Deserialize, Serialize};

use super::VolumeMap;
use crate::lightfield::MicroImageGrid;

/// Deviations of one camera from its nominal geometry; `None`: nominal.
#[derive(Debug, Clone, Default, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields, default)]
pub struct CameraCalibration {
    /// Centres of the micro-images.
    pub grid: Option<MicroImageGrid>,
    /// Equivalent points of the nominal thin lens for the volume's points. `None`: they follow from the pose.
    pub map: Option<VolumeMap>,
}

impl CameraCalibration {
    /// Whether the camera is uncalibrated.
    pub fn is_nominal(&self) -> bool {
        self.grid.is_none() && self.map.is_none()
    }
}
