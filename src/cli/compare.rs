//! `lfpiv compare`: compares two runs, with every number of every vector and placed particle, and their ledgers.

use std::{
    collections::BTreeMap,
    path::{Path, PathBuf},
};

use anyhow::bail;
use lfpiv_hw::CameraName;
use serde_json::Value;

use super::{
    ledger_file::{CUT_OFF, has_ledger, read_json},
    output::{count, print},
};
use crate::archive::{stored_particles, stored_vectors};

/// Arguments of `lfpiv compare`.
#[derive(Debug, clap::Args)]
pub struct CompareArgs {
    /// Folder of the run.
    #[arg(value_name = "RUN")]
    pub run: PathBuf,
    /// Folder of the run's replay.
    #[arg(value_name = "AGAIN")]
    pub again: PathBuf,
}

/// Compares vectors bit for bit, and ledgers.
pub fn compare_runs(args: &CompareArgs) -> anyhow::Result<()> {
    let [then, now] = [&args.run, &args.again].map(|run| {
        let results = Results::read(run)?;
        if results.vectors.is_empty() {
            bail!("{} contains no results: is it the folder of a run?", run.display());
        }
        Ok(results)
    });
    compare(&then?, &now?)
}

/// The results of a run on disk.
pub(super) struct Results {
    /// The bits of each shot's vectors.
    vectors: BTreeMap<u64, Vec<u32>>,
    /// The same of the particles, of the shots whose particles were stored.
    particles: BTreeMap<u64, Vec<u64>>,
    /// Each camera's counts. Empty if they cannot be compared: the record of a killed run has
    /// undecided triggers, which a replay decides.
    accounts: Vec<BTreeMap<String, u64>>,
}

impl Results {
    /// # Errors
    ///
    /// Existing results or an existing ledger cannot be read.
    pub fn read(run: &Path) -> anyhow::Result<Self> {
        let accounts = if has_ledger(run) { accounts(run)? } else { Vec::new() };
        let (vectors, particles) = (stored_vectors(run)?, stored_particles(run)?);
        Ok(Self { vectors, particles, accounts })
    }

    /// Whether a shot has vectors.
    pub fn has(&self, shot: u64) -> bool {
        self.vectors.contains_key(&shot)
    }

    /// Excludes the shots that a damaged record has lost, and the counts.
    pub fn leave_out(&mut self, is_lost: impl Fn(u64) -> bool) {
        let before = self.vectors.len();
        self.vectors.retain(|shot, _| !is_lost(*shot));
        self.particles.retain(|shot, _| !is_lost(*shot));
        self.accounts.clear();
        let left_out = before - self.vectors.len();
        tracing::warn!(
            "{} and the ledger are not compared: the record is damaged",
            count(left_out, "shot")
        );
    }
}

/// Compares the results of a run with those of its replay. Shots without a stored result in the run
/// (shed, or lost in a crash) are left out and counted.
///
/// # Errors
///
/// The runs differ; the message says where.
pub(super) fn compare(then: &Results, now: &Results) -> anyhow::Result<()> {
    let mut differ = Vec::new();
    for (shot, vectors) in &then.vectors {
        match now.vectors.get(shot) {
            Some(same) if same == vectors => {}
            Some(_) => differ.push(format!("shot {shot}: different vectors")),
            None => differ.push(format!("shot {shot}: no result in the replay")),
        }
    }
    let more = now.vectors.keys().filter(|shot| !then.vectors.contains_key(shot)).count();
    print(&format!(
        "{} compared with the recorded run's results bit for bit, {} different; {more} had no \
         result in the run",
        count(then.vectors.len(), "shot"),
        differ.len()
    ))?;
    let particles = then.particles.iter().filter(|(shot, _)| now.has(**shot));
    for (shot, _) in
        particles.filter(|(shot, particles)| now.particles.get(shot) != Some(particles))
    {
        differ.push(format!("shot {shot}: different particles"));
    }
    differ.extend(ledger_differences(then, now));
    if differ.is_empty() {
        return match then.accounts.len() {
            0 => print(
                "no ledgers to compare: the recorded run was killed, or its record is damaged",
            ),
            _ => print("the ledgers are the same"),
        };
    }
    let listed: String = differ.iter().map(|line| format!("\n  {line}")).collect();
    bail!("the replay differs from the recorded run:{listed}")
}

/// Differences between the cameras' accounts. Shots shed live but measured in the replay are not a
/// difference.
fn ledger_differences(then: &Results, now: &Results) -> Vec<String> {
    let cameras = then.accounts.iter().zip(&now.accounts).enumerate();
    let lines = cameras.flat_map(|(camera, (then, now))| {
        then.iter().filter_map(move |(name, before)| {
            let after = now.get(name).copied().unwrap_or_default();
            (after != *before).then(|| {
                format!("{}: {name} {before} in the run, {after} in the replay", CameraName(camera))
            })
        })
    });
    lines.collect()
}

/// Counts of each camera. Shed shots count as complete. Triggers without evidence that they were
/// given are left out, because their number depends on when the run ended.
fn accounts(run: &Path) -> anyhow::Result<Vec<BTreeMap<String, u64>>> {
    let ledger = read_json(run)?;
    if ledger["error"] == CUT_OFF {
        return Ok(Vec::new());
    }
    let cameras = ledger["cameras"].as_array().cloned().unwrap_or_default();
    Ok(cameras.iter().map(account).collect())
}

fn account(camera: &Value) -> BTreeMap<String, u64> {
    let not_fired = camera["outcomes"]["not_fired"].as_u64().unwrap_or_default();
    let triggers = camera["triggers"].as_u64().unwrap_or_default().saturating_sub(not_fired);
    let mut counts = BTreeMap::from([("triggers".to_owned(), triggers)]);
    for (name, number) in camera["outcomes"].as_object().into_iter().flatten() {
        let name = match name.as_str() {
            "not_fired" => continue,
            "complete" | "shed" => "complete or shed",
            name => name,
        };
        *counts.entry(name.to_owned()).or_default() += number.as_u64().unwrap_or_default();
    }
    counts
}
