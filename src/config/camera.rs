//! A `[[camera]]` table: a camera's pose and its calibration file.

use std::path::PathBuf;

use garde::Validate;
use lfpiv_hw::{
    Pose,
    pose::{completes, near_origin, unit_vector},
};
use nalgebra::Vector3;
use serde::{Deserialize, Serialize};

/// One camera; its axes are those of [`Pose`].
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, Validate)]
#[serde(deny_unknown_fields)]
pub struct CameraTable {
    /// Unit vector along increasing pixel column.
    #[garde(custom(unit_vector))]
    pub right: Vector3<f64>,
    /// Unit vector along decreasing pixel row.
    #[garde(custom(unit_vector))]
    pub up: Vector3<f64>,
    /// Unit vector from the volume to the camera.
    #[garde(custom(unit_vector), custom(completes(&self.right, &self.up, self.mirrored)))]
    pub axis: Vector3<f64>,
    /// World point in focus on the optical axis, in mm.
    #[serde(default = "Vector3::zeros")]
    #[garde(custom(near_origin))]
    pub origin_mm: Vector3<f64>,
    /// Whether the camera looks into a mirror: its images are mirrored, and `right`, `up`, `axis` are a
    /// left-handed triple.
    #[serde(default, skip_serializing_if = "std::ops::Not::not")]
    #[garde(skip)]
    pub mirrored: bool,
    /// Calibration file written by `lfpiv calibrate`, relative to the configuration's folder;
    /// without it the camera is taken as nominal.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    #[garde(skip)]
    pub calibration: Option<PathBuf>,
}

impl CameraTable {
    /// The camera's pose.
    pub fn pose(&self) -> Pose {
        let Self { right, up, axis, origin_mm, .. } = *self;
        Pose { right, up, axis, origin_mm }
    }
}

impl From<Pose> for CameraTable {
    fn from(Pose { right, up, axis, origin_mm }: Pose) -> Self {
        let mirrored = right.cross(&up).dot(&axis) < 0.0;
        Self { right, up, axis, origin_mm, mirrored, calibration: None }
    }
}
