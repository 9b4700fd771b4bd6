//! `lfpiv timing`: the timing diagram of lamps, Q-switches and cameras.

use std::{fs, path::PathBuf};

use anyhow::Context;
use lfpiv_hw::PulseSchedule;

use super::output::print;
use crate::config::{ConfigFile, Purpose};

/// Arguments of `lfpiv timing`.
#[derive(Debug, clap::Args)]
pub struct TimingArgs {
    /// Configuration file (TOML).
    #[arg(long, value_name = "FILE")]
    pub config: PathBuf,
    /// Also write the diagram to this file.
    #[arg(long, value_name = "FILE")]
    pub svg: Option<PathBuf>,
}

/// Plans the pulse schedule and prints its diagram, or the rules that it violates.
pub fn timing(args: &TimingArgs) -> anyhow::Result<()> {
    let config = ConfigFile::load_for(Purpose::Optics, &args.config)?.config;
    let schedule = PulseSchedule::plan(&config.timing, config.shot.dt_us, config.shot.rate_hz)
        .with_context(|| format!("{}: [shot] cannot be timed", args.config.display()))?;
    if let Some(path) = &args.svg {
        fs::write(path, schedule.diagram_svg())
            .with_context(|| format!("cannot write {}", path.display()))?;
    }
    print(schedule.diagram_text().trim_end())
}
