//! What acquisition needs to know, passed in by value.

use std::{num::NonZeroU64, sync::Arc, time::Duration};

use lfpiv_hw::timing::PulseSchedule;
use serde::{Deserialize, Serialize};

use super::BurstStart;

/// What happens when shots come faster than they are processed.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum OverloadPolicy {
    /// A shot that finds the queue full is not processed, and that is recorded: a real bench does
    /// not wait.
    Shed,
    /// Triggers are given only as there is room in the queue: for bounded simulated runs, in
    /// which every shot counts.
    Wait,
}

/// What a run does when its synchroniser does not answer any more.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum AfterBenchLoss {
    /// It looks for the unit, makes it safe and programs it, and waits until an operator says that
    /// shots may be taken.
    #[default]
    WaitForArm,
    /// The same, without waiting for anybody: the laser fires again by itself.
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
    /// How long a frame that is due is waited for.
    pub patience: Duration,
    /// Memory of one frame: room for each of a burst must be on the disk before it is fired.
    pub frame_bytes: u64,
}

impl AcquisitionSettings {
    /// Time between triggers.
    pub fn period(&self) -> Duration {
        Duration::from_secs_f64(self.schedule.period_us * 1e-6)
    }

    /// From the start of exposure 1, which stamps frame a, to that of exposure 2.
    pub fn frame_interval(&self) -> Duration {
        let [frame_a_us, frame_b_us] =
            [self.schedule.exposure_1_us[0], self.schedule.exposure_2_us[0]];
        Duration::from_secs_f64((frame_b_us - frame_a_us).max(0.0) * 1e-6)
    }

    /// Shots in the longest burst: what fits in [`MAX_BURST`], and at least one.
    pub fn max_burst(&self) -> u64 {
        let shots = MAX_BURST.as_secs_f64() / self.period().as_secs_f64();
        (shots as u64).max(1)
    }
}

/// Longest burst. A dead host or a lost line ends the firing within this time by itself.
pub const MAX_BURST: Duration = Duration::from_secs(5);

/// Decides the bursts in the run loop's place, to play a run again.
pub trait BurstScript: Send + Sync {
    /// What the run loop should do when it has nothing else to do.
    fn next(&self) -> ScriptedBurst;
    /// How the burst that was fired last began then; `None` where the record does not say.
    fn burst_start(&self) -> Option<BurstStart>;
    /// Whether the burst that runs was over by now, for whatever reason.
    fn burst_is_over(&self) -> bool;
}

/// See [`BurstScript`].
#[derive(Debug, Clone)]
pub enum ScriptedBurst {
    /// Fire so many shots with this schedule.
    Fire { shots: u64, schedule: Arc<PulseSchedule> },
    /// Wait for what comes.
    NotYet,
    /// End the run.
    Over,
}
