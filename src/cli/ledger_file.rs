//! `ledger.json`: the outcome of every trigger of a run.

use std::{
    collections::BTreeSet,
    fs,
    io::Write,
    path::{Path, PathBuf},
};

use anyhow::Context;
use lfpiv_hw::device::StreamStatistics;
use lfpiv_rawlog::regular_file::read_regular;
use serde::Serialize;
use serde_json::Value;

use crate::{
    acquisition::{Account, AcquisitionReport, Ledger, TriggerEntry, journal::RunEnd},
    archive::write_replacing,
    pipeline::{Board, ShotRecord, Stage},
};

/// Name of the file in the run's folder.
const NAME: &str = "ledger.json";

/// New name of a ledger that cannot be read.
const DAMAGED_NAME: &str = "ledger.json.damaged";

/// Largest size to read. The numbers of exceptions and shots without a result in a ledger are
/// limited.
const MOST_BYTES: u64 = 64 << 20;

#[derive(Serialize)]
struct LedgerFile<'a> {
    code_version: &'static str,
    synchroniser: Option<&'a str>,
    /// Why the run ended early.
    error: Option<String>,
    /// Whether every trigger is accounted for.
    balanced: bool,
    /// One account per camera, in the order of the configuration.
    cameras: &'a [Account],
    /// Counters of each camera's driver.
    streams: &'a [StreamStatistics],
    frames: Option<crate::acquisition::pairing::FrameCounters>,
    /// Triggers that are incomplete or suspect, up to a limit.
    exceptions: Vec<&'a TriggerEntry>,
    /// Shots that were acquired but gave no result, up to a limit.
    without_result: Vec<ShotRecord>,
}

/// The ledger of a run that ended without writing it.
#[derive(Serialize)]
struct RecoveredLedgerFile<'a> {
    code_version: &'static str,
    error: Option<&'a str>,
    balanced: bool,
    cameras: &'a [Account],
    streams: &'a [StreamStatistics],
    exceptions: Vec<&'a TriggerEntry>,
}

/// `error` of a ledger that was not written by the run itself.
pub(super) const CUT_OFF: &str = "the run was cut off; this is made from its record";

/// Whether the run in `folder` has a ledger.
pub(super) fn has_ledger(folder: &Path) -> bool {
    folder.join(NAME).exists()
}

/// What a run's ledger says about its triggers.
pub(super) struct RunLedger {
    /// Whether the run wrote the ledger itself and ended normally.
    pub has_ended: bool,
    /// Number of triggers given.
    pub triggers: u64,
    /// Triggers without images, up to a limit.
    pub without_images: BTreeSet<u64>,
}

/// Reads the ledger of the run in `folder`; `None` if there is none.
///
/// # Errors
/// The file cannot be read or is not a ledger.
pub(super) fn read_ledger(folder: &Path) -> anyhow::Result<Option<RunLedger>> {
    if !has_ledger(folder) {
        return Ok(None);
    }
    let ledger = read_json(folder)?;
    let cameras = |entry: &Value| entry["cameras"].as_array().cloned().unwrap_or_default();
    let has_images = |entry: &Value| {
        cameras(entry)
            .iter()
            .all(|of| ["complete", "shed", "write_failed"].map(Value::from).contains(of))
    };
    let exceptions = ledger["exceptions"].as_array().into_iter().flatten();
    let without_images = exceptions.filter(|entry| !has_images(entry));
    Ok(Some(RunLedger {
        has_ended: ledger["error"].is_null(),
        triggers: cameras(&ledger)
            .iter()
            .filter_map(|of| of["triggers"].as_u64())
            .max()
            .unwrap_or(0),
        without_images: without_images.filter_map(|entry| entry["trigger"].as_u64()).collect(),
    }))
}

/// The ledger of the run in `folder` as JSON.
///
/// # Errors
/// As [`read_ledger`]; there is no ledger.
pub(super) fn read_json(folder: &Path) -> anyhow::Result<Value> {
    let path = folder.join(NAME);
    let text = read_regular(&path, MOST_BYTES)
        .with_context(|| format!("cannot read {}", path.display()))?;
    serde_json::from_slice(&text).with_context(|| format!("{} is not a ledger", path.display()))
}

/// Renames a damaged ledger and returns the new path.
///
/// # Errors
/// The file cannot be read or renamed.
pub(super) fn set_damaged_ledger_aside(folder: &Path) -> anyhow::Result<Option<PathBuf>> {
    let is_damaged = |error: &anyhow::Error| error.is::<serde_json::Error>();
    match read_json(folder) {
        Err(error) if is_damaged(&error) => {}
        read => return read.map(|_| None),
    }
    let (path, aside) = (folder.join(NAME), folder.join(DAMAGED_NAME));
    fs::rename(&path, &aside).with_context(|| format!("cannot rename {}", path.display()))?;
    Ok(Some(aside))
}

/// Writes the ledger of a run from its record; `end` is `None` for a killed run.
pub(super) fn write_recovered_ledger(
    folder: &Path,
    ledger: &Ledger,
    end: Option<&RunEnd>,
) -> anyhow::Result<()> {
    let file = RecoveredLedgerFile {
        code_version: env!("CARGO_PKG_VERSION"),
        error: end.map_or(Some(CUT_OFF), |end| end.error.as_deref()),
        balanced: ledger.is_balanced(),
        cameras: ledger.accounts(),
        streams: ledger.streams(),
        exceptions: ledger.entries().filter(is_exception).collect(),
    };
    write_json(folder, &file)
}

/// Notes in the ledger which shots without a result in the run have one now. Everything else stays
/// as the run wrote it.
pub(super) fn note_processed_later(folder: &Path, measured: &BTreeSet<u64>) -> anyhow::Result<()> {
    let mut ledger = read_json(folder)?;
    let shed = |entry: &&Value| {
        entry["cameras"].as_array().is_some_and(|cameras| cameras.iter().all(|of| of == "shed"))
    };
    let exceptions = ledger["exceptions"].as_array().into_iter().flatten().filter(shed);
    let later: Vec<u64> = exceptions
        .filter_map(|entry| entry["trigger"].as_u64())
        .filter(|shot| measured.contains(shot))
        .collect();
    ledger["processed_later"] = later.into();
    write_json(folder, &ledger)
}

fn is_exception(entry: &&TriggerEntry) -> bool {
    !entry.is_complete() || !entry.suspect.is_empty()
}

fn write_json(folder: &Path, file: &impl Serialize) -> anyhow::Result<()> {
    let text = serde_json::to_vec_pretty(file).context("the ledger cannot be written as JSON")?;
    write_replacing(&folder.join(NAME), |writer| writer.write_all(&text))?;
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
        exceptions: ledger.entries().filter(is_exception).collect(),
        without_result,
    };
    write_json(folder, &file)
}
