//! Settings of acquisition.

use std::{num::NonZeroU64, sync::Arc, time::Duration};

use lfpiv_hw::{synchroniser::LONGEST_BURST_S, timing::PulseSchedule};
use serde::{Deserialize, Serialize};

use super::BurstStart;

/// What happens when shots arrive faster than they are processed.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum OverloadPolicy {
    /// A shot that finds the queue full is shed, and this is recorded. A real bench cannot wait.
    Shed,
    /// Triggers are given only as the queue has space: for bounded simulated runs in which every shot
    /// counts.
    Wait,
}

/// What a run does when its synchroniser no longer answers.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum AfterBenchLoss {
    /// It searches for the unit, makes it safe, programs it, and waits until an operator permits
    /// firing.
    #[default]
    WaitForArm,
    /// The same, without an operator: the laser fires again by itself.
    GoOn,
    /// It ends.
    End,
}

/// How shots are taken.
#[derive(Debug, Clone)]
pub struct AcquisitionSettings {
    /// The pulse schedule, validated.
    pub schedule: PulseSchedule,
    /// Triggers to give; unbounded when absent.
    pub shots: Option<NonZeroU64>,
    /// What happens when the queue is full.
    pub overload: OverloadPolicy,
    /// How long a due frame is awaited.
    pub patience: Duration,
    /// Memory of one frame. Before a burst is fired, the disk must have space for all of its frames.
    pub frame_bytes: u64,
}

impl AcquisitionSettings {
    /// Time between triggers.
    pub fn period(&self) -> Duration {
        Duration::from_secs_f64(self.schedule.period_us * 1e-6)
    }

    /// From the start of exposure 1, which timestamps frame a, to that of exposure 2.
    pub fn frame_interval(&self) -> Duration {
        let [frame_a_us, frame_b_us] =
            [self.schedule.exposure_1_us[0], self.schedule.exposure_2_us[0]];
        Duration::from_secs_f64((frame_b_us - frame_a_us).max(0.0) * 1e-6)
    }

    /// Shots in the longest burst: what fits in [`LONGEST_BURST_S`], and at least one.
    pub fn max_burst(&self) -> u64 {
        let shots = LONGEST_BURST_S / self.period().as_secs_f64();
        (shots as u64).max(1)
    }
}

/// Decides the bursts in place of the run loop, for a replay.
pub trait BurstScript: Send + Sync {
    /// What the run loop should do when it is idle.
    fn next(&self) -> ScriptedBurst;
    /// How the last burst began in the record; `None` if it does not say.
    fn burst_start(&self) -> Option<BurstStart>;
    /// Whether the next step of the record is that the laser was switched off.
    fn switching_off_is_due(&self) -> bool;
    /// Goes on after that step. Call it once the frames recorded before it are handled.
    fn pass_switching_off(&self);
    /// Whether the record shows the current burst as over by now.
    fn burst_is_over(&self) -> bool;
}

/// See [`BurstScript`].
#[derive(Debug, Clone)]
pub enum ScriptedBurst {
    /// Fire this many shots with this schedule.
    Fire { shots: u64, schedule: Arc<PulseSchedule> },
    /// Wait for events.
    NotYet,
    /// End the run.
    Over,
}
