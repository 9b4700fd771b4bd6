//! Gives the shots of a run to a coordinator.

use std::{
    path::{Path, PathBuf},
    sync::{Arc, mpsc::SyncSender},
    time::Duration,
};

use anyhow::{Context, anyhow, bail};
use parking_lot::Mutex;

use super::{
    LiveCluster,
    backlog::{Backlog, Recorded},
};
use crate::{
    acquisition::journal::{FramePlaces, RecordedRun, RecordedShot},
    archive::ShotResult,
    cli::cluster_run::{assignment, print_workers, run_name},
    cluster::{
        ClusterProgress, Coordinator, CoordinatorSetup, DeliveryLog, ServiceSettings, Tally,
        WorkService,
    },
    config::Config,
    pipeline::{Finished, PoolLinks},
};

/// How often a read error of the growing record is passed over in one search.
const MOST_READ_ERRORS: usize = 16;

/// Gives shots to the coordinator as soon as their records are on disk.
pub(super) struct Publisher {
    pub places: Arc<Mutex<Option<FramePlaces>>>,
    pub inbox: SyncSender<Finished>,
    pub progress: Arc<ClusterProgress>,
    pub backlog: Arc<Backlog>,
    pub links: PoolLinks,
    pub folder: PathBuf,
    pub config: Config,
}

/// What came of the shots.
pub(super) struct Ended {
    tally: Tally,
    refused: usize,
    log: Option<DeliveryLog>,
}

impl Publisher {
    /// Gives the shots after the `reference`, which has decided the forward model, to workers until all are settled,
    /// or the run is told to stop.
    ///
    /// # Errors
    /// The record cannot be opened, or the coordinator's work cannot go on.
    pub async fn publish(
        self,
        cluster: LiveCluster,
        reference: (RecordedShot, ShotResult),
    ) -> anyhow::Result<Ended> {
        let LiveCluster { settings, at, queue, .. } = cluster;
        let coordinator = self.coordinator(reference, settings.heartbeat_timeout()).await?;
        self.progress.follow(coordinator.clone());
        let service = ServiceSettings {
            run_name: run_name(&self.folder),
            heartbeat_timeout: settings.heartbeat_timeout(),
            deadline: settings.deadline(),
            first_issue: 1,
        };
        let service = WorkService::start(&coordinator, at, queue, service)
            // Otherwise the writer would wait for its results.
            .inspect_err(|_| drop(coordinator.close()))?;
        let served = tokio::select! {
            served = self.hand_out(&coordinator) => served,
            failed = coordinator.failed() => failed.map_err(Into::into),
            () = self.links.stop.cancelled() => Ok(()),
        };
        service.end().await;
        let (tally, refused, log) = coordinator.close();
        for (shot, reasons) in tally.dead() {
            self.give_up(shot, reasons.join("; ")).await;
        }
        served.map(|()| Ended { tally, refused, log })
    }

    /// The coordinator of a run of which nothing but the reference is measured yet.
    async fn coordinator(
        &self,
        (shot, result): (RecordedShot, ShotResult),
        heartbeat_timeout: Duration,
    ) -> anyhow::Result<Arc<Coordinator>> {
        let (folder, config) = (self.folder.clone(), self.config.clone());
        let (backlog, inbox) = (self.backlog.clone(), self.inbox.clone());
        let opened = blocking(move || {
            let run = RecordedRun::open(&folder)?;
            let assignment = assignment(&run, &config, (&shot, &result), true)?;
            let light = Some(config.volume.grid().voxels);
            let model = result.measured.model.clone();
            let (log, _) = DeliveryLog::open(&folder, &assignment, &model)?;
            let grid = result.measured.field.grid.clone();
            let sink = move |shot, result| {
                let due = backlog.settle(shot);
                let finished = Finished { shot, due, result: Ok(result), worker: None };
                inbox.send(finished).is_ok()
            };
            let (shots, tally, sink) = (Vec::new(), Tally::default(), Box::new(sink));
            let setup = CoordinatorSetup {
                run,
                shots,
                assignment,
                model,
                grid,
                tally,
                log,
                heartbeat_timeout,
                light,
                sink,
            };
            Ok(Arc::new(Coordinator::open(setup)))
        });
        opened.await
    }

    /// Hands out every shot that the run takes, and waits until all are settled.
    async fn hand_out(&self, coordinator: &Coordinator) -> anyhow::Result<()> {
        while let Some(recorded) = self.next().await {
            match self.find(recorded).await {
                Ok(shot) => coordinator.add(shot),
                Err((shot, why)) => self.give_up(shot, why).await,
            }
        }
        Ok(coordinator.settled().await?)
    }

    /// The next shot whose record is on disk, or lost; `None` at the end of the run, or when it is told to stop.
    pub async fn next(&self) -> Option<Recorded> {
        let next = tokio::select! {
            next = self.backlog.next() => next,
            () = self.links.stop.cancelled() => None,
        };
        self.progress.set_waiting(self.backlog.waiting());
        next
    }

    /// A shot in the record; otherwise its number and why it is not there.
    pub async fn find(&self, recorded: Recorded) -> Result<RecordedShot, (u64, String)> {
        let shot = match recorded {
            Recorded::Synced(shot) => shot,
            Recorded::Lost(shot) => return Err((shot, "its images could not be recorded".into())),
        };
        let (places, folder) = (self.places.clone(), self.folder.clone());
        let found = blocking(move || found(&mut places.lock(), &folder, shot)).await;
        found.map_err(|error| (shot, format!("{error:#}")))
    }

    /// A shot without a result.
    pub async fn give_up(&self, shot: u64, why: String) {
        self.finish(shot, Err(why)).await;
    }

    /// Settles a shot that was measured here, or not at all.
    pub async fn finish(&self, shot: u64, result: Result<ShotResult, String>) {
        let due: Duration = self.backlog.settle(shot);
        let inbox = self.inbox.clone();
        let finished = Finished { shot, due, result, worker: None };
        // The writer may wait for a disk.
        let handed = blocking(move || inbox.send(finished).map_err(|_| anyhow!("it has ended")));
        if let Err(error) = handed.await {
            tracing::error!(shot, "the result could not be passed to the result writer: {error:#}");
        }
    }
}

impl Ended {
    /// Says who has measured how much. The log of results goes once all are stored.
    pub fn conclude(self, all_are_written: bool) -> anyhow::Result<()> {
        let Self { tally, refused, log } = self;
        print_workers(&tally, refused)?;
        if let Some(log) = log.filter(|_| all_are_written && tally.open().len() == 0) {
            log.remove()?;
        }
        let unequal = tally.unequal();
        if !unequal.is_empty() {
            let listed = unequal
                .iter()
                .map(|(shot, makers)| format!("\n  shot {shot}: {}", makers.join(", ")));
            bail!(
                "workers have delivered unequal results; the first ones are stored{}",
                listed.collect::<String>()
            )
        }
        Ok(())
    }
}

/// Reads on in the growing record up to a shot.
fn found(
    places: &mut Option<FramePlaces>,
    folder: &Path,
    shot: u64,
) -> anyhow::Result<RecordedShot> {
    let places = match places {
        Some(places) => places,
        None => places.insert(FramePlaces::new(RecordedRun::open(folder)?)),
    };
    // A damaged record before it costs only itself.
    let found = (0..=MOST_READ_ERRORS).find_map(|_| places.shot(shot).cloned());
    found.context("its record cannot be read back")
}

/// Runs what waits for a disk, or measures, where waiting holds up nobody.
pub(super) async fn blocking<T: Send + 'static>(
    work: impl FnOnce() -> anyhow::Result<T> + Send + 'static,
) -> anyhow::Result<T> {
    tokio::task::spawn_blocking(work).await.context("a thread has failed")?
}
