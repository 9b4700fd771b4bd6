//! The entries of the journal, in the order in which the run loop saw the events.

use lfpiv_hw::{
    device::{Frame, FrameStatus, StreamStatistics},
    synchroniser::line::Direction,
    timing::PulseSchedule,
};
use serde::{Deserialize, Serialize};

use crate::acquisition::{BurstStart, Outcome};

/// Version of the entries; a reader refuses a later one. Version 2 added [`Entry::BurstStarted`],
/// version 3 [`Entry::Given`] and [`Outcome::NotFired`], version 4 [`Entry::BurstLost`],
/// [`Entry::SynchroniserLost`] and [`Entry::SynchroniserBack`], version 5 [`Entry::SwitchingOff`].
pub const JOURNAL_VERSION: u32 = 5;

/// The raw log's description, which a reader needs before the first entry.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Description {
    /// Version of the entries.
    pub journal_version: u32,
    /// Version of the program that wrote it.
    pub code_version: String,
    /// Number of cameras.
    pub cameras: usize,
    /// How long due frames were awaited, in ns.
    pub patience_ns: u64,
    /// The configuration used, in TOML.
    pub configuration: String,
}

/// One entry. Times `at_ns` are in ns since the run began.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(tag = "entry", rename_all = "snake_case")]
pub enum Entry {
    /// The unit was programmed with this schedule, and its trigger count restarts.
    Programmed { at_ns: u64, identity: String, schedule: PulseSchedule },
    /// A burst of triggers `first` to `first + shots - 1` begins.
    Fired { at_ns: u64, first: u64, shots: u64 },
    /// The unit has accepted the burst that begins with trigger `first`.
    BurstStarted { first: u64, start: BurstStart },
    /// The laser was switched off during a burst: shots that were incomplete may lack light.
    SwitchingOff { at_ns: u64 },
    /// The unit has stopped firing; `given` is the number of triggers since the run began.
    BurstEnded { at_ns: u64, given: u64 },
    /// The unit was lost during a burst; `given` is the number of triggers that count since the run
    /// began.
    BurstLost { at_ns: u64, given: u64 },
    /// The unit no longer answers.
    SynchroniserLost { at_ns: u64, reason: String },
    /// It answers again, and was read back as safe.
    SynchroniserBack { at_ns: u64, identity: String },
    /// A frame; its image, damaged or not, belongs to the same record.
    Frame {
        at_ns: u64,
        camera: usize,
        #[serde(flatten)]
        frame: FrameHead,
        statistics: StreamStatistics,
    },
    /// State of a camera's stream: lost, back, or ended.
    Stream { at_ns: u64, camera: usize, connected: bool, statistics: StreamStatistics },
    /// These frames were paired: frames a and b of each camera.
    Shot {
        trigger: u64,
        frames: Vec<[FrameKey; 2]>,
        residuals_ns: Vec<i64>,
        suspect: Vec<String>,
        dt_us: f64,
    },
    /// The trigger counts from now on: it was given, or was due and the synchroniser cannot be asked.
    Given { trigger: u64 },
    /// The outcome of a trigger for one camera, if acquisition decided it.
    Settled { trigger: u64, camera: usize, outcome: Outcome },
    /// The trigger was requested but not given.
    Withdrawn { trigger: u64 },
    /// Shed from the queue; it can be processed later.
    Shed { trigger: u64 },
    /// Bytes on the synchroniser's line; all but printable ASCII is escaped.
    Serial { host_time_ns: u64, direction: Direction, bytes: String },
    /// A note by the operator.
    Note { at_ns: u64, text: String },
    /// The run was told to stop.
    Stopping { at_ns: u64 },
    /// The run is over and every trigger is settled; `error` if it ended early.
    Ended { at_ns: u64, error: Option<String> },
}

impl Entry {
    /// Time in ns since the run began; `None` for entries without a time.
    pub fn at_ns(&self) -> Option<u64> {
        match self {
            Self::Programmed { at_ns, .. }
            | Self::Fired { at_ns, .. }
            | Self::SwitchingOff { at_ns }
            | Self::BurstEnded { at_ns, .. }
            | Self::BurstLost { at_ns, .. }
            | Self::SynchroniserLost { at_ns, .. }
            | Self::SynchroniserBack { at_ns, .. }
            | Self::Frame { at_ns, .. }
            | Self::Stream { at_ns, .. }
            | Self::Note { at_ns, .. }
            | Self::Stopping { at_ns }
            | Self::Ended { at_ns, .. } => Some(*at_ns),
            Self::BurstStarted { start, .. } => Some(start.not_before_ns),
            Self::Shot { .. }
            | Self::Given { .. }
            | Self::Settled { .. }
            | Self::Withdrawn { .. }
            | Self::Shed { .. }
            | Self::Serial { .. } => None,
        }
    }
}

/// A [`Frame`] without its image.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
pub struct FrameHead {
    /// See [`Frame::frame_id`].
    pub frame_id: u64,
    /// See [`Frame::device_timestamp_ns`].
    pub device_timestamp_ns: u64,
    /// See [`Frame::host_timestamp_ns`].
    pub host_timestamp_ns: u64,
    /// See [`Frame::status`].
    pub status: FrameStatus,
}

/// Identifies a frame of a camera: numbers alone repeat after a restart of the camera.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, Serialize, Deserialize)]
pub struct FrameKey {
    /// See [`Frame::frame_id`].
    pub frame_id: u64,
    /// See [`Frame::device_timestamp_ns`].
    pub device_timestamp_ns: u64,
}

impl From<&Frame> for FrameKey {
    fn from(frame: &Frame) -> Self {
        FrameHead::from(frame).key()
    }
}

impl FrameHead {
    /// Identifies this frame among the camera's frames.
    pub fn key(&self) -> FrameKey {
        FrameKey { frame_id: self.frame_id, device_timestamp_ns: self.device_timestamp_ns }
    }
}

impl From<&Frame> for FrameHead {
    fn from(frame: &Frame) -> Self {
        let Frame { frame_id, device_timestamp_ns, host_timestamp_ns, status, .. } = *frame;
        Self { frame_id, device_timestamp_ns, host_timestamp_ns, status }
    }
}
