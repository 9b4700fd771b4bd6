//! What calibration found out about a camera.

use serde::{Deserialize, Serialize};

use super::VolumeMap;
use crate::lightfield::MicroImageGrid;

/// How one camera differs from the drawing; as drawn where it says nothing.
#[derive(Debug, Clone, Default, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields, default)]
pub struct CameraCalibration {
    /// Where the micro-images are centred.
    pub grid: Option<MicroImageGrid>,
    /// What an ideal thin lens would see in place of the volume's points; the pose says it
    /// otherwise.
    pub map: Option<VolumeMap>,
}

impl CameraCalibration {
    /// Whether nothing is known that the drawing does not say.
    pub fn is_nominal(&self) -> bool {
        self.grid.is_none() && self.map.is_none()
    }
}
