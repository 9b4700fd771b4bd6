//! Settings of injected faults, as a table or a file.
//!
//! ```toml
//! seed = 1
//!
//! [camera]
//! late_ms = 250
//! clock_drift_ppm = 100.0
//! clock_jumps = [{ frame = 140, jump_ns = 31_000_000 }]
//! only = ["cam2"]             # cam1 is left alone
//!
//! [camera.shares]             # of all frames
//! dropped = 0.02
//! late = 0.01
//!
//! [line.shares]               # of all commands
//! silent = 0.01
//! unavailable = 0.002         # ?8 at the wrong time
//! ```

use garde::Validate;
use lfpiv_hw::{CameraName, check::finite};
use serde::{Deserialize, Serialize};

use super::{FrameFault, LineFault};

/// Faults of all devices; none when absent.
#[derive(Debug, Clone, Default, PartialEq, Serialize, Deserialize, Validate)]
#[serde(deny_unknown_fields, default)]
pub struct FaultSettings {
    /// Seed: the same seed disturbs the same frames and commands in the same way, whatever their
    /// timing.
    #[garde(skip)]
    pub seed: u64,
    /// Faults of every camera; each has its own random stream.
    #[garde(dive)]
    pub camera: CameraFaults,
    /// Faults of the synchroniser's serial line.
    #[garde(dive)]
    pub line: LineFaults,
}

/// The `[camera]` table.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, Validate)]
#[serde(deny_unknown_fields, default)]
pub struct CameraFaults {
    /// Probabilities of frame faults.
    #[garde(custom(frames_at_most_one), dive)]
    pub shares: FrameShares,
    /// Delay of late frames, in ms.
    #[garde(range(max = 600_000))]
    pub late_ms: u64,
    /// Number of later frames that overtake a reordered one.
    #[garde(range(min = 1, max = 100))]
    pub reordered_by: u64,
    /// Number of flipped bits in a corrupted frame.
    #[garde(range(min = 1, max = 1_000_000))]
    pub corrupted_bits: u64,
    /// Rate error of the camera's clock, in parts per million; positive is fast.
    #[garde(custom(finite), range(min = -10_000.0, max = 10_000.0))]
    pub clock_drift_ppm: f64,
    /// Jumps of the camera's clock.
    #[garde(dive)]
    pub clock_jumps: Vec<ClockJump>,
    /// Only these cameras are affected; all of them when absent.
    #[garde(skip)]
    pub only: Option<Vec<CameraName>>,
    /// The connection is lost for good after this many frames.
    #[garde(skip)]
    pub disconnect_after: Option<u64>,
}

impl Default for CameraFaults {
    fn default() -> Self {
        Self {
            shares: FrameShares::default(),
            late_ms: 1000,
            reordered_by: 1,
            corrupted_bits: 16,
            clock_drift_ppm: 0.0,
            clock_jumps: Vec::new(),
            only: None,
            disconnect_after: None,
        }
    }
}

/// A jump of a camera's clock.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize, Validate)]
#[serde(deny_unknown_fields)]
pub struct ClockJump {
    /// Frame before which it jumps, counted from 0 over all frames of the camera.
    #[garde(skip)]
    pub frame: u64,
    /// Size, in ns; negative sets the clock back.
    #[garde(skip)]
    pub jump_ns: i64,
}

/// The `[camera.shares]` table: probability of each fault per frame. A frame has at most one fault,
/// so the sum is at most 1.
#[derive(Debug, Clone, Default, PartialEq, Serialize, Deserialize, Validate)]
#[serde(deny_unknown_fields, default)]
pub struct FrameShares {
    /// The frame is lost; its number is missing.
    #[garde(custom(share))]
    pub dropped: f64,
    /// The frame is delayed by `late_ms`.
    #[garde(custom(share))]
    pub late: f64,
    /// The frame is overtaken by later ones.
    #[garde(custom(share))]
    pub reordered: f64,
    /// The frame is delivered twice with the same number.
    #[garde(custom(share))]
    pub duplicated: f64,
    /// The lower rows are missing (zero), and the status says so.
    #[garde(custom(share))]
    pub truncated: f64,
    /// The lower rows are missing: the image is too small, and the status says complete.
    #[garde(custom(share))]
    pub cropped: f64,
    /// Bits are flipped, and the status says complete. A program cannot detect this, but must
    /// survive it.
    #[garde(custom(share))]
    pub corrupted: f64,
    /// Share of missed triggers: neither frame is delivered or counted by the camera, so later
    /// frame numbers are two lower.
    #[garde(custom(share))]
    pub missed_trigger: f64,
}

impl FrameShares {
    /// Every fault with its probability, in the order of the draw.
    pub(super) fn by_fault(&self) -> [(FrameFault, f64); 8] {
        [
            (FrameFault::MissedTrigger, self.missed_trigger),
            (FrameFault::Dropped, self.dropped),
            (FrameFault::Late, self.late),
            (FrameFault::Reordered, self.reordered),
            (FrameFault::Duplicated, self.duplicated),
            (FrameFault::Truncated, self.truncated),
            (FrameFault::Cropped, self.cropped),
            (FrameFault::Corrupted, self.corrupted),
        ]
    }
}

/// The `[line]` table.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, Validate)]
#[serde(deny_unknown_fields, default)]
pub struct LineFaults {
    /// Probabilities of command faults.
    #[garde(custom(commands_at_most_one), dive)]
    pub shares: CommandShares,
    /// Delay of slow replies, in ms.
    #[garde(range(max = 600_000))]
    pub slow_ms: u64,
    /// The line is cut for good after this many commands.
    #[garde(skip)]
    pub cut_after: Option<u64>,
}

impl Default for LineFaults {
    fn default() -> Self {
        Self { shares: CommandShares::default(), slow_ms: 1000, cut_after: None }
    }
}

/// The `[line.shares]` table: probability of each fault per command. A command has at most one
/// fault, so the sum is at most 1.
#[derive(Debug, Clone, Default, PartialEq, Serialize, Deserialize, Validate)]
#[serde(deny_unknown_fields, default)]
pub struct CommandShares {
    /// The command does not reach the unit.
    #[garde(custom(share))]
    pub lost: f64,
    /// The unit receives the command, and its reply is lost.
    #[garde(custom(share))]
    pub silent: f64,
    /// The reply is delayed by `slow_ms`.
    #[garde(custom(share))]
    pub slow: f64,
    /// Random bytes precede the reply.
    #[garde(custom(share))]
    pub stray: f64,
    /// One byte of the reply is changed.
    #[garde(custom(share))]
    pub garbled: f64,
    /// The unit ignores the command and answers `?8`: unavailable in its present state.
    #[garde(custom(share))]
    pub unavailable: f64,
}

impl CommandShares {
    /// Every fault with its probability, in the order of the draw.
    pub(super) fn by_fault(&self) -> [(LineFault, f64); 6] {
        [
            (LineFault::Lost, self.lost),
            (LineFault::Silent, self.silent),
            (LineFault::Slow, self.slow),
            (LineFault::Stray, self.stray),
            (LineFault::Garbled, self.garbled),
            (LineFault::Unavailable, self.unavailable),
        ]
    }
}

fn share(share: &f64, _: &()) -> garde::Result {
    match (0.0..=1.0).contains(share) {
        true => Ok(()),
        false => Err(garde::Error::new("allowed: 0 to 1")),
    }
}

fn frames_at_most_one(shares: &FrameShares, _: &()) -> garde::Result {
    at_most_one(&shares.by_fault())
}

fn commands_at_most_one(shares: &CommandShares, _: &()) -> garde::Result {
    at_most_one(&shares.by_fault())
}

fn at_most_one<F>(shares: &[(F, f64)]) -> garde::Result {
    let sum: f64 = shares.iter().map(|(_, share)| share).sum();
    // Ten shares of 0.1 sum to slightly more than 1.
    match sum <= 1.0 + 1e-9 {
        true => Ok(()),
        false => Err(garde::Error::new(format!("together {sum}; allowed: together at most 1"))),
    }
}
