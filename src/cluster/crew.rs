//! The workers of a run: what they have in hand, and how fast they are.

use std::{
    collections::{BTreeMap, VecDeque},
    time::{Duration, Instant},
};

use serde::Serialize;
use utoipa::ToSchema;

use super::tally::Tries;

/// Time over which a worker's rate is taken.
const RATE_TIME: Duration = Duration::from_secs(60);
/// Workers remembered: their names come over the network.
const MOST_WORKERS: usize = 1000;

/// What a worker is doing.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, ToSchema)]
#[serde(rename_all = "snake_case")]
pub enum WorkerState {
    /// It has shots in hand.
    Measuring,
    /// It waits for shots, or makes ready for this run.
    Idle,
    /// It was not heard of for longer than a worker may be silent: its shots go to others.
    Lost,
    /// It has said that it ends.
    Ended,
}

/// A worker as readers see it.
#[derive(Debug, Clone, PartialEq, Serialize, ToSchema)]
pub struct WorkerView {
    /// Its name.
    pub worker: String,
    pub state: WorkerState,
    /// Shots of which it was the first to deliver a result.
    pub shots: u64,
    /// Shots that it has begun and not ended; none of a worker that is lost or has ended.
    pub in_hand: u64,
    /// Measurements that it has begun.
    pub attempts: u64,
    /// Those of which it has reported that they failed.
    pub failures: u64,
    /// Those that it did not end: their shots went to others.
    pub not_ended: u64,
    /// First results a second, over the last minute.
    pub shots_per_s: f64,
    /// Seconds since it was last heard of.
    pub silent_s: f64,
}

/// See the module.
#[derive(Debug)]
pub(super) struct Crew {
    /// A worker that is silent for longer is lost.
    longest_silence: Duration,
    workers: BTreeMap<String, Worker>,
    /// Who has begun a shot last, and not ended it.
    in_hand: BTreeMap<u64, String>,
}

#[derive(Debug)]
struct Worker {
    joined: Instant,
    seen: Instant,
    has_ended: bool,
    shots: u64,
    /// Of the last minute.
    delivered: VecDeque<Instant>,
}

impl Crew {
    /// Nobody yet. A worker that is silent for longer than this is lost.
    pub fn new(longest_silence: Duration) -> Self {
        Self { longest_silence, workers: BTreeMap::new(), in_hand: BTreeMap::new() }
    }

    /// Hears of a worker; whether it is new.
    pub fn see(&mut self, worker: &str, now: Instant) -> bool {
        if let Some(known) = self.workers.get_mut(worker) {
            known.seen = now;
            known.has_ended = false;
            return false;
        }
        if self.workers.len() >= MOST_WORKERS {
            self.forget_one();
        }
        let new = Worker {
            joined: now,
            seen: now,
            has_ended: false,
            shots: 0,
            delivered: VecDeque::new(),
        };
        self.workers.insert(worker.to_owned(), new);
        true
    }

    /// A worker says that it ends.
    pub fn leave(&mut self, worker: &str, now: Instant) {
        if let Some(known) = self.workers.get_mut(worker) {
            known.seen = now;
            known.has_ended = true;
        }
    }

    /// A worker has begun a shot; whoever had it before is lost, or as good as that.
    pub fn begin(&mut self, worker: &str, shot: u64) {
        self.in_hand.insert(shot, worker.to_owned());
    }

    /// A worker has ended a shot.
    pub fn end(&mut self, worker: &str, shot: u64) {
        if self.in_hand.get(&shot).is_some_and(|holder| holder == worker) {
            self.in_hand.remove(&shot);
        }
    }

    /// A worker was the first with a result.
    pub fn count(&mut self, worker: &str, now: Instant) {
        let Some(worker) = self.workers.get_mut(worker) else { return };
        worker.shots += 1;
        worker.delivered.push_back(now);
        while worker.delivered.front().is_some_and(|at| now.duration_since(*at) > RATE_TIME) {
            worker.delivered.pop_front();
        }
    }

    /// Number of workers heard of.
    pub fn len(&self) -> usize {
        self.workers.len()
    }

    /// All workers, by name. What each has tried is `tried`'s.
    pub fn view(&self, now: Instant, tried: &BTreeMap<&str, Tries>) -> Vec<WorkerView> {
        let mut in_hand: BTreeMap<&str, u64> = BTreeMap::new();
        self.in_hand.values().for_each(|holder| *in_hand.entry(holder).or_default() += 1);
        let view = |(name, worker): (&String, &Worker)| {
            let Tries { begun, failed, not_ended } =
                tried.get(name.as_str()).copied().unwrap_or_default();
            let silent = now.saturating_duration_since(worker.seen);
            let hands = in_hand.get(name.as_str()).copied().unwrap_or(0);
            let state = match hands {
                _ if worker.has_ended => WorkerState::Ended,
                _ if silent > self.longest_silence => WorkerState::Lost,
                0 => WorkerState::Idle,
                _ => WorkerState::Measuring,
            };
            WorkerView {
                worker: name.clone(),
                state,
                shots: worker.shots,
                in_hand: if state == WorkerState::Measuring { hands } else { 0 },
                attempts: begun,
                failures: failed,
                not_ended,
                shots_per_s: worker.rate(now),
                silent_s: silent.as_secs_f64(),
            }
        };
        self.workers.iter().map(view).collect()
    }

    /// The one that has been silent for longest makes room.
    fn forget_one(&mut self) {
        let silent = self.workers.iter().min_by_key(|(_, worker)| worker.seen);
        if let Some(name) = silent.map(|(name, _)| name.clone()) {
            self.workers.remove(&name);
        }
    }
}

impl Worker {
    /// A worker that has just joined has shown less than a minute.
    fn rate(&self, now: Instant) -> f64 {
        let since = |at: Instant| now.saturating_duration_since(at);
        let time = since(self.joined).min(RATE_TIME).max(Duration::from_secs(1));
        let recent = self.delivered.iter().filter(|at| since(**at) <= RATE_TIME).count();
        recent as f64 / time.as_secs_f64()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const S: Duration = Duration::from_secs(1);

    fn crew() -> Crew {
        Crew::new(30 * S)
    }

    fn seen(crew: &Crew, now: Instant) -> Vec<WorkerView> {
        crew.view(now, &BTreeMap::new())
    }

    #[test]
    fn rates_are_of_the_last_minute_or_since_a_worker_has_joined() {
        let (mut crew, began) = (crew(), Instant::now());
        assert!(crew.see("one", began) && !crew.see("one", began));
        for second in 1..=20_u32 {
            crew.count("one", began + second * S);
        }
        let rate = |at_s: u32| seen(&crew, began + at_s * S)[0].shots_per_s;
        assert_eq!(rate(20), 1.0);
        assert_eq!(rate(40), 0.5);
        // The first 10 are older than a minute.
        assert_eq!(rate(70), 11.0 / 60.0);
        assert_eq!(rate(200), 0.0);
        assert_eq!(seen(&crew, began + 20 * S)[0].shots, 20);
    }

    #[test]
    fn a_shot_is_in_the_hands_of_the_last_one_who_has_begun_it() {
        let (mut crew, now) = (crew(), Instant::now());
        assert!(["lost", "other"].iter().all(|worker| crew.see(worker, now)));
        crew.begin("lost", 7);
        crew.begin("lost", 8);
        crew.begin("other", 7);
        let hands = |crew: &Crew| seen(crew, now).iter().map(|w| w.in_hand).collect::<Vec<_>>();
        assert_eq!(hands(&crew), [1, 1]);
        // It was only slow.
        crew.end("lost", 7);
        crew.end("lost", 8);
        assert_eq!(hands(&crew), [0, 1]);
        crew.end("other", 7);
        assert_eq!(hands(&crew), [0, 0]);
    }

    #[test]
    fn who_is_silent_for_too_long_is_lost_unless_it_has_said_that_it_ends() {
        use WorkerState::{Ended, Idle, Lost, Measuring};
        let (mut crew, began) = (crew(), Instant::now());
        for worker in ["measures", "waits", "was told to end"] {
            crew.see(worker, began);
        }
        crew.begin("measures", 7);
        // By name.
        let states = |crew: &Crew, at_s: u32| {
            seen(crew, began + at_s * S).iter().map(|w| (w.state, w.in_hand)).collect::<Vec<_>>()
        };
        assert_eq!(states(&crew, 30), [(Measuring, 1), (Idle, 0), (Idle, 0)]);
        crew.leave("was told to end", began + 30 * S);
        crew.leave("nobody", began + 30 * S);
        assert_eq!(states(&crew, 31), [(Lost, 0), (Lost, 0), (Ended, 0)]);
        crew.see("measures", began + 40 * S);
        crew.see("was told to end", began + 40 * S);
        assert_eq!(states(&crew, 41), [(Measuring, 1), (Lost, 0), (Idle, 0)]);
    }

    #[test]
    fn what_a_worker_has_tried_stands_beside_its_name() {
        let (mut crew, now) = (crew(), Instant::now());
        crew.see("one", now);
        crew.see("two", now);
        let tried = BTreeMap::from([("two", Tries { begun: 5, failed: 1, not_ended: 2 })]);
        let tries = |view: &WorkerView| (view.attempts, view.failures, view.not_ended);
        let views = crew.view(now, &tried);
        assert_eq!(views.iter().map(tries).collect::<Vec<_>>(), [(0, 0, 0), (5, 1, 2)]);
    }

    #[test]
    fn memory_is_bounded() {
        let (mut crew, began) = (crew(), Instant::now());
        for number in 0..=MOST_WORKERS as u32 {
            crew.see(&number.to_string(), began + number * S);
        }
        assert_eq!(crew.len(), MOST_WORKERS);
        assert!(seen(&crew, began).iter().all(|worker| worker.worker != "0"));
    }
}
