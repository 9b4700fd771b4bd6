//! `lfpiv peers`: the cases that other programs are compared on, and this program's own rows.

use std::{
    fs,
    path::{Path, PathBuf},
};

use anyhow::{Context, bail};
use lfpiv::cli::output::print;
use lfpiv::config::{Config, ConfigFile};
use lfpiv_bench::peers::{
    CorrelationCase, FieldCase, ReconstructionCase, Row, time_correlation, time_field,
    time_reconstruction,
};
use lfpiv_sim::Scene;

/// The configuration that a case was made with, in its folder.
const CONFIGURATION: &str = "configuration.toml";

/// What is made or timed.
#[derive(Debug, clap::Subcommand)]
pub enum PeersCommand {
    /// Write a frame's views, the explicit weight matrix, the photo-hull and the true volume.
    ExportViews(ExportArgs),
    /// Write a pair of volumes and the true displacement of every window.
    ExportVolumes {
        #[command(flatten)]
        export: ExportArgs,
        /// Volumes reconstructed from ray-traced images, not the true particles.
        #[arg(long)]
        reconstructed: bool,
    },
    /// Write true particles with their displacements, unseen places, and the particles' light as volumes.
    ExportParticles(ExportArgs),
    /// Time the configured solver on exported views and print the row as JSON.
    Reconstruct {
        #[command(flatten)]
        time: TimeArgs,
        /// Passes over all views instead of the configured ones.
        #[arg(long, value_name = "N")]
        passes: Option<usize>,
    },
    /// Time the correlation of exported volumes and print the row as JSON.
    Correlate {
        #[command(flatten)]
        time: TimeArgs,
        /// Correlation passes instead of the configured ones.
        #[arg(long, value_name = "N")]
        passes: Option<usize>,
    },
    /// Time the field through exported particles and print the row as JSON.
    Field {
        #[command(flatten)]
        time: TimeArgs,
        /// A field that is nearly free of divergence.
        #[arg(long)]
        incompressible: bool,
    },
}

/// From where to where a case is exported.
#[derive(Debug, clap::Args)]
pub struct ExportArgs {
    /// Configuration file (TOML) with a [simulation] table.
    #[arg(long, value_name = "FILE")]
    pub config: PathBuf,
    /// Folder of the case, whose name is the folder's.
    #[arg(long, value_name = "DIR")]
    pub out: PathBuf,
}

/// What is timed, and how often.
#[derive(Debug, clap::Args)]
pub struct TimeArgs {
    /// Folder of an exported case.
    #[arg(value_name = "DIR")]
    pub case: PathBuf,
    /// Runs of which the median is taken.
    #[arg(long, value_name = "N", default_value_t = 5)]
    pub repeats: usize,
}

/// Exports a case or times this program on one.
pub fn peers(command: &PeersCommand) -> anyhow::Result<()> {
    match command {
        PeersCommand::ExportViews(export) => export_views(export),
        PeersCommand::ExportVolumes { export, reconstructed } => {
            export_volumes(export, *reconstructed)
        }
        PeersCommand::ExportParticles(export) => export_particles(export),
        PeersCommand::Field { time, incompressible } => {
            let grid = case_config(&time.case)?.volume.grid();
            print_row(&time_field(&time.case, &grid, *incompressible, time.repeats)?)
        }
        PeersCommand::Reconstruct { time, passes } => {
            let config = case_config(&time.case)?;
            let (bench, grid) = (config.bench_geometry(), &config.volume.grid());
            let mut settings = config.reconstruction.clone();
            settings.passes = passes.or(settings.passes);
            print_row(&time_reconstruction(&time.case, &bench, grid, &settings, time.repeats)?)
        }
        PeersCommand::Correlate { time, passes } => {
            let config = case_config(&time.case)?;
            let mut settings = config.velocimetry.clone();
            settings.passes = passes.unwrap_or(settings.passes);
            let dt_s = config.measurement().dt_s;
            let repeats = time.repeats;
            print_row(&time_correlation(
                &time.case,
                &config.volume.grid(),
                &settings,
                dt_s,
                repeats,
            )?)
        }
    }
}

fn export_views(export: &ExportArgs) -> anyhow::Result<()> {
    let (config, scene) = start_export(export)?;
    let bench = config.bench_geometry();
    let case = ReconstructionCase::simulate(&bench, &config.volume.grid(), &scene)?;
    Ok(case.write(&bench, &export.out)?)
}

fn export_volumes(export: &ExportArgs, reconstructed: bool) -> anyhow::Result<()> {
    let (config, scene) = start_export(export)?;
    let bench = config.bench_geometry();
    let case = if reconstructed {
        CorrelationCase::reconstructed(&bench, &config.measurement(), &scene)?
    } else {
        CorrelationCase::of_particles(&bench, &config.volume.grid(), &scene, &config.velocimetry)
    };
    Ok(case.write(&export.out)?)
}

fn export_particles(export: &ExportArgs) -> anyhow::Result<()> {
    let (config, scene) = start_export(export)?;
    let grid = config.volume.grid();
    let bench = config.bench_geometry();
    let case = FieldCase::of_particles(&bench, &grid, &scene, &config.velocimetry);
    Ok(case.write(&export.out)?)
}

/// Makes the case's folder with the configuration in it.
fn start_export(export: &ExportArgs) -> anyhow::Result<(Config, Scene)> {
    let ConfigFile { text, config, .. } = ConfigFile::load(&export.config)?;
    let Some(scene) = config.simulation.clone() else {
        bail!("{} has no [simulation] table", export.config.display());
    };
    fs::create_dir_all(&export.out)
        .and_then(|()| fs::write(export.out.join(CONFIGURATION), text))
        .with_context(|| format!("cannot write to {}", export.out.display()))?;
    Ok((config, scene))
}

fn case_config(folder: &Path) -> anyhow::Result<Config> {
    Ok(ConfigFile::load(&folder.join(CONFIGURATION))?.config)
}

fn print_row(row: &Row) -> anyhow::Result<()> {
    print(&serde_json::to_string(row)?)
}
