//! The frames of a recorded run, shown by simulated instruments at the ends of real wires.
//!
//! Trigger n of the synchroniser shows the frames of trigger n in the record. What the daemon
//! programs is not taken from the record: a picture is shown only where the light falls as it did
//! then, and is dark where not.

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

/// A recorded run, ready to be shown.
pub(super) struct RecordedBench {
    recorded: RecordedRun,
    triggers: RecordedTriggers,
    /// What of the record is damaged or missing, images left out.
    pub losses: Losses,
    /// Significant bits of the run's counts.
    pub count_bits: u32,
}

impl RecordedBench {
    /// Opens the record in `run`, whose frames a bench as `bench` describes it shall show.
    ///
    /// # Errors
    /// The record cannot be opened, or is of other cameras.
    pub fn open(run: &Path, bench: &Config) -> anyhow::Result<Self> {
        let recorded = RecordedRun::open(run)?.finished();
        let config = Config::parse(
            "the recorded run's configuration",
            &recorded.description().configuration,
        )?;
        let [then, now] = [&config, bench].map(|config| ImageSize::from(&config.optics.sensor));
        if then != now {
            bail!(
                "{} was recorded with images of {} x {} pixels, this bench has {} x {}: give it \
                 the [optics] of the recorded run's configuration",
                run.display(),
                then.columns,
                then.rows,
                now.columns,
                now.rows
            );
        }
        if config.camera.len() != bench.camera.len() {
            let (then, now) = (config.camera.len(), bench.camera.len());
            bail!("{} was recorded with {then} cameras, this bench has {now}", run.display());
        }
        let count_bits =
            count_bits(&config).with_context(|| format!("{} cannot be played", run.display()))?;
        let triggers = RecordedTriggers::read(&recorded);
        let losses = Losses::of(run, &recorded.index());
        losses.tell();
        Ok(Self { recorded, triggers, losses, count_bits })
    }

    /// Number of triggers in the record.
    pub fn triggers(&self) -> usize {
        self.triggers.len()
    }

    /// The frames, as the bench asks for them.
    ///
    /// # Errors
    /// There is no thread to read them.
    pub fn pictures(self, bench: &Config) -> anyhow::Result<RecordedPictures> {
        let size = ImageSize::from(&bench.optics.sensor);
        RecordedPictures::read(self.recorded, self.triggers, size, self.count_bits)
    }
}

/// Bits that the counts of a run may use, by its configuration.
fn count_bits(config: &Config) -> anyhow::Result<u32> {
    if let Some(scene) = &config.simulation {
        return Ok(scene.sensor.bits.into());
    }
    let cameras = config.instruments.iter().flat_map(|instruments| &instruments.camera);
    let bits = cameras.map(|camera| camera.pixel_format.significant_bits()).max();
    bits.context("its configuration names neither a simulated sensor nor cameras")
}
