//! One image pair to one velocity field.

use lfpiv_hw::{Optics, Pose};
use thiserror::Error;

use crate::{
    lightfield::ImageSettings,
    model::VolumeGrid,
    pipeline::{ImagePair, PairResult},
    reconstruction::{DenseVolume, ReconstructionSettings},
    velocimetry::VelocimetrySettings,
};

/// Everything that turns image pairs into vectors.
#[derive(Debug, Clone, PartialEq)]
pub struct Measurement {
    /// The optics that all cameras share.
    pub optics: Optics,
    /// Where the cameras stand.
    pub cameras: Vec<Pose>,
    /// The measurement volume.
    pub volume: VolumeGrid,
    /// What is known about the images.
    pub image: ImageSettings,
    /// How volumes are reconstructed.
    pub reconstruction: ReconstructionSettings,
    /// How volumes are correlated.
    pub velocimetry: VelocimetrySettings,
    /// Time between the frames, in s.
    pub dt_s: f64,
}

/// Why a measurement cannot be set up.
#[derive(Debug, Error)]
pub enum SetupError {}

/// Why a pair gave no result.
#[derive(Debug, Error)]
pub enum ProcessError {
    /// The solver is not there yet.
    #[error("not ready")]
    NotReady,
}

/// Tables and plans that are made once and used for every pair. Shared between workers.
#[derive(Debug)]
pub struct Processor {
    measurement: Measurement,
}

impl Processor {
    /// Builds the tables.
    pub fn new(measurement: Measurement) -> Result<Self, SetupError> {
        Ok(Self { measurement })
    }

    /// What is measured and how.
    pub fn measurement(&self) -> &Measurement {
        &self.measurement
    }

    /// Measures one pair.
    pub fn process(&self, pair: &ImagePair) -> Result<PairResult, ProcessError> {
        self.process_with_volumes(pair).map(|(result, _)| result)
    }

    /// Measures one pair and hands out the volumes of frames a and b.
    pub fn process_with_volumes(
        &self,
        _pair: &ImagePair,
    ) -> Result<(PairResult, [DenseVolume; 2]), ProcessError> {
        Err(ProcessError::NotReady)
    }
}
