//! From frames to shots: a state machine without clocks, threads or devices.
//!
//! Trigger `n` makes frames `2n` and `2n + 1` of every camera. The frame id decides, and three
//! witnesses check it: the camera's own timestamps (frames b follow frames a after a fixed time,
//! triggers of a burst are whole periods apart), the other cameras (the difference between two
//! cameras' clocks is the same in every shot), and the synchroniser's trigger count. The order in
//! which frames arrive decides nothing.
//!
//! A camera that misses a trigger does not count it, so all its later frame ids are one shot
//! behind. Within a burst its timestamps show this; for the first trigger of a burst the other
//! camera does, given the difference of their clocks. That difference is learnt from bursts of a
//! single shot, in which nothing can be exchanged: fire such bursts until
//! [`Pairing::has_reference`]. When a clock jumps, it is forgotten and learnt anew; until then
//! shots are suspect. A jump by a whole number of periods looks like missed triggers: nothing
//! tells them apart.
//!
//! Clocks are fitted ([`clocks`]): every shot carries how far each camera's timestamp is off its
//! clock's line, and is suspect when that is far out. Far out is more than eight standard
//! deviations of the recent shots and more than the exactness that cameras are believed to have
//! (`frame_interval_tolerance_ns`), or an eighth of a period.
//!
//! The first frame of a stream may be lost, and the next one, frame b, be numbered 0 in its place.
//! Two successive frames as far apart as exposures of one trigger show this.
//!
//! Each trigger entered with [`Pairing::fired`] leads, for each camera, to exactly one ruling.
//! Time is passed in, as a duration since any fixed moment.

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

use clocks::Clocks;
use lfpiv_hw::device::Frame;
use serde::Serialize;
use slot::Slot;
use thiserror::Error;
use track::{Burst, Location, TimeGrid, Track};

use super::{Outcome, Shot};

/// What pairing needs to know.
#[derive(Debug, Clone, PartialEq)]
pub struct PairingSettings {
    /// Number of cameras.
    pub cameras: usize,
    /// Time between triggers of a burst, in ns.
    pub period_ns: u64,
    /// Timestamp of frame b less that of frame a, in ns.
    pub frame_interval_ns: u64,
    /// How far that difference may be off before the shot is suspect, in ns.
    pub frame_interval_tolerance_ns: u64,
    /// Time between the light pulses, in µs: it goes into the shots.
    pub dt_us: f64,
    /// How long to wait for a frame that is due. A shot is given up after this; what comes within
    /// as long again is late.
    pub patience: Duration,
}

/// What was decided about a trigger.
#[derive(Debug)]
pub enum Ruling {
    /// It counts from now on: a camera saw it or a later one, the synchroniser has counted it, or it
    /// was due and nobody can be asked. No other ruling on it comes before.
    Given { trigger: u64 },
    /// All cameras delivered.
    Paired(Shot),
    /// One camera's part in a shot that will not be paired.
    Settled { trigger: u64, camera: usize, outcome: Outcome },
    /// The trigger was asked for, but never given.
    Withdrawn { trigger: u64 },
}

/// Where the frames went. Every frame is counted once:
/// `received = paired + unpaired + duplicate + stray + `[`Pairing::held_frames`].
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq, Serialize)]
pub struct FrameCounters {
    /// Frames received in all.
    pub received: u64,
    /// Frames of shots that were paired.
    pub paired: u64,
    /// Frames of triggers that could not be paired; their outcomes say why.
    pub unpaired: u64,
    /// Frames that were there already.
    pub duplicate: u64,
    /// Frames of no open trigger.
    pub stray: u64,
}

/// The synchroniser gave more triggers than it was asked for.
#[derive(Debug, Error, PartialEq, Eq)]
#[error(
    "the synchroniser counts {counted} triggers, {asked} were asked for: something else fires the \
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
    slots: Vec<Slot>,
}

/// The state machine; see the module.
#[derive(Debug)]
pub struct Pairing {
    settings: PairingSettings,
    grid: TimeGrid,
    burst: Burst,
    /// Triggers that the synchroniser is known to have given.
    given: u64,
    /// Triggers that were ruled to be given.
    told_given: u64,
    tracks: Vec<Track>,
    last_arrival: Vec<Duration>,
    clocks: Clocks,
    /// The time of the last call.
    now: Duration,
    open: BTreeMap<u64, OpenTrigger>,
    counters: FrameCounters,
}

impl Pairing {
    /// A machine that waits for the first burst.
    pub fn new(settings: PairingSettings) -> Self {
        Self {
            grid: TimeGrid::of(&settings),
            burst: Burst::default(),
            given: 0,
            told_given: 0,
            tracks: vec![Track::default(); settings.cameras],
            last_arrival: vec![Duration::ZERO; settings.cameras],
            clocks: Clocks::new(settings.cameras, TimeGrid::of(&settings)),
            now: Duration::ZERO,
            open: BTreeMap::new(),
            counters: FrameCounters::default(),
            settings,
        }
    }

    /// The unit is programmed anew, perhaps with another schedule; no burst runs.
    pub fn rescheduled(&mut self, settings: PairingSettings) {
        let grid = TimeGrid::of(&settings);
        if grid != self.grid {
            self.clocks.rescheduled(grid);
            self.grid = grid;
        }
        self.settings = settings;
    }

    /// Whether the difference between the cameras' clocks is known well enough at `now` to tell
    /// one trigger from the next: after a long pause it no longer is. Until then, fire single shots.
    pub fn has_reference(&self, now: Duration) -> bool {
        self.clocks.are_compared(now)
    }

    /// Triggers that are not ruled on yet.
    pub fn open_triggers(&self) -> usize {
        self.open.len()
    }

    /// Frames of open triggers.
    pub fn held_frames(&self) -> u64 {
        self.open.values().flat_map(|open| &open.slots).map(Slot::frames_held).sum()
    }

    /// Frames counted so far.
    pub fn counters(&self) -> FrameCounters {
        self.counters
    }

    /// A burst of `shots` triggers begins now; its first trigger's number is returned.
    pub fn fired(&mut self, shots: u64, now: Duration) -> u64 {
        self.now = now;
        if !self.clocks.are_compared(now) {
            self.clocks.forget_differences();
        }
        let first = self.burst.end;
        self.burst = Burst { first, end: first + shots };
        let period = Duration::from_nanos(self.settings.period_ns);
        for trigger in first..self.burst.end {
            let due = now + period * u32::try_from(trigger - first).unwrap_or(u32::MAX);
            let slots = (0..self.settings.cameras).map(|_| Slot::default()).collect();
            self.open.insert(trigger, OpenTrigger { due, given_up: false, slots });
        }
        first
    }

    /// A frame arrived from `camera`.
    pub fn frame(&mut self, camera: usize, frame: Frame, now: Duration) -> Vec<Ruling> {
        self.now = now;
        self.counters.received += 1;
        self.last_arrival[camera] = now;
        let mut rulings = Vec::new();
        match self.tracks[camera].locate(&frame, self.burst, self.grid) {
            Location::Past => self.counters.stray += 1,
            Location::Trigger { trigger, missed, disagreement } => {
                let half = self.tracks[camera].half(&frame);
                self.mark_missed(camera, trigger - missed..trigger, &mut rulings);
                self.mark_passed(camera, trigger, now);
                if self.store(camera, trigger, half, frame, disagreement) {
                    self.examine(trigger, &mut rulings);
                }
            }
        }
        self.with_given(rulings)
    }

    /// The stream of `camera` has lost `total` frames since its start for want of a buffer.
    pub fn underruns(&mut self, camera: usize, total: u64) {
        self.tracks[camera].report_underruns(total);
    }

    /// `camera` is back after an absence. The difference between the cameras' clocks has to be
    /// learnt anew: [`Self::has_reference`].
    pub fn camera_returned(&mut self, camera: usize) {
        self.tracks[camera].restart();
        self.clocks.restart(camera);
    }

    /// Time has passed. A trigger is given up for silence only once it is known to have been
    /// given: from [`Self::burst_ended`] or because a camera saw it.
    pub fn tick(&mut self, now: Duration) -> Vec<Ruling> {
        self.now = now;
        let mut rulings = Vec::new();
        let triggers: Vec<u64> = self.open.keys().copied().collect();
        for trigger in triggers {
            self.wait_or_give_up(trigger, now, &mut rulings);
        }
        self.with_given(rulings)
    }

    /// Triggers up to the last one that was due by `now`, or that a camera has seen: as far as can be
    /// known of a burst that was cut short, where the synchroniser does not count.
    pub fn due_by(&self, now: Duration) -> u64 {
        let due = self.open.iter().rev().find(|(_, open)| open.due <= now);
        due.map_or(0, |(trigger, _)| trigger + 1).max(self.told_given).max(self.burst.first)
    }

    /// The burst is over and the synchroniser has counted `counted` triggers since it was
    /// programmed. Triggers that were not given are withdrawn.
    pub fn burst_ended(&mut self, counted: u64) -> Result<Vec<Ruling>, ExtraTriggers> {
        if counted > self.burst.end {
            return Err(ExtraTriggers { counted, asked: self.burst.end });
        }
        self.burst.end = counted.max(self.burst.first);
        self.given = self.burst.end;
        let mut rulings = Vec::new();
        for (trigger, open) in self.open.split_off(&self.burst.end) {
            if open.is_untouched() && trigger >= self.told_given {
                rulings.push(Ruling::Withdrawn { trigger });
            } else {
                // Frames prove that it happened, whatever the counter says.
                self.burst.end = self.burst.end.max(trigger + 1);
                self.open.insert(trigger, open);
            }
        }
        Ok(self.with_given(rulings))
    }

    /// The synchroniser is lost and cannot be asked how many triggers of the burst it gave. Those that
    /// a camera saw, and earlier ones, were given, and are waited for; the others were not fired,
    /// where they were due, and are withdrawn, where not. Returns the number of triggers that count.
    pub fn burst_lost(&mut self) -> (u64, Vec<Ruling>) {
        let mut rulings = self.with_given(Vec::new());
        for trigger in self.open.range(self.told_given..).map(|open| *open.0).collect::<Vec<_>>() {
            self.close_unseen(trigger, &mut rulings);
        }
        self.given = self.told_given.max(self.burst.first);
        self.burst.end = self.given;
        (self.given, rulings)
    }

    /// The end: every open trigger is ruled on with what is known. Where nothing says
    /// that a frame is lost, the end of the run is the reason, and the trigger is shed. One that
    /// nothing shows to have been given was not fired, if it was due, and is withdrawn, if not.
    pub fn finish(&mut self) -> Vec<Ruling> {
        let mut rulings = self.with_given(Vec::new());
        for trigger in self.open.keys().copied().collect::<Vec<_>>() {
            if trigger >= self.told_given {
                self.close_unseen(trigger, &mut rulings);
                continue;
            }
            self.give_up(trigger, &mut rulings);
            self.shed_unfinished(trigger, &mut rulings);
            self.close_slots(trigger, |_| true, &mut rulings);
        }
        rulings
    }

    /// The rulings, behind those that triggers were given: what is ruled on has been.
    fn with_given(&mut self, rulings: Vec<Ruling>) -> Vec<Ruling> {
        let ruled = rulings.iter().filter_map(|ruling| match ruling {
            Ruling::Paired(shot) => Some(shot.trigger),
            Ruling::Settled { trigger, .. } => Some(*trigger),
            Ruling::Given { .. } | Ruling::Withdrawn { .. } => None,
        });
        let seen = self.open.iter().rev().find(|(_, open)| !open.is_untouched());
        let last = ruled.max().max(seen.map(|(trigger, _)| *trigger));
        let given = last.map_or(0, |last| last + 1).max(self.given).max(self.told_given);
        let told = std::mem::replace(&mut self.told_given, given);
        let mut all: Vec<Ruling> = (told..given).map(|trigger| Ruling::Given { trigger }).collect();
        all.extend(rulings);
        all
    }
}

impl OpenTrigger {
    /// Whether nothing is known that shows that it was given.
    fn is_untouched(&self) -> bool {
        self.slots.iter().all(Slot::is_untouched)
    }
}
