//! The triggers of the simulated synchroniser. Time is passed in.

use std::{collections::VecDeque, sync::Arc};

use lfpiv_hw::PulseSchedule;

/// How simulated time advances.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Pacing {
    /// Triggers and frames follow the schedule on the host's clock. A frame is late if rendering it
    /// takes longer than the schedule allows.
    RealTime,
    /// A trigger is given once every started camera has delivered the frames of the trigger
    /// [`LEAD`] before it. Device timestamps are those of a bench on schedule.
    AsFramesAreTaken,
}

/// Number of triggers that a camera may be ahead of the slowest one when frames set the pace.
pub const LEAD: u64 = 2;

/// One trigger of the cameras.
#[derive(Debug, Clone)]
pub(crate) struct Trigger {
    /// Number since the schedule was programmed: the displayed shot.
    pub(crate) shot: u64,
    /// T0 on the bench's clock, in ns.
    pub(crate) t0_ns: u64,
    /// The schedule it follows.
    pub(crate) schedule: Arc<PulseSchedule>,
}

impl Trigger {
    /// A time in µs after T0, converted to the bench's clock in ns.
    pub(crate) fn at_ns(&self, after_t0_us: f64) -> u64 {
        self.t0_ns.saturating_add_signed((after_t0_us * 1000.0).round() as i64)
    }
}

/// A series of triggers, one per period.
#[derive(Debug)]
struct Burst {
    /// Number of its first trigger since the bench was connected.
    first: u64,
    first_shot: u64,
    shots: u64,
    start_ns: u64,
    schedule: Arc<PulseSchedule>,
    /// Ended by [`Triggers::make_safe`], possibly within a period.
    stopped: bool,
}

impl Burst {
    fn t0_ns(&self, number: u64) -> u64 {
        let periods = (number - self.first) as f64;
        self.start_ns + (periods * self.schedule.period_us * 1000.0).round() as u64
    }

    /// Number of the first trigger after it.
    fn end(&self) -> u64 {
        self.first + self.shots
    }

    fn end_ns(&self) -> u64 {
        self.t0_ns(self.end())
    }

    /// Number of the first trigger after `now_ns`.
    fn reached(&self, now_ns: u64) -> u64 {
        if now_ns < self.start_ns {
            return self.first;
        }
        let periods = (now_ns - self.start_ns) as f64 / (self.schedule.period_us * 1000.0);
        self.first + self.shots.min(periods as u64 + 1)
    }
}

/// Why a burst was not started.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum NotFired {
    NotProgrammed,
    StillFiring,
}

/// All triggers of a simulated bench since it was connected, numbered from zero.
#[derive(Debug)]
pub(crate) struct Triggers {
    pacing: Pacing,
    programmed: Option<Arc<PulseSchedule>>,
    /// Number of the first trigger after the last programming.
    programmed_at: u64,
    bursts: VecDeque<Burst>,
    /// Number of the next trigger.
    given: u64,
    /// End of the last burst on the bench's clock.
    busy_until_ns: u64,
}

impl Triggers {
    pub(crate) fn new(pacing: Pacing) -> Self {
        Self {
            pacing,
            programmed: None,
            programmed_at: 0,
            bursts: VecDeque::new(),
            given: 0,
            busy_until_ns: 0,
        }
    }

    pub(crate) fn pacing(&self) -> Pacing {
        self.pacing
    }

    pub(crate) fn is_programmed(&self) -> bool {
        self.programmed.is_some()
    }

    /// Sets the schedule; shots count from zero again.
    pub(crate) fn program(&mut self, schedule: &PulseSchedule) {
        self.programmed = Some(Arc::new(schedule.clone()));
        self.programmed_at = self.given;
    }

    /// Begins a burst of `shots` periods at `now_ns`.
    pub(crate) fn fire(&mut self, shots: u64, now_ns: u64) -> Result<(), NotFired> {
        if self.firing(now_ns) {
            return Err(NotFired::StillFiring);
        }
        let schedule = self.programmed.clone().ok_or(NotFired::NotProgrammed)?;
        let start_ns = match self.pacing {
            Pacing::RealTime => now_ns,
            Pacing::AsFramesAreTaken => self.busy_until_ns,
        };
        let first_shot = self.given - self.programmed_at;
        let first = self.given;
        let burst = Burst { first, first_shot, shots, start_ns, schedule, stopped: false };
        self.busy_until_ns = burst.end_ns();
        self.bursts.push_back(burst);
        Ok(())
    }

    /// Gives the triggers that are due at `now_ns`. `slowest` is the number of the trigger whose
    /// frames the slowest started camera delivers next; `None` without a started camera.
    pub(crate) fn advance(&mut self, now_ns: u64, slowest: Option<u64>) {
        if let Some(last) = self.bursts.back() {
            let reached = match (self.pacing, slowest) {
                (Pacing::RealTime, _) => last.reached(now_ns),
                (Pacing::AsFramesAreTaken, None) => last.end(),
                (Pacing::AsFramesAreTaken, Some(slowest)) => last.end().min(slowest + LEAD),
            };
            self.given = self.given.max(reached);
        }
        let needed_from = slowest.unwrap_or(self.given);
        while self.bursts.len() > 1 && self.bursts[0].end() <= needed_from {
            self.bursts.pop_front();
        }
    }

    /// Whether a burst is running at `now_ns`.
    pub(crate) fn firing(&self, now_ns: u64) -> bool {
        self.bursts.back().is_some_and(|last| match self.pacing {
            Pacing::RealTime => !last.stopped && now_ns < last.end_ns(),
            Pacing::AsFramesAreTaken => self.given < last.end(),
        })
    }

    /// Cancels pending triggers and discards the schedule. Call [`Triggers::advance`] first.
    pub(crate) fn make_safe(&mut self) {
        self.programmed = None;
        if let Some(last) = self.bursts.back_mut() {
            last.shots = last.shots.min(self.given - last.first);
            last.stopped = true;
            self.busy_until_ns = last.end_ns();
        }
    }

    /// Number of the next trigger.
    pub(crate) fn given(&self) -> u64 {
        self.given
    }

    /// Triggers given since the last programming.
    pub(crate) fn given_since_programmed(&self) -> u64 {
        self.given - self.programmed_at
    }

    /// Trigger `number`, given or, in real time, scheduled; `None` if there is no such trigger.
    pub(crate) fn find(&self, number: u64) -> Option<Trigger> {
        if self.pacing == Pacing::AsFramesAreTaken && number >= self.given {
            return None;
        }
        let burst = self.bursts.iter().find(|b| (b.first..b.end()).contains(&number))?;
        Some(Trigger {
            shot: burst.first_shot + (number - burst.first),
            t0_ns: burst.t0_ns(number),
            schedule: Arc::clone(&burst.schedule),
        })
    }
}

#[cfg(test)]
mod tests {
    use lfpiv_hw::TimingSettings;

    use super::*;

    const PERIOD_NS: u64 = 100_000_000;

    fn schedule() -> PulseSchedule {
        PulseSchedule::plan(&TimingSettings::default(), 100.0, 10.0).unwrap()
    }

    fn programmed(pacing: Pacing) -> Triggers {
        let mut triggers = Triggers::new(pacing);
        triggers.program(&schedule());
        triggers
    }

    #[test]
    fn real_time_triggers_come_once_a_period_and_stop_by_themselves() {
        let mut triggers = programmed(Pacing::RealTime);
        let start = 5 * PERIOD_NS;
        triggers.fire(3, start).unwrap();
        for (after, given, firing) in [
            (0, 1, true),
            (PERIOD_NS - 1, 1, true),
            (PERIOD_NS, 2, true),
            (3 * PERIOD_NS, 3, false),
        ] {
            triggers.advance(start + after, Some(0));
            assert_eq!((triggers.given(), triggers.firing(start + after)), (given, firing));
        }
        assert_eq!(triggers.find(2).unwrap().t0_ns, start + 2 * PERIOD_NS);
        assert!(triggers.find(3).is_none());
        assert_eq!(triggers.find(1).unwrap().at_ns(-3.5), start + PERIOD_NS - 3500);
    }

    #[test]
    fn a_burst_is_refused_without_schedule_or_during_another() {
        let mut triggers = Triggers::new(Pacing::RealTime);
        assert_eq!(triggers.fire(1, 0), Err(NotFired::NotProgrammed));
        triggers.program(&schedule());
        triggers.fire(2, 0).unwrap();
        assert_eq!(triggers.fire(1, PERIOD_NS), Err(NotFired::StillFiring));
        triggers.advance(2 * PERIOD_NS, None);
        triggers.fire(1, 2 * PERIOD_NS).unwrap();
        assert_eq!(triggers.find(2).unwrap().shot, 2);
    }

    #[test]
    fn made_safe_a_burst_ends_with_the_triggers_already_given() {
        let mut triggers = programmed(Pacing::RealTime);
        triggers.fire(10, 0).unwrap();
        triggers.advance(4 * PERIOD_NS, Some(0));
        triggers.make_safe();
        assert_eq!(triggers.given_since_programmed(), 5);
        assert!(!triggers.firing(4 * PERIOD_NS));
        assert!(triggers.find(4).is_some() && triggers.find(5).is_none());
        triggers.advance(20 * PERIOD_NS, Some(0));
        assert_eq!(triggers.given(), 5);
        assert!(!triggers.firing(20 * PERIOD_NS));
        assert_eq!(triggers.fire(1, 20 * PERIOD_NS), Err(NotFired::NotProgrammed));
    }

    #[test]
    fn frames_taken_set_the_pace_but_not_the_timestamps() {
        let mut triggers = programmed(Pacing::AsFramesAreTaken);
        triggers.fire(5, 123).unwrap();
        triggers.advance(123, Some(0));
        assert_eq!(triggers.given(), LEAD);
        assert!(triggers.find(LEAD).is_none());
        triggers.advance(123, Some(4));
        assert_eq!((triggers.given(), triggers.firing(123)), (5, false));
        triggers.fire(1, 123).unwrap();
        triggers.advance(123, Some(5));
        assert_eq!(triggers.find(5).unwrap().t0_ns, 5 * PERIOD_NS);
        // Without cameras nothing limits the burst.
        triggers.fire(7, 123).unwrap();
        triggers.advance(123, None);
        assert_eq!(triggers.given(), 13);
    }

    #[test]
    fn programming_again_counts_shots_from_zero() {
        let mut triggers = programmed(Pacing::AsFramesAreTaken);
        triggers.fire(3, 0).unwrap();
        triggers.advance(0, None);
        triggers.program(&schedule());
        assert_eq!(triggers.given_since_programmed(), 0);
        triggers.fire(1, 0).unwrap();
        triggers.advance(0, None);
        assert_eq!((triggers.find(3).unwrap().shot, triggers.given()), (0, 4));
    }
}
