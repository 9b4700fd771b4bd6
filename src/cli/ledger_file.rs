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

/// Writes `ledger.json` into `folder`.
pub(super) fn write_ledger(
    folder: &Path,
    ledger: &Ledger,
    board: &Board,
    ended: &anyhow::Result<AcquisitionReport>,
) -> anyhow::Result<()> {
    let report = ended.as_ref().ok();
    let odd = |entry: &&TriggerEntry| !entry.is_complete() || !entry.suspect.is_empty();
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
        exceptions: ledger.entries().filter(odd).collect(),
        without_result,
    };
    let text = serde_json::to_vec_pretty(&file).context("the ledger cannot be written as JSON")?;
    write_replacing(&folder.join("ledger.json"), |writer| writer.write_all(&text))?;
    Ok(())
}
