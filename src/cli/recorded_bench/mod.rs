//! Simulated instruments on real wires that show the frames of a recorded run.
//!
//! Trigger n of the synchroniser shows the frames of trigger n of the record. The daemon programs
//! the synchroniser anew: if light pulses and exposures agree with those of the record, the
//! recorded images are shown, otherwise dark ones.

mod light;
mod pictures;
mod triggers;

use std::path::Path;

use anyhow::{Context, bail};
use lfpiv_hw::gige::ImageSize;

pub(super) use pictures::{RecordedPictures, Shown};
use triggers::RecordedTriggers;

use super::losses::Losses;
use crate::{acquisition::journal::RecordedRun, config::Config};

/// An opened recorded run.
pub(super) struct RecordedBench {
    recorded: RecordedRun,
    triggers: RecordedTriggers,
    /// Damaged or missing parts of the record, without images.
    pub losses: Losses,
    /// Significant bits of the images.
    pub count_bits: u32,
}

impl RecordedBench {
    /// Opens the record in `run` for a bench described by `bench`.
    ///
    /// # Errors
    /// The record cannot be opened, or its cameras differ from the bench's.
    pub fn open(run: &Path, bench: &Config) -> anyhow::Result<Self> {
        let recorded = RecordedRun::open(run)?.finished();
        let config = Config::parse(
            "the recorded run's configuration",
            &recorded.description().configuration,
        )?;
        let [recorded_size, bench_size] =
            [&config, bench].map(|config| ImageSize::from(&config.optics.sensor));
        if recorded_size != bench_size {
            bail!(
                "{} was recorded with images of {} x {} pixels, but this bench has {} x {}: use \
                 the [optics] of the recorded run's configuration",
                run.display(),
                recorded_size.columns,
                recorded_size.rows,
                bench_size.columns,
                bench_size.rows
            );
        }
        if config.camera.len() != bench.camera.len() {
            let (recorded_cameras, bench_cameras) = (config.camera.len(), bench.camera.len());
            bail!(
                "{} was recorded with {recorded_cameras} cameras, but this bench has \
                 {bench_cameras}",
                run.display()
            );
        }
        let count_bits =
            count_bits(&config).with_context(|| format!("{} cannot be replayed", run.display()))?;
        let triggers = RecordedTriggers::read(&recorded);
        let losses = Losses::of(run, &recorded.index());
        losses.log();
        Ok(Self { recorded, triggers, losses, count_bits })
    }

    /// Number of triggers in the record.
    pub fn triggers(&self) -> usize {
        self.triggers.len()
    }

    /// The frames as images for the bench.
    ///
    /// # Errors
    /// The reading thread cannot be started.
    pub fn pictures(self, bench: &Config) -> anyhow::Result<RecordedPictures> {
        let size = ImageSize::from(&bench.optics.sensor);
        RecordedPictures::read(self.recorded, self.triggers, size, self.count_bits)
    }
}

/// Significant bits of the images, from the run's configuration.
fn count_bits(config: &Config) -> anyhow::Result<u32> {
    if let Some(scene) = &config.simulation {
        return Ok(scene.sensor.bits.into());
    }
    let cameras = config.instruments.iter().flat_map(|instruments| &instruments.camera);
    let bits = cameras.map(|camera| camera.pixel_format.significant_bits()).max();
    bits.context("its configuration names neither a simulated sensor nor cameras")
}
