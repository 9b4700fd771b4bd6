//! The thread that stores results and settles shots: the only one that does.

use std::{
    panic::{AssertUnwindSafe, catch_unwind},
    sync::{
        Arc,
        mpsc::{Receiver, RecvTimeoutError, SyncSender, sync_channel},
    },
    thread::JoinHandle,
    time::Duration,
};

use tokio::sync::OwnedSemaphorePermit;

use super::{Board, PoolError, PoolLinks, ShotRecord};
use crate::{
    acquisition::{Outcome, panic_message},
    archive::{ArchiveError, RawLevel, ResultStore, ShotResult},
};

/// Poll interval while a shot's raw data is being written.
const POLL: Duration = Duration::from_millis(1);
/// Idle time after which the sink may do housekeeping.
const IDLE_AFTER: Duration = Duration::from_secs(1);

/// Stores results.
pub trait ResultSink: Send + 'static {
    /// Why a result cannot be stored.
    type Error: std::error::Error;
    /// Stores the result of one shot.
    fn append(&mut self, shot: u64, result: &ShotResult) -> Result<(), Self::Error>;
    /// Called after [`IDLE_AFTER`] without results.
    fn idle(&mut self) -> Result<(), Self::Error> {
        Ok(())
    }
    /// Seals the stored results.
    fn close(self) -> Result<(), Self::Error>;
}

impl ResultSink for ResultStore {
    type Error = ArchiveError;

    fn append(&mut self, shot: u64, result: &ShotResult) -> Result<(), ArchiveError> {
        Self::append(self, shot, result)
    }

    fn idle(&mut self) -> Result<(), ArchiveError> {
        self.seal_if_due().map(|_| ())
    }

    fn close(self) -> Result<(), ArchiveError> {
        Self::close(self)
    }
}

/// Called for every shot that ends in the pool, with its result if there is one.
pub type Observer = Box<dyn FnMut(&ShotRecord, Option<&ShotResult>) + Send>;

/// A processed shot.
pub struct Finished {
    pub shot: u64,
    /// When its trigger was due.
    pub due: Duration,
    pub result: Result<ShotResult, String>,
    /// Its worker of the pool, if it has one, which is free again once this is written.
    pub worker: Option<OwnedSemaphorePermit>,
}

/// See the module.
pub struct ResultWriter {
    finished: SyncSender<Finished>,
    thread: JoinHandle<Result<(), String>>,
}

impl ResultWriter {
    /// Starts the thread. `waiting` shots may wait for it; `sink` stores results, and `observer` is called for every
    /// finished shot.
    ///
    /// # Errors
    /// [`PoolError::WriterThread`].
    pub fn start(
        waiting: usize,
        sink: impl ResultSink,
        observer: Observer,
        links: PoolLinks,
    ) -> Result<Self, PoolError> {
        let (finished, inbox) = sync_channel(waiting);
        let writer = Writer { sink, observer, links };
        let thread = std::thread::Builder::new()
            .name("results".to_owned())
            .spawn(move || writer.run(inbox))
            .map_err(PoolError::WriterThread)?;
        Ok(Self { finished, thread })
    }

    /// Where processed shots go. A sender waits while too many wait.
    pub fn inbox(&self) -> SyncSender<Finished> {
        self.finished.clone()
    }

    /// Waits until all senders are gone and everything is written, then seals the results.
    ///
    /// # Errors
    /// [`PoolError::WriterPanicked`], [`PoolError::Close`].
    pub async fn close(self) -> Result<(), PoolError> {
        let Self { finished, thread } = self;
        drop(finished);
        let never = |error: tokio::task::JoinError| Err(Box::new(error.to_string()) as _);
        match tokio::task::spawn_blocking(|| thread.join()).await.unwrap_or_else(never) {
            Ok(closed) => closed.map_err(PoolError::Close),
            Err(panic) => Err(PoolError::WriterPanicked(panic_message(panic.as_ref()))),
        }
    }
}

struct Writer<S> {
    sink: S,
    observer: Observer,
    links: PoolLinks,
}

impl<S: ResultSink> Writer<S> {
    /// Writes until all senders are gone; returns the error of closing.
    fn run(mut self, inbox: Receiver<Finished>) -> Result<(), String> {
        let heartbeat = self.links.board.writing().clone();
        loop {
            match inbox.recv_timeout(IDLE_AFTER) {
                Ok(finished) => {
                    heartbeat.beat();
                    self.take(finished);
                }
                Err(RecvTimeoutError::Timeout) => {
                    heartbeat.beat();
                    if let Err(error) = self.sink.idle() {
                        tracing::error!(%error, "results may not be on disk");
                    }
                }
                Err(RecvTimeoutError::Disconnected) => break,
            }
            heartbeat.rest();
        }
        heartbeat.beat();
        let closed = self.sink.close().map_err(|error| error.to_string());
        heartbeat.rest();
        closed
    }

    fn take(&mut self, finished: Finished) {
        let Finished { shot, due, result, worker } = finished;
        let ended = catch_unwind(AssertUnwindSafe(|| match result {
            Ok(mut result) => {
                if let Some(light) = result.measured.light.take() {
                    self.links.board.gallery().show_light(shot, light);
                }
                self.write(shot, due, result);
            }
            Err(message) => self.fail(shot, message),
        }));
        if let Err(panic) = ended {
            self.end_after_panic(shot, &panic_message(panic.as_ref()));
        }
        drop(worker);
    }

    /// Settles a shot whose writing panicked, so that the conservation law holds.
    fn end_after_panic(&self, shot: u64, message: &str) {
        let message = format!("the writer panicked: {message}");
        tracing::error!(shot, message);
        let settled = self.links.ledger.lock().entry(shot).is_none_or(|entry| entry.is_settled());
        if !settled {
            self.links
                .conclude(shot, Outcome::WriteFailed, |board| board.write_lost(shot, message));
        }
    }

    fn write(&mut self, shot: u64, due: Duration, mut result: ShotResult) {
        result.raw = self.raw_level(shot);
        let result = Arc::new(result);
        let kept = result.clone();
        let record = match self.sink.append(shot, &result) {
            Ok(()) => {
                self.links.board.record_latency(self.links.clock.now().saturating_sub(due));
                self.links.conclude(shot, Outcome::Complete, |board| board.done(shot, kept))
            }
            Err(error) => {
                tracing::error!(shot, %error, "the result is not on disk");
                let message = error.to_string();
                self.links.conclude(shot, Outcome::WriteFailed, |board| {
                    board.write_failed(shot, kept, message)
                })
            }
        };
        (self.observer)(&record, Some(&result));
    }

    /// Durability of a shot's raw data, once it is at least written: no result survives a kill that its
    /// images do not survive. Usually they were written before the shot was measured.
    fn raw_level(&self, shot: u64) -> RawLevel {
        loop {
            match self.links.journal.level(shot) {
                RawLevel::Acquired => std::thread::sleep(POLL),
                level => return level,
            }
        }
    }

    /// Settles a failed shot. Its frames were intact: processing failed, not the trigger.
    fn fail(&mut self, shot: u64, message: String) {
        tracing::error!(shot, message, "no result");
        let conclude = |board: &Board| board.failed(shot, message);
        let record = self.links.conclude(shot, Outcome::Complete, conclude);
        (self.observer)(&record, None);
    }
}
