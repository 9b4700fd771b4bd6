//! `lfpiv process RUN`: measures the shots of a recorded run that have no result yet.
//!
//! The run may have shed them or been killed. First the raw log is recovered: incomplete data after
//! a crash is cut off and reported. Then the ledger is made from the record, if the run did not
//! write it. Then results are added: sealed segments stay, and no shot is measured twice.

use std::path::Path;

use anyhow::{Context, bail};
use lfpiv_core::{lightfield::ImagePair, measurement::Processor, model::ModelMode};
use lfpiv_rawlog::recover;
use tokio_util::sync::CancellationToken;

use super::{
    ledger_file::{
        has_ledger, note_processed_later, set_damaged_ledger_aside, write_recovered_ledger,
    },
    losses::{Losses, warn_if_cut_off},
    output::{count, print, progress_bar},
    recording::RunLock,
    run_processor::run_processor,
};
use crate::{
    acquisition::journal::{RAW_FOLDER, RecordedRun, RecordedShot, RunIndex, ledger_of},
    archive::{RawLevel, ResultStore, ShotResult, StoredResults, merge_segments},
    config::Config,
};

/// Whether `folder` is the folder of a recorded run.
pub(super) fn is_run(folder: &Path) -> bool {
    folder.join(RAW_FOLDER).is_dir()
}

/// Finishes the run in `folder`. When interrupted, it ends after the current shot.
pub(super) fn process_run(folder: &Path, stop: &CancellationToken) -> anyhow::Result<()> {
    let _lock = RunLock::take(folder)?;
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
    let mut losses = Losses::of(folder, &index);
    for shot in stored.shots.iter().filter(|shot| !index.shots.contains_key(shot)) {
        losses.add(*shot, "it has a result, but its images are not in the record");
    }
    losses.log();
    warn_if_cut_off(folder, &index);
    let missing: Vec<&RecordedShot> =
        index.shots.values().filter(|shot| !stored.shots.contains(&shot.trigger)).collect();
    // The ledger is written before the results, because it describes the run itself.
    let has_ledger = has_ledger(folder);
    let damaged = if has_ledger { set_damaged_ledger_aside(folder)? } else { None };
    if let Some(aside) = &damaged {
        let aside = aside.display();
        tracing::warn!(
            "the ledger is damaged: it is moved to {aside} and made again from the record"
        );
    }
    if !has_ledger || damaged.is_some() {
        let ledger =
            ledger_of(&recorded, &stored.shots).context("the record contradicts itself")?;
        write_recovered_ledger(folder, &ledger, index.end.as_ref())?;
    }
    let mut finished = Finished::default();
    if missing.is_empty() {
        store.close()?;
    } else {
        let processor = prepare(&config, &recorded, &index, &stored)?;
        finished = measure(&recorded, &processor, &missing, &mut losses, store, stop)?;
    }
    merge_segments(folder, || !stop.is_cancelled())?;
    let measured = StoredResults::find(folder)?.shots;
    note_processed_later(folder, &measured)?;
    let (had, now) = (stored.shots.len(), measured.len());
    print(&format!(
        "{}: {} recorded, {had} had a result, {now} have one now",
        folder.display(),
        count(index.shots.len(), "shot"),
    ))?;
    if finished.left > 0 {
        bail!(
            "interrupted: {} without a result remain; repeat the command to measure them",
            count(finished.left, "shot")
        );
    }
    if finished.failed.is_empty() {
        return losses.conclude();
    }
    let listed: String = finished.failed.iter().map(|failure| format!("\n  {failure}")).collect();
    bail!("{} gave no result{listed}", count(finished.failed.len(), "shot"))
}

/// Outcome of the shots without a result.
#[derive(Debug, Default)]
struct Finished {
    failed: Vec<String>,
    /// Shots that were not processed.
    left: usize,
}

fn measure(
    recorded: &RecordedRun,
    processor: &Processor,
    missing: &[&RecordedShot],
    losses: &mut Losses,
    mut store: ResultStore,
    stop: &CancellationToken,
) -> anyhow::Result<Finished> {
    let bar = progress_bar(missing.len(), "shots");
    let mut finished = Finished { left: missing.len(), ..Finished::default() };
    for shot in missing {
        if stop.is_cancelled() {
            break;
        }
        finished.left -= 1;
        match recorded.pair(shot).map(|pair| measure_one(processor, shot, pair)) {
            Ok(Ok(result)) => {
                store.append(shot.trigger, &result)?;
            }
            Ok(Err(error)) => finished.failed.push(format!("shot {}: {error:#}", shot.trigger)),
            Err(error) => losses.note(shot.trigger, error)?,
        }
        bar.inc(1);
    }
    bar.finish_and_clear();
    store.close()?;
    Ok(finished)
}

/// The processor with the forward model that the run's first result chose.
fn prepare(
    config: &Config,
    recorded: &RecordedRun,
    index: &RunIndex,
    stored: &StoredResults,
) -> anyhow::Result<Processor> {
    let processor = run_processor(config)?;
    if config.model.mode == ModelMode::Explicit {
        return Ok(processor);
    }
    let candidates = stored.first.iter().chain(&stored.shots);
    for shot in candidates.filter_map(|number| index.shots.get(number)) {
        match recorded.pair(shot) {
            Ok(pair) => {
                processor.process(pair)?;
                break;
            }
            Err(error) => tracing::warn!("{error}: another shot chooses the forward model"),
        }
    }
    Ok(processor)
}

fn measure_one(
    processor: &Processor,
    shot: &RecordedShot,
    pair: ImagePair,
) -> anyhow::Result<ShotResult> {
    let mut measured = processor.process(pair)?;
    measured.field.dt_s = shot.dt_us * 1e-6;
    let words = shot.suspect.iter().map(|words| format!("suspect pairing: {words}"));
    measured.warnings.extend(words);
    Ok(ShotResult { measured, time: shot.time, raw: RawLevel::Synced })
}
