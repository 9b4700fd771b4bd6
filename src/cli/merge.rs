//! `lfpiv merge`: merges the many NetCDF files of a run into few.

use std::path::PathBuf;

use anyhow::bail;

use super::{
    output::{count, print},
    recording::RunLock,
};
use crate::archive::{StoredShots, merge_segments};

/// Arguments of `lfpiv merge`.
#[derive(Debug, clap::Args)]
pub struct MergeArgs {
    /// Folders of finished runs.
    #[arg(required = true, value_name = "RUN")]
    pub runs: Vec<PathBuf>,
}

/// Merges the sealed NetCDF files of each run.
pub fn merge(args: &MergeArgs) -> anyhow::Result<()> {
    for run in &args.runs {
        if !run.join("configuration.toml").is_file() {
            bail!("{} is not the folder of a run: it has no configuration.toml", run.display());
        }
        let _lock = RunLock::take(run)?;
        let before = StoredShots::find(run)?.files();
        merge_segments(run, || true)?;
        let stored = StoredShots::find(run)?;
        print(&format!(
            "{}: {} in {}, {before} before",
            run.display(),
            count(stored.len(), "shot"),
            count(stored.files(), "file"),
        ))?;
    }
    Ok(())
}
