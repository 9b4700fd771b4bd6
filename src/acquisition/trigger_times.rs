//! When triggers were given, in UTC: what the run loop saw leaves them little room.
//!
//! A trigger lies between two bounds. It cannot be earlier than the command that started its burst,
//! plus the periods before it. It cannot be later than the host received frame a, less the exposure
//! that ended before; and where the synchroniser makes the triggers itself, no later than the
//! bounds of the burst's earlier ones, plus the periods between. Nothing tells the times between
//! the bounds apart, so the time is their middle, with the standard deviation of a uniform
//! distribution, width / √12 (JCGM 100:2008, 4.3.7). The error of the host's clock against UTC,
//! where the kernel knows a bound of it, is added in quadrature.
//!
//! The bounds are times of the run's clock, which never jumps. A [`ClockPair`] per burst says what
//! UTC is; records of journal version 1 have none, and the host times of frames stand in for it.
//!
//! [`TriggerTimes`] reads the entries of the journal: a run, its replay and whoever reads its
//! record find the same times.

use lfpiv_hw::PulseSchedule;
use serde::{Deserialize, Serialize};

use super::journal::Entry;
use crate::archive::ShotTime;

/// By how much the rates of two quartz clocks may differ: the synchroniser's and the host's.
const QUARTZ_RATE: f64 = 1e-4;

/// The run's clock and UTC at one moment.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
pub struct ClockPair {
    /// The run's clock: ns since the run began.
    pub at_ns: u64,
    /// The host's clock: ns since 1970-01-01T00:00:00Z.
    pub utc_ns: u64,
    /// Largest error of the host's clock that the kernel believes possible, in ns; absent where
    /// it is not known to be synchronised.
    pub clock_error_ns: Option<u64>,
}

impl ClockPair {
    /// How far UTC is ahead of the run's clock, in ns.
    fn ahead_ns(self) -> i128 {
        i128::from(self.utc_ns) - i128::from(self.at_ns)
    }
}

/// How a burst began.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
pub struct BurstStart {
    /// Its first trigger was not given before, in ns of the run's clock.
    pub not_before_ns: u64,
    /// UTC when the unit had accepted the burst; absent where the run's clock is not the host's.
    pub clock: Option<ClockPair>,
}

/// See the module.
#[derive(Debug, Default)]
pub(super) struct TriggerTimes {
    grid: Option<Grid>,
    burst: Option<Burst>,
    /// The time of the last frame.
    now_ns: i128,
}

/// What the schedule says of the triggers of a burst.
#[derive(Debug, Clone, Copy)]
struct Grid {
    /// Least time between triggers, in ns.
    period_ns: f64,
    /// Whether they come after exactly that time.
    is_regular: bool,
    /// End of exposure 1 after the trigger, in ns.
    exposed_ns: i128,
}

#[derive(Debug, Clone, Copy)]
struct Burst {
    first: u64,
    not_before_ns: i128,
    /// When the unit had accepted it, by the run's clock.
    accepted_ns: Option<i128>,
    utc: Option<Utc>,
    /// A trigger, and what it was not given after.
    bound: Option<(u64, i128)>,
}

/// What the host's clock shows.
#[derive(Debug, Clone, Copy)]
struct Utc {
    /// Less the run's clock, in ns.
    ahead_ns: i128,
    clock_error_ns: Option<u64>,
    /// From frames' host times, which are earlier than their arrival: never too late.
    is_from_frames: bool,
}

impl TriggerTimes {
    /// Takes an entry in, in the order of the journal.
    pub fn see(&mut self, entry: &Entry) {
        match entry {
            Entry::Programmed { schedule, .. } => self.grid = Some(Grid::of(schedule)),
            Entry::Fired { at_ns, first, .. } => {
                let not_before_ns = i128::from(*at_ns);
                let (accepted_ns, utc, bound) = (None, None, None);
                let first = *first;
                self.burst = Some(Burst { first, not_before_ns, accepted_ns, utc, bound });
            }
            Entry::BurstStarted { start, .. } => {
                if let Some(burst) = &mut self.burst {
                    burst.started(start);
                }
            }
            Entry::Frame { at_ns, frame, .. } => {
                self.now_ns = i128::from(*at_ns);
                let ahead_ns = i128::from(frame.host_timestamp_ns) - self.now_ns;
                let has_host_time = frame.host_timestamp_ns != 0;
                if let Some(burst) = self.burst.as_mut().filter(|_| has_host_time) {
                    burst.frame_received(ahead_ns);
                }
            }
            _ => {}
        }
    }

    /// When a trigger of the burst on its way is given, while no frame of it has come; `None` where
    /// the source of triggers is another than the synchroniser.
    pub fn expected(&self, trigger: u64) -> Option<ShotTime> {
        let (grid, burst) = (self.grid.filter(|grid| grid.is_regular)?, self.burst?);
        let after = trigger.checked_sub(burst.first)?;
        let earliest_ns = burst.not_before_ns + grid.least_ns(after);
        let latest_ns = burst.accepted_ns? + grid.most_ns(after + 1);
        Some(between(earliest_ns, latest_ns, burst.utc?))
    }

    /// When the trigger of a shot was given; `received_ns` are the host times of its frames a.
    pub fn of_shot(
        &mut self,
        trigger: u64,
        received_ns: impl IntoIterator<Item = u64>,
    ) -> Option<ShotTime> {
        let (grid, burst) = (self.grid?, self.burst.as_mut()?);
        let after = trigger.checked_sub(burst.first)?;
        let utc = burst.utc?;
        // A host time beyond these was taken while the host's clock was set.
        let received_ns = received_ns.into_iter().map(|host_ns| i128::from(host_ns) - utc.ahead_ns);
        let received_ns = received_ns.filter(|at_ns| *at_ns >= burst.not_before_ns).min();
        let received_ns = received_ns.unwrap_or(self.now_ns).min(self.now_ns);
        let mut latest_ns = received_ns - grid.exposed_ns;
        if grid.is_regular {
            if let Some((earlier, bound_ns)) = burst.bound.filter(|bound| bound.0 <= trigger) {
                latest_ns = latest_ns.min(bound_ns + grid.most_ns(trigger - earlier));
            }
            burst.bound = Some((trigger, latest_ns));
        }
        let earliest_ns = burst.not_before_ns + grid.least_ns(after);
        // Frames that come before the schedule has them: it is not kept, and says nothing.
        let earliest_ns =
            if earliest_ns <= latest_ns { earliest_ns } else { burst.not_before_ns.min(latest_ns) };
        Some(between(earliest_ns, latest_ns, utc))
    }
}

impl Grid {
    fn of(schedule: &PulseSchedule) -> Self {
        Self {
            period_ns: schedule.shortest_period_us() * 1e3,
            is_regular: schedule.external_trigger.is_none(),
            exposed_ns: (schedule.exposure_1_us[1] * 1e3) as i128,
        }
    }

    /// So many periods last no shorter, in ns.
    fn least_ns(self, periods: u64) -> i128 {
        (periods as f64 * self.period_ns * (1.0 - QUARTZ_RATE)) as i128
    }

    /// So many periods last no longer, in ns.
    fn most_ns(self, periods: u64) -> i128 {
        (periods as f64 * self.period_ns * (1.0 + QUARTZ_RATE)) as i128
    }
}

impl Burst {
    fn started(&mut self, start: &BurstStart) {
        self.not_before_ns = i128::from(start.not_before_ns);
        if let Some(pair) = start.clock {
            self.accepted_ns = Some(i128::from(pair.at_ns));
            let (ahead_ns, clock_error_ns) = (pair.ahead_ns(), pair.clock_error_ns);
            self.utc = Some(Utc { ahead_ns, clock_error_ns, is_from_frames: false });
        }
    }

    /// The frame that was seen soonest after its host time says most about UTC.
    fn frame_received(&mut self, ahead_ns: i128) {
        let known = self.utc.is_some_and(|utc| !utc.is_from_frames || utc.ahead_ns >= ahead_ns);
        if !known {
            self.utc = Some(Utc { ahead_ns, clock_error_ns: None, is_from_frames: true });
        }
    }
}

/// The time of a trigger that lies between two times of the run's clock.
fn between(earliest_ns: i128, latest_ns: i128, utc: Utc) -> ShotTime {
    let width_ns = (latest_ns - earliest_ns) as f64;
    let clock_ns = utc.clock_error_ns.unwrap_or(0) as f64;
    // Both are bounds of uniform distributions: half-width / √3.
    let uncertainty_ns = (width_ns / 2.0).hypot(clock_ns) / 3.0_f64.sqrt();
    let middle_ns = earliest_ns + (latest_ns - earliest_ns) / 2 + utc.ahead_ns;
    ShotTime {
        utc_ns: i64::try_from(middle_ns).unwrap_or(i64::MAX),
        uncertainty_ns: uncertainty_ns.round() as u64,
        clock_synchronised: utc.clock_error_ns.is_some(),
    }
}

#[cfg(test)]
mod tests;
