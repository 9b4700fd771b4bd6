//! The ledger of a run, made again from its record.

use std::collections::BTreeSet;

use super::{Entry, Placed, RecordedRun, RecordedRunError, recorded::ShotFinder};
use crate::acquisition::{Ledger, LedgerError, Outcome};

/// The ledger of a recorded run, every trigger settled; `measured` are the shots with a stored
/// result. What is damaged in the log is left out.
///
/// # Errors
///
/// The entries contradict each other.
pub fn ledger(recorded: &RecordedRun, measured: &BTreeSet<u64>) -> Result<Ledger, LedgerError> {
    let mut ledger = Ledger::new(recorded.description().cameras);
    let mut finder = ShotFinder::default();
    for placed in recorded.entries() {
        take(&mut ledger, &mut finder, placed)?;
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

fn take(
    ledger: &mut Ledger,
    finder: &mut ShotFinder,
    placed: Result<Placed, RecordedRunError>,
) -> Result<(), LedgerError> {
    let Ok(placed) = placed else { return Ok(()) };
    match &placed.entry {
        Entry::Fired { first, shots, .. } => {
            (*first..first + shots).try_for_each(|trigger| ledger.enter(trigger))?;
        }
        Entry::Withdrawn { trigger } => ledger.withdraw(*trigger)?,
        Entry::Settled { trigger, camera, outcome } => {
            ledger.settle(*trigger, *camera, *outcome)?;
        }
        Entry::Shed { trigger } => ledger.settle_all(*trigger, Outcome::Shed)?,
        Entry::Shot { trigger, suspect, .. } => ledger.queued(*trigger, suspect),
        Entry::Frame { camera, statistics, .. } | Entry::Stream { camera, statistics, .. } => {
            ledger.streamed(*camera, *statistics);
        }
        _ => {}
    }
    let started = match placed.entry {
        Entry::BurstStarted { first, .. } => Some(first),
        _ => None,
    };
    if let Some(Ok(shot)) = finder.take(placed) {
        ledger.timed(shot.trigger, shot.time);
    }
    if let Some(first) = started {
        ledger.timed_from(first, |trigger| finder.times().expected(trigger));
    }
    Ok(())
}
