//! The result of a shot: measurement, time, and durability of its images.

use lfpiv_core::{particles::CAMERAS, velocimetry::PairResult};
use serde::{Deserialize, Serialize};

use super::ShotTime;

/// Durability of the raw images of a result.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq, PartialOrd, Ord, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum RawLevel {
    /// Not recorded: imported images, or a run without a raw log.
    #[default]
    NotKept,
    /// Recording failed.
    Lost,
    /// In memory, waiting to be written.
    Acquired,
    /// Handed to the operating system: the images survive the end of this process.
    Written,
    /// On the disk: the images survive a power cut.
    Synced,
}

/// The measurement of one shot of a run.
#[derive(Debug, Clone)]
pub struct ShotResult {
    /// The vectors and their quality.
    pub measured: PairResult,
    /// Time of the trigger; `None` for images without a time.
    pub time: Option<ShotTime>,
    /// Durability of the raw images when the result was stored.
    pub raw: RawLevel,
}

impl ShotResult {
    /// Number of cameras that its particles have light of.
    pub fn cameras(&self) -> usize {
        self.measured.fit.as_ref().map_or(CAMERAS, |fit| fit.cameras.len().min(CAMERAS))
    }
}

/// For images that do not belong to a run.
impl From<PairResult> for ShotResult {
    fn from(measured: PairResult) -> Self {
        Self { measured, time: None, raw: RawLevel::NotKept }
    }
}
