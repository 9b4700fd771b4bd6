//! From frames to shots: a state machine without clocks, threads or devices.
//!
//! Trigger `n` makes frames `2n` and `2n + 1` of every camera. Frames are assigned by frame id, which
//! is checked against three other sources: the camera's own timestamps (frame b follows frame a after
//! a fixed time, triggers of a burst are whole periods apart), the other cameras (the difference
//! between two cameras' clocks is the same in every shot), and the synchroniser's trigger count. The
//! order of arrival is never used.
//!
//! A camera that misses a trigger does not count it, so all its later frame ids are one shot behind.
//! Within a burst its timestamps show this. For the first trigger of a burst the other camera shows
//! it, given the difference of their clocks. That difference is learnt from bursts of a single shot,
//! in which frames cannot be confused: fire such bursts until [`Pairing::has_reference`]. After a jump
//! of a clock it is discarded and learnt again; until then shots are suspect. A jump by a whole number
//! of periods cannot be distinguished from missed triggers.
//!
//! Camera clocks are fitted ([`clocks`]). Every shot carries each camera's timestamp residual, and is
//! suspect when one is an outlier. An outlier exceeds eight standard deviations of recent shots and
//! the assumed timestamp precision of cameras (`frame_interval_tolerance_ns`), or an eighth of a
//! period.
//!
//! If the first frame of a stream is lost, the next one, a frame b, is numbered 0. Two successive
//! frames with the interval of one trigger's exposures reveal this.
//!
//! Each trigger announced with [`Pairing::fired`] leads, for each camera, to exactly one decision.
//! Time is passed in, as a duration since an arbitrary moment.

mod clock_fit;
mod clocks;
#[cfg(test)]
mod many_shots;
mod rules;
mod slot;
#[cfg(test)]
mod tests;
mod track;

use std::{collections::BTreeMap, time::Duration};

use clocks::CameraClocks;
use lfpiv_hw::device::Frame;
use serde::Serialize;
use slot::Slot;
use thiserror::Error;
use track::{BurstRange, Location, StreamTrack, TimeGrid};

use super::{Outcome, Shot};

/// Settings of pairing.
#[derive(Debug, Clone, PartialEq)]
pub struct PairingSettings {
    /// Number of cameras.
    pub cameras: usize,
    /// Time between triggers of a burst, in ns.
    pub period_ns: u64,
    /// Timestamp of frame b minus that of frame a, in ns.
    pub frame_interval_ns: u64,
    /// Tolerance of that difference before the shot is suspect, in ns.
    pub frame_interval_tolerance_ns: u64,
    /// Time between the light pulses, in µs; copied into the shots.
    pub dt_us: f64,
    /// How long to wait for a due frame. Then the shot is settled without it; frames that arrive within
    /// the same time again are late.
    pub patience: Duration,
}

/// A decision about a trigger.
#[derive(Debug)]
pub enum Decision {
    /// The trigger counts from now on: a camera saw it or a later one, the synchroniser counted it,
    /// or it was due and the synchroniser cannot be asked. It precedes all other decisions about
    /// the trigger.
    Given { trigger: u64 },
    /// All cameras delivered.
    Paired(Shot),
    /// The outcome of one camera for a shot that will not be paired.
    Settled { trigger: u64, camera: usize, outcome: Outcome },
    /// The trigger was requested but not given.
    Withdrawn { trigger: u64 },
}

/// Number of frames by fate. Every frame is counted once:
/// `received = paired + unpaired + duplicate + stray + `[`Pairing::held_frames`].
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq, Serialize)]
pub struct FrameCounters {
    /// Frames received in all.
    pub received: u64,
    /// Frames of shots that were paired.
    pub paired: u64,
    /// Frames of triggers that could not be paired; their outcomes say why.
    pub unpaired: u64,
    /// Duplicates.
    pub duplicate: u64,
    /// Frames that belong to no open trigger.
    pub stray: u64,
}

/// The synchroniser gave more triggers than requested.
#[derive(Debug, Error, PartialEq, Eq)]
#[error(
    "the synchroniser counted {counted} triggers but {asked} were requested: something else fires the \
     laser; use the hardware interlock"
)]
pub struct ExtraTriggers {
    counted: u64,
    asked: u64,
}

#[derive(Debug)]
struct OpenTrigger {
    due: Duration,
    given_up: bool,
    /// The laser was being switched off before its frames had arrived.
    may_be_dark: bool,
    slots: Vec<Slot>,
}

/// The state machine; see the module.
#[derive(Debug)]
pub struct Pairing {
    settings: PairingSettings,
    grid: TimeGrid,
    burst: BurstRange,
    /// Triggers that the synchroniser is known to have given.
    given: u64,
    /// Triggers already announced as given.
    announced_given: u64,
    tracks: Vec<StreamTrack>,
    last_arrival: Vec<Duration>,
    clocks: CameraClocks,
    /// Time of the last call.
    now: Duration,
    open: BTreeMap<u64, OpenTrigger>,
    counters: FrameCounters,
}

impl Pairing {
    /// A state machine waiting for the first burst.
    pub fn new(settings: PairingSettings) -> Self {
        Self {
            grid: TimeGrid::of(&settings),
            burst: BurstRange::default(),
            given: 0,
            announced_given: 0,
            tracks: vec![StreamTrack::default(); settings.cameras],
            last_arrival: vec![Duration::ZERO; settings.cameras],
            clocks: CameraClocks::new(settings.cameras, TimeGrid::of(&settings)),
            now: Duration::ZERO,
            open: BTreeMap::new(),
            counters: FrameCounters::default(),
            settings,
        }
    }

    /// The unit is programmed again, possibly with another schedule; no burst is running.
    pub fn rescheduled(&mut self, settings: PairingSettings) {
        let grid = TimeGrid::of(&settings);
        if grid != self.grid {
            self.clocks.rescheduled(grid);
            self.grid = grid;
        }
        self.settings = settings;
    }

    /// Whether the difference between the cameras' clocks is known well enough at `now` to distinguish
    /// neighbouring triggers; a long pause invalidates it. Until then, fire single shots.
    pub fn has_reference(&self, now: Duration) -> bool {
        self.clocks.are_differences_known(now)
    }

    /// Number of unsettled triggers.
    pub fn open_triggers(&self) -> usize {
        self.open.len()
    }

    /// Number of frames held for open triggers.
    pub fn held_frames(&self) -> u64 {
        self.open.values().flat_map(|open| &open.slots).map(Slot::frames_held).sum()
    }

    /// Frames counted so far.
    pub fn counters(&self) -> FrameCounters {
        self.counters
    }

    /// Starts a burst of `shots` triggers; returns the number of its first trigger.
    pub fn fired(&mut self, shots: u64, now: Duration) -> u64 {
        self.now = now;
        if !self.clocks.are_differences_known(now) {
            self.clocks.discard_differences();
        }
        let first = self.burst.end;
        self.burst = BurstRange { first, end: first + shots };
        let period = Duration::from_nanos(self.settings.period_ns);
        for trigger in first..self.burst.end {
            let due = now + period * u32::try_from(trigger - first).unwrap_or(u32::MAX);
            let slots = (0..self.settings.cameras).map(|_| Slot::default()).collect();
            let open = OpenTrigger { due, given_up: false, may_be_dark: false, slots };
            self.open.insert(trigger, open);
        }
        first
    }

    /// Processes a frame of `camera`.
    pub fn frame(&mut self, camera: usize, frame: Frame, now: Duration) -> Vec<Decision> {
        self.now = now;
        self.counters.received += 1;
        self.last_arrival[camera] = now;
        let mut decisions = Vec::new();
        match self.tracks[camera].locate(&frame, self.burst, self.grid) {
            Location::Past => self.counters.stray += 1,
            Location::Trigger { trigger, missed, disagreement } => {
                let half = self.tracks[camera].half(&frame);
                self.mark_missed(camera, trigger - missed..trigger, &mut decisions);
                self.mark_passed(camera, trigger, now);
                if self.store(camera, trigger, half, frame, disagreement) {
                    self.try_pair(trigger, &mut decisions);
                }
            }
        }
        self.with_given(decisions)
    }

    /// The stream of `camera` has lost `total` frames to underruns since its start.
    pub fn underruns(&mut self, camera: usize, total: u64) {
        self.tracks[camera].report_underruns(total);
    }

    /// `camera` is back after an absence. The difference of the cameras' clocks must be learnt again:
    /// [`Self::has_reference`].
    pub fn camera_returned(&mut self, camera: usize) {
        self.tracks[camera].restart();
        self.clocks.restart(camera);
    }

    /// Advances time. The wait for frames of a trigger ends only once the trigger is known to have been
    /// given: from [`Self::burst_ended`] or because a camera saw it.
    pub fn tick(&mut self, now: Duration) -> Vec<Decision> {
        self.now = now;
        let mut decisions = Vec::new();
        let triggers: Vec<u64> = self.open.keys().copied().collect();
        for trigger in triggers {
            self.expire_overdue(trigger, now, &mut decisions);
        }
        self.with_given(decisions)
    }

    /// Triggers up to the last one that was due by `now` or that a camera has seen: the best
    /// estimate for an aborted burst of a synchroniser without a counter.
    pub fn due_by(&self, now: Duration) -> u64 {
        let due = self.open.iter().rev().find(|(_, open)| open.due <= now);
        due.map_or(0, |(trigger, _)| trigger + 1).max(self.announced_given).max(self.burst.first)
    }

    /// The laser has been switched off during the burst. Its Q-switches go off before the cameras'
    /// triggers, so a shot whose frames have not arrived may lack one pulse or both: it is suspect.
    pub fn laser_switched_off(&mut self) {
        for open in self.open.values_mut() {
            open.may_be_dark = true;
        }
    }

    /// The burst is over, and the synchroniser has counted `counted` triggers since it was programmed.
    /// Triggers that were not given are withdrawn.
    pub fn burst_ended(&mut self, counted: u64) -> Result<Vec<Decision>, ExtraTriggers> {
        if counted > self.burst.end {
            return Err(ExtraTriggers { counted, asked: self.burst.end });
        }
        self.burst.end = counted.max(self.burst.first);
        self.given = self.burst.end;
        let mut decisions = Vec::new();
        for (trigger, open) in self.open.split_off(&self.burst.end) {
            if open.has_no_evidence() && trigger >= self.announced_given {
                decisions.push(Decision::Withdrawn { trigger });
            } else {
                // A frame proves the trigger, whatever the counter says.
                self.burst.end = self.burst.end.max(trigger + 1);
                self.open.insert(trigger, open);
            }
        }
        Ok(self.with_given(decisions))
    }

    /// The synchroniser is lost, so its trigger count cannot be read. Triggers that a camera saw, and
    /// earlier ones, were given and are awaited. Of the others, those that were due are not fired, and
    /// the rest is withdrawn. Returns the number of triggers that count.
    pub fn burst_lost(&mut self) -> (u64, Vec<Decision>) {
        let mut decisions = self.with_given(Vec::new());
        for trigger in
            self.open.range(self.announced_given..).map(|open| *open.0).collect::<Vec<_>>()
        {
            self.close_unseen(trigger, &mut decisions);
        }
        self.given = self.announced_given.max(self.burst.first);
        self.burst.end = self.given;
        (self.given, decisions)
    }

    /// Ends the run: settles every open trigger. A trigger without evidence of a lost frame is
    /// shed. One without evidence that it was given is not fired if it was due, and otherwise
    /// withdrawn.
    pub fn finish(&mut self) -> Vec<Decision> {
        let mut decisions = self.with_given(Vec::new());
        for trigger in self.open.keys().copied().collect::<Vec<_>>() {
            if trigger >= self.announced_given {
                self.close_unseen(trigger, &mut decisions);
                continue;
            }
            self.close_unpaired(trigger, &mut decisions);
            self.shed_incomplete(trigger, &mut decisions);
            self.close_slots(trigger, |_| true, &mut decisions);
        }
        decisions
    }

    /// Inserts [`Decision::Given`] before the decisions about newly given triggers.
    fn with_given(&mut self, decisions: Vec<Decision>) -> Vec<Decision> {
        let ruled = decisions.iter().filter_map(|ruling| match ruling {
            Decision::Paired(shot) => Some(shot.trigger),
            Decision::Settled { trigger, .. } => Some(*trigger),
            Decision::Given { .. } | Decision::Withdrawn { .. } => None,
        });
        let seen = self.open.iter().rev().find(|(_, open)| !open.has_no_evidence());
        let last = ruled.max().max(seen.map(|(trigger, _)| *trigger));
        let given = last.map_or(0, |last| last + 1).max(self.given).max(self.announced_given);
        let announced = std::mem::replace(&mut self.announced_given, given);
        let mut all: Vec<Decision> =
            (announced..given).map(|trigger| Decision::Given { trigger }).collect();
        all.extend(decisions);
        all
    }
}

impl OpenTrigger {
    /// Whether there is no evidence that it was given.
    fn has_no_evidence(&self) -> bool {
        self.slots.iter().all(Slot::has_no_evidence)
    }
}
