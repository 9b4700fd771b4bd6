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
mod publisher;
mod reference;

use std::{fmt::Display, path::PathBuf, sync::Arc};

use lfpiv_core::{lightfield::ImagePair, velocimetry::PairResult};

use self::{
    backlog::Backlog,
    publisher::{Ended, Publisher},
    reference::ReferenceSearch,
};
use crate::{
    acquisition::{Outcome, ShotReceiver},
    archive::ResultStore,
    cluster::{ClusterProgress, ClusterSettings, JobQueue, WorkersAddress},
    config::Config,
    pipeline::{Board, Observer, PoolLinks, ResultWriter},
};

/// Results that may wait for the disk.
const RESULTS_WAITING: usize = 16;
/// What a missing broker means for a run.
const MEANWHILE: &str =
    "recording continues; shots are offered to workers as soon as it is available";

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
        let progress = Arc::new(ClusterProgress::new(queue.clone(), settings.heartbeat_timeout()));
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
        let named = folder.display().to_string();
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
        let publishing = async {
            published(publisher, self, process).await.inspect_err(|error| {
                tracing::error!(
                    "workers get no more shots: {error:#}; the run goes on recording, and `lfpiv process {named}` \
                     measures them afterwards"
                );
            })
        };
        let ((), published) = tokio::join!(draining, publishing);
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

/// Measures shots here until one decides the forward model, and has workers measure those after it. `None` if the
/// run ends before.
///
/// # Errors
/// The record cannot be opened, or the coordinator's work cannot go on.
async fn published<P, E>(
    publisher: Publisher,
    cluster: LiveCluster,
    process: P,
) -> anyhow::Result<Option<Ended>>
where
    P: Fn(&ImagePair) -> Result<PairResult, E> + Send + Sync + 'static,
    E: Display + 'static,
{
    let search = ReferenceSearch::new(&publisher.config, process)?;
    match search.run(&publisher).await? {
        Some(reference) => publisher.publish(cluster, reference).await.map(Some),
        None => Ok(None),
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
