//! Holds two runs against each other: every number of every vector, and the ledgers.

use std::{collections::BTreeMap, fs, path::Path};

use anyhow::{Context, bail};
use serde_json::Value;

use super::output::{count, print};
use crate::archive::stored_vectors;

/// Compares the run in `again` with the one in `original`. Shots without a stored result in
/// `original` (shed then, or lost with a crash) are left out, and said.
///
/// # Errors
///
/// They differ; where.
pub(super) fn compare(original: &Path, again: &Path) -> anyhow::Result<()> {
    let (then, now) = (stored_vectors(original)?, stored_vectors(again)?);
    let mut differ = Vec::new();
    for (shot, vectors) in &then {
        match now.get(shot) {
            Some(same) if same == vectors => {}
            Some(_) => differ.push(format!("shot {shot}: other vectors")),
            None => differ.push(format!("shot {shot}: no result now")),
        }
    }
    let more = now.keys().filter(|shot| !then.contains_key(shot)).count();
    print(&format!(
        "{} held against the recorded run's results bit for bit, {} different; {more} had none then",
        count(then.len(), "shot"),
        differ.len()
    ))?;
    differ.extend(ledger_differences(original, again)?);
    if differ.is_empty() {
        return print("the ledgers are the same");
    }
    let listed: String = differ.iter().map(|line| format!("\n  {line}")).collect();
    bail!("the replay differs from the recorded run:{listed}")
}

/// Cameras' accounts that differ. What was shed live and is measured now moved from one count to
/// another, and is no difference.
fn ledger_differences(original: &Path, again: &Path) -> anyhow::Result<Vec<String>> {
    if !original.join("ledger.json").exists() {
        return Ok(Vec::new());
    }
    let (then, now) = (accounts(original)?, accounts(again)?);
    let lines = then.iter().zip(&now).enumerate().flat_map(|(camera, (then, now))| {
        then.iter().filter_map(move |(name, before)| {
            let after = now.get(name).copied().unwrap_or_default();
            (after != *before)
                .then(|| format!("camera {}: {name} {before} then, {after} now", camera + 1))
        })
    });
    Ok(lines.collect())
}

/// Counts of each camera, shed ones among the complete.
fn accounts(run: &Path) -> anyhow::Result<Vec<BTreeMap<String, u64>>> {
    let path = run.join("ledger.json");
    let text = fs::read(&path).with_context(|| format!("cannot read {}", path.display()))?;
    let ledger: Value = serde_json::from_slice(&text)
        .with_context(|| format!("{} is no ledger", path.display()))?;
    let cameras = ledger["cameras"].as_array().cloned().unwrap_or_default();
    Ok(cameras.iter().map(account).collect())
}

fn account(camera: &Value) -> BTreeMap<String, u64> {
    let mut counts = BTreeMap::from([(
        "triggers".to_owned(),
        camera["triggers"].as_u64().unwrap_or_default(),
    )]);
    for (name, number) in camera["outcomes"].as_object().into_iter().flatten() {
        let name = match name.as_str() {
            "complete" | "shed" => "complete or shed",
            name => name,
        };
        *counts.entry(name.to_owned()).or_default() += number.as_u64().unwrap_or_default();
    }
    counts
}
