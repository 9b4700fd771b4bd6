//! `lfpiv process RUN`: measures the shots of a recorded run that have no result yet.
//!
//! The run may have shed them, or been killed. Raw log first: what a crash has left half-written
//! is cut off, and said. Then the results: whole segments stay, no shot is measured twice. The
//! ledger is written last, made again from the record.

use std::path::Path;

use anyhow::{Context, bail};

use super::{
    ledger_file::{ProcessedLater, write_recovered_ledger},
    output::{count, print, progress_bar},
    recording::RunLock,
};
use crate::{
    acquisition::journal::{RAW_FOLDER, RecordedRun, RecordedShot, RunIndex, ledger_of},
    archive::{ResultStore, StoredResults, recover},
    config::Config,
    lightfield::{Background, RawLevel},
    pipeline::{PairResult, Processor},
};

/// Whether `folder` is that of a recorded run.
pub(super) fn is_run(folder: &Path) -> bool {
    folder.join(RAW_FOLDER).is_dir()
}

/// Finishes the run in `folder`.
pub(super) fn process_run(folder: &Path) -> anyhow::Result<()> {
    let _lock = RunLock::take(folder)?;
    let recovery = recover(&folder.join(RAW_FOLDER))?;
    for torn in recovery.segments.iter().filter_map(|segment| segment.torn.as_ref()) {
        tracing::warn!("{torn}");
    }
    let recorded = RecordedRun::open(folder)?;
    let index = recorded.index();
    for damage in &index.damaged {
        tracing::error!("{damage}");
    }
    let text = &recorded.description().configuration;
    let (store, stored) = ResultStore::reopen(folder, text)?;
    for part in &stored.unreadable {
        tracing::warn!("{}: the run was killed before this was sealed", part.display());
    }
    let missing: Vec<&RecordedShot> =
        index.shots.values().filter(|shot| !stored.shots.contains(&shot.trigger)).collect();
    let mut finished = Finished::default();
    if missing.is_empty() {
        store.close()?;
    } else {
        finished = measure(&recorded, &index, &stored, &missing, store)?;
    }
    let measured = StoredResults::find(folder)?.shots;
    let ledger = ledger_of(&recorded, &stored.shots).context("the record contradicts itself")?;
    let later = ProcessedLater { ended: index.ended, shots: finished.measured };
    write_recovered_ledger(folder, &ledger, &later)?;
    let (had, now) = (stored.shots.len(), measured.len());
    print(&format!(
        "{}: {} recorded, {had} had a result, {now} have one now",
        folder.display(),
        count(index.shots.len(), "shot"),
    ))?;
    if finished.failed.is_empty() && index.damaged.is_empty() {
        return Ok(());
    }
    let listed: String = finished.failed.iter().map(|failure| format!("\n  {failure}")).collect();
    bail!(
        "{} gave no result, {} damaged in the record{listed}",
        count(finished.failed.len(), "shot"),
        count(index.damaged.len(), "place")
    )
}

/// What came of the shots that had no result.
#[derive(Debug, Default)]
struct Finished {
    measured: Vec<u64>,
    failed: Vec<String>,
}

fn measure(
    recorded: &RecordedRun,
    index: &RunIndex,
    stored: &StoredResults,
    missing: &[&RecordedShot],
    mut store: ResultStore,
) -> anyhow::Result<Finished> {
    let config = Config::parse("the run's configuration", &recorded.description().configuration)?;
    let processor = prepare(&config, recorded, index, stored)?;
    let bar = progress_bar(missing.len(), "shots");
    let mut finished = Finished::default();
    for shot in missing {
        match measure_one(&processor, recorded, shot) {
            Ok(result) => {
                store.append(shot.trigger, &result)?;
                finished.measured.push(shot.trigger);
            }
            Err(error) => finished.failed.push(format!("shot {}: {error:#}", shot.trigger)),
        }
        bar.inc(1);
    }
    bar.finish_and_clear();
    store.close()?;
    Ok(finished)
}

/// The processor, with the forward model that the run's first result decided.
fn prepare(
    config: &Config,
    recorded: &RecordedRun,
    index: &RunIndex,
    stored: &StoredResults,
) -> anyhow::Result<Processor> {
    let mut processor =
        Processor::new(config.measurement()).context("the run cannot be measured")?;
    if config.image.background != Background::Constant {
        for shot in index.shots.values() {
            processor.learn_background(&recorded.pair(shot)?)?;
        }
    }
    if let Some(first) = stored.first.and_then(|first| index.shots.get(&first)) {
        processor.process(recorded.pair(first)?)?;
    }
    Ok(processor)
}

fn measure_one(
    processor: &Processor,
    recorded: &RecordedRun,
    shot: &RecordedShot,
) -> anyhow::Result<PairResult> {
    let mut result = processor.process(recorded.pair(shot)?)?;
    result.field.dt_s = shot.dt_us * 1e-6;
    result.raw = RawLevel::Synced;
    let words = shot.suspect.iter().map(|words| format!("suspect pairing: {words}"));
    result.warnings.extend(words);
    Ok(result)
}
