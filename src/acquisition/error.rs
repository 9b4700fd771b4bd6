//! Why acquisition ended.

use lfpiv_hw::{CameraName, device::DeviceError};
use lfpiv_rawlog::RawLogError;
use thiserror::Error;

use std::sync::Arc;

use super::pairing::ExtraTriggers;

/// Why acquisition could not begin or go on. The synchroniser has been made safe by then, or the
/// error says that it has not.
#[derive(Debug, Error)]
pub enum AcquisitionError {
    /// A device failed.
    #[error(transparent)]
    Device(#[from] DeviceError),
    /// The synchroniser does not answer any more.
    #[error(transparent)]
    SynchroniserLost(DeviceError),
    /// It was looked for and did not come back.
    #[error("the synchroniser has not come back within {seconds:.0} s: {before}")]
    BenchGone { seconds: f64, before: Box<AcquisitionError> },
    /// The operating system gave no thread.
    #[error("{device}: no thread for it")]
    Thread { device: String, source: std::io::Error },
    /// A camera answers, but sends no frames.
    #[error(
        "{camera} sent no frame for the last {triggers} triggers: check its trigger cable \
         and the synchroniser's camera channel"
    )]
    Silent { camera: CameraName, triggers: u64 },
    /// The unit accepted a burst and gave none of it.
    #[error(
        "the synchroniser gave none of the {shots} triggers asked for: check its interlock and its \
         trigger mode"
    )]
    NoTriggers { shots: u64 },
    /// No camera thread is left.
    #[error("every camera has stopped; see the log for the reasons")]
    NoCamera,
    /// A burst runs on after its time.
    #[error("the burst of {shots} shots is still firing long after its time: use the interlock")]
    Endless { shots: u64 },
    /// Triggers from elsewhere.
    #[error(transparent)]
    ExtraTriggers(#[from] ExtraTriggers),
    /// The run's raw data can no longer be kept.
    #[error(transparent)]
    RawLog(#[from] Arc<RawLogError>),
    /// The disk takes no more, and says nothing about it.
    #[error(
        "the disk has taken nothing for {seconds} s and frames wait to be written: check the disk \
         that holds the results"
    )]
    DiskHangs { seconds: u64 },
    /// Nobody takes the shots.
    #[error("the worker pool no longer takes shots")]
    QueueClosed,
    /// The synchroniser does not confirm its safe state.
    #[error(
        "the laser may still fire: the synchroniser does not confirm that it is safe ({reason}). \
         Use the hardware interlock{}",
        before.as_ref().map_or(String::new(), |error| format!(". Before that: {error}"))
    )]
    NotSafe {
        /// What it answered instead.
        reason: String,
        /// It did not answer at all.
        is_lost: bool,
        /// What had ended the run before.
        before: Option<Box<AcquisitionError>>,
    },
}

impl AcquisitionError {
    /// Whether the synchroniser did not answer: it may come back.
    pub(super) fn is_loss(&self) -> bool {
        matches!(self, Self::SynchroniserLost(_) | Self::NotSafe { is_lost: true, .. })
    }
}
