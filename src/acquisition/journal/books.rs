//! The ledger of a run, made again from its record.

use std::{collections::BTreeSet, time::Duration};

use super::{Entry, Placed, RecordedRun, recorded::ShotFinder};
use crate::acquisition::{Ledger, LedgerError, Outcome};

/// So many triggers at once, a day of a 10 Hz laser, are entered without a word of those between; more
/// is no run, and would cost the memory of an entry each.
const MOST_AT_ONCE: u64 = 1_000_000;

/// The ledger of a recorded run, every trigger settled; `measured` are the shots with a stored
/// result. What is damaged in the log is left out; a trigger whose burst is not in the record any more
/// is entered by what is said of it.
///
/// # Errors
///
/// The entries of a whole record contradict each other.
pub fn ledger(recorded: &RecordedRun, measured: &BTreeSet<u64>) -> Result<Ledger, LedgerError> {
    let mut books = Books::new(recorded.description().cameras);
    let mut is_damaged = false;
    for placed in recorded.entries() {
        match placed.map(|placed| books.take(placed)) {
            Err(_) => is_damaged = true,
            // An entry that refers to one that is lost.
            Ok(Err(_)) if is_damaged => {}
            Ok(taken) => taken?,
        }
    }
    books.close(measured)
}

/// The books as far as the entries have been read.
struct Books {
    ledger: Ledger,
    finder: ShotFinder,
    /// Triggers that are entered: all before this one.
    entered: u64,
    period: Duration,
    /// The burst that was fired last, while its end is not known.
    burst: Option<Burst>,
    /// The latest time of any entry.
    now_ns: u64,
}

struct Burst {
    at_ns: u64,
    first: u64,
    shots: u64,
}

impl Books {
    fn new(cameras: usize) -> Self {
        Self {
            ledger: Ledger::new(cameras),
            finder: ShotFinder::default(),
            entered: 0,
            period: Duration::ZERO,
            burst: None,
            now_ns: 0,
        }
    }

    fn take(&mut self, placed: Placed) -> Result<(), LedgerError> {
        self.see(&placed.entry)?;
        match &placed.entry {
            Entry::Settled { trigger, camera, outcome } => {
                self.ledger.settle(*trigger, *camera, *outcome)?;
            }
            Entry::Shed { trigger } => self.ledger.settle_all(*trigger, Outcome::Shed)?,
            Entry::Shot { trigger, suspect, .. } => self.ledger.queued(*trigger, suspect),
            Entry::Frame { camera, statistics, .. } | Entry::Stream { camera, statistics, .. } => {
                self.ledger.streamed(*camera, *statistics);
            }
            _ => {}
        }
        if let Some(Ok(shot)) = self.finder.take(placed) {
            self.ledger.timed(shot.trigger, shot.time);
        }
        Ok(())
    }

    /// What an entry says of triggers that were given. Before version 3 of the journal this was
    /// said by what became of them, and by the synchroniser's count.
    fn see(&mut self, entry: &Entry) -> Result<(), LedgerError> {
        match entry {
            Entry::Programmed { schedule, .. } => {
                // A damaged record may say anything.
                let period = Duration::try_from_secs_f64(schedule.period_us * 1e-6);
                self.period = period.unwrap_or_default();
            }
            Entry::Fired { at_ns, first, shots } => {
                self.burst = Some(Burst { at_ns: *at_ns, first: *first, shots: *shots });
            }
            Entry::BurstEnded { given, .. } => {
                self.burst = None;
                self.enter_before(*given)?;
            }
            // What the rest of it came to is said one by one.
            Entry::BurstLost { given, .. } => {
                if let Some(burst) = &mut self.burst {
                    burst.shots = given.saturating_sub(burst.first);
                }
            }
            Entry::Given { trigger }
            | Entry::Shot { trigger, .. }
            | Entry::Shed { trigger }
            | Entry::Settled { trigger, .. } => self.enter_before(trigger.saturating_add(1))?,
            _ => {}
        }
        self.now_ns = self.now_ns.max(entry.at_ns().unwrap_or_default());
        Ok(())
    }

    /// These triggers were given.
    fn enter_before(&mut self, end: u64) -> Result<(), LedgerError> {
        if end.saturating_sub(self.entered) > MOST_AT_ONCE {
            return Err(LedgerError::FarAhead {
                trigger: end - 1,
                last: self.entered.saturating_sub(1),
            });
        }
        for trigger in self.entered..end {
            self.ledger.enter(trigger)?;
            self.ledger.timed(trigger, self.finder.times().expected(trigger));
            self.entered = trigger + 1;
        }
        Ok(())
    }

    /// A run that was cut off had no time for what it had in hand: nothing says that any of it is
    /// lost. What it had asked for and nobody saw was not fired, as far as it was due by then; the
    /// rest is no trigger.
    fn close(mut self, measured: &BTreeSet<u64>) -> Result<Ledger, LedgerError> {
        let seen = self.entered;
        // Without a period nobody can say what was due.
        if let Some(burst) = self.burst.take().filter(|_| !self.period.is_zero()) {
            let end = burst.first.saturating_add(burst.shots);
            let due = (burst.first..end).take_while(|trigger| {
                let after = u32::try_from(trigger - burst.first).unwrap_or(u32::MAX);
                let due = Duration::from_nanos(burst.at_ns)
                    .saturating_add(self.period.saturating_mul(after));
                due <= Duration::from_nanos(self.now_ns)
            });
            let due = due.take(MOST_AT_ONCE as usize).last().map_or(0, |trigger| trigger + 1);
            self.enter_before(due)?;
        }
        let open: Vec<(u64, bool)> = self
            .ledger
            .entries()
            .filter(|entry| !entry.is_settled())
            .map(|entry| (entry.trigger, entry.queued))
            .collect();
        for (trigger, queued) in open {
            let outcome = if trigger >= seen {
                Outcome::NotFired
            } else if queued && measured.contains(&trigger) {
                Outcome::Complete
            } else {
                Outcome::Shed
            };
            self.ledger.settle_open(trigger, outcome);
        }
        Ok(self.ledger)
    }
}

#[cfg(test)]
mod tests {
    use lfpiv_hw::timing::{PulseSchedule, TimingSettings};

    use super::*;

    #[test]
    fn a_trigger_far_beyond_the_last_is_refused_before_it_costs_memory() {
        let mut books = Books::new(2);
        let far = u64::MAX - 1;
        let refused = books.see(&Entry::Given { trigger: far }).unwrap_err();
        assert_eq!(refused, LedgerError::FarAhead { trigger: far, last: 0 });
        books.see(&Entry::Given { trigger: 2 }).unwrap();
        assert_eq!(books.entered, 3);
    }

    #[test]
    fn a_burst_without_a_period_gave_nothing_that_is_known() {
        let planned = PulseSchedule::plan(&TimingSettings::default(), 100.0, 10.0).unwrap();
        for period_us in [f64::NAN, f64::INFINITY, -1.0, 0.0, 1e300] {
            let schedule = PulseSchedule { period_us, ..planned.clone() };
            let (at_ns, identity) = (0, String::new());
            let mut books = Books::new(2);
            books.see(&Entry::Programmed { at_ns, identity, schedule }).unwrap();
            books.see(&Entry::Fired { at_ns, first: u64::MAX - 1, shots: u64::MAX }).unwrap();
            let ledger = books.close(&BTreeSet::new()).unwrap();
            assert_eq!(ledger.accounts()[0].triggers, 0, "{period_us}");
        }
    }
}
