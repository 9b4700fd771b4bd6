//! `lfpiv run` with `[cluster]`: workers measure the shots of a run while it goes on.
//!
//! ```text
//! queue -> backlog -> (record on disk) -> coordinator -> jobs -> workers
//!                          |                   ^                    |
//!                     reference, here          └───── results ──────┘-> writer
//! ```
//!
//! Nothing here can hold the run up: shots leave the queue at once, and their frames are read from the record. The
//! daemon measures the shots up to the one that decides the forward model itself. Without a broker, or without
//! workers, the backlog grows by some bytes a shot; at the end of the run `lfpiv process RUN` measures what is left.

mod backlog;
mod reference;

use std::{
    fmt::Display,
    path::{Path, PathBuf},
    sync::{Arc, mpsc::SyncSender},
    time::Duration,
};

use anyhow::{Context, anyhow, bail};
use lfpiv_core::{lightfield::ImagePair, velocimetry::PairResult};
use parking_lot::Mutex;

use self::{
    backlog::{Backlog, Recorded},
    reference::ReferenceSearch,
};
use super::cluster_run::{assignment, print_workers, run_name};
use crate::{
    acquisition::{
        Outcome, ShotReceiver,
        journal::{FramePlaces, RecordedRun, RecordedShot},
    },
    archive::{ResultStore, ShotResult},
    cluster::{
        ClusterProgress, ClusterSettings, Coordinator, CoordinatorSetup, DeliveryLog, JobQueue,
        ServiceSettings, Tally, WorkService, WorkersAddress,
    },
    config::Config,
    pipeline::{Board, Finished, Observer, PoolLinks, ResultWriter},
};

/// Results that may wait for the disk.
const RESULTS_WAITING: usize = 16;
/// What a missing broker means for a run.
const MEANWHILE: &str =
    "the run goes on recording, and its shots are offered to workers as soon as it is there";
/// How often a read error of the growing record is passed over in one search.
const MOST_READ_ERRORS: usize = 16;

/// The ends at which workers find a run, before it begins.
pub(super) struct LiveCluster {
    settings: ClusterSettings,
    at: WorkersAddress,
    queue: JobQueue,
    progress: Arc<ClusterProgress>,
}

/// A run whose shots are to be measured.
pub(super) struct LiveRun<P> {
    pub folder: PathBuf,
    pub config: Config,
    /// Measures a pair, here.
    pub process: P,
    pub store: ResultStore,
    pub observer: Observer,
    pub links: PoolLinks,
}

impl LiveCluster {
    /// Takes the address for workers, and connects to the broker, which may come later.
    ///
    /// # Errors
    /// The address is taken, the broker's cannot be used, or it does not let us in.
    pub async fn prepare(settings: &ClusterSettings) -> anyhow::Result<Self> {
        let at = WorkersAddress::bind(settings.serve).await?;
        let queue = JobQueue::connect(&settings.broker(), "lfpiv run", MEANWHILE).await?;
        at.warn(&queue);
        let progress = Arc::new(ClusterProgress::new(queue.clone()));
        Ok(Self { settings: settings.clone(), at, queue, progress })
    }

    /// Workers, rates and backlog.
    pub fn progress(&self) -> Arc<ClusterProgress> {
        self.progress.clone()
    }

    /// Has the shots of `queue` measured until all are settled, or the run is told to stop.
    ///
    /// # Errors
    /// Results cannot be stored, or workers do not compute alike; the run is recorded all the same.
    pub async fn run<P, E>(self, run: LiveRun<P>, queue: ShotReceiver) -> anyhow::Result<()>
    where
        P: Fn(&ImagePair) -> Result<PairResult, E> + Send + Sync + 'static,
        E: Display + 'static,
    {
        let LiveRun { folder, config, process, store, observer, links } = run;
        let writer = ResultWriter::start(RESULTS_WAITING, store, observer, links.clone())?;
        let backlog = Arc::new(Backlog::new(links.journal.clone()));
        let progress = self.progress.clone();
        let publisher = Publisher {
            places: Arc::default(),
            inbox: writer.inbox(),
            progress: progress.clone(),
            backlog: backlog.clone(),
            links: links.clone(),
            folder,
            config,
        };
        let board = links.board.clone();
        let draining = drain(queue, &backlog, &progress, &board);
        let ((), published) = tokio::join!(draining, publisher.publish(self, process));
        writer.close().await?;
        // Only now: what was delivered is written.
        for shot in backlog.unsettled() {
            if let Err(error) = links.ledger.lock().settle_all(shot, Outcome::Shed) {
                tracing::error!(%error, "the ledger refused an entry (a fault of this program)");
            }
        }
        match published? {
            Some(ended) => ended.conclude(board.counts().write_failed == 0),
            None => Ok(()),
        }
    }
}

/// Notes the shots, and shows their frames, until the run takes no more.
async fn drain(
    mut queue: ShotReceiver,
    backlog: &Backlog,
    progress: &ClusterProgress,
    board: &Board,
) {
    while let Some(shot) = queue.recv().await {
        let frames = shot.cameras.into_iter().map(|frames| frames.map(|frame| frame.image));
        board.gallery().show_frames(shot.trigger, &ImagePair { cameras: frames.collect() });
        backlog.add(shot.trigger, shot.due);
        progress.set_waiting(backlog.waiting());
    }
    backlog.close();
}

/// Gives shots to the coordinator as soon as their records are on disk.
struct Publisher {
    places: Arc<Mutex<Option<FramePlaces>>>,
    inbox: SyncSender<Finished>,
    progress: Arc<ClusterProgress>,
    backlog: Arc<Backlog>,
    links: PoolLinks,
    folder: PathBuf,
    config: Config,
}

/// What came of the shots.
struct Ended {
    tally: Tally,
    refused: usize,
    log: Option<DeliveryLog>,
}

impl Publisher {
    async fn publish<P, E>(self, cluster: LiveCluster, process: P) -> anyhow::Result<Option<Ended>>
    where
        P: Fn(&ImagePair) -> Result<PairResult, E> + Send + Sync + 'static,
        E: Display + 'static,
    {
        let published = self.try_publishing(cluster, process).await;
        if let Err(error) = &published {
            tracing::error!(
                "workers get no more shots: {error:#}; the run goes on recording, and `lfpiv process {}` \
                 measures them afterwards",
                self.folder.display()
            );
        }
        published
    }

    async fn try_publishing<P, E>(
        &self,
        cluster: LiveCluster,
        process: P,
    ) -> anyhow::Result<Option<Ended>>
    where
        P: Fn(&ImagePair) -> Result<PairResult, E> + Send + Sync + 'static,
        E: Display + 'static,
    {
        let search = ReferenceSearch::new(&self.config, process)?;
        let Some((shot, result)) = search.run(self).await? else { return Ok(None) };
        let coordinator = self.coordinator((shot, result)).await?;
        self.progress.follow(coordinator.clone());
        let LiveCluster { settings, at, queue, .. } = cluster;
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
        served.map(|()| Some(Ended { tally, refused, log }))
    }

    /// The coordinator of a run of which nothing but the reference is measured yet.
    async fn coordinator(
        &self,
        (shot, result): (RecordedShot, ShotResult),
    ) -> anyhow::Result<Arc<Coordinator>> {
        let (folder, config) = (self.folder.clone(), self.config.clone());
        let (backlog, inbox) = (self.backlog.clone(), self.inbox.clone());
        let opened = blocking(move || {
            let run = RecordedRun::open(&folder)?;
            let assignment = assignment(&run, &config, (&shot, &result))?;
            let model = result.measured.model.clone();
            let (log, _) = DeliveryLog::open(&folder, &assignment, &model)?;
            let grid = result.measured.field.grid.clone();
            let sink = move |shot, result| {
                let due = backlog.settle(shot);
                let finished = Finished { shot, due, result: Ok(result), worker: None };
                inbox.send(finished).is_ok()
            };
            let (shots, tally, sink) = (Vec::new(), Tally::default(), Box::new(sink));
            let setup = CoordinatorSetup { run, shots, assignment, model, grid, tally, log, sink };
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
    async fn next(&self) -> Option<Recorded> {
        let next = tokio::select! {
            next = self.backlog.next() => next,
            () = self.links.stop.cancelled() => None,
        };
        self.progress.set_waiting(self.backlog.waiting());
        next
    }

    /// A shot in the record; otherwise its number and why it is not there.
    async fn find(&self, recorded: Recorded) -> Result<RecordedShot, (u64, String)> {
        let shot = match recorded {
            Recorded::Synced(shot) => shot,
            Recorded::Lost(shot) => return Err((shot, "its images could not be recorded".into())),
        };
        let (places, folder) = (self.places.clone(), self.folder.clone());
        let found = blocking(move || found(&mut places.lock(), &folder, shot)).await;
        found.map_err(|error| (shot, format!("{error:#}")))
    }

    /// A shot without a result.
    async fn give_up(&self, shot: u64, why: String) {
        self.finish(shot, Err(why)).await;
    }

    /// Settles a shot that was measured here, or not at all.
    async fn finish(&self, shot: u64, result: Result<ShotResult, String>) {
        let due: Duration = self.backlog.settle(shot);
        let inbox = self.inbox.clone();
        let finished = Finished { shot, due, result, worker: None };
        // The writer may wait for a disk.
        let handed = blocking(move || inbox.send(finished).map_err(|_| anyhow!("it has ended")));
        if let Err(error) = handed.await {
            tracing::error!(shot, "the writer of results cannot be told: {error:#}");
        }
    }
}

impl Ended {
    /// Says who has measured how much. The log of results goes once all are stored.
    fn conclude(self, all_are_written: bool) -> anyhow::Result<()> {
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
async fn blocking<T: Send + 'static>(
    work: impl FnOnce() -> anyhow::Result<T> + Send + 'static,
) -> anyhow::Result<T> {
    tokio::task::spawn_blocking(work).await.context("a thread has failed")?
}
