//! `ledger.json`: what became of every trigger of a run.

use std::{io::Write, path::Path};

use anyhow::Context;
use lfpiv_hw::device::StreamStatistics;
use serde::Serialize;

use crate::{
    acquisition::{Account, AcquisitionReport, Ledger, TriggerEntry},
    archive::write_replacing,
    pipeline::{Board, ShotRecord, Stage},
};

#[derive(Serialize)]
struct LedgerFile<'a> {
    code_version: &'static str,
    synchroniser: Option<&'a str>,
    /// Why the run ended before its time.
    error: Option<String>,
    /// Whether every trigger is accounted for.
    balanced: bool,
    /// One account per camera, in the order of the configuration.
    cameras: &'a [Account],
    /// What each camera's driver counted.
    streams: &'a [StreamStatistics],
    frames: Option<crate::acquisition::pairing::FrameCounters>,
    /// The triggers that are not complete or suspect, as far as they are remembered.
    exceptions: Vec<&'a TriggerEntry>,
    /// Shots that were acquired and gave no result, as far as they are remembered.
    without_result: Vec<ShotRecord>,
}

/// What was measured after the run.
pub(super) struct ProcessedLater {
    /// Whether the run came to its end; otherwise it was killed.
    pub ended: bool,
    /// The shots.
    pub shots: Vec<u64>,
}

#[derive(Serialize)]
struct RecoveredLedgerFile<'a> {
    code_version: &'static str,
    error: Option<&'static str>,
    balanced: bool,
    cameras: &'a [Account],
    streams: &'a [StreamStatistics],
    exceptions: Vec<&'a TriggerEntry>,
    /// Shots that gave no result in the run and have one now.
    processed_later: &'a [u64],
}

/// Writes `ledger.json` again, from the run's record.
pub(super) fn write_recovered_ledger(
    folder: &Path,
    ledger: &Ledger,
    later: &ProcessedLater,
) -> anyhow::Result<()> {
    let file = RecoveredLedgerFile {
        code_version: env!("CARGO_PKG_VERSION"),
        error: (!later.ended).then_some("the run was cut off; this is made from its record"),
        balanced: ledger.is_balanced(),
        cameras: ledger.accounts(),
        streams: ledger.streams(),
        exceptions: ledger.entries().filter(is_odd).collect(),
        processed_later: &later.shots,
    };
    write_json(folder, &file)
}

fn is_odd(entry: &&TriggerEntry) -> bool {
    !entry.is_complete() || !entry.suspect.is_empty()
}

fn write_json(folder: &Path, file: &impl Serialize) -> anyhow::Result<()> {
    let text = serde_json::to_vec_pretty(file).context("the ledger cannot be written as JSON")?;
    write_replacing(&folder.join("ledger.json"), |writer| writer.write_all(&text))?;
    Ok(())
}

/// Writes `ledger.json` into `folder`.
pub(super) fn write_ledger(
    folder: &Path,
    ledger: &Ledger,
    board: &Board,
    ended: &anyhow::Result<AcquisitionReport>,
) -> anyhow::Result<()> {
    let report = ended.as_ref().ok();
    let without_result = ledger
        .entries()
        .filter_map(|entry| board.record(entry.trigger))
        .filter(|record| record.stage != Stage::Done)
        .collect();
    let file = LedgerFile {
        code_version: env!("CARGO_PKG_VERSION"),
        synchroniser: report.map(|report| report.synchroniser.as_str()),
        error: ended.as_ref().err().map(|error| format!("{error:#}")),
        balanced: ledger.is_balanced(),
        cameras: ledger.accounts(),
        streams: ledger.streams(),
        frames: report.map(|report| report.frames),
        exceptions: ledger.entries().filter(is_odd).collect(),
        without_result,
    };
    write_json(folder, &file)
}
