//! What goes into the worker pool and what comes out of it.

use lfpiv_hw::RawImage;
use serde::{Deserialize, Serialize};

use crate::velocimetry::VelocityField;

/// The four (or two) raw images of one shot.
#[derive(Debug, Clone)]
pub struct ImagePair {
    /// Frames a and b of each camera, in the order of the configuration's cameras.
    pub cameras: Vec<[RawImage; 2]>,
}

/// Wall-clock seconds spent in each stage of one pair.
#[derive(Debug, Clone, Copy, Default, PartialEq, Serialize, Deserialize)]
pub struct StageSeconds {
    /// Raw images to views.
    pub decode_s: f64,
    /// Views to volumes.
    pub reconstruct_s: f64,
    /// Volumes to vectors.
    pub correlate_s: f64,
}

/// The measurement made from one pair.
#[derive(Debug, Clone)]
pub struct PairResult {
    /// The vectors.
    pub field: VelocityField,
    /// Where the time went.
    pub seconds: StageSeconds,
    /// What the reader should know: saturation, a dark camera, an empty volume.
    pub warnings: Vec<String>,
}
