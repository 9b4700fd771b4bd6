//! The processor of a run: what it knows before the first shot.

use anyhow::{Context, bail};
use lfpiv_core::{
    lightfield::{Background, ImagePair},
    measurement::Processor,
};

use crate::{archive::read_pair, config::Config, pipeline::monotonic};

/// The background images that the configuration names.
///
/// # Errors
/// It names none, or they cannot be read.
pub(super) fn background_images(config: &Config) -> anyhow::Result<ImagePair> {
    let Some(folder) = &config.image.background_dir else {
        bail!(
            "image.background = \"images\" needs image.background_dir, a folder with one background \
             image per camera and frame, named like a pair"
        )
    };
    read_pair(folder, config.camera.len(), (&config.optics.sensor).into())
        .context("cannot read the background images")
}

/// Says once what calibrations leave as it was drawn.
pub(super) fn warn_of_drawn_places(config: &Config) {
    if let Some(left) = config.left_as_drawn() {
        tracing::warn!("{left}");
    }
}

/// Tables for a run's shots, and its stationary light where the configuration has images of it.
///
/// # Errors
///
/// The volume cannot be measured, the background images cannot be read, or the background is to be
/// taken from pairs that a run does not have yet.
pub(super) fn run_processor(config: &Config) -> anyhow::Result<Processor> {
    warn_of_drawn_places(config);
    let mut processor =
        Processor::timed(config.measurement(), monotonic).context("this cannot be measured")?;
    match config.image.background {
        Background::Constant => {}
        Background::Images => processor.learn_background(&background_images(config)?)?,
        Background::Minimum | Background::Mean => bail!(
            "image.background takes what all pairs have in common for stationary light, and a run \
             has them only when it is over: set it to \"constant\" or \"images\"; afterwards `lfpiv \
             export` makes pairs of the run, and `lfpiv process` takes them all"
        ),
    }
    Ok(processor)
}
