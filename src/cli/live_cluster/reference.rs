//! The first shots of a run, measured by the daemon itself: one of them decides the forward model.

use std::{fmt::Display, sync::Arc};

use lfpiv_core::{lightfield::ImagePair, model::ModelMode, velocimetry::PairResult};
use rayon::ThreadPool;

use super::publisher::{Publisher, blocking};
use crate::{
    acquisition::journal::{RecordedRun, RecordedShot},
    archive::{RawLevel, ShotResult},
    config::Config,
    pipeline::{measuring_threads, process_guarded},
};

/// See the module.
pub(super) struct ReferenceSearch<P> {
    process: Arc<P>,
    threads: Arc<ThreadPool>,
    /// Whether a shot decides; the configuration may.
    is_chosen: bool,
}

impl<P, E> ReferenceSearch<P>
where
    P: Fn(&ImagePair) -> Result<PairResult, E> + Send + Sync + 'static,
    E: Display + 'static,
{
    pub fn new(config: &Config, process: P) -> anyhow::Result<Self> {
        let is_chosen = config.model.mode != ModelMode::Explicit;
        let (process, threads) = (Arc::new(process), Arc::new(measuring_threads(0)?));
        Ok(Self { process, threads, is_chosen })
    }

    /// Measures shots, in their order, up to the one that decides, and returns it with its result. `None` if the
    /// run ends before.
    ///
    /// # Errors
    /// The record cannot be opened.
    pub async fn run(
        &self,
        publisher: &Publisher,
    ) -> anyhow::Result<Option<(RecordedShot, ShotResult)>> {
        while let Some(recorded) = publisher.next().await {
            let shot = match publisher.find(recorded).await {
                Ok(shot) => shot,
                Err((shot, why)) => {
                    publisher.give_up(shot, why).await;
                    continue;
                }
            };
            let number = shot.trigger;
            publisher.links.board.processing(number);
            let result = self.measure(publisher, shot.clone()).await;
            let reference = result.as_ref().ok().filter(|result| self.decides(result)).cloned();
            publisher.finish(number, result).await;
            if let Some(result) = reference {
                tracing::info!(
                    "shot {number} has decided the forward model: workers measure the others"
                );
                return Ok(Some((shot, result)));
            }
        }
        Ok(None)
    }

    fn decides(&self, result: &ShotResult) -> bool {
        !self.is_chosen || result.measured.model.scene.is_some()
    }

    /// As a worker does: from the record.
    async fn measure(
        &self,
        publisher: &Publisher,
        shot: RecordedShot,
    ) -> Result<ShotResult, String> {
        let (process, threads) = (self.process.clone(), self.threads.clone());
        let folder = publisher.folder.clone();
        let measured = blocking(move || {
            let pair = RecordedRun::open(&folder)?.pair(&shot)?;
            let RecordedShot { dt_us, suspect, time, .. } = shot;
            let measured =
                threads.install(|| process_guarded(process.as_ref(), &pair, dt_us, suspect));
            let measured = measured.map_err(anyhow::Error::msg)?;
            Ok(ShotResult { measured, time, raw: RawLevel::Synced })
        });
        measured.await.map_err(|error| format!("{error:#}"))
    }
}
