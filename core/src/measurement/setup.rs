//! What measures a pair: bench, volume and method.

use std::sync::Arc;

use lfpiv_hw::{Optics, Pose};
use thiserror::Error;

use crate::{
    lightfield::ImageSettings,
    model::{CameraCalibration, ModelError, ModelSettings, VolumeGrid, VolumeMask},
    reconstruction::ReconstructionSettings,
    velocimetry::VelocimetrySettings,
};

/// All settings of the measurement of image pairs.
#[derive(Debug, Clone, PartialEq)]
pub struct Measurement {
    /// The optics that all cameras share.
    pub optics: Optics,
    /// Where the cameras stand.
    pub cameras: Vec<Pose>,
    /// Calibrations of the cameras, in their order; cameras beyond its end are uncalibrated.
    pub calibrations: Vec<CameraCalibration>,
    /// The measurement volume.
    pub volume: VolumeGrid,
    /// The flow region of the volume; all of it if absent.
    ///
    /// The whole volume is reconstructed: light seen beside a body is real, and without voxels there it would
    /// be assigned to voxels in the flow. What is not flow is left out where displacements are found.
    pub mask: Option<Arc<VolumeMask>>,
    /// Settings of the images.
    pub image: ImageSettings,
    /// Which effects the forward model includes, or that it is to be chosen.
    pub model: ModelSettings,
    /// How volumes are reconstructed.
    pub reconstruction: ReconstructionSettings,
    /// How volumes are correlated.
    pub velocimetry: VelocimetrySettings,
    /// Spacing of the vectors, in mm; that of the windows if absent.
    pub spacing_mm: Option<f64>,
    /// Time between the frames, in s.
    pub dt_s: f64,
}

impl Measurement {
    /// Whether no camera is calibrated: only then does a comparison with nominal positions assess the
    /// bench.
    pub fn is_nominal(&self) -> bool {
        self.calibrations.iter().all(CameraCalibration::is_nominal)
    }
}

/// Why a measurement cannot be set up.
#[derive(Debug, Error)]
pub enum SetupError {
    /// The optics cannot see the volume.
    #[error(transparent)]
    Model(#[from] ModelError),
}
