//! `lfpiv check`: validates a configuration and shows what a run will do.

mod advice;
mod sample;

use std::{fmt::Write, path::PathBuf};

use anyhow::Context;
use lfpiv_core::{lightfield::Background, measurement::Processor, model::VolumeGrid};

use super::{
    finding,
    output::{count, print},
    run_processor::background_images,
};
use crate::{
    config::{Config, ConfigFile, Purpose},
    pipeline::monotonic,
};

/// Arguments of `lfpiv check`.
#[derive(Debug, clap::Args)]
pub struct CheckArgs {
    /// Configuration file (TOML).
    #[arg(long, value_name = "FILE")]
    pub config: PathBuf,
    /// Leave out the expected seconds, for which a part of the volume is simulated and measured.
    #[arg(long)]
    pub quick: bool,
}

/// Validates a configuration, sets the measurement up, and prints what it will do and what could be
/// better.
pub fn check(args: &CheckArgs) -> anyhow::Result<()> {
    let file = ConfigFile::load_for(Purpose::Bench, &args.config)?;
    let mut processor = Processor::timed(file.config.measurement(), monotonic)
        .with_context(|| format!("no measurement is possible with {}", args.config.display()))?;
    if file.config.image.background == Background::Images {
        processor.learn_background(&background_images(&file.config)?)?;
    }
    let (path, plan) = (args.config.display(), processor.plan());
    print(&format!("{path} is valid.\n\n{}\n{plan}", summary(&file.config)))?;
    // The tables of the whole volume are no longer needed, and may be large.
    drop(processor);
    let mut findings = advice::for_configuration(&file.config);
    findings.extend(advice::mask(&file.config, &plan));
    findings.push(advice::memory(&file.config, &plan));
    if !args.quick {
        findings.push(advice::time(&file.config, &sample::expected(&file.config, &plan)));
    }
    print(&finding::report(&findings))
}

/// Summary of the configuration, one line per subject.
fn summary(config: &Config) -> String {
    let mut lines = vec![
        ("cameras", cameras(config)),
        ("field of view", field_of_view(config)),
        ("volume", volume(&config.volume.grid())),
        ("mask", mask(config)),
        ("timing", format!("dt {} us, {} shots/s", config.shot.dt_us, config.shot.rate_hz)),
    ];
    if let Some(scene) = &config.simulation {
        let particles = config
            .simulated_particles()
            .map_or(String::new(), |n| format!(", {n:.0} in the volume"));
        lines.push(("simulation", format!("{} particles per microlens{particles}", scene.ppm)));
    }
    lines.push(("server", config.server.url(config.server.address)));
    lines.push(("output", config.output.dir.display().to_string()));
    lines.into_iter().fold(String::new(), |mut text, (subject, line)| {
        // Writing to a String does not fail.
        let _ = writeln!(text, "{subject:<14} {line}");
        text
    })
}

fn cameras(config: &Config) -> String {
    let optics = &config.optics;
    format!(
        "{}, each {} x {} microlenses on {} x {} pixels of {} um",
        config.camera.len(),
        optics.microlens.columns,
        optics.microlens.rows,
        optics.sensor.columns,
        optics.sensor.rows,
        optics.sensor.pixel_pitch_um
    )
}

fn field_of_view(config: &Config) -> String {
    let optics = &config.optics;
    let object_pitch_mm =
        optics.microlens.pitch_mm * optics.object_distance_mm / optics.image_distance_mm();
    format!(
        "{:.2} x {:.2} mm in focus, one microlens {object_pitch_mm:.3} mm",
        optics.microlens.columns as f64 * object_pitch_mm,
        optics.microlens.rows as f64 * object_pitch_mm
    )
}

/// How much of the volume is flow, and which files say so.
fn mask(config: &Config) -> String {
    let Some(stored) = &config.mask else { return "none: all of the volume is flow".to_owned() };
    let files = stored.files.iter().map(|file| {
        format!(", {} with {}", file.file.display(), count(file.triangles, "triangle"))
    });
    format!(
        "{:.1} % of the volume is flow{}",
        100.0 * stored.mask.flow_share(),
        files.collect::<String>()
    )
}

fn volume(grid: &VolumeGrid) -> String {
    let [x, y, z] = [0, 1, 2].map(|axis| {
        let half_mm = grid.voxels[axis] as f64 * grid.voxel_mm / 2.0;
        let centre_mm = grid.centre_mm[axis];
        format!("{:.2} to {:.2}", centre_mm - half_mm, centre_mm + half_mm)
    });
    let [nx, ny, nz] = grid.voxels;
    format!("{nx} x {ny} x {nz} voxels of {} mm: x {x}, y {y}, z {z} mm", grid.voxel_mm)
}
