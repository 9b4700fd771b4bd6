//! The traits that drivers implement.
//!
//! Calls block; acquisition runs every device on a thread of its own. Drivers (Aravis, serial) and the
//! simulated bench implement the same two traits, so that the rest of the program does not know which
//! one it uses.

use std::time::{Duration, Instant};

use serde::{Deserialize, Serialize};
use thiserror::Error;

use crate::{RawImage, timing::PulseSchedule};

/// A camera that delivers one frame per triggered exposure.
///
/// In double-frame mode one trigger gives two frames, exposure 1 and then exposure 2.
pub trait Camera: Send {
    /// Configured name of this camera, for messages.
    fn name(&self) -> &str;
    /// Allocates buffers and waits for triggers.
    fn start(&mut self) -> Result<(), DeviceError>;
    /// The next frame, or `None` on timeout. While a driver searches for a lost camera it returns
    /// `None`, possibly some seconds late.
    fn next_frame(&mut self, timeout: Duration) -> Result<Option<Frame>, DeviceError>;
    /// Stops waiting for triggers. Idempotent.
    fn stop(&mut self) -> Result<(), DeviceError>;
    /// The stream's counters since `start`.
    fn statistics(&self) -> StreamStatistics;
    /// Whether the camera is connected. While it is not, nothing should be fired.
    fn is_connected(&self) -> bool {
        true
    }
    /// Longest time until [`Self::is_connected`] reports a lost camera.
    fn loss_detection_time(&self) -> Duration {
        Duration::ZERO
    }
}

impl<C: Camera + ?Sized> Camera for Box<C> {
    fn name(&self) -> &str {
        (**self).name()
    }

    fn start(&mut self) -> Result<(), DeviceError> {
        (**self).start()
    }

    fn next_frame(&mut self, timeout: Duration) -> Result<Option<Frame>, DeviceError> {
        (**self).next_frame(timeout)
    }

    fn stop(&mut self) -> Result<(), DeviceError> {
        (**self).stop()
    }

    fn statistics(&self) -> StreamStatistics {
        (**self).statistics()
    }

    fn is_connected(&self) -> bool {
        (**self).is_connected()
    }

    fn loss_detection_time(&self) -> Duration {
        (**self).loss_detection_time()
    }
}

/// The unit that times laser and cameras.
///
/// ```text
/// make_safe -> program -> arm, wait -> fire, fire, ... -> disarm
/// ```
///
/// Every burst is bounded, so that Q-switching ends by itself if the host dies or the line is cut.
/// `fire` starts the next one.
pub trait Synchroniser: Send {
    /// The unit's identity string.
    fn identify(&mut self) -> Result<String, DeviceError>;
    /// Writes a validated schedule and compares the read-back; outputs stay off.
    fn program(&mut self, schedule: &PulseSchedule) -> Result<(), DeviceError>;
    /// Lets only the lamps fire, and returns the time until `fire` is allowed: the rest of the lamps'
    /// warm-up and, with an external trigger, of the measurement of its rate. Does not wait. Call it
    /// before every burst, because the lamps may have cooled down. Units without warm-up do nothing.
    fn arm(&mut self) -> Result<Duration, DeviceError> {
        Ok(Duration::ZERO)
    }
    /// Fires one bounded burst of `shots` periods. Returns once the unit has accepted it; an error
    /// while a burst is running.
    fn fire(&mut self, shots: u64) -> Result<(), DeviceError>;
    /// A moment before the last burst began: just before the command that started it. `None` if the
    /// unit does not provide it; then the call of `fire` is the bound.
    fn started_after(&self) -> Option<Instant> {
        None
    }
    /// Shots since `program`, counted by the unit; `None` if the unit has no counter.
    fn trigger_count(&mut self) -> Result<Option<u64>, DeviceError>;
    /// The unit's state, always read from the unit.
    fn state(&mut self) -> Result<SynchroniserState, DeviceError>;
    /// Periodic supervision. With an external trigger, the lamps fire at its rate, so the rate must
    /// be monitored. The owner of the unit calls this every [`WATCH_INTERVAL`] while it makes no
    /// other call. If the source is too fast, the unit is made safe and read back, and this returns
    /// an error. Sends nothing if there is nothing to monitor.
    fn watch(&mut self) -> Result<(), DeviceError> {
        Ok(())
    }
    /// Q-switches off, then lamps off, then cameras off, verified by read-back. Idempotent.
    fn make_safe(&mut self) -> Result<(), DeviceError>;
    /// Stops firing and lets the lamps cool down; `program` must precede the next `arm`.
    fn disarm(&mut self) -> Result<(), DeviceError> {
        self.make_safe()
    }
    /// Whether timing and state are read from the unit. Otherwise they rest on its
    /// acknowledgements, and reports must say so.
    fn reads_back(&self) -> bool {
        true
    }
}

/// How often [`Synchroniser::watch`] is called.
pub const WATCH_INTERVAL: Duration = Duration::from_millis(500);

/// State of the synchroniser.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum SynchroniserState {
    /// All outputs off.
    Safe,
    /// Programmed, not firing.
    Armed,
    /// A burst is running.
    Firing,
    /// The line does not answer; use the hardware interlock.
    Unknown,
}

/// One exposure as delivered.
#[derive(Debug, Clone)]
pub struct Frame {
    /// The image.
    pub image: RawImage,
    /// Frame number since `start`, unwrapped from the device's counter.
    pub frame_id: u64,
    /// The camera's clock, in ns.
    pub device_timestamp_ns: u64,
    /// Host clock at reception, in ns since the Unix epoch.
    pub host_timestamp_ns: u64,
    /// Whether every byte arrived.
    pub status: FrameStatus,
}

/// Completeness of a frame.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum FrameStatus {
    /// Every byte arrived.
    Complete,
    /// Packets are missing and their pixels are zero. If it is unknown which are missing, all are zero.
    MissingPackets,
}

/// Counters of one camera's stream since its start.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq, Serialize, Deserialize)]
pub struct StreamStatistics {
    /// Intact frames.
    pub completed: u64,
    /// Damaged frames.
    pub failed: u64,
    /// Frames lost because no buffer was free.
    pub underruns: u64,
    /// Packets received after a resend request.
    pub resent: u64,
    /// Packets never received.
    pub missing: u64,
    /// Reconnections of a lost camera.
    pub reconnects: u64,
}

/// Errors of a device.
#[derive(Debug, Error)]
pub enum DeviceError {
    /// The device no longer answers.
    #[error("{device}: connection lost: {detail}")]
    Lost { device: String, detail: String },
    /// The device rejected the command.
    #[error("{device}: refused: {detail}")]
    Refused { device: String, detail: String },
    /// The device was not found.
    #[error("{device}: not found: {detail}")]
    NotFound { device: String, detail: String },
    /// Its driver panicked; the state of the device is unknown.
    #[error("{device}: its driver panicked: {message}")]
    Panicked { device: String, message: String },
    /// This build lacks its driver.
    #[error("{device}: not in this build: {detail}")]
    NotBuilt { device: String, detail: String },
}
