//! The ledger of a run, made again from its record.

use std::collections::BTreeSet;

use super::{Entry, Placed, RecordedRun, RecordedRunError};
use crate::acquisition::{Ledger, LedgerError, Outcome};

/// The ledger of a recorded run, every trigger settled; `measured` are the shots with a stored
/// result. What is damaged in the log is left out.
///
/// # Errors
///
/// The entries contradict each other.
pub fn ledger(recorded: &RecordedRun, measured: &BTreeSet<u64>) -> Result<Ledger, LedgerError> {
    let mut ledger = Ledger::new(recorded.description().cameras);
    for placed in recorded.entries() {
        take(&mut ledger, placed)?;
    }
    let open: Vec<(u64, bool)> = ledger
        .entries()
        .filter(|entry| !entry.is_settled())
        .map(|entry| (entry.trigger, entry.queued))
        .collect();
    for (trigger, queued) in open {
        // A run that was cut off had no time for the others: nothing says that anything is lost.
        let is_measured = queued && measured.contains(&trigger);
        let outcome = if is_measured { Outcome::Complete } else { Outcome::Shed };
        ledger.settle_open(trigger, outcome);
    }
    Ok(ledger)
}

fn take(ledger: &mut Ledger, placed: Result<Placed, RecordedRunError>) -> Result<(), LedgerError> {
    match placed.map(|placed| placed.entry) {
        Ok(Entry::Fired { first, shots, .. }) => {
            (first..first + shots).try_for_each(|trigger| ledger.enter(trigger))
        }
        Ok(Entry::Withdrawn { trigger }) => ledger.withdraw(trigger),
        Ok(Entry::Settled { trigger, camera, outcome }) => ledger.settle(trigger, camera, outcome),
        Ok(Entry::Shed { trigger }) => ledger.settle_all(trigger, Outcome::Shed),
        Ok(Entry::Shot { trigger, suspect, .. }) => {
            ledger.queued(trigger, &suspect);
            Ok(())
        }
        Ok(Entry::Frame { camera, statistics, .. } | Entry::Stream { camera, statistics, .. }) => {
            ledger.streamed(camera, statistics);
            Ok(())
        }
        _ => Ok(()),
    }
}
