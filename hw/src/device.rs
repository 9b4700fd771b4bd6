//! The contract between the daemon and its instruments.
//!
//! Calls block; the acquisition room gives every device a thread of its own. Drivers (Aravis,
//! serial) and the simulated bench implement the same two traits, and nothing above them knows
//! which one it drives.

use std::time::{Duration, Instant};

use serde::{Deserialize, Serialize};
use thiserror::Error;

use crate::{RawImage, timing::PulseSchedule};

/// A camera that delivers one frame for every exposure the synchroniser triggers.
///
/// In double-frame mode one trigger gives two frames, exposure 1 and then exposure 2.
pub trait Camera: Send {
    /// Name of this camera as configured, for messages.
    fn name(&self) -> &str;
    /// Allocates buffers and begins to wait for triggers.
    fn start(&mut self) -> Result<(), DeviceError>;
    /// The next frame, or `None` when none came within `timeout`. A driver that is looking for a
    /// camera that has vanished answers `None` and may take some seconds over it.
    fn next_frame(&mut self, timeout: Duration) -> Result<Option<Frame>, DeviceError>;
    /// Stops waiting for triggers. Idempotent.
    fn stop(&mut self) -> Result<(), DeviceError>;
    /// What the stream counted since `start`.
    fn statistics(&self) -> StreamStatistics;
    /// Whether the camera answers. While it does not, nothing should be fired.
    fn is_connected(&self) -> bool {
        true
    }
    /// How long it may take until [`Self::is_connected`] tells of a camera that has vanished.
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
}

/// The unit that times laser and cameras.
///
/// ```text
/// make_safe -> program -> arm, wait -> fire, fire, ... -> disarm
/// ```
///
/// Every burst is bounded, so that a host that dies or a line that is cut ends Q-switching by
/// itself; `fire` renews it.
pub trait Synchroniser: Send {
    /// The unit's identity string.
    fn identify(&mut self) -> Result<String, DeviceError>;
    /// Writes a validated schedule and compares its read-back; outputs stay off.
    fn program(&mut self, schedule: &PulseSchedule) -> Result<(), DeviceError>;
    /// Lets the lamps fire alone and returns how long it takes until `fire` is allowed: the rest
    /// of the lamps' warm-up, and with an external trigger the time in which its rate is counted.
    /// Does not wait. Call it before every burst: the lamps may have gone cold. Units without
    /// lamps to warm have nothing to do.
    fn arm(&mut self) -> Result<Duration, DeviceError> {
        Ok(Duration::ZERO)
    }
    /// Fires one bounded burst of `shots` periods. Returns once the unit has accepted it; refused
    /// while a burst is running.
    fn fire(&mut self, shots: u64) -> Result<(), DeviceError>;
    /// When the burst that was fired last had not begun yet: just before the command that starts
    /// it. `None` from a unit that does not say; then the call of `fire` is all that is known.
    fn started_after(&self) -> Option<Instant> {
        None
    }
    /// Shots given since `program`, counted by the unit; `None` from a unit that does not count.
    fn trigger_count(&mut self) -> Result<Option<u64>, DeviceError>;
    /// The unit's state, read from the unit and never remembered.
    fn state(&mut self) -> Result<SynchroniserState, DeviceError>;
    /// Looks after what has to be seen at any time: lamps that follow an external trigger fire as
    /// fast as it does. Whoever owns the unit calls this every [`WATCH_INTERVAL`] while nothing
    /// else is asked of it. Where the source is too fast the unit is made safe, read back, and
    /// this is an error. Does nothing, and sends nothing, where there is nothing to see.
    fn watch(&mut self) -> Result<(), DeviceError> {
        Ok(())
    }
    /// Q-switches off, then lamps off, then cameras off, verified by read-back. Idempotent.
    fn make_safe(&mut self) -> Result<(), DeviceError>;
    /// Ends firing and lets the lamps go cold; `program` comes before the next `arm`.
    fn disarm(&mut self) -> Result<(), DeviceError> {
        self.make_safe()
    }
    /// Whether timing and state are read from the unit. Where not, they rest on its
    /// acknowledgements, and whoever reports them has to say so.
    fn reads_back(&self) -> bool {
        true
    }
}

/// How often [`Synchroniser::watch`] is called.
pub const WATCH_INTERVAL: Duration = Duration::from_millis(500);

/// What the synchroniser is doing.
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
    /// The picture.
    pub image: RawImage,
    /// Frame number since `start`, unwrapped from the device's counter.
    pub frame_id: u64,
    /// The camera's own clock, in ns.
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
    /// Packets are missing; the missing pixels are zero. Where it is not known which are missing,
    /// all of them are.
    MissingPackets,
}

/// Counters of one camera's stream since its start.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq, Serialize, Deserialize)]
pub struct StreamStatistics {
    /// Frames delivered whole.
    pub completed: u64,
    /// Frames delivered damaged.
    pub failed: u64,
    /// Frames lost because no buffer was free.
    pub underruns: u64,
    /// Packets that were asked for again and came.
    pub resent: u64,
    /// Packets that never came.
    pub missing: u64,
    /// Times the camera vanished and came back.
    pub reconnects: u64,
}

/// Why a device could not do what it was asked.
#[derive(Debug, Error)]
pub enum DeviceError {
    /// The device no longer answers.
    #[error("{device}: connection lost: {detail}")]
    Lost { device: String, detail: String },
    /// The device answered, but refused.
    #[error("{device}: refused: {detail}")]
    Refused { device: String, detail: String },
    /// No such device answers.
    #[error("{device}: not found: {detail}")]
    NotFound { device: String, detail: String },
    /// Its driver has a fault; what the device does is not known.
    #[error("{device}: its driver panicked: {words}")]
    Panicked { device: String, words: String },
    /// This build has no driver for it.
    #[error("{device}: not in this build: {detail}")]
    NotBuilt { device: String, detail: String },
}
