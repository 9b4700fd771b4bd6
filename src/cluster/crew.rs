//! The workers of a run: what they have in hand, and how fast they are.

use std::{
    collections::{BTreeMap, VecDeque},
    time::{Duration, Instant},
};

use serde::Serialize;
use utoipa::ToSchema;

/// Time over which a worker's rate is taken.
const RATE_TIME: Duration = Duration::from_secs(60);
/// Workers remembered: their names come over the network.
const MOST_WORKERS: usize = 1000;

/// A worker as readers see it.
#[derive(Debug, Clone, PartialEq, Serialize, ToSchema)]
pub struct WorkerView {
    /// Its name.
    pub worker: String,
    /// Shots of which it was the first to deliver a result.
    pub shots: u64,
    /// Shots that it has begun and not ended.
    pub in_hand: u64,
    /// First results a second, over the last minute.
    pub shots_per_s: f64,
    /// Seconds since it was last heard of.
    pub silent_s: f64,
}

/// See the module.
#[derive(Debug, Default)]
pub(super) struct Crew {
    workers: BTreeMap<String, Worker>,
    /// Who has begun a shot last, and not ended it.
    in_hand: BTreeMap<u64, String>,
}

#[derive(Debug)]
struct Worker {
    joined: Instant,
    seen: Instant,
    shots: u64,
    /// Of the last minute.
    delivered: VecDeque<Instant>,
}

impl Crew {
    /// Hears of a worker; whether it is new.
    pub fn see(&mut self, worker: &str, now: Instant) -> bool {
        if let Some(known) = self.workers.get_mut(worker) {
            known.seen = now;
            return false;
        }
        if self.workers.len() >= MOST_WORKERS {
            self.forget_one();
        }
        let new = Worker { joined: now, seen: now, shots: 0, delivered: VecDeque::new() };
        self.workers.insert(worker.to_owned(), new);
        true
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

    /// Number of shots begun and not ended.
    pub fn in_hand(&self) -> usize {
        self.in_hand.len()
    }

    /// All workers, by name.
    pub fn view(&self, now: Instant) -> Vec<WorkerView> {
        let mut in_hand: BTreeMap<&str, u64> = BTreeMap::new();
        self.in_hand.values().for_each(|holder| *in_hand.entry(holder).or_default() += 1);
        let view = |(name, worker): (&String, &Worker)| WorkerView {
            worker: name.clone(),
            shots: worker.shots,
            in_hand: in_hand.get(name.as_str()).copied().unwrap_or(0),
            shots_per_s: worker.rate(now),
            silent_s: now.saturating_duration_since(worker.seen).as_secs_f64(),
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

    #[test]
    fn rates_are_of_the_last_minute_or_since_a_worker_has_joined() {
        let (mut crew, began) = (Crew::default(), Instant::now());
        assert!(crew.see("one", began) && !crew.see("one", began));
        for second in 1..=20_u32 {
            crew.count("one", began + second * S);
        }
        let rate = |at_s: u32| crew.view(began + at_s * S)[0].shots_per_s;
        assert_eq!(rate(20), 1.0);
        assert_eq!(rate(40), 0.5);
        // The first 10 are older than a minute.
        assert_eq!(rate(70), 11.0 / 60.0);
        assert_eq!(rate(200), 0.0);
        assert_eq!(crew.view(began + 20 * S)[0].shots, 20);
    }

    #[test]
    fn a_shot_is_in_the_hands_of_the_last_one_who_has_begun_it() {
        let (mut crew, now) = (Crew::default(), Instant::now());
        assert!(["lost", "other"].iter().all(|worker| crew.see(worker, now)));
        crew.begin("lost", 7);
        crew.begin("lost", 8);
        crew.begin("other", 7);
        let hands = |crew: &Crew| crew.view(now).iter().map(|w| w.in_hand).collect::<Vec<_>>();
        assert_eq!((hands(&crew), crew.in_hand()), (vec![1, 1], 2));
        // It was only slow.
        crew.end("lost", 7);
        crew.end("lost", 8);
        assert_eq!(hands(&crew), [0, 1]);
        crew.end("other", 7);
        assert_eq!(crew.in_hand(), 0);
    }

    #[test]
    fn memory_is_bounded() {
        let (mut crew, began) = (Crew::default(), Instant::now());
        for number in 0..=MOST_WORKERS as u32 {
            crew.see(&number.to_string(), began + number * S);
        }
        assert_eq!(crew.len(), MOST_WORKERS);
        assert!(crew.view(began).iter().all(|worker| worker.worker != "0"));
    }
}
