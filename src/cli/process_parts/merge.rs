//! Makes the results of all parts those of the run.

use std::{
    collections::BTreeSet,
    fs::{self, File},
    io::Write,
    path::{Path, PathBuf},
};

use anyhow::{Context, bail};
use lfpiv_rawlog::regular_file::read_text;
use tokio_util::sync::CancellationToken;

use super::{
    part_file::NAME,
    verify::{PartFolder, Run},
};
use crate::{
    archive::write_replacing,
    cli::{process_run::UnfinishedRun, recorded_shots::Finished, run_processor::conditions},
};

/// Where parts are looked for when none is given, in the run's folder.
const PARTS: &str = "parts";
/// Names the parts whose results are being copied, in the run's folder: results of theirs that are in
/// the run, too, are from a merge that was cut off.
const MERGING: &str = "merging_parts";

/// Verifies the parts of `run` in `given`, or in its folder `parts`, and merges them into it.
///
/// # Errors
/// The parts are not each shot of the run once, measured alike: nothing is merged then. A file cannot be
/// read or written: the same call goes on. Shots have failed, or are lost.
pub(in crate::cli) fn merge_parts(
    run: &Path,
    given: &[PathBuf],
    stop: &CancellationToken,
) -> anyhow::Result<()> {
    let folders = if given.is_empty() { parts_of(run)? } else { given.to_vec() };
    let parts: Vec<PartFolder> =
        folders.iter().map(|folder| PartFolder::open(folder)).collect::<Result<_, _>>()?;
    let (unfinished, mut store) = UnfinishedRun::open(run)?;
    let UnfinishedRun { recorded, index, config, stored, .. } = &unfinished;
    let marker = Marker::of(run, &folders)?;
    let copied = |shot: &u64| {
        marker.is_there && parts.iter().any(|part| part.file.shots.binary_search(shot).is_ok())
    };
    Run {
        folder: run,
        configuration: &recorded.description().configuration,
        conditions: &conditions(recorded, index, config)?,
        measured: stored.shots.iter().copied().filter(|shot| !copied(shot)).collect(),
        missing: unfinished.missing().iter().map(|shot| shot.trigger).collect(),
    }
    .verify(&parts)?;

    tell_instructions(&parts);
    let mut losses = unfinished.losses();
    unfinished.settle_ledger()?;
    marker.set()?;
    store.adopt(&folders)?;
    store.close()?;
    unfinished.complete(stop)?;
    marker.remove()?;
    let mut finished = Finished::default();
    for part in parts {
        finished.failed.extend(part.file.failed);
        part.file.lost.into_iter().for_each(|(shot, why)| losses.add(shot, why));
    }
    finished.conclude()?;
    losses.conclude()
}

/// Warns where results are not bit for bit those of one machine.
fn tell_instructions(parts: &[PartFolder]) {
    let kinds: BTreeSet<&String> =
        parts.iter().flat_map(|part| part.file.instructions.iter()).collect();
    if kinds.len() > 1 {
        let kinds: Vec<&str> = kinds.into_iter().map(String::as_str).collect();
        tracing::warn!(
            "the parts were measured on processors with different vector instructions ({}): their \
             vectors are rounded differently, by up to 1e-4 voxel",
            kinds.join("; ")
        );
    }
}

/// The folders of parts that lie in the run's own.
fn parts_of(run: &Path) -> anyhow::Result<Vec<PathBuf>> {
    let below = run.join(PARTS);
    let mut found = Vec::new();
    for entry in fs::read_dir(&below).into_iter().flatten() {
        let folder = entry.with_context(|| format!("cannot list {}", below.display()))?.path();
        if folder.join(NAME).exists() {
            found.push(folder);
        }
    }
    if found.is_empty() {
        bail!("{} holds no parts: give their folders after --merge", below.display());
    }
    found.sort();
    Ok(found)
}

/// Says in the run's folder that parts are being merged into it, and which.
struct Marker {
    path: PathBuf,
    parts: String,
    is_there: bool,
}

impl Marker {
    /// # Errors
    /// The folders cannot be found, or other parts are being merged.
    fn of(run: &Path, folders: &[PathBuf]) -> anyhow::Result<Self> {
        let path = run.join(MERGING);
        let mut names = Vec::new();
        for folder in folders {
            let name = folder
                .canonicalize()
                .with_context(|| format!("cannot find {}", folder.display()))?;
            names.push(format!("{}\n", name.display()));
        }
        names.sort();
        let parts = names.concat();
        let others = if path.exists() { read_text(&path)? } else { String::new() };
        // One that a power cut has left empty was not on disk before anything was copied.
        let is_there = !others.is_empty();
        if is_there && others != parts {
            bail!(
                "{}: the merge of other parts was cut off; merge those first:\n{}",
                run.display(),
                others.trim_end()
            );
        }
        Ok(Self { path, parts, is_there })
    }

    /// On disk before anything is copied.
    fn set(&self) -> anyhow::Result<()> {
        write_replacing(&self.path, |writer| writer.write_all(self.parts.as_bytes()))?;
        let folder = self.path.parent().unwrap_or(Path::new("."));
        [&self.path, folder].into_iter().try_for_each(|path| {
            let synced = File::open(path).and_then(|file| file.sync_all());
            synced.with_context(|| format!("cannot sync {}", path.display()))
        })
    }

    fn remove(&self) -> anyhow::Result<()> {
        fs::remove_file(&self.path)
            .with_context(|| format!("cannot remove {}", self.path.display()))
    }
}
