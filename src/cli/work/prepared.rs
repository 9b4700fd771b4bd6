//! A run that a worker is ready to measure.

use std::path::Path;

use anyhow::{Context, bail};
use lfpiv_core::measurement::Processor;

use super::frames::{Frames, shared_run};
use crate::{
    acquisition::journal::RecordedRun,
    archive::{ShotResult, sha256},
    cli::{
        recorded_shots::shot_result,
        run_processor::{background_crc32, run_processor},
    },
    cluster::{Assignment, Attempt, CoordinatorClient, Delivery, Job, Shot, model_sha256},
    config::Config,
};

/// See the module.
pub(super) struct Prepared {
    processor: Processor,
    frames: Frames,
    wants_light: bool,
}

impl Prepared {
    /// Makes ready for the run of `job`: verifies that this machine has the same version, configuration and
    /// background images, and computes the same.
    ///
    /// # Errors
    /// It has not or does not; the message says in which way. A frame cannot be read.
    pub fn new(
        job: &Job,
        assignment: &Assignment,
        client: &CoordinatorClient,
        shared: Option<&Path>,
    ) -> anyhow::Result<Self> {
        let text = &assignment.configuration;
        if sha256(text.as_bytes()) != job.conditions.configuration_sha256 {
            bail!("the coordinator has sent another configuration than that of the job");
        }
        let config = Config::parse("the run's configuration", text)?;
        let own = background_crc32(&config)?;
        if own != job.conditions.background_crc32 {
            bail!("the background images on this machine are not those of the coordinator");
        }
        let frames = frames(job, &assignment.reference.shot, shared)?;
        let processor = run_processor(&config)?;
        let prepared = Self { processor, frames, wants_light: assignment.wants_light };
        prepared.reproduce(assignment, client)?;
        Ok(prepared)
    }

    /// Measures a shot.
    ///
    /// # Errors
    /// A frame cannot be read, or the shot cannot be measured.
    pub fn measure(&self, client: &CoordinatorClient, shot: &Shot) -> anyhow::Result<ShotResult> {
        let pair = self.frames.pair(client, shot)?;
        let measured = match self.wants_light {
            true => self.processor.process_with_light(pair)?,
            false => self.processor.process(pair)?,
        };
        Ok(shot_result(measured, shot.dt_us(), &shot.suspect, shot.time()))
    }

    /// Measures the reference, which decides the forward model here as it did there.
    fn reproduce(&self, assignment: &Assignment, client: &CoordinatorClient) -> anyhow::Result<()> {
        let reference = &assignment.reference;
        let result =
            self.measure(client, &reference.shot).context("the reference cannot be measured")?;
        let model_sha256 = model_sha256(&result.measured.model);
        let measured = Delivery {
            shot: reference.shot.number,
            attempt: Attempt { issue: 0, delivery: 0 },
            worker: String::new(),
            model_sha256,
            result,
        };
        let alike = measured.model_sha256 == reference.model_sha256
            && measured.result_sha256() == reference.result_sha256;
        if !alike {
            bail!(
                "this machine's result for shot {} differs from the coordinator's, perhaps because its \
                 processor has other vector instructions; use machines of one kind",
                reference.shot.number
            );
        }
        Ok(())
    }
}

/// Frames from the shared folder where the run is there, and is the same.
fn frames(job: &Job, reference: &Shot, shared: Option<&Path>) -> anyhow::Result<Frames> {
    let Some(shared) = shared else { return Ok(Frames::Coordinator) };
    let Some(folder) = shared_run(shared, &job.run_name) else {
        tracing::warn!(
            "{} has no run {}: its frames are read from the coordinator",
            shared.display(),
            job.run_name
        );
        return Ok(Frames::Coordinator);
    };
    let recorded = RecordedRun::open(&folder)?;
    let there = sha256(recorded.description().configuration.as_bytes());
    if there != job.conditions.configuration_sha256 {
        bail!("the run in {} has another configuration than the coordinator's", folder.display());
    }
    for frame in reference.frames.iter().flatten() {
        match recorded.image_crc32(frame.position()) {
            Ok(crc32) if crc32 != frame.crc32 => bail!(
                "the run in {} is another one than the coordinator's: shot {} has other images",
                folder.display(),
                reference.number
            ),
            Ok(_) => {}
            // A shared folder may show late what a run has just written.
            Err(error) => tracing::debug!("{error}"),
        }
    }
    Ok(Frames::Shared(Box::new(recorded)))
}
