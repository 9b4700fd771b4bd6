//! The instruments of a run, and how a lost synchroniser is opened again.

use std::time::Duration;

use lfpiv_hw::{
    device::{Camera, DeviceError, Synchroniser},
    synchroniser::line,
};
use tokio::sync::mpsc;

/// The instruments, opened and idle.
pub struct Bench {
    /// In the order of the configuration.
    pub cameras: Vec<Box<dyn Camera>>,
    /// Triggers the cameras.
    pub synchroniser: Box<dyn Synchroniser>,
    /// Bytes on the synchroniser's line, to be recorded.
    pub transcript: Option<mpsc::UnboundedReceiver<line::TranscriptEntry>>,
    /// How a lost synchroniser is reopened; without this a loss ends the run.
    pub reconnection: Option<Reconnection>,
}

impl Bench {
    /// A bench without transcript and reconnection.
    pub fn new(cameras: Vec<Box<dyn Camera>>, synchroniser: Box<dyn Synchroniser>) -> Self {
        Self { cameras, synchroniser, transcript: None, reconnection: None }
    }
}

/// Reopens a lost synchroniser; as at the first opening, disabling comes before anything else.
pub type Reopen = Box<dyn FnMut() -> Result<Box<dyn Synchroniser>, DeviceError> + Send>;

/// How a lost synchroniser is reopened.
pub struct Reconnection {
    /// Opens it.
    pub open: Reopen,
    /// How long to search; without limit when absent.
    pub patience: Option<Duration>,
    /// Whether an operator must permit firing again.
    pub waits_for_operator: bool,
}

/// The part of [`Reconnection`] that the run loop needs.
#[derive(Debug, Clone, Copy)]
pub(super) struct SearchPolicy {
    pub patience: Option<Duration>,
    pub waits_for_operator: bool,
}
