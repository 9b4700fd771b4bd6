//! `lfpiv correlate`: velocity from two given volumes.

use std::{
    path::{Path, PathBuf},
    sync::Arc,
    time::Instant,
};

use anyhow::Context;
use lfpiv_core::{
    model::ModelChoice,
    velocimetry::{PairResult, StageSeconds, VelocityField, VolumeInterrogation},
};

use super::{
    output::{count, print},
    volume_reader::read_safely,
};
use crate::{
    archive::{VtiSource, write_velocity, write_vti},
    config::{ConfigFile, Purpose},
};

/// Arguments of `lfpiv correlate`.
#[derive(Debug, clap::Args)]
pub struct CorrelateArgs {
    /// Configuration file (TOML): position of the volume, windows, and time between frames.
    #[arg(long, value_name = "FILE")]
    pub config: PathBuf,
    /// Folder for the result.
    #[arg(long, value_name = "OUT")]
    pub out: PathBuf,
    /// NetCDF file with frames a and b over z, y, x, written by `process --save-volumes` or by any
    /// other reconstruction.
    #[arg(value_name = "VOLUMES")]
    pub volumes: PathBuf,
}

/// Measures the displacement between the two frames of a file.
pub fn correlate(args: &CorrelateArgs) -> anyhow::Result<()> {
    let ConfigFile { config, text, .. } = ConfigFile::load_for(Purpose::Volumes, &args.config)?;
    let [a, b] = read_safely(&args.volumes, &config.volume.grid())?;
    let interrogation = VolumeInterrogation::new(&config.volume.grid(), &config.velocimetry)
        .with_mask(config.measurement().mask);
    let started = Instant::now();
    let field = interrogation.measure(&a, &b, config.measurement().dt_s);
    let seconds =
        StageSeconds { correlate_s: started.elapsed().as_secs_f64(), ..Default::default() };
    let line = summary(&field, seconds.correlate_s);
    if config.output.paraview {
        create(&args.out)?;
        let source = VtiSource { shot: 0, utc_s: None, configuration: &text };
        write_vti(&args.out.join("velocity.vti"), &source, &field)?;
    }
    store(&args.out, &text, field, seconds)?;
    print(&line)
}

fn summary(field: &VelocityField, seconds: f64) -> String {
    format!(
        "{}, {:.1} % valid; correlated in {seconds:.2} s",
        count(field.grid.len(), "vector"),
        100.0 * field.valid_share(),
    )
}

fn create(folder: &Path) -> anyhow::Result<()> {
    std::fs::create_dir_all(folder).with_context(|| format!("cannot create {}", folder.display()))
}

fn store(
    folder: &Path,
    configuration: &str,
    field: VelocityField,
    seconds: StageSeconds,
) -> anyhow::Result<()> {
    create(folder)?;
    let measured = PairResult {
        field,
        seconds,
        warnings: Vec::new(),
        // The volumes come from elsewhere, so there is no model of ours.
        model: Arc::new(ModelChoice::default()),
        fit: None,
        light: None,
        particles: None,
    };
    Ok(write_velocity(&folder.join("velocity.nc"), configuration, 0, &measured.into())?)
}
