//! What a run says to its raw log, in the order in which the run loop saw it.

use lfpiv_hw::{
    device::{Frame, FrameStatus, StreamStatistics},
    synchroniser::line::Direction,
    timing::PulseSchedule,
};
use serde::{Deserialize, Serialize};

use crate::acquisition::{BurstStart, Outcome};

/// Version of the entries; a reader refuses a later one. Since version 2 there is
/// [`Entry::BurstStarted`], since version 3 [`Entry::Given`] and [`Outcome::NotFired`], since version 4
/// [`Entry::BurstLost`], [`Entry::SynchroniserLost`] and [`Entry::SynchroniserBack`].
pub const JOURNAL_VERSION: u32 = 4;

/// The raw log's description: what a reader must know before the first entry.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Description {
    /// Version of the entries.
    pub journal_version: u32,
    /// Version of the program that wrote it.
    pub code_version: String,
    /// Number of cameras.
    pub cameras: usize,
    /// How long a frame that is due was waited for, in ns.
    pub patience_ns: u64,
    /// The configuration, TOML as it was used.
    pub configuration: String,
}

/// One entry. Times `at_ns` are in ns since the run began.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(tag = "entry", rename_all = "snake_case")]
pub enum Entry {
    /// The unit took this schedule, and its count starts anew.
    Programmed { at_ns: u64, identity: String, schedule: PulseSchedule },
    /// A burst of triggers `first` to `first + shots - 1` begins.
    Fired { at_ns: u64, first: u64, shots: u64 },
    /// The unit has accepted the burst that begins with trigger `first`.
    BurstStarted { first: u64, start: BurstStart },
    /// The unit no longer fires; it has given so many triggers since the run began.
    BurstEnded { at_ns: u64, given: u64 },
    /// The unit is lost in a burst, and nothing more is seen of it: so many triggers count since the run
    /// began.
    BurstLost { at_ns: u64, given: u64 },
    /// The unit does not answer any more.
    SynchroniserLost { at_ns: u64, reason: String },
    /// It answers again, and was read back as safe.
    SynchroniserBack { at_ns: u64, identity: String },
    /// The image of this record, as it came, damaged or not.
    Frame {
        at_ns: u64,
        camera: usize,
        #[serde(flatten)]
        frame: FrameHead,
        statistics: StreamStatistics,
    },
    /// What a camera's stream says of itself: that it is away, back, or has ended.
    Stream { at_ns: u64, camera: usize, connected: bool, statistics: StreamStatistics },
    /// These frames are one shot: frames a and b of each camera.
    Shot {
        trigger: u64,
        frames: Vec<[FrameKey; 2]>,
        residuals_ns: Vec<i64>,
        suspect: Vec<String>,
        dt_us: f64,
    },
    /// The trigger counts from now on: it was given, or was due where nobody can be asked.
    Given { trigger: u64 },
    /// How a trigger ended for one camera, as far as acquisition decides it.
    Settled { trigger: u64, camera: usize, outcome: Outcome },
    /// The trigger was asked for and never given.
    Withdrawn { trigger: u64 },
    /// Shed from the queue: nothing is wrong with it, and it can be processed later.
    Shed { trigger: u64 },
    /// Bytes on the synchroniser's line; the text has all but printable ASCII escaped.
    Serial { host_time_ns: u64, direction: Direction, bytes: String },
    /// Words of whoever runs the bench.
    Note { at_ns: u64, text: String },
    /// The run was told to stop.
    Stopping { at_ns: u64 },
    /// The run is over and every trigger is ruled on; the reason where it ended before its time.
    Ended { at_ns: u64, error: Option<String> },
}

impl Entry {
    /// When it was, in ns since the run began; `None` for one that does not say.
    pub fn at_ns(&self) -> Option<u64> {
        match self {
            Self::Programmed { at_ns, .. }
            | Self::Fired { at_ns, .. }
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

/// Which of a camera's frames is meant: numbers alone repeat where a camera has restarted.
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
    /// What tells this frame from the camera's others.
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
