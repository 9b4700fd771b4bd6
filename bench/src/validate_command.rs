//! `lfpiv validate`: light-field and planar PIV of one simulated jet, beside the truth.

use std::{fs, path::PathBuf};

use anyhow::Context;
use lfpiv::{
    cli::output::{count, print, progress_bar},
    config::{Config, read_or_shipped},
};
use lfpiv_bench::validate::{Validation, write};

/// Files are written after this many shots, and at the end.
const SHOTS_BETWEEN_FILES: u64 = 5;

/// Arguments of `lfpiv validate`.
#[derive(Debug, clap::Args)]
pub struct ValidateArgs {
    /// Number of shots. Means of fewer than 20 say little of fluctuations.
    #[arg(long, value_name = "N", default_value_t = 200, value_parser = clap::value_parser!(u64).range(2..=100_000))]
    pub shots: u64,
    /// Folder for validation.html, its pictures, validation.json and profiles.csv.
    #[arg(long, value_name = "DIR", default_value = "results/validation")]
    pub out: PathBuf,
    /// The light-field bench, with two cameras and a [simulation] table. Its flow and time between the pulses are
    /// replaced by those of the jet.
    #[arg(long, value_name = "FILE", default_value = "config/jet.toml")]
    pub config: PathBuf,
    /// Seed of particles, noise and fluctuations.
    #[arg(long, default_value_t = 1)]
    pub seed: u64,
}

/// Simulates and measures all shots, prints the differences and writes the comparison, that of the shots so far
/// meanwhile.
pub fn validate(args: &ValidateArgs) -> anyhow::Result<()> {
    let name = args.config.display().to_string();
    let text = read_or_shipped(&args.config).with_context(|| format!("cannot read {name}"))?;
    let config = Config::parse(&name, &text)?;
    anyhow::ensure!(
        config.camera.len() == 2,
        "{name} has {}: validate compares one camera with two; add a [[camera]] table or choose \
         config/jet.toml",
        count(config.camera.len(), "camera")
    );
    fs::create_dir_all(&args.out)
        .with_context(|| format!("cannot create {}", args.out.display()))?;
    let mut running = Validation::new(config, args.seed).start()?;
    let bar = progress_bar(args.shots as usize, "shots");
    bar.tick();
    for shot in 1..=args.shots {
        running.next_shot()?;
        bar.inc(1);
        // What is broken off has its comparison so far.
        if shot % SHOTS_BETWEEN_FILES == 0 && shot < args.shots {
            write(&running.comparison(), &args.out)?;
        }
    }
    bar.finish_and_clear();
    let comparison = running.comparison();
    write(&comparison, &args.out)?;
    print(&comparison.table())?;
    let page = args.out.join("validation.html");
    print(&format!("{}: {}", count(args.shots as usize, "shot"), page.display()))
}
