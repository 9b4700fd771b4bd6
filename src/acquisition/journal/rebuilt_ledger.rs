//! Rebuilds a run's ledger from its record.

use std::{collections::BTreeSet, time::Duration};

use super::{Entry, LocatedEntry, RecordedRun, recorded::ShotFinder};
use crate::acquisition::{Ledger, LedgerError, Outcome};

/// Largest gap in trigger numbers that is filled: a day of a 10 Hz laser. A larger one is corrupt, and
/// would allocate an entry each.
const MAX_GAP: u64 = 1_000_000;

/// The ledger of a recorded run, with every trigger settled; `measured` are the shots with a stored
/// result. Damaged records are skipped. A trigger whose burst is missing from the record is entered
/// when another entry mentions it.
///
/// # Errors
///
/// The entries of an undamaged record contradict each other.
pub fn ledger(recorded: &RecordedRun, measured: &BTreeSet<u64>) -> Result<Ledger, LedgerError> {
    let mut rebuild = LedgerRebuild::new(recorded.description().cameras);
    let mut is_damaged = false;
    for placed in recorded.entries() {
        match placed.map(|placed| rebuild.take(placed)) {
            Err(_) => is_damaged = true,
            // An entry that refers to a lost one.
            Ok(Err(_)) if is_damaged => {}
            Ok(taken) => taken?,
        }
    }
    rebuild.close(measured)
}

/// The ledger while the entries are being read.
struct LedgerRebuild {
    ledger: Ledger,
    finder: ShotFinder,
    /// Number of triggers entered: all before this one.
    entered: u64,
    period: Duration,
    /// The last burst, while its end is unknown.
    burst: Option<OpenBurst>,
    /// The latest time of any entry.
    now_ns: u64,
}

struct OpenBurst {
    at_ns: u64,
    first: u64,
    shots: u64,
}

impl LedgerRebuild {
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

    fn take(&mut self, placed: LocatedEntry) -> Result<(), LedgerError> {
        self.enter_given(&placed.entry)?;
        match &placed.entry {
            Entry::Settled { trigger, camera, outcome } => {
                self.ledger.settle(*trigger, *camera, *outcome)?;
            }
            Entry::Shed { trigger } => self.ledger.settle_all(*trigger, Outcome::Shed)?,
            Entry::Shot { trigger, suspect, .. } => self.ledger.mark_queued(*trigger, suspect),
            Entry::Frame { camera, statistics, .. } | Entry::Stream { camera, statistics, .. } => {
                self.ledger.set_stream_statistics(*camera, *statistics);
            }
            _ => {}
        }
        if let Some(Ok(shot)) = self.finder.take(placed) {
            self.ledger.set_time(shot.trigger, shot.time);
        }
        Ok(())
    }

    /// Enters the triggers that an entry shows to have been given. Before version 3 of the journal,
    /// their outcomes and the synchroniser's count showed this.
    fn enter_given(&mut self, entry: &Entry) -> Result<(), LedgerError> {
        match entry {
            Entry::Programmed { schedule, .. } => {
                // A damaged record may hold any value.
                let period = Duration::try_from_secs_f64(schedule.period_us * 1e-6);
                self.period = period.unwrap_or_default();
            }
            Entry::Fired { at_ns, first, shots } => {
                self.burst = Some(OpenBurst { at_ns: *at_ns, first: *first, shots: *shots });
            }
            Entry::BurstEnded { given, .. } => {
                self.burst = None;
                self.enter_before(*given)?;
            }
            // The outcomes of the other triggers have entries of their own.
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

    /// Enters all triggers before `end`.
    fn enter_before(&mut self, end: u64) -> Result<(), LedgerError> {
        if end.saturating_sub(self.entered) > MAX_GAP {
            return Err(LedgerError::FarAhead {
                trigger: end - 1,
                last: self.entered.saturating_sub(1),
            });
        }
        for trigger in self.entered..end {
            self.ledger.enter(trigger)?;
            self.ledger.set_time(trigger, self.finder.times().expected(trigger));
            self.entered = trigger + 1;
        }
        Ok(())
    }

    /// Settles the triggers of a run that was cut off. Triggers in process are shed, because there
    /// is no evidence of a loss. Requested triggers without a frame are not fired if they were due
    /// by then, and otherwise not counted.
    fn close(mut self, measured: &BTreeSet<u64>) -> Result<Ledger, LedgerError> {
        let seen = self.entered;
        // Without a period it is unknown what was due.
        if let Some(burst) = self.burst.take().filter(|_| !self.period.is_zero()) {
            let end = burst.first.saturating_add(burst.shots);
            let due = (burst.first..end).take_while(|trigger| {
                let after = u32::try_from(trigger - burst.first).unwrap_or(u32::MAX);
                let due = Duration::from_nanos(burst.at_ns)
                    .saturating_add(self.period.saturating_mul(after));
                due <= Duration::from_nanos(self.now_ns)
            });
            let due = due.take(MAX_GAP as usize).last().map_or(0, |trigger| trigger + 1);
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
        let mut rebuild = LedgerRebuild::new(2);
        let far = u64::MAX - 1;
        let refused = rebuild.enter_given(&Entry::Given { trigger: far }).unwrap_err();
        assert_eq!(refused, LedgerError::FarAhead { trigger: far, last: 0 });
        rebuild.enter_given(&Entry::Given { trigger: 2 }).unwrap();
        assert_eq!(rebuild.entered, 3);
    }

    #[test]
    fn a_burst_without_a_period_gave_nothing_that_is_known() {
        let planned = PulseSchedule::plan(&TimingSettings::default(), 100.0, 10.0).unwrap();
        for period_us in [f64::NAN, f64::INFINITY, -1.0, 0.0, 1e300] {
            let schedule = PulseSchedule { period_us, ..planned.clone() };
            let (at_ns, identity) = (0, String::new());
            let mut rebuild = LedgerRebuild::new(2);
            rebuild.enter_given(&Entry::Programmed { at_ns, identity, schedule }).unwrap();
            rebuild
                .enter_given(&Entry::Fired { at_ns, first: u64::MAX - 1, shots: u64::MAX })
                .unwrap();
            let ledger = rebuild.close(&BTreeSet::new()).unwrap();
            assert_eq!(ledger.accounts()[0].triggers, 0, "{period_us}");
        }
    }
}
