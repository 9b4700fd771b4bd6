//! Errors that end acquisition.

use lfpiv_hw::{CameraName, device::DeviceError};
use lfpiv_rawlog::RawLogError;
use thiserror::Error;

use std::sync::Arc;

use super::pairing::ExtraTriggers;

/// Why acquisition could not start or continue. The synchroniser has been made safe by then, or the
/// error says that it has not.
#[derive(Debug, Error)]
pub enum AcquisitionError {
    /// A device failed.
    #[error(transparent)]
    Device(#[from] DeviceError),
    /// The synchroniser does not answer any more.
    #[error(transparent)]
    SynchroniserLost(DeviceError),
    /// The search for it failed.
    #[error("the synchroniser did not come back within {seconds:.0} s: {before}")]
    NotReconnected { seconds: f64, before: Box<AcquisitionError> },
    /// A thread could not be started.
    #[error("{device}: cannot start its thread")]
    Thread { device: String, source: std::io::Error },
    /// A camera answers, but sends no frames.
    #[error(
        "{camera} sent no frame for the last {triggers} triggers: check its trigger cable \
         and the synchroniser's camera channel"
    )]
    Silent { camera: CameraName, triggers: u64 },
    /// The unit accepted a burst but gave no trigger.
    #[error(
        "the synchroniser gave none of the {shots} triggers asked for: check its interlock and its \
         trigger mode"
    )]
    NoTriggers { shots: u64 },
    /// No camera thread is left.
    #[error("every camera has stopped; see the log for the reasons")]
    NoCamera,
    /// A burst did not end in time.
    #[error("the burst of {shots} shots is still firing long after its time: use the interlock")]
    BurstOverrun { shots: u64 },
    /// Triggers from another source.
    #[error(transparent)]
    ExtraTriggers(#[from] ExtraTriggers),
    /// Raw data can no longer be recorded.
    #[error(transparent)]
    RawLog(#[from] Arc<RawLogError>),
    /// The disk does not write, and reports no error.
    #[error(
        "the disk has written nothing for {seconds} s while frames are waiting: check the disk \
         that holds the results"
    )]
    DiskHangs { seconds: u64 },
    /// The receiver of the shots is gone.
    #[error("the worker pool no longer takes shots")]
    QueueClosed,
    /// The synchroniser does not confirm its safe state.
    #[error(
        "the laser may still fire: the synchroniser does not confirm that it is safe ({reason}). \
         Use the hardware interlock{}",
        before.as_ref().map_or(String::new(), |error| format!(". Before that: {error}"))
    )]
    NotSafe {
        /// Its answer, or the reason why there is none.
        reason: String,
        /// It did not answer at all.
        is_lost: bool,
        /// The error that ended the run before.
        before: Option<Box<AcquisitionError>>,
    },
}

impl AcquisitionError {
    /// Whether the synchroniser did not answer and may come back.
    pub(super) fn is_loss(&self) -> bool {
        matches!(self, Self::SynchroniserLost(_) | Self::NotSafe { is_lost: true, .. })
    }
}
