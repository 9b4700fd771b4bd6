//! Sets up the processor of a run.

use anyhow::{Context, bail};
use lfpiv_core::{
    lightfield::{Background, ImagePair},
    measurement::Processor,
};

use crate::{
    acquisition::journal::{RecordedRun, RunIndex},
    archive::{read_pair, sha256},
    cluster::Conditions,
    config::Config,
    pipeline::monotonic,
};

/// Reads the configured background images.
///
/// # Errors
/// No folder is configured, or the images cannot be read.
pub(super) fn background_images(config: &Config) -> anyhow::Result<ImagePair> {
    let Some(folder) = &config.image.background_dir else {
        bail!(
            "image.background = \"images\" needs image.background_dir, a folder with one \
             background image per camera and frame, named like a pair"
        )
    };
    read_pair(folder, config.camera.len(), (&config.optics.sensor).into())
        .context("cannot read the background images")
}

/// Warns if only a part of the cameras' parameters is calibrated.
pub(super) fn warn_of_nominal_poses(config: &Config) {
    if let Some(left) = config.left_nominal() {
        tracing::warn!("{left}");
    }
}

/// Builds the tables, and learns stationary light from background images if configured.
///
/// # Errors
///
/// The volume cannot be measured, the background images cannot be read, or the background is to be
/// estimated from all pairs, which are not available before the run.
pub(super) fn run_processor(config: &Config) -> anyhow::Result<Processor> {
    warn_of_nominal_poses(config);
    let mut processor = Processor::timed(config.measurement(), monotonic)
        .context("no measurement is possible with this configuration")?;
    match config.image.background {
        Background::Constant => {}
        Background::Images => processor.learn_background(&background_images(config)?)?,
        Background::Minimum | Background::Mean => bail!(
            "image.background estimates stationary light from all pairs, but a run \
             has them only at its end: set it to \"constant\" or \"images\"; afterwards `lfpiv \
             export` writes the run's pairs, and `lfpiv process` uses all of them"
        ),
    }
    Ok(processor)
}

/// What results of a run depend on besides its images and the forward model.
///
/// # Errors
/// The background images cannot be read.
pub(super) fn conditions(
    recorded: &RecordedRun,
    index: &RunIndex,
    config: &Config,
) -> anyhow::Result<Conditions> {
    let shots = index.shots.values().map(|shot| {
        let utc_ns = shot.time.map(|time| time.utc_ns);
        format!("{} {utc_ns:?} {}\n", shot.trigger, shot.dt_us)
    });
    conditions_of(recorded, sha256(shots.collect::<String>().as_bytes()), config)
}

/// The same, where something else tells runs apart.
///
/// # Errors
/// The background images cannot be read.
pub(super) fn conditions_of(
    recorded: &RecordedRun,
    shots_sha256: String,
    config: &Config,
) -> anyhow::Result<Conditions> {
    Ok(Conditions {
        code_version: env!("CARGO_PKG_VERSION").to_owned(),
        configuration_sha256: sha256(recorded.description().configuration.as_bytes()),
        shots_sha256,
        background_crc32: background_crc32(config)?,
    })
}

/// Checksums of the background images, where there are some.
///
/// # Errors
/// They cannot be read.
pub(super) fn background_crc32(config: &Config) -> anyhow::Result<Vec<u32>> {
    let images = match config.image.background {
        Background::Images => background_images(config)?.cameras,
        _ => Vec::new(),
    };
    Ok(images.iter().flatten().map(|image| image.crc32()).collect())
}
