//! Result of the measurement of a pair: vectors, times and warnings.

use std::sync::Arc;

use serde::{Deserialize, Serialize};

use super::VelocityField;
use crate::{
    model::ModelChoice,
    particles::CAMERAS,
    reconstruction::{FrameLight, ModelFit},
};

/// Wall-clock seconds spent in each stage of one pair.
#[derive(Debug, Clone, Copy, Default, PartialEq, Serialize, Deserialize)]
pub struct StageSeconds {
    /// Raw images to views.
    pub decode_s: f64,
    /// Views to volumes.
    pub reconstruct_s: f64,
    /// Volumes to vectors.
    pub correlate_s: f64,
    /// Comparison of the bench with the images.
    pub judge_s: f64,
}

impl StageSeconds {
    /// Of all stages.
    pub fn total_s(&self) -> f64 {
        self.decode_s + self.reconstruct_s + self.correlate_s + self.judge_s
    }
}

/// The measurement made from one pair.
#[derive(Debug, Clone)]
pub struct PairResult {
    /// The vectors.
    pub field: VelocityField,
    /// Time of each stage.
    pub seconds: StageSeconds,
    /// Warnings: saturation, a dark camera, an empty volume.
    pub warnings: Vec<String>,
    /// The forward model, and the reason for its selection.
    pub model: Arc<ModelChoice>,
    /// How well the configured bench explains the images. Under a poor fit no vector is valid.
    /// Absent where vectors were made from volumes, without images.
    pub fit: Option<ModelFit>,
    /// The light of frames a and b on the configured grid, where it was asked for.
    pub light: Option<[FrameLight; 2]>,
    /// Particles in both frames, if they were placed in the images.
    pub particles: Option<Vec<MeasuredParticle>>,
}

/// A particle in the middle of the pair, from its images and the particles about it.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct MeasuredParticle {
    /// Its place, in mm.
    pub at_mm: [f64; 3],
    /// Standard uncertainty of the place, in voxels.
    pub place_uncertainty_vox: [f32; 3],
    /// From frame a to frame b, in voxels.
    pub displacement_vox: [f32; 3],
    /// Standard uncertainty of the displacement, in voxels.
    pub uncertainty_vox: [f32; 3],
    /// Its light in each camera, mean of both frames, in counts of an open pixel that gets all of it.
    pub light: [f32; CAMERAS],
    /// Whether its displacement in the images agrees with that of the neighbouring particles. If not, the images alone
    /// tell its motion.
    pub agrees: bool,
}
