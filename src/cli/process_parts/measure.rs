//! Measures one part.

use std::{collections::BTreeSet, fs, path::Path};

use anyhow::{Context, bail};
use tokio_util::sync::CancellationToken;

use super::part_file::{NAME, Part, PartFile, vector_instructions};
use crate::{
    acquisition::journal::RecordedRun,
    archive::{ResultStore, StoredResults, merge_segments},
    cli::{
        losses::Losses,
        output::{count, print},
        process_run::missing,
        recorded_shots::ShotProcessor,
        recording::{RunLock, refuse_running},
        run_processor::conditions,
    },
    config::Config,
};

/// Measures `part` of the shots of `run` that have no result there, into the folder `out`. Called again, it
/// goes on. Told to stop, it ends after the shot in hand.
///
/// # Errors
/// The run is still written or cannot be read; `out` holds something else; shots are left, failed or lost.
pub(in crate::cli) fn process_part(
    run: &Path,
    part: Part,
    out: &Path,
    stop: &CancellationToken,
) -> anyhow::Result<()> {
    refuse_running(run)?;
    let recorded = RecordedRun::open(run)?;
    let index = recorded.index();
    let text = &recorded.description().configuration;
    let config = Config::parse("the run's configuration", text)?;
    let in_run = StoredResults::find(run)?;
    let missing = missing(&index, &in_run);
    let conditions = conditions(&recorded, &index, &config)?;
    let shots = part.share(missing.iter().map(|shot| shot.trigger));

    fs::create_dir_all(out).with_context(|| format!("cannot create {}", out.display()))?;
    let _lock = RunLock::take(out)?;
    let mut file = begin(out, PartFile::new(part, conditions, shots))?;
    let (store, stored) = match out.join("configuration.toml").exists() {
        true => ResultStore::reopen(out, text)?,
        false => (ResultStore::create(out, text)?, StoredResults::default()),
    };
    if file.instructions.insert(vector_instructions()) {
        file.write(out)?;
    }
    let store = store.for_paraview(config.output.paraview);
    for part in &stored.unreadable {
        tracing::warn!("{}: the part was cut off before this was sealed", part.display());
    }

    let own: BTreeSet<u64> = file.shots.iter().copied().collect();
    let is_wanted = |shot| own.contains(&shot) && !stored.shots.contains(&shot);
    let mut losses = Losses::none_yet(run);
    let mut processor = ShotProcessor::prepare(&config, &recorded, &index, &in_run)?;
    let finished = processor.measure(&missing, is_wanted, &mut losses, store, stop)?;
    merge_segments(out, || !stop.is_cancelled())?;

    if let (Some(before), Some(now)) = (&file.decision, processor.decision())
        && before != now
    {
        bail!(
            "{}: the forward model is another one than when this part was begun, on another \
             processor perhaps: remove the folder, and measure the part anew",
            out.display()
        );
    }
    file.decision = processor.decision().cloned().or(file.decision);
    file.finished = finished.left == 0;
    file.failed.clone_from(&finished.failed);
    file.lost.clone_from(losses.shots());
    file.write(out)?;
    let have = StoredResults::find(out)?.shots.len();
    print(&format!(
        "{}: part {part} of {}: {have} of {} have a result",
        out.display(),
        run.display(),
        count(own.len(), "shot")
    ))?;
    finished.conclude()?;
    losses.conclude()
}

/// Begins the part that `new` describes in `out`, or goes on with it.
fn begin(out: &Path, new: PartFile) -> anyhow::Result<PartFile> {
    let Some(file) = PartFile::read(out)? else {
        if out.join("configuration.toml").exists() {
            bail!(
                "{} holds other results and no {NAME}: give the part a folder of its own",
                out.display()
            );
        }
        new.write(out)?;
        return Ok(new);
    };
    let out = out.display();
    if file.part != new.part {
        bail!("{out} holds part {}: give part {} a folder of its own", file.part, new.part);
    }
    if let Some(difference) = file.conditions.difference(&new.conditions) {
        bail!("the part in {out} {difference}: give this one a folder of its own");
    }
    if file.shots != new.shots {
        bail!(
            "{out} holds a part of other shots: the run has got results since it was begun. Remove \
             the folder, and measure the part anew"
        );
    }
    Ok(file)
}
