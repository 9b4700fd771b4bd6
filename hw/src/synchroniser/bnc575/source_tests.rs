use proptest::prelude::*;

use super::*;
use crate::device::WATCH_INTERVAL;

/// A source with known triggers, and the monitor that reads its count.
struct Watched {
    begun: Instant,
    source: SourceRate,
}

impl Watched {
    fn new(max_rate_hz: f64) -> Self {
        let begun = Instant::now();
        let first = Reading { asked: begun, answered: begun, count: 1000 };
        Self { begun, source: SourceRate::new(max_rate_hz, first) }
    }

    /// Queries the unit after `at_s`; the reply arrives `latency_s` later.
    fn read(&mut self, at_s: f64, latency_s: f64, count: u64) {
        let after = |seconds| self.begun + Duration::from_secs_f64(seconds);
        let (asked, answered) = (after(at_s), after(at_s + latency_s));
        self.source.add(Reading { asked, answered, count: 1000 + count });
    }

    /// Reads the count of a regular source every [`WATCH_INTERVAL`] until `until_s`.
    fn even(rate_hz: f64, max_rate_hz: f64, until_s: f64) -> Self {
        let mut watched = Self::new(max_rate_hz);
        for at_s in looks(until_s) {
            watched.read(at_s, 0.01, (rate_hz * at_s) as u64);
        }
        watched
    }
}

fn looks(until_s: f64) -> impl Iterator<Item = f64> {
    let step_s = WATCH_INTERVAL.as_secs_f64();
    (1..).map(move |look| f64::from(look) * step_s).take_while(move |at_s| *at_s <= until_s)
}

#[test]
fn only_three_seconds_at_the_declared_rate_confirm() {
    assert!(Watched::even(10.0, 10.0, 3.0).source.is_confirmed());
    assert!(Watched::even(0.5, 10.0, 3.0).source.is_confirmed());
    assert!(!Watched::even(0.0, 10.0, 60.0).source.is_confirmed());
    assert!(!Watched::even(10.0, 10.0, 2.5).source.is_confirmed());
    assert!(!Watched::even(11.0, 10.0, 3.0).source.is_confirmed());
    // Waiting and asking once gives the same result.
    let mut waited = Watched::new(10.0);
    assert_eq!(waited.source.wait(waited.begun + Duration::from_secs(1)), Duration::from_secs(2));
    waited.read(3.2, 0.01, 30);
    assert!(waited.source.is_confirmed() && waited.source.wait(waited.begun).is_zero());
}

#[test]
fn after_an_hour_at_nine_hertz_thirty_hertz_show_at_the_next_look() {
    let mut watched = Watched::even(9.0, 10.0, 3600.0);
    assert!(watched.source.is_confirmed() && !watched.source.is_exceeded());
    assert!(watched.source.readings.len() <= 8, "no more than the window is kept");
    let count = 9 * 3600;
    watched.read(3600.5, 0.01, count + 15);
    assert!(watched.source.is_exceeded(), "{}", watched.source.describe());
    assert!(watched.source.describe().contains("external triggers in 0.5"));
}

#[test]
fn an_excess_is_detected_after_a_pause_of_the_triggers() {
    // T0 is stopped while a burst is prepared, and the source is faster afterwards.
    let mut watched = Watched::new(10.0);
    watched.read(0.5, 0.01, 0);
    watched.read(2.0, 0.01, 0);
    watched.read(2.5, 0.01, 15);
    assert!(watched.source.is_exceeded());
}

#[test]
fn a_counter_reset_restarts_counting() {
    let mut watched = Watched::even(10.0, 10.0, 4.0);
    let after = |seconds| watched.begun + Duration::from_secs_f64(seconds);
    let set_back = Reading { asked: after(4.5), answered: after(4.51), count: 3 };
    let garbled = Reading { count: 91_040, ..set_back };
    let next = Reading { count: 1045, ..set_back };
    assert!(watched.source.expects(next));
    assert!(!watched.source.expects(set_back) && !watched.source.expects(garbled));
    watched.source.add(set_back);
    assert!(watched.source.is_confirmed() && !watched.source.is_exceeded());
}

proptest! {
    /// Triggers within the declared rate, read at arbitrary times over a line of arbitrary latency,
    /// never count as an excess.
    #[test]
    fn a_source_within_its_declared_rate_never_counts_as_too_fast(
        max_rate_hz in 0.5_f64..100.0,
        pauses in prop::collection::vec(1.0_f64..3.0, 1..400),
        looks in prop::collection::vec((0.02_f64..2.0, 0.0_f64..0.5, 0.0_f64..1.0), 1..40),
    ) {
        let mut at_s = 0.0;
        let triggers: Vec<f64> = pauses.iter().map(|pause| { at_s += pause / max_rate_hz; at_s })
            .collect();
        let mut watched = Watched::new(max_rate_hz);
        let mut asked_s = 0.0;
        for (pause_s, latency_s, moment) in looks {
            asked_s += pause_s;
            let read_s = asked_s + moment * latency_s;
            let count = triggers.iter().filter(|trigger| **trigger <= read_s).count();
            watched.read(asked_s, latency_s, count as u64);
            asked_s += latency_s;
            prop_assert!(!watched.source.is_exceeded(), "{}", watched.source.describe());
        }
    }

    /// After any history within the declared rate, three times the rate is detected within 2.5 s.
    #[test]
    fn three_times_the_declared_rate_shows_at_once(
        max_rate_hz in 1.0_f64..100.0,
        before in 0.0_f64..1.0,
        before_s in 0.0_f64..600.0,
        latency_s in 0.0_f64..0.1,
    ) {
        let triggers = |at_s: f64| {
            let slow = before * max_rate_hz * at_s.min(before_s);
            (slow + 3.0 * max_rate_hz * (at_s - before_s).max(0.0)) as u64
        };
        let mut watched = Watched::new(max_rate_hz);
        for at_s in looks(before_s) {
            watched.read(at_s, latency_s, triggers(at_s));
            prop_assert!(!watched.source.is_exceeded(), "{}", watched.source.describe());
        }
        let seen = looks(before_s + 2.5).filter(|at_s| *at_s > before_s).any(|at_s| {
            watched.read(at_s, latency_s, triggers(at_s));
            watched.source.is_exceeded()
        });
        prop_assert!(seen, "{}", watched.source.describe());
    }
}
