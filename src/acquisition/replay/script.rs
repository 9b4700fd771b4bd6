//! Keeps cameras and run loop in the recorded order.
//!
//! Each step of the record belongs to a camera (a frame, a lost connection) or to the run loop (a
//! burst fired, a burst ended). A camera's step ends when the camera asks for its next frame, because
//! by then the run loop has received this one. So the run loop sees the steps in order.

use std::{
    collections::BTreeSet,
    sync::Arc,
    time::{Duration, Instant},
};

use lfpiv_hw::{
    RawImage,
    device::{Frame, StreamStatistics},
};
use lfpiv_rawlog::Position;
use parking_lot::{Condvar, Mutex, MutexGuard};
use tokio_util::sync::CancellationToken;

use super::{
    clock::ReplayClock,
    steps::{Step, Steps},
};
use crate::acquisition::{
    BurstScript, BurstStart, Outcome, ScriptedBurst,
    journal::{Entry, FrameHead, RecordedRun, RecordedRunError},
};

/// Speed of a replay.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Speed {
    /// The original speed.
    Recorded,
    /// As fast as the frames can be read and processed.
    Max,
}

/// Poll interval of a camera waiting for its turn.
const POLL: Duration = Duration::from_millis(1);
/// Advance of the clock per poll while only the run loop can act, in ns.
const CLOCK_STEP_NS: u64 = 20_000_000;
/// How long a step of the run loop may be pending before the clock advances beyond it: longer than
/// one iteration of the run loop.
const STALLED: Duration = Duration::from_secs(1);

/// The record being replayed.
pub(super) struct Script {
    recorded: RecordedRun,
    steps: Vec<Step>,
    speed: Speed,
    clock: Arc<ReplayClock>,
    began: Instant,
    state: Mutex<State>,
    changed: Condvar,
    stop: CancellationToken,
    /// Total number of triggers shown to have been given; `None` if the record does not say.
    seen: Option<u64>,
    unreadable: Mutex<Vec<(Position, RecordedRunError)>>,
}

struct State {
    next: usize,
    /// When the last step was taken.
    moved: Instant,
    /// Triggers given according to the steps so far.
    given: u64,
    /// Triggers requested.
    fired: u64,
    /// Start of the last burst.
    start: Option<BurstStart>,
}

/// What a camera receives in its turn.
pub(super) enum Turn {
    Frame {
        frame: Frame,
        statistics: StreamStatistics,
    },
    Stream {
        connected: bool,
        statistics: StreamStatistics,
    },
    /// Timeout.
    None,
}

/// State of the last burst.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum BurstState {
    Firing,
    Over,
    /// The unit was lost during it.
    Lost,
}

impl Script {
    pub fn read(
        recorded: RecordedRun,
        speed: Speed,
        clock: Arc<ReplayClock>,
        stop: CancellationToken,
    ) -> Self {
        let mut steps = Steps::new(recorded.description().cameras);
        let mut seen = GivenTriggers::of(&recorded);
        for placed in recorded.entries() {
            match placed {
                Ok(placed) => {
                    seen.take(&placed.entry);
                    steps.take(placed);
                }
                Err(_) => {
                    seen.record_gap();
                    steps.record_gap();
                }
            }
        }
        let state = State { next: 0, moved: Instant::now(), given: 0, fired: 0, start: None };
        Self {
            recorded,
            steps: steps.finish(),
            speed,
            clock,
            began: Instant::now(),
            state: Mutex::new(state),
            changed: Condvar::new(),
            stop,
            seen: seen.triggers(),
            unreadable: Mutex::default(),
        }
    }

    /// Unreadable frames and their errors. They are lost in the replay.
    pub fn unreadable(&self) -> Vec<(Position, RecordedRunError)> {
        std::mem::take(&mut self.unreadable.lock())
    }

    pub fn longest_burst(&self) -> u64 {
        let shots = self.steps.iter().map(|step| match step {
            Step::Fired { shots, .. } => *shots,
            _ => 0,
        });
        shots.max().unwrap_or(0)
    }

    /// The camera's next step, if its turn comes within `timeout`. The turn lasts until
    /// [`Self::finish`].
    pub fn turn(&self, camera: usize, timeout: Duration) -> Turn {
        let until = Instant::now() + timeout;
        let mut state = self.state.lock();
        while Instant::now() < until {
            match self.steps.get(state.next) {
                Some(Step::Frame { camera: of, .. } | Step::Stream { camera: of, .. })
                    if *of == camera =>
                {
                    if self.is_due(&self.steps[state.next]) {
                        let step = self.steps[state.next].clone();
                        drop(state);
                        if let Some(turn) = self.play(step) {
                            return turn;
                        }
                        self.finish();
                        state = self.state.lock();
                        continue;
                    }
                }
                Some(Step::Stopping { .. }) => {
                    self.stop.cancel();
                    self.advance(&mut state);
                    continue;
                }
                Some(step @ (Step::Fired { .. } | Step::BurstEnded { .. })) => {
                    self.advance_clock(step, &state);
                }
                Some(_) => {}
                // A record that is cut off ends the run; a complete one has already ended it.
                None => self.stop.cancel(),
            }
            self.changed.wait_for(&mut state, POLL);
        }
        Turn::None
    }

    /// Ends the step that [`Self::turn`] returned.
    pub fn finish(&self) {
        self.advance(&mut self.state.lock());
    }

    /// State of the unit: it fires until the end of the burst is the next step.
    pub fn burst_state(&self) -> BurstState {
        let mut state = self.state.lock();
        match self.steps.get(state.next) {
            Some(Step::BurstEnded { at_ns, given, lost }) => {
                self.clock.advance(*at_ns);
                state.given = *given;
                self.advance(&mut state);
                if *lost { BurstState::Lost } else { BurstState::Over }
            }
            Some(_) => BurstState::Firing,
            None => {
                // The record is cut off: triggers that nobody saw count as not given.
                state.given = self.seen.unwrap_or(state.fired);
                BurstState::Over
            }
        }
    }

    /// Number of triggers given.
    pub fn given(&self) -> u64 {
        self.state.lock().given
    }

    /// Starts a burst.
    pub fn fire(&self, shots: u64) -> Result<(), String> {
        let mut state = self.state.lock();
        match self.steps.get(state.next) {
            Some(Step::Fired { shots: recorded, start, .. }) if *recorded == shots => {
                state.start = *start;
                state.fired += shots;
                self.advance(&mut state);
                Ok(())
            }
            _ => Err(format!("the record does not continue with a burst of {shots}")),
        }
    }

    fn advance(&self, state: &mut MutexGuard<'_, State>) {
        state.next += 1;
        state.moved = Instant::now();
        self.changed.notify_all();
    }

    fn is_due(&self, step: &Step) -> bool {
        self.speed == Speed::Max || self.began.elapsed().as_nanos() as u64 >= step.at_ns()
    }

    /// Only the run loop can act: advances the clock up to the recorded time of its step, and beyond it
    /// only if the run loop stalls.
    fn advance_clock(&self, step: &Step, state: &State) {
        let mut to_ns = match self.speed {
            Speed::Max => self.clock.now_ns() + CLOCK_STEP_NS,
            Speed::Recorded => self.began.elapsed().as_nanos() as u64,
        };
        if state.moved.elapsed() < STALLED {
            to_ns = to_ns.min(step.at_ns());
        }
        self.clock.advance(to_ns);
    }

    /// `None` if the image of a frame cannot be read.
    fn play(&self, step: Step) -> Option<Turn> {
        self.clock.advance(step.at_ns());
        match step {
            Step::Frame { head, statistics, place, .. } => match self.recorded.image(place) {
                Ok(image) => Some(Turn::Frame { frame: frame(head, image), statistics }),
                Err(error) => {
                    tracing::error!("a frame is lost: {error}");
                    self.unreadable.lock().push((place, error));
                    None
                }
            },
            Step::Stream { connected, statistics, .. } => {
                Some(Turn::Stream { connected, statistics })
            }
            _ => Some(Turn::None),
        }
    }
}

impl BurstScript for Script {
    fn next(&self) -> ScriptedBurst {
        let mut state = self.state.lock();
        match self.steps.get(state.next) {
            Some(Step::Fired { shots, schedule, at_ns, .. }) => {
                // The run loop is active: it may wait for queue space, and time must not pass
                // meanwhile.
                state.moved = Instant::now();
                if !self.is_due(&self.steps[state.next]) {
                    return ScriptedBurst::NotYet;
                }
                self.clock.advance(*at_ns);
                ScriptedBurst::Fire { shots: *shots, schedule: schedule.clone() }
            }
            Some(_) => ScriptedBurst::NotYet,
            None => ScriptedBurst::Over,
        }
    }

    fn burst_start(&self) -> Option<BurstStart> {
        self.state.lock().start
    }

    fn switching_off_is_due(&self) -> bool {
        let state = self.state.lock();
        let step = self.steps.get(state.next);
        step.is_some_and(|step| matches!(step, Step::SwitchingOff { .. }) && self.is_due(step))
    }

    fn pass_switching_off(&self) {
        let mut state = self.state.lock();
        if let Some(Step::SwitchingOff { at_ns }) = self.steps.get(state.next) {
            self.clock.advance(*at_ns);
            self.advance(&mut state);
        }
    }

    fn burst_is_over(&self) -> bool {
        let state = self.state.lock();
        match self.steps.get(state.next) {
            Some(Step::BurstEnded { at_ns, .. }) => self.clock.now_ns() >= *at_ns,
            Some(_) => false,
            None => true,
        }
    }
}

/// Counts the triggers that a record shows to have been given.
struct GivenTriggers {
    /// The journal states each of them (since version 3).
    is_explicit: bool,
    given: u64,
    unseen: BTreeSet<u64>,
}

impl GivenTriggers {
    fn of(recorded: &RecordedRun) -> Self {
        let is_explicit = recorded.description().journal_version >= 3;
        Self { is_explicit, given: 0, unseen: BTreeSet::new() }
    }

    fn take(&mut self, entry: &Entry) {
        match entry {
            Entry::Given { trigger } => self.given = self.given.max(trigger + 1),
            Entry::Settled { trigger, outcome: Outcome::NotFired, .. } => {
                self.unseen.insert(*trigger);
            }
            _ => {}
        }
    }

    /// A missing entry may have been one of these.
    fn record_gap(&mut self) {
        self.is_explicit = false;
    }

    fn triggers(&self) -> Option<u64> {
        self.is_explicit.then(|| self.given - self.unseen.len() as u64)
    }
}

fn frame(head: FrameHead, image: RawImage) -> Frame {
    let FrameHead { frame_id, device_timestamp_ns, host_timestamp_ns, status } = head;
    Frame { image, frame_id, device_timestamp_ns, host_timestamp_ns, status }
}
