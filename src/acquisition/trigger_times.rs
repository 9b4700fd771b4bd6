//! The UTC time of triggers, bounded by the events of the run loop.
//!
//! Lower bound: the command that started the burst, plus the periods before the trigger. Upper
//! bound: the host's reception of frame a, minus the end of exposure 1; if the synchroniser makes
//! the triggers itself, also the upper bounds of the burst's earlier triggers, plus the periods in
//! between. All times between the bounds are equally likely, so the result is their midpoint, with
//! the standard deviation of a uniform distribution, width / √12 (JCGM 100:2008, 4.3.7). The error
//! bound of the host's clock against UTC, if the kernel knows one, is added in quadrature.
//!
//! The bounds are on the run's clock, which never jumps. One [`ClockPair`] per burst converts to
//! UTC. Records of journal version 1 have none, and use the host times of frames instead.
//!
//! [`TriggerTimes`] folds over the journal's entries, so that a run, its replay and later processing
//! find the same times.

use lfpiv_hw::PulseSchedule;
use serde::{Deserialize, Serialize};

use super::journal::Entry;
use crate::archive::ShotTime;

/// Largest relative rate difference of two quartz clocks: the synchroniser's and the host's.
const QUARTZ_RATE: f64 = 1e-4;

/// The run's clock and UTC at one moment.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
pub struct ClockPair {
    /// The run's clock: ns since the run began.
    pub at_ns: u64,
    /// The host's clock: ns since 1970-01-01T00:00:00Z.
    pub utc_ns: u64,
    /// Maximum error of the host's clock according to the kernel, in ns; absent if it is not
    /// synchronised.
    pub clock_error_ns: Option<u64>,
}

impl ClockPair {
    /// UTC minus the run's clock, in ns.
    fn utc_offset_ns(self) -> i128 {
        i128::from(self.utc_ns) - i128::from(self.at_ns)
    }
}

/// How a burst began.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
pub struct BurstStart {
    /// Its first trigger was given no earlier than this, in ns on the run's clock.
    pub not_before_ns: u64,
    /// UTC when the unit accepted the burst; absent if the run's clock is not the host's.
    pub clock: Option<ClockPair>,
}

/// See the module.
#[derive(Debug, Default)]
pub(super) struct TriggerTimes {
    grid: Option<TriggerTiming>,
    burst: Option<BurstTiming>,
    /// The time of the last frame.
    now_ns: i128,
}

/// Timing of a burst's triggers according to the schedule.
#[derive(Debug, Clone, Copy)]
struct TriggerTiming {
    /// Shortest time between triggers, in ns.
    period_ns: f64,
    /// Whether the period is exact.
    is_regular: bool,
    /// End of exposure 1 after the trigger, in ns.
    exposure_end_ns: i128,
}

#[derive(Debug, Clone, Copy)]
struct BurstTiming {
    first: u64,
    not_before_ns: i128,
    /// When the unit had accepted it, on the run's clock.
    accepted_ns: Option<i128>,
    utc: Option<Utc>,
    /// A trigger and its upper bound.
    bound: Option<(u64, i128)>,
}

/// The relation between UTC and the run's clock.
#[derive(Debug, Clone, Copy)]
struct Utc {
    /// UTC minus the run's clock, in ns.
    utc_offset_ns: i128,
    clock_error_ns: Option<u64>,
    /// Derived from host times of frames, which precede their arrival: never too late.
    is_from_frames: bool,
}

impl TriggerTimes {
    /// Processes the next entry of the journal.
    pub fn see(&mut self, entry: &Entry) {
        match entry {
            Entry::Programmed { schedule, .. } => self.grid = Some(TriggerTiming::of(schedule)),
            Entry::Fired { at_ns, first, .. } => {
                let not_before_ns = i128::from(*at_ns);
                let (accepted_ns, utc, bound) = (None, None, None);
                let first = *first;
                self.burst = Some(BurstTiming { first, not_before_ns, accepted_ns, utc, bound });
            }
            Entry::BurstStarted { start, .. } => {
                if let Some(burst) = &mut self.burst {
                    burst.started(start);
                }
            }
            Entry::Frame { at_ns, frame, .. } => {
                self.now_ns = i128::from(*at_ns);
                let utc_offset_ns = i128::from(frame.host_timestamp_ns) - self.now_ns;
                let has_host_time = frame.host_timestamp_ns != 0;
                if let Some(burst) = self.burst.as_mut().filter(|_| has_host_time) {
                    burst.frame_received(utc_offset_ns);
                }
            }
            _ => {}
        }
    }

    /// Expected time of a trigger of the current burst of which no frame has arrived. `None` if the
    /// triggers come from an external source.
    pub fn expected(&self, trigger: u64) -> Option<ShotTime> {
        let (grid, burst) = (self.grid.filter(|grid| grid.is_regular)?, self.burst?);
        let after = trigger.checked_sub(burst.first)?;
        let earliest_ns = burst.not_before_ns + grid.min_duration_ns(after);
        let latest_ns = burst.accepted_ns? + grid.max_duration_ns(after + 1);
        Some(between(earliest_ns, latest_ns, burst.utc?))
    }

    /// The time of a shot's trigger; `received_ns` are the host times of its frames a.
    pub fn of_shot(
        &mut self,
        trigger: u64,
        received_ns: impl IntoIterator<Item = u64>,
    ) -> Option<ShotTime> {
        let (grid, burst) = (self.grid?, self.burst.as_mut()?);
        let after = trigger.checked_sub(burst.first)?;
        let utc = burst.utc?;
        // A later host time was taken while the host's clock was being set.
        let received_ns =
            received_ns.into_iter().map(|host_ns| i128::from(host_ns) - utc.utc_offset_ns);
        let received_ns = received_ns.filter(|at_ns| *at_ns >= burst.not_before_ns).min();
        let received_ns = received_ns.unwrap_or(self.now_ns).min(self.now_ns);
        let mut latest_ns = received_ns - grid.exposure_end_ns;
        if grid.is_regular {
            if let Some((earlier, bound_ns)) = burst.bound.filter(|bound| bound.0 <= trigger) {
                latest_ns = latest_ns.min(bound_ns + grid.max_duration_ns(trigger - earlier));
            }
            burst.bound = Some((trigger, latest_ns));
        }
        let earliest_ns = burst.not_before_ns + grid.min_duration_ns(after);
        // Frames that arrive before they are due: the schedule is not kept, and gives no lower bound.
        let earliest_ns =
            if earliest_ns <= latest_ns { earliest_ns } else { burst.not_before_ns.min(latest_ns) };
        Some(between(earliest_ns, latest_ns, utc))
    }
}

impl TriggerTiming {
    fn of(schedule: &PulseSchedule) -> Self {
        Self {
            period_ns: schedule.shortest_period_us() * 1e3,
            is_regular: schedule.external_trigger.is_none(),
            exposure_end_ns: (schedule.exposure_1_us[1] * 1e3) as i128,
        }
    }

    /// Shortest duration of this many periods, in ns.
    fn min_duration_ns(self, periods: u64) -> i128 {
        (periods as f64 * self.period_ns * (1.0 - QUARTZ_RATE)) as i128
    }

    /// Longest duration of this many periods, in ns.
    fn max_duration_ns(self, periods: u64) -> i128 {
        (periods as f64 * self.period_ns * (1.0 + QUARTZ_RATE)) as i128
    }
}

impl BurstTiming {
    fn started(&mut self, start: &BurstStart) {
        self.not_before_ns = i128::from(start.not_before_ns);
        if let Some(pair) = start.clock {
            self.accepted_ns = Some(i128::from(pair.at_ns));
            let (utc_offset_ns, clock_error_ns) = (pair.utc_offset_ns(), pair.clock_error_ns);
            self.utc = Some(Utc { utc_offset_ns, clock_error_ns, is_from_frames: false });
        }
    }

    /// The frame with the shortest delay after its host time gives the best estimate of UTC.
    fn frame_received(&mut self, utc_offset_ns: i128) {
        let known =
            self.utc.is_some_and(|utc| !utc.is_from_frames || utc.utc_offset_ns >= utc_offset_ns);
        if !known {
            self.utc = Some(Utc { utc_offset_ns, clock_error_ns: None, is_from_frames: true });
        }
    }
}

/// Time of a trigger between two bounds on the run's clock.
fn between(earliest_ns: i128, latest_ns: i128, utc: Utc) -> ShotTime {
    let width_ns = (latest_ns - earliest_ns) as f64;
    let clock_ns = utc.clock_error_ns.unwrap_or(0) as f64;
    // Both are bounds of uniform distributions: standard deviation = half-width / √3.
    let uncertainty_ns = (width_ns / 2.0).hypot(clock_ns) / 3.0_f64.sqrt();
    let middle_ns = earliest_ns + (latest_ns - earliest_ns) / 2 + utc.utc_offset_ns;
    ShotTime {
        utc_ns: i64::try_from(middle_ns).unwrap_or(i64::MAX),
        uncertainty_ns: uncertainty_ns.round() as u64,
        clock_synchronised: utc.clock_error_ns.is_some(),
    }
}

#[cfg(test)]
mod tests;
