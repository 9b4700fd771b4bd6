//! Whose turn it is.
//!
//! A step of the record belongs to a camera (a frame, a connection lost) or to the run loop (a
//! burst fired, a burst ended). A camera's step is over when the camera asks for the next frame,
//! for by then the run loop has been told of this one: so the run loop sees the steps in order.

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

/// How fast a run is played.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Speed {
    /// As it was.
    Recorded,
    /// As fast as the frames can be read and taken.
    Max,
}

/// How long a camera looks at whose turn it is before it looks again.
const LOOK: Duration = Duration::from_millis(1);
/// How far the clock goes on in that time while only the run loop can act, in ns.
const LOOK_AHEAD_NS: u64 = 20_000_000;
/// For so long the run loop may let a step of its own wait before the clock goes on beyond it:
/// longer than the run loop takes for a turn.
const STALLED: Duration = Duration::from_secs(1);

/// The record as it is played.
pub(super) struct Script {
    recorded: RecordedRun,
    steps: Vec<Step>,
    speed: Speed,
    clock: Arc<ReplayClock>,
    began: Instant,
    state: Mutex<State>,
    changed: Condvar,
    stop: CancellationToken,
    /// Triggers that were seen to be given, all in all; `None` where the record does not say.
    seen: Option<u64>,
    unread: Mutex<Vec<(Position, RecordedRunError)>>,
}

struct State {
    next: usize,
    /// When the last step was taken.
    moved: Instant,
    /// Triggers that the unit has given, as far as the steps taken say.
    given: u64,
    /// Triggers that it was asked for.
    fired: u64,
    /// How the burst that was fired last began.
    start: Option<BurstStart>,
}

/// What a camera gets from its turn.
pub(super) enum Turn {
    Frame {
        frame: Frame,
        statistics: StreamStatistics,
    },
    Stream {
        connected: bool,
        statistics: StreamStatistics,
    },
    /// Nothing within the time given.
    None,
}

/// How it stands with the burst that was fired last.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum BurstState {
    Firing,
    Over,
    /// The unit was lost in it.
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
        let mut seen = Seen::of(&recorded);
        for placed in recorded.entries() {
            match placed {
                Ok(placed) => {
                    seen.take(&placed.entry);
                    steps.take(placed);
                }
                Err(_) => {
                    seen.note_gap();
                    steps.note_gap();
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
            unread: Mutex::default(),
        }
    }

    /// Frames whose images could not be read, and why. They are lost in the run played again.
    pub fn unread(&self) -> Vec<(Position, RecordedRunError)> {
        std::mem::take(&mut self.unread.lock())
    }

    pub fn longest_burst(&self) -> u64 {
        let shots = self.steps.iter().map(|step| match step {
            Step::Fired { shots, .. } => *shots,
            _ => 0,
        });
        shots.max().unwrap_or(0)
    }

    /// The camera's step, if its turn comes within `timeout`. The turn lasts until
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
                    self.let_time_pass(step, &state);
                }
                Some(_) => {}
                // A record that breaks off ends the run; one that is whole has ended it already.
                None => self.stop.cancel(),
            }
            self.changed.wait_for(&mut state, LOOK);
        }
        Turn::None
    }

    /// The step that [`Self::turn`] gave is over.
    pub fn finish(&self) {
        self.advance(&mut self.state.lock());
    }

    /// What the unit does: it fires until the end of the burst is the next step.
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
                // The record breaks off: what nobody saw is taken for not given.
                state.given = self.seen.unwrap_or(state.fired);
                BurstState::Over
            }
        }
    }

    /// Triggers given.
    pub fn given(&self) -> u64 {
        self.state.lock().given
    }

    /// A burst begins.
    pub fn fire(&self, shots: u64) -> Result<(), String> {
        let mut state = self.state.lock();
        match self.steps.get(state.next) {
            Some(Step::Fired { shots: recorded, start, .. }) if *recorded == shots => {
                state.start = *start;
                state.fired += shots;
                self.advance(&mut state);
                Ok(())
            }
            _ => Err(format!("a burst of {shots} is not what the record says comes next")),
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

    /// Only the run loop can act: the clock goes on, up to the time at which it did, and beyond
    /// only when it does not.
    fn let_time_pass(&self, step: &Step, state: &State) {
        let mut to_ns = match self.speed {
            Speed::Max => self.clock.now_ns() + LOOK_AHEAD_NS,
            Speed::Recorded => self.began.elapsed().as_nanos() as u64,
        };
        if state.moved.elapsed() < STALLED {
            to_ns = to_ns.min(step.at_ns());
        }
        self.clock.advance(to_ns);
    }

    /// Nothing where the image of a frame cannot be read.
    fn play(&self, step: Step) -> Option<Turn> {
        self.clock.advance(step.at_ns());
        match step {
            Step::Frame { head, statistics, place, .. } => match self.recorded.image(place) {
                Ok(image) => Some(Turn::Frame { frame: frame(head, image), statistics }),
                Err(error) => {
                    tracing::error!("a frame is lost: {error}");
                    self.unread.lock().push((place, error));
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
                // The run loop is here: it may have to wait for room, and time must not pass for it.
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

    fn burst_is_over(&self) -> bool {
        let state = self.state.lock();
        match self.steps.get(state.next) {
            Some(Step::BurstEnded { at_ns, .. }) => self.clock.now_ns() >= *at_ns,
            Some(_) => false,
            None => true,
        }
    }
}

/// Which triggers a record shows to have been given.
struct Seen {
    /// The journal says so of each since version 3.
    is_told: bool,
    given: u64,
    unseen: BTreeSet<u64>,
}

impl Seen {
    fn of(recorded: &RecordedRun) -> Self {
        let is_told = recorded.description().journal_version >= 3;
        Self { is_told, given: 0, unseen: BTreeSet::new() }
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

    /// An entry is missing, which may have been one of these.
    fn note_gap(&mut self) {
        self.is_told = false;
    }

    fn triggers(&self) -> Option<u64> {
        self.is_told.then(|| self.given - self.unseen.len() as u64)
    }
}

fn frame(head: FrameHead, image: RawImage) -> Frame {
    let FrameHead { frame_id, device_timestamp_ns, host_timestamp_ns, status } = head;
    Frame { image, frame_id, device_timestamp_ns, host_timestamp_ns, status }
}
