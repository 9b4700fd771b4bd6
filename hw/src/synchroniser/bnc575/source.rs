//! Rate of an external trigger, from the unit's trigger count.
//!
//! Lamps follow every trigger, so the rate is monitored as long as lamps run. It is measured over a
//! sliding window: an average since arming would react more slowly the longer it has run.

use std::{
    collections::VecDeque,
    time::{Duration, Instant},
};

use super::{
    Bnc575,
    command::{Parameter, Value},
    link::{LinkError, Reading},
};
use crate::device::DeviceError;

/// How long the rate is measured before a Q-switch is enabled.
const CONFIRMATION: Duration = Duration::from_secs(3);
/// Length of the sliding window.
const WINDOW: Duration = Duration::from_secs(3);
/// Tolerance for the rate difference of the host's and the source's clocks.
const TOLERANCE: f64 = 1.01;

/// Triggers within a time interval.
#[derive(Debug, Clone, Copy, PartialEq)]
struct TriggerInterval {
    triggers: u64,
    /// Upper bound of the interval.
    within: Duration,
}

/// Counts of the last [`WINDOW`]. Time is passed in.
#[derive(Debug, Clone)]
pub struct SourceRate {
    max_rate_hz: f64,
    /// Start of uninterrupted counting.
    since: Instant,
    /// In order of time; never empty.
    readings: VecDeque<Reading>,
    /// Triggers were counted for [`CONFIRMATION`] without exceeding the rate.
    confirmed: bool,
}

impl SourceRate {
    /// Starts with the reading `first`.
    pub fn new(max_rate_hz: f64, first: Reading) -> Self {
        let (since, readings) = (first.answered, VecDeque::from([first]));
        Self { max_rate_hz, since, readings, confirmed: false }
    }

    /// Adds a reading. A lower count than the last means that the unit reset its counter: counting
    /// restarts, and the confirmation is kept.
    pub fn add(&mut self, reading: Reading) {
        if self.readings.back().is_some_and(|last| reading.count < last.count) {
            self.since = reading.answered;
            self.readings.clear();
        }
        let age = |old: &Reading| reading.asked.saturating_duration_since(old.answered);
        // After a long pause, the last reading still bounds the triggers since.
        while self.readings.len() > 1 && self.readings.front().is_some_and(|old| age(old) > WINDOW)
        {
            self.readings.pop_front();
        }
        self.readings.push_back(reading);
        let watched = reading.asked.saturating_duration_since(self.since);
        let counted = self.counted_since(self.readings.front());
        if watched >= CONFIRMATION && counted.triggers > 0 && !self.is_exceeded() {
            self.confirmed = true;
        }
    }

    /// Whether the declared rate allows this count.
    pub fn expects(&self, reading: Reading) -> bool {
        let mut then = self.clone();
        then.add(reading);
        let set_back = self.readings.back().is_some_and(|last| reading.count < last.count);
        !set_back && !then.is_exceeded()
    }

    /// Time left until the rate can be confirmed.
    pub fn wait(&self, now: Instant) -> Duration {
        match self.confirmed {
            true => Duration::ZERO,
            false => CONFIRMATION.saturating_sub(now.saturating_duration_since(self.since)),
        }
    }

    pub fn is_confirmed(&self) -> bool {
        self.confirmed
    }

    /// Whether the declared rate was exceeded since some reading of the window.
    pub fn is_exceeded(&self) -> bool {
        self.worst().is_some()
    }

    /// The part of the window with the largest excess of triggers.
    fn worst(&self) -> Option<TriggerInterval> {
        let parts = self.readings.iter().map(|old| self.counted_since(Some(old)));
        let excess =
            |part: &TriggerInterval| part.triggers as f64 - self.max_triggers_within(part.within);
        let worst = parts.max_by(|a, b| excess(a).total_cmp(&excess(b)));
        worst.filter(|part| excess(part) > 0.0)
    }

    /// Most triggers within a time at the declared rate, including both ends.
    fn max_triggers_within(&self, time: Duration) -> f64 {
        time.as_secs_f64() * self.max_rate_hz * TOLERANCE + 1.0
    }

    fn counted_since(&self, old: Option<&Reading>) -> TriggerInterval {
        match (old, self.readings.back()) {
            (Some(old), Some(new)) => TriggerInterval {
                triggers: new.count.saturating_sub(old.count),
                within: new.answered.saturating_duration_since(old.asked),
            },
            _ => TriggerInterval { triggers: 0, within: Duration::ZERO },
        }
    }

    fn describe(&self) -> String {
        let whole = self.counted_since(self.readings.front());
        let TriggerInterval { triggers, within } = self.worst().unwrap_or(whole);
        format!(
            "{triggers} external triggers in {:.2} s: allowed: at most {} per second, as declared",
            within.as_secs_f64(),
            self.max_rate_hz
        )
    }
}

impl Bnc575 {
    /// Reads the count; goes to the safe state if the source is faster than declared.
    pub(super) fn watch_source(&mut self) -> Result<(), DeviceError> {
        let Some(mut source) = self.source.clone() else { return Ok(()) };
        match self.read_expected(&source) {
            Ok(reading) => source.add(reading),
            Err(error) => {
                // Lamps must not run at an unknown rate.
                let error = self.failed(error);
                return self.reach_safe_state().and(Err(error));
            }
        }
        if !source.is_exceeded() {
            self.source = Some(source);
            return Ok(());
        }
        self.reach_safe_state()?;
        let reason = source.describe();
        Err(self.refused(format!("{reason}; lamps and Q-switches are switched off")))
    }

    /// An unexpected count is queried again and then believed: a wrong digit on the line is not a
    /// trigger.
    fn read_expected(&mut self, source: &SourceRate) -> Result<Reading, LinkError> {
        let reading = self.link.read_triggers()?;
        match source.expects(reading) {
            true => Ok(reading),
            false => self.link.read_triggers(),
        }
    }

    /// Keeps Q-switches off until the declared rate is confirmed.
    pub(super) fn confirm_source(&mut self) -> Result<(), DeviceError> {
        let external = self.programmed.as_ref().is_some_and(|s| s.external_trigger.is_some());
        if !external {
            return Ok(());
        }
        self.link
            .verify(Parameter::TriggerMode, Value::Keyword("TRIG"))
            .map_err(|error| self.failed(error))?;
        self.watch_source()?;
        match &self.source {
            Some(source) if source.is_confirmed() => Ok(()),
            Some(source) => Err(self.refused(format!(
                "the rate of the external trigger is not confirmed yet, {:.1} s are left; so far \
                 {}; arm, wait, then fire",
                source.wait(self.link.now()).as_secs_f64(),
                source.describe()
            ))),
            None => Err(self.refused(
                "the rate of the external trigger is not confirmed: arm, wait, then fire",
            )),
        }
    }
}

#[cfg(test)]
#[path = "source_tests.rs"]
mod tests;
