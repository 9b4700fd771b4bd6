//! Processing times of pairs, to detect hung workers.
//!
//! The expected time depends on volume, seeding and machine. The limit therefore follows from the
//! longest pair so far that gave a result, and from the configuration before there is one. The
//! current time is passed in.

use std::{
    collections::BTreeMap,
    fmt,
    time::{Duration, Instant},
};

use parking_lot::Mutex;

/// Limit in multiples of the longest pair so far: seeding may change, and other programs may run.
const LIMIT_FACTOR: u32 = 10;
/// Lower bound of the limit.
const MIN_LIMIT: Duration = Duration::from_secs(60);
/// Default limit of the first pair.
const DEFAULT_FIRST_LIMIT: Duration = Duration::from_secs(900);

/// See the module.
#[derive(Debug)]
pub struct PairTimes(Mutex<State>);

#[derive(Debug)]
struct State {
    /// Limit of the first pair.
    first: Duration,
    /// Longest time of a pair with a result.
    longest: Option<Duration>,
    /// Start time of each shot in process.
    running: BTreeMap<u64, Instant>,
}

/// A pair that exceeds its limit.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct HungPair {
    /// Its shot number.
    pub shot: u64,
    /// Time taken so far.
    pub taken: Duration,
    /// Its limit.
    pub allowed: Duration,
}

impl fmt::Display for HungPair {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { shot, taken, allowed } = self;
        let (taken, allowed) = (taken.as_secs_f64(), allowed.as_secs_f64());
        write!(
            f,
            "the worker of shot {shot} hangs: it has taken {taken:.1} s, and {allowed:.1} \
             s are allowed (pipeline.first_pair_patience_s)"
        )
    }
}

impl Default for PairTimes {
    fn default() -> Self {
        Self::new(DEFAULT_FIRST_LIMIT)
    }
}

impl PairTimes {
    /// With this limit for the first pair.
    pub fn new(first: Duration) -> Self {
        let (longest, running) = (None, BTreeMap::new());
        Self(Mutex::new(State { first, longest, running }))
    }

    /// Records that a worker has started a pair.
    pub fn begin(&self, shot: u64, now: Instant) {
        self.0.lock().running.insert(shot, now);
    }

    /// Records that a pair is done. A pair without a result does not change the limit.
    pub fn end(&self, shot: u64, now: Instant, has_result: bool) {
        let mut state = self.0.lock();
        let Some(began) = state.running.remove(&shot).filter(|_| has_result) else { return };
        let taken = now.saturating_duration_since(began);
        state.longest = state.longest.max(Some(taken));
    }

    /// The hung pair that has been running longest.
    pub fn hung(&self, now: Instant) -> Option<HungPair> {
        let state = self.0.lock();
        let allowed =
            state.longest.map_or(state.first, |longest| MIN_LIMIT.max(LIMIT_FACTOR * longest));
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
        // A shorter time changes nothing.
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
        assert_eq!(times.hung(began + MIN_LIMIT), None);
        assert_eq!(times.hung(began + MIN_LIMIT + S).map(|hung| hung.shot), Some(2));
    }
}
