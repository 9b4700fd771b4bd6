//! `lfpiv process RUN`: measures the shots of a recorded run that have no result yet.
//!
//! The run may have shed them or been killed. First the raw log is recovered: incomplete data after
//! a crash is cut off and reported. Then the ledger is made from the record, if the run did not
//! write it. Then results are added: sealed segments stay, and no shot is measured twice.

use std::path::Path;

use anyhow::Context;
use lfpiv_rawlog::recover;
use tokio_util::sync::CancellationToken;

use super::{
    ledger_file::{
        has_ledger, note_processed_later, set_damaged_ledger_aside, write_recovered_ledger,
    },
    losses::{Losses, warn_if_cut_off},
    output::{count, print},
    recorded_shots::{Finished, ShotProcessor},
    recording::RunLock,
};
use crate::{
    acquisition::journal::{RAW_FOLDER, RecordedRun, RecordedShot, RunIndex, ledger_of},
    archive::{ResultStore, StoredResults, merge_segments},
    config::Config,
};

/// Whether `folder` is the folder of a recorded run.
pub(super) fn is_run(folder: &Path) -> bool {
    folder.join(RAW_FOLDER).is_dir()
}

/// Finishes the run in `folder`. When interrupted, it ends after the current shot.
pub(super) fn process_run(folder: &Path, stop: &CancellationToken) -> anyhow::Result<()> {
    let (run, store) = UnfinishedRun::open(folder)?;
    let mut losses = run.losses();
    run.settle_ledger()?;
    let missing = run.missing();
    let mut finished = Finished::default();
    if missing.is_empty() {
        store.close()?;
    } else {
        let UnfinishedRun { config, recorded, index, stored, .. } = &run;
        let mut processor = ShotProcessor::prepare(config, recorded, index, stored)?;
        finished = processor.measure(&missing, |_| true, &mut losses, store, stop)?;
    }
    run.complete(stop)?;
    finished.conclude()?;
    losses.conclude()
}

/// A recorded run that nobody else writes, and what it has so far.
pub(super) struct UnfinishedRun<'a> {
    folder: &'a Path,
    pub recorded: RecordedRun,
    pub index: RunIndex,
    pub config: Config,
    pub stored: StoredResults,
    _lock: RunLock,
}

impl<'a> UnfinishedRun<'a> {
    /// Cuts off what a crash has left half-written; with the store that its results go to.
    ///
    /// # Errors
    /// Another program has the run, or its record or results cannot be read.
    pub fn open(folder: &'a Path) -> anyhow::Result<(Self, ResultStore)> {
        let lock = RunLock::take(folder)?;
        let recovery = recover(&folder.join(RAW_FOLDER))?;
        for torn in recovery.segments.iter().filter_map(|segment| segment.torn.as_ref()) {
            tracing::warn!("{torn}");
        }
        let recorded = RecordedRun::open(folder)?.finished();
        let index = recorded.index();
        let text = &recorded.description().configuration;
        let config = Config::parse("the run's configuration", text)?;
        let (store, stored) = ResultStore::reopen(folder, text)?;
        let store = store.for_paraview(config.output.paraview);
        for part in &stored.unreadable {
            tracing::warn!("{}: the run was killed before this was sealed", part.display());
        }
        Ok((Self { folder, recorded, index, config, stored, _lock: lock }, store))
    }

    /// What its record lacks, told.
    pub fn losses(&self) -> Losses {
        let mut losses = Losses::of(self.folder, &self.index);
        for shot in self.stored.shots.iter().filter(|shot| !self.index.shots.contains_key(shot)) {
            losses.add(*shot, "it has a result, but its images are not in the record");
        }
        losses.log();
        warn_if_cut_off(self.folder, &self.index);
        losses
    }

    /// Shots without a result.
    pub fn missing(&self) -> Vec<&RecordedShot> {
        missing(&self.index, &self.stored)
    }

    /// Makes a ledger from the record where the run has none. Before its results: whatever happens to
    /// them, it says what the run itself came to.
    pub fn settle_ledger(&self) -> anyhow::Result<()> {
        let has_ledger = has_ledger(self.folder);
        let damaged = if has_ledger { set_damaged_ledger_aside(self.folder)? } else { None };
        if let Some(aside) = &damaged {
            let aside = aside.display();
            tracing::warn!(
                "the ledger is damaged: it is moved to {aside} and made again from the record"
            );
        }
        if !has_ledger || damaged.is_some() {
            let ledger = ledger_of(&self.recorded, &self.stored.shots)
                .context("the record contradicts itself")?;
            write_recovered_ledger(self.folder, &ledger, self.index.end.as_ref())?;
        }
        Ok(())
    }

    /// Merges the results, completes the ledger, and says what the run has now.
    ///
    /// # Errors
    /// A file cannot be read or written.
    pub fn complete(&self, stop: &CancellationToken) -> anyhow::Result<()> {
        merge_segments(self.folder, || !stop.is_cancelled())?;
        let measured = StoredResults::find(self.folder)?.shots;
        note_processed_later(self.folder, &measured)?;
        let (had, now) = (self.stored.shots.len(), measured.len());
        print(&format!(
            "{}: {} recorded, {had} had a result, {now} have one now",
            self.folder.display(),
            count(self.index.shots.len(), "shot"),
        ))
    }
}

/// Shots of a run without a result, in their order.
pub(super) fn missing<'a>(index: &'a RunIndex, stored: &StoredResults) -> Vec<&'a RecordedShot> {
    index.shots.values().filter(|shot| !stored.shots.contains(&shot.trigger)).collect()
}
