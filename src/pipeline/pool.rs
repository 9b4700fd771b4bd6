//! The worker pool: shots from the queue to results on disk.
//!
//! By default one shot is processed at a time: its stages use all cores through rayon, and a second
//! concurrent shot would cost some 100 MB and gain only the serial parts. At most `workers` shots are
//! in flight between queue and disk, however slow the disk is.
//!
//! A failure or panic while processing costs that shot only. Once `stop` is cancelled, the shots in
//! process are finished and queued ones are shed.

use std::{
    fmt::Display,
    panic::{AssertUnwindSafe, catch_unwind},
    sync::{
        Arc,
        mpsc::{SendError, SyncSender},
    },
    time::Instant,
};

use lfpiv_core::{lightfield::ImagePair, velocimetry::PairResult};
use parking_lot::Mutex;
use rayon::{ThreadPool, ThreadPoolBuilder};
use thiserror::Error;
use tokio::sync::{OwnedSemaphorePermit, Semaphore};
use tokio_util::sync::CancellationToken;

use super::{
    Board, ShotRecord,
    writer::{Finished, Observer, ResultSink, ResultWriter},
};
use crate::{
    acquisition::{
        Journal, Ledger, LedgerError, Outcome, RunClock, Shot, ShotReceiver, panic_message,
    },
    archive::{RawLevel, ShotResult},
};

/// Number of workers and threads.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct PoolSettings {
    /// Shots processed at the same time.
    pub workers: usize,
    /// Threads shared by the workers; 0 for one per core.
    pub threads: usize,
}

impl Default for PoolSettings {
    fn default() -> Self {
        Self { workers: 1, threads: 0 }
    }
}

/// Why the pool could not start, or how it ended.
#[derive(Debug, Error)]
pub enum PoolError {
    /// The worker threads could not be started.
    #[error("cannot start the worker threads")]
    Threads(#[from] rayon::ThreadPoolBuildError),
    /// The writer thread could not be started.
    #[error("cannot start the writer thread of results")]
    WriterThread(#[source] std::io::Error),
    /// Closing the results panicked.
    #[error("closing the results panicked: {0}; the last of them are not on disk")]
    WriterPanicked(String),
    /// The last results could not be sealed.
    #[error("the results could not be closed: {0}")]
    Close(String),
}

/// What the pool shares with the rest of the daemon.
#[derive(Clone)]
pub struct PoolLinks {
    /// Receives the outcome of each shot.
    pub ledger: Arc<Mutex<Ledger>>,
    /// Knows how durable each shot's raw data is.
    pub journal: Journal,
    /// The clock of trigger due times.
    pub clock: Arc<dyn RunClock>,
    /// Receives records and results.
    pub board: Arc<Board>,
    /// Cancelled when queued shots shall no longer be processed.
    pub stop: CancellationToken,
}

/// The pool, not started yet.
pub struct Pool<P> {
    process: Arc<P>,
    threads: ThreadPool,
    workers: usize,
    links: PoolLinks,
    writer: ResultWriter,
}

impl<P, E> Pool<P>
where
    P: Fn(&ImagePair) -> Result<PairResult, E> + Send + Sync + 'static,
    E: Display,
{
    /// Starts the threads. `process` turns a pair into a result, `sink` stores results, and `observer`
    /// is called for every finished shot on the writer thread.
    ///
    /// # Errors
    ///
    /// [`PoolError::Threads`], [`PoolError::WriterThread`].
    pub fn new(
        settings: PoolSettings,
        process: P,
        sink: impl ResultSink,
        observer: Observer,
        links: PoolLinks,
    ) -> Result<Self, PoolError> {
        let threads = measuring_threads(settings.threads)?;
        let workers = settings.workers.max(1);
        // A worker has one shot, so none waits for room.
        let writer = ResultWriter::start(workers, sink, observer, links.clone())?;
        Ok(Self { process: Arc::new(process), threads, workers, links, writer })
    }

    /// Processes shots until `queue` is closed and empty, then seals the results.
    ///
    /// # Errors
    ///
    /// [`PoolError::WriterPanicked`], [`PoolError::Close`].
    pub async fn run(self, mut queue: ShotReceiver) -> Result<(), PoolError> {
        let free = Arc::new(Semaphore::new(self.workers));
        loop {
            // First a free worker, then a shot: a shot without a worker stays in the queue.
            let Ok(worker) = free.clone().acquire_owned().await else { break };
            let Some(shot) = queue.recv().await else { break };
            if self.links.stop.is_cancelled() {
                log_refusal(self.links.ledger.lock().settle_all(shot.trigger, Outcome::Shed));
            } else {
                self.hand_to(worker, shot);
            }
        }
        drop(free.acquire_many_owned(u32::try_from(self.workers).unwrap_or(u32::MAX)).await);
        self.writer.close().await
    }

    fn hand_to(&self, worker: OwnedSemaphorePermit, shot: Shot) {
        let process = self.process.clone();
        let results: SyncSender<Finished> = self.writer.inbox();
        let links = self.links.clone();
        links.board.pair_times().begin(shot.trigger, Instant::now());
        self.threads.spawn(move || {
            let Shot { trigger, cameras, time, due, dt_us, suspect, .. } = shot;
            links.board.processing(trigger);
            let cameras = cameras.into_iter().map(|frames| frames.map(|frame| frame.image));
            let pair = ImagePair { cameras: cameras.collect() };
            links.board.gallery().show_frames(trigger, &pair);
            let result = process_guarded(process.as_ref(), &pair, dt_us, suspect);
            links.board.pair_times().end(trigger, Instant::now(), result.is_ok());
            let result = result.map(|measured| ShotResult { time, ..measured.into() });
            let finished = Finished { shot: trigger, due, result, worker: Some(worker) };
            if let Err(SendError(lost)) = results.send(finished) {
                links.write_failed(lost, "the writer thread has ended");
            }
        });
    }
}

impl PoolLinks {
    /// Settles a shot whose result cannot be written because the writer has ended.
    fn write_failed(&self, lost: Finished, message: &str) {
        let shot = lost.shot;
        match lost.result {
            Ok(result) => self.conclude(shot, Outcome::WriteFailed, |board| {
                board.write_failed(shot, Arc::new(result), message.to_owned())
            }),
            Err(reason) => {
                self.conclude(shot, Outcome::Complete, |board| board.failed(shot, reason))
            }
        };
    }

    /// Settles a shot on the board and in the ledger together: a holder of the ledger's lock sees
    /// both or neither.
    pub(super) fn conclude(
        &self,
        shot: u64,
        outcome: Outcome,
        record: impl FnOnce(&Board) -> ShotRecord,
    ) -> ShotRecord {
        let raw_lost = self.journal.level(shot) == RawLevel::Lost;
        let outcome = if raw_lost { Outcome::WriteFailed } else { outcome };
        let mut ledger = self.ledger.lock();
        let record = record(&self.board);
        log_refusal(ledger.settle_all(shot, outcome));
        record
    }
}

/// Threads that measure, after everything that acquires; 0 for one per core.
///
/// # Errors
/// [`PoolError::Threads`].
pub fn measuring_threads(threads: usize) -> Result<ThreadPool, PoolError> {
    let threads = ThreadPoolBuilder::new()
        .num_threads(threads)
        .thread_name(|index| format!("worker {index}"))
        .start_handler(|_| run_after_acquisition());
    Ok(threads.build()?)
}

/// Niceness of worker threads relative to the threads that receive, pair and record frames. With five,
/// `scripts/beside-busy.sh 1 scripts/loopback.sh` takes a third of the time that it takes with ten.
const WORKERS_NICENESS: i32 = 5;

/// Lowers the priority of the calling thread below acquisition: a measurement may take longer, but no
/// frame may be lost. Linux counts niceness per thread.
pub fn run_after_acquisition() {
    if let Err(error) = rustix::process::nice(WORKERS_NICENESS) {
        tracing::debug!(%error, "workers run at the same priority as acquisition");
    }
}

/// A refused entry is a bug of this program: it is logged, and the run continues.
fn log_refusal(entry: Result<(), LedgerError>) {
    if let Err(error) = entry {
        tracing::error!(%error, "the ledger refused an entry (a fault of this program)");
    }
}

/// Measures a pair; a panic is a failure.
///
/// # Errors
/// Why there is no result.
pub fn process_guarded<E: Display>(
    process: &impl Fn(&ImagePair) -> Result<PairResult, E>,
    pair: &ImagePair,
    dt_us: f64,
    suspect: Vec<String>,
) -> Result<PairResult, String> {
    let processed = catch_unwind(AssertUnwindSafe(|| process(pair)));
    let mut result = processed
        .map_err(|panic| format!("the worker panicked: {}", panic_message(panic.as_ref())))?
        .map_err(|error| error.to_string())?;
    // The operator may have changed it since the start.
    result.field.dt_s = dt_us * 1e-6;
    result.warnings.extend(suspect.into_iter().map(|words| format!("suspect: {words}")));
    Ok(result)
}

#[cfg(test)]
#[path = "pool_tests.rs"]
mod tests;
