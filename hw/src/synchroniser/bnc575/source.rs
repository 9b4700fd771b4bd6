//! The rate of an external trigger, from the unit's own count of triggers.

use std::time::{Duration, Instant};

use super::{
    Bnc575,
    command::{Parameter, Value},
};
use crate::device::{DeviceError, Synchroniser};

/// How long triggers are counted before a Q-switch is enabled (DESIGN section 5).
const CONFIRMATION: Duration = Duration::from_secs(3);
/// How much faster than declared counts may look: the host's and the source's clocks differ.
const TOLERANCE: f64 = 1.01;

/// Triggers counted since some moment.
#[derive(Debug, Clone)]
pub struct SourceRate {
    max_rate_hz: f64,
    first: (Instant, u64),
    last: (Instant, u64),
    /// A window has been watched to its end and was slow enough.
    confirmed: bool,
}

impl SourceRate {
    pub fn new(max_rate_hz: f64, count: u64) -> Self {
        let now = (Instant::now(), count);
        Self { max_rate_hz, first: now, last: now, confirmed: false }
    }

    /// Begins a new window; what was confirmed stays so.
    pub fn restart(&mut self, count: u64) {
        self.first = (Instant::now(), count);
        self.last = self.first;
    }

    pub fn note(&mut self, count: u64) {
        if count < self.first.1 {
            self.restart(count);
        }
        self.last = (Instant::now(), count);
        let (elapsed, triggers) = self.counted();
        if elapsed >= CONFIRMATION && triggers > 0 && !self.is_exceeded() {
            self.confirmed = true;
        }
    }

    /// What is left of the time in which triggers are counted first.
    pub fn wait(&self) -> Duration {
        match self.confirmed {
            true => Duration::ZERO,
            false => CONFIRMATION.saturating_sub(self.first.0.elapsed()),
        }
    }

    pub fn is_confirmed(&self) -> bool {
        self.confirmed
    }

    /// More triggers came than the declared rate gives in that time, counting both ends.
    pub fn is_exceeded(&self) -> bool {
        let (elapsed, triggers) = self.counted();
        triggers as f64 > elapsed.as_secs_f64() * self.max_rate_hz * TOLERANCE + 1.0
    }

    fn counted(&self) -> (Duration, u64) {
        (self.last.0 - self.first.0, self.last.1.saturating_sub(self.first.1))
    }

    fn describe(&self) -> String {
        let (elapsed, triggers) = self.counted();
        format!(
            "{triggers} external triggers in {:.2} s: allowed: at most {} a second, as declared",
            elapsed.as_secs_f64(),
            self.max_rate_hz
        )
    }
}

impl Bnc575 {
    /// Counts once more; drops to safe when the source is faster than declared.
    pub(super) fn watch_source(&mut self) -> Result<(), DeviceError> {
        if self.source.is_none() {
            return Ok(());
        }
        let count = self.link.query_count(Parameter::TriggerCount);
        let count = count.map_err(|error| self.failed(error))?;
        let Some(source) = &mut self.source else { return Ok(()) };
        source.note(count);
        if !source.is_exceeded() {
            return Ok(());
        }
        let reason = source.describe();
        self.make_safe()?;
        Err(self.refused(format!("{reason}; lamps and Q-switches are switched off")))
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
                source.wait().as_secs_f64(),
                source.describe()
            ))),
            None => Err(self.refused(
                "the rate of the external trigger is not confirmed: arm, wait and fire then",
            )),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn watched(rate_hz: f64, window: Duration) -> SourceRate {
        let mut source = SourceRate::new(10.0, 1000);
        // The window began that long ago.
        source.first.0 -= window;
        source.note(1000 + (rate_hz * window.as_secs_f64()) as u64);
        source
    }

    #[test]
    fn only_a_whole_window_at_the_declared_rate_confirms() {
        let whole = Duration::from_millis(3010);
        assert!(watched(10.0, whole).is_confirmed());
        assert!(watched(0.5, whole).is_confirmed());
        assert!(!watched(0.0, whole).is_confirmed());
        assert!(!watched(10.0, Duration::from_secs(2)).is_confirmed());
        assert!(!watched(11.0, whole).is_confirmed());
    }

    #[test]
    fn a_source_that_is_too_fast_is_seen_at_any_time() {
        for window_ms in [1000, 3000, 10_000] {
            let window = Duration::from_millis(window_ms);
            assert!(!watched(10.0, window).is_exceeded());
            assert!(watched(13.0, window).is_exceeded(), "{window_ms} ms");
        }
    }

    #[test]
    fn a_counter_set_back_begins_a_new_window() {
        let mut source = watched(10.0, Duration::from_secs(4));
        source.note(3);
        assert!(source.is_confirmed() && !source.is_exceeded());
    }
}
