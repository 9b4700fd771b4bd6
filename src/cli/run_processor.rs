//! The processor of a run: what it knows before the first shot.

use anyhow::{Context, bail};

use crate::{archive::read_pair, config::Config, lightfield::Background, pipeline::Processor};

/// Tables for a run's shots, and its stationary light where the configuration has images of it.
///
/// # Errors
///
/// The volume cannot be measured, the background images cannot be read, or the background is to be
/// taken from pairs that a run does not have yet.
pub(super) fn run_processor(config: &Config) -> anyhow::Result<Processor> {
    let mut processor = Processor::new(config.measurement()).context("this cannot be measured")?;
    match (config.image.background, &config.image.background_dir) {
        (Background::Constant, _) => {}
        (Background::Images, Some(folder)) => {
            let pair = read_pair(folder, config.camera.len(), (&config.optics.sensor).into())
                .context("cannot read the background images")?;
            processor.learn_background(&pair)?;
        }
        (Background::Images, None) => bail!(
            "image.background = \"images\" needs image.background_dir, a folder with one background \
             image per camera and frame, named like a pair"
        ),
        (Background::Minimum | Background::Mean, _) => bail!(
            "image.background takes what all pairs have in common for stationary light, and a run \
             has them only when it is over: set it to \"constant\" or \"images\"; afterwards `lfpiv \
             export` makes pairs of the run, and `lfpiv process` takes them all"
        ),
    }
    Ok(processor)
}
