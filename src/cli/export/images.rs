//! Exports the images of a recorded run as TIFF files.

use anyhow::{Context, bail};

use super::ExportArgs;
use crate::{
    acquisition::journal::RecordedRun,
    archive::{FileDepth, write_pair},
    cli::{
        losses::{Losses, warn_if_cut_off},
        output::{count, print, progress_bar},
        recording::refuse_running,
    },
};

/// Writes a pair folder per shot and the run's configuration. Shots whose images cannot be read are
/// reported and left out.
pub(super) fn export(args: &ExportArgs) -> anyhow::Result<()> {
    let mut recorded = RecordedRun::open(&args.run)?;
    let is_running = refuse_running(&args.run).is_err();
    if !is_running {
        recorded = recorded.finished();
    }
    let index = recorded.index();
    let shots: Vec<_> = index.shots.values().filter(|shot| args.includes(shot.trigger)).collect();
    let mut losses = if is_running { Losses::default() } else { Losses::of(&args.run, &index) };
    losses.only(|shot| args.includes(*shot));
    if shots.is_empty() && losses.is_empty() {
        bail!(
            "{} has none of these shots: it has {}",
            args.run.display(),
            count(index.shots.len(), "shot")
        );
    }
    let bar = progress_bar(shots.len(), "shots");
    let mut exported = 0;
    for shot in &shots {
        match recorded.pair(shot) {
            Ok(pair) => {
                let folder = args.out.join(format!("shot_{:06}", shot.trigger));
                write_pair(&folder, &pair, FileDepth::Sixteen)?;
                exported += 1;
            }
            Err(error) => losses.note(shot.trigger, error)?,
        }
        bar.inc(1);
    }
    bar.finish_and_clear();
    let configuration = args.out.join("configuration.toml");
    std::fs::create_dir_all(&args.out)
        .with_context(|| format!("cannot create {}", args.out.display()))?;
    std::fs::write(&configuration, &recorded.description().configuration)
        .with_context(|| format!("cannot write {}", configuration.display()))?;
    print(&format!("{} in {}", count(exported, "pair"), args.out.display()))?;
    if !is_running {
        warn_if_cut_off(&args.run, &index);
    }
    losses.conclude()
}
