//! A model of a camera and its driver's frame numbers.

use std::time::Duration;

use lfpiv_hw::gige::FrameIds;
use rand::{Rng, RngExt};

pub const PERIOD: Duration = Duration::from_millis(100);
pub const INTERVAL_NS: u64 = 202_000;

/// The true identity of a frame, encoded in its only pixel.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub struct FrameTruth {
    pub trigger: u64,
    pub camera: usize,
    pub half: usize,
}

impl FrameTruth {
    /// Number of triggers that a pixel can encode.
    pub const TRIGGERS: u64 = 1 << 14;

    pub fn count(self) -> u16 {
        assert!(self.trigger < Self::TRIGGERS && self.camera < 2 && self.half < 2);
        (self.trigger as u16) << 2 | (self.camera as u16) << 1 | self.half as u16
    }

    pub fn of_count(count: u16) -> Self {
        let (trigger, camera) = (u64::from(count >> 2), usize::from(count >> 1 & 1));
        Self { trigger, camera, half: usize::from(count & 1) }
    }
}

pub struct ModelCamera {
    pub ids: FrameIds,
    pub underruns: u64,
    pub gone_at: Option<Duration>,
    /// Reading of the clock at `clock_set`, its rate, and the jitter of timestamps.
    clock_ns: i128,
    clock_set: Duration,
    rate: f64,
    jitter_ns: i128,
    /// 16-bit counter that skips 0.
    counter: u64,
}

impl ModelCamera {
    /// The clock is up to 100 ppm off; the counter wraps within a few thousand frames.
    pub fn new(random: &mut impl Rng) -> Self {
        Self {
            ids: FrameIds::starting_at(0),
            underruns: 0,
            gone_at: None,
            clock_ns: random.random_range(10_000_000_000_000..1_000_000_000_000_000_000),
            clock_set: Duration::ZERO,
            rate: random.random_range(-1e-4..1e-4),
            jitter_ns: random.random_range(0..3000),
            counter: random.random_range(63_000..=65_535),
        }
    }

    /// Sets rate and jitter of the clock; its offset stays random.
    pub fn set_clock(&mut self, rate: f64, jitter_ns: i128) {
        (self.rate, self.jitter_ns) = (rate, jitter_ns);
    }

    /// Counters and timestamps of the two frames of a trigger.
    pub fn expose(&mut self, at: Duration, random: &mut impl Rng) -> [(u64, u64); 2] {
        let elapsed_ns = (at - self.clock_set).as_nanos() as i128;
        let drift_ns = (elapsed_ns as f64 * self.rate) as i128;
        let jitter_ns = random.random_range(-self.jitter_ns..=self.jitter_ns);
        let first_ns = (self.clock_ns + elapsed_ns + drift_ns + jitter_ns) as u64;
        [first_ns, first_ns + INTERVAL_NS].map(|timestamp_ns| (self.count(), timestamp_ns))
    }

    fn count(&mut self) -> u64 {
        let shown = self.counter;
        self.counter = if shown == 65_535 { 1 } else { shown + 1 };
        shown
    }

    /// Sets the clock by a fraction of a period or a little more; never by whole periods, which look
    /// like missed triggers.
    pub fn jump(&mut self, random: &mut impl Rng) {
        let period_ns = PERIOD.as_nanos() as i128;
        let by_ns = if random.random_bool(0.5) {
            let whole = random.random_range(-30..30);
            (100 * whole + random.random_range(20..80)) * period_ns / 100
        } else {
            either_way(random, 100_000, 10_000_000)
        };
        self.clock_ns += if self.clock_ns + by_ns > 1_000_000_000 { by_ns } else { -by_ns };
    }

    /// A power cycle: clock and counter restart, and the driver continues its numbering.
    pub fn restart(&mut self, now: Duration, random: &mut impl Rng) {
        self.clock_ns = random.random_range(5_000_000_000..30_000_000_000);
        self.clock_set = now;
        self.counter = random.random_range(1..=65_535);
        self.ids.resume(2);
        self.gone_at = None;
    }
}

/// A random number with magnitude `least` to `most` and random sign.
pub fn either_way(random: &mut impl Rng, least: i128, most: i128) -> i128 {
    let size = random.random_range(least..most);
    if random.random_bool(0.5) { size } else { -size }
}
