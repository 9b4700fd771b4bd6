//! The rate of an external trigger, from the unit's own count of triggers.
//!
//! Lamps follow every trigger, so the rate is watched for as long as lamps run: over a sliding
//! window, because an average since arming hides a change for longer the longer it has run.

use std::{
    collections::VecDeque,
    time::{Duration, Instant},
};

use super::{
    Bnc575,
    command::{Parameter, Value},
    link::LinkError,
};
use crate::device::DeviceError;

/// How long triggers are counted before a Q-switch is enabled.
const CONFIRMATION: Duration = Duration::from_secs(3);
/// How far back a new count is compared with earlier ones.
const WINDOW: Duration = Duration::from_secs(3);
/// How much faster than declared counts may look: the host's and the source's clocks differ.
const TOLERANCE: f64 = 1.01;

/// A count of triggers. The unit took it at some moment between question and answer.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Reading {
    pub asked: Instant,
    pub answered: Instant,
    pub count: u64,
}

/// Triggers that came within some time.
#[derive(Debug, Clone, Copy, PartialEq)]
struct Counted {
    triggers: u64,
    /// The longest time that they can have taken.
    within: Duration,
}

/// Counts of the last [`WINDOW`]. Time is passed in.
#[derive(Debug, Clone)]
pub struct SourceRate {
    max_rate_hz: f64,
    /// Since when triggers have been counted without a break.
    since: Instant,
    /// The newest is the last; there is always one.
    readings: VecDeque<Reading>,
    /// Triggers have come for [`CONFIRMATION`], and not too fast.
    confirmed: bool,
}

impl SourceRate {
    /// Watches from `first` on.
    pub fn new(max_rate_hz: f64, first: Reading) -> Self {
        let (since, readings) = (first.answered, VecDeque::from([first]));
        Self { max_rate_hz, since, readings, confirmed: false }
    }

    /// A new count. One that is lower than the last was set back in the unit and begins anew; what
    /// was confirmed stays so.
    pub fn note(&mut self, reading: Reading) {
        if self.readings.back().is_some_and(|last| reading.count < last.count) {
            self.since = reading.answered;
            self.readings.clear();
        }
        let age = |old: &Reading| reading.asked.saturating_duration_since(old.answered);
        // After too long a pause the last one still says how many came meanwhile.
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

    /// Whether the count can be what a source as declared gives.
    pub fn expects(&self, reading: Reading) -> bool {
        let mut then = self.clone();
        then.note(reading);
        let set_back = self.readings.back().is_some_and(|last| reading.count < last.count);
        !set_back && !then.is_exceeded()
    }

    /// What is left of the time in which triggers are counted first.
    pub fn wait(&self, now: Instant) -> Duration {
        match self.confirmed {
            true => Duration::ZERO,
            false => CONFIRMATION.saturating_sub(now.saturating_duration_since(self.since)),
        }
    }

    pub fn is_confirmed(&self) -> bool {
        self.confirmed
    }

    /// Since some reading of the window more triggers came than the declared rate gives.
    pub fn is_exceeded(&self) -> bool {
        self.worst().is_some()
    }

    /// The part of the window with the most triggers too many.
    fn worst(&self) -> Option<Counted> {
        let parts = self.readings.iter().map(|old| self.counted_since(Some(old)));
        let excess = |part: &Counted| part.triggers as f64 - self.most_within(part.within);
        let worst = parts.max_by(|a, b| excess(a).total_cmp(&excess(b)));
        worst.filter(|part| excess(part) > 0.0)
    }

    /// Most triggers of a source as declared, counting both ends.
    fn most_within(&self, time: Duration) -> f64 {
        time.as_secs_f64() * self.max_rate_hz * TOLERANCE + 1.0
    }

    fn counted_since(&self, old: Option<&Reading>) -> Counted {
        match (old, self.readings.back()) {
            (Some(old), Some(new)) => Counted {
                triggers: new.count.saturating_sub(old.count),
                within: new.answered.saturating_duration_since(old.asked),
            },
            _ => Counted { triggers: 0, within: Duration::ZERO },
        }
    }

    fn describe(&self) -> String {
        let whole = self.counted_since(self.readings.front());
        let Counted { triggers, within } = self.worst().unwrap_or(whole);
        format!(
            "{triggers} external triggers in {:.2} s: allowed: at most {} a second, as declared",
            within.as_secs_f64(),
            self.max_rate_hz
        )
    }
}

impl Bnc575 {
    /// Counts once more; drops to safe when the source is faster than declared.
    pub(super) fn watch_source(&mut self) -> Result<(), DeviceError> {
        let Some(mut source) = self.source.clone() else { return Ok(()) };
        match self.read_expected(&source) {
            Ok(reading) => source.note(reading),
            Err(error) => {
                // Lamps at a rate that cannot be seen must not run.
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

    /// A count that is not expected is asked for again and believed then: one wrong digit on the
    /// line is no trigger.
    fn read_expected(&mut self, source: &SourceRate) -> Result<Reading, LinkError> {
        let reading = self.link.read_triggers()?;
        match source.expects(reading) {
            true => Ok(reading),
            false => self.link.read_triggers(),
        }
    }

    /// Q-switches stay off until the declared rate is confirmed.
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
                 {}; arm, wait and fire then",
                source.wait(self.link.now()).as_secs_f64(),
                source.describe()
            ))),
            None => Err(self.refused(
                "the rate of the external trigger is not confirmed: arm, wait and fire then",
            )),
        }
    }
}

#[cfg(test)]
#[path = "source_tests.rs"]
mod tests;
