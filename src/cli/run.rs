//! `lfpiv run`: the daemon.

use std::path::PathBuf;

use crate::config::ConfigFile;

/// Arguments of `lfpiv run`.
#[derive(Debug, clap::Args)]
pub struct RunArgs {
    /// Configuration file (TOML).
    #[arg(long, value_name = "FILE")]
    pub config: PathBuf,
    /// Stop after this many shots; without it, run until told to stop.
    #[arg(long, value_name = "N")]
    pub shots: Option<u64>,
}

/// Runs the bench until its shots are done or it is told to stop.
pub fn run(args: RunArgs) -> anyhow::Result<()> {
    ConfigFile::load(&args.config)?;
    anyhow::bail!("this build cannot run a bench yet: use `lfpiv simulate` and `lfpiv process`")
}
