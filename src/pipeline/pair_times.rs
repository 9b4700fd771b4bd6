//! How long pairs take, and which one takes too long: its worker hangs.
//!
//! How long a pair should take depends on volume, seeding and machine. The longest that gave a
//! result so far says; before there is one, the configuration does. Time is passed in.

use std::{
    collections::BTreeMap,
    fmt,
    time::{Duration, Instant},
};

use parking_lot::Mutex;

/// A pair may take so many times as long as the longest before it: the number of particles may
/// have changed, and other programs may be running.
const ALLOWANCE: u32 = 10;
/// It may always take so long.
const LEAST: Duration = Duration::from_secs(60);
/// What the first pair may take unless configured.
const FIRST: Duration = Duration::from_secs(900);

/// See the module.
#[derive(Debug)]
pub struct PairTimes(Mutex<State>);

#[derive(Debug)]
struct State {
    /// What the first pair may take.
    first: Duration,
    /// The longest that a pair with a result has taken.
    longest: Option<Duration>,
    /// Since when each shot is with a worker.
    running: BTreeMap<u64, Instant>,
}

/// A pair that takes too long.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct HungPair {
    /// Its shot.
    pub shot: u64,
    /// How long it has taken until now.
    pub taken: Duration,
    /// How long it may take.
    pub allowed: Duration,
}

impl fmt::Display for HungPair {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { shot, taken, allowed } = self;
        let (taken, allowed) = (taken.as_secs_f64(), allowed.as_secs_f64());
        write!(
            f,
            "the worker of shot {shot} hangs: it has had the pair for {taken:.1} s, and {allowed:.1} \
             s are allowed (pipeline.first_pair_patience_s)"
        )
    }
}

impl Default for PairTimes {
    fn default() -> Self {
        Self::new(FIRST)
    }
}

impl PairTimes {
    /// The first pair may take so long.
    pub fn new(first: Duration) -> Self {
        let (longest, running) = (None, BTreeMap::new());
        Self(Mutex::new(State { first, longest, running }))
    }

    /// A worker is given a pair.
    pub fn begin(&self, shot: u64, now: Instant) {
        self.0.lock().running.insert(shot, now);
    }

    /// The worker is done with it. What gave no result says nothing of how long one takes.
    pub fn end(&self, shot: u64, now: Instant, has_result: bool) {
        let mut state = self.0.lock();
        let Some(began) = state.running.remove(&shot).filter(|_| has_result) else { return };
        let taken = now.saturating_duration_since(began);
        state.longest = state.longest.max(Some(taken));
    }

    /// The pair that takes too long, and has for longest.
    pub fn hung(&self, now: Instant) -> Option<HungPair> {
        let state = self.0.lock();
        let allowed = state.longest.map_or(state.first, |longest| LEAST.max(ALLOWANCE * longest));
        let (shot, began) = state.running.iter().min_by_key(|(_, began)| **began)?;
        let taken = now.saturating_duration_since(*began);
        (taken > allowed).then_some(HungPair { shot: *shot, taken, allowed })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const S: Duration = Duration::from_secs(1);

    #[test]
    fn a_pair_may_take_ten_times_as_long_as_the_longest_before_it() {
        let (times, began) = (PairTimes::new(200 * S), Instant::now());
        let hung = |at_s: u32| times.hung(began + at_s * S).map(|hung| (hung.shot, hung.allowed));
        assert_eq!(hung(10_000), None, "nothing is being measured");
        times.begin(0, began);
        assert_eq!(hung(200), None);
        assert_eq!(hung(201), Some((0, 200 * S)));
        times.end(0, began + 20 * S, true);
        // A shorter one changes nothing.
        times.begin(1, began + 20 * S);
        times.end(1, began + 21 * S, true);
        times.begin(2, began + 100 * S);
        assert_eq!(hung(300), None);
        assert_eq!(hung(301), Some((2, 200 * S)));
        times.begin(3, began + 250 * S);
        assert_eq!(hung(301), Some((2, 200 * S)), "the one that began first");
    }

    #[test]
    fn quick_pairs_leave_a_minute_and_failed_ones_say_nothing() {
        let (times, began) = (PairTimes::new(200 * S), Instant::now());
        times.begin(0, began);
        times.end(0, began, false);
        times.begin(1, began);
        assert_eq!(times.hung(began + 200 * S), None);
        times.end(1, began, true);
        times.begin(2, began);
        assert_eq!(times.hung(began + LEAST), None);
        assert_eq!(times.hung(began + LEAST + S).map(|hung| hung.shot), Some(2));
    }
}
