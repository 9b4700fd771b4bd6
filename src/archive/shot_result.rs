//! What is kept of a shot: its measurement, its time, and how safe its images are.

use lfpiv_core::velocimetry::PairResult;
use serde::{Deserialize, Serialize};

use super::ShotTime;

/// How safe the raw images behind a result are.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq, PartialOrd, Ord, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum RawLevel {
    /// They are in no raw log: imported images, or a run without one.
    #[default]
    NotKept,
    /// They should have been kept, and could not be written.
    Lost,
    /// In memory, on their way to the disk.
    Acquired,
    /// With the operating system: they survive the end of this process.
    Written,
    /// On the disk: they survive a power cut.
    Synced,
}

/// A measurement as a shot of a run.
#[derive(Debug, Clone)]
pub struct ShotResult {
    /// What its images gave.
    pub measured: PairResult,
    /// When its trigger was given; absent for images that come without a time.
    pub time: Option<ShotTime>,
    /// How safe its raw images were when the result was stored.
    pub raw: RawLevel,
}

/// The measurement of images that belong to no run.
impl From<PairResult> for ShotResult {
    fn from(measured: PairResult) -> Self {
        Self { measured, time: None, raw: RawLevel::NotKept }
    }
}
