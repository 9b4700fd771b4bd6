//! `lfpiv export`: image files of a recorded run's shots.

use std::{ops::RangeInclusive, path::PathBuf};

use anyhow::{Context, bail};

use super::{
    losses::{Losses, tell_cut_off},
    output::{count, print, progress_bar},
    recording::refuse_running,
};
use crate::{
    acquisition::journal::RecordedRun,
    archive::{FileDepth, write_pair},
};

/// Arguments of `lfpiv export`.
#[derive(Debug, clap::Args)]
pub struct ExportArgs {
    /// Folder of the run.
    #[arg(value_name = "RUN")]
    pub run: PathBuf,
    /// Folder for the pairs: one folder per shot, as `lfpiv process` reads them.
    #[arg(long, value_name = "DIR")]
    pub out: PathBuf,
    /// Only these shots: a number, or first and last as A..B.
    #[arg(long, value_name = "A..B", value_parser = shot_range)]
    pub shots: Option<RangeInclusive<u64>>,
}

/// Writes a pair folder per shot, and the run's configuration beside them. Shots whose images cannot
/// be read are left out, and said.
pub fn export(args: &ExportArgs) -> anyhow::Result<()> {
    let mut recorded = RecordedRun::open(&args.run)?;
    let is_running = refuse_running(&args.run).is_err();
    if !is_running {
        recorded = recorded.finished();
    }
    let index = recorded.index();
    let wanted = |shot: &u64| args.shots.as_ref().is_none_or(|range| range.contains(shot));
    let shots: Vec<_> = index.shots.values().filter(|shot| wanted(&shot.trigger)).collect();
    let mut losses = if is_running { Losses::default() } else { Losses::of(&args.run, &index) };
    losses.only(wanted);
    if shots.is_empty() && losses.is_empty() {
        bail!(
            "{} holds no such shot: it has {}",
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
        tell_cut_off(&args.run, &index);
    }
    losses.conclude()
}

fn shot_range(text: &str) -> Result<RangeInclusive<u64>, String> {
    let number =
        |text: &str| text.trim().parse::<u64>().map_err(|_| format!("'{text}' is no shot number"));
    match text.split_once("..") {
        None => number(text).map(|shot| shot..=shot),
        Some((first, last)) => Ok(number(first)?..=number(last.trim_start_matches('='))?),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn ranges_name_their_first_and_last_shot() {
        assert_eq!(shot_range("7"), Ok(7..=7));
        assert_eq!(shot_range("3..5"), Ok(3..=5));
        assert_eq!(shot_range("3..=5"), Ok(3..=5));
        assert!(shot_range("3..x").unwrap_err().contains("'x'"));
    }
}
