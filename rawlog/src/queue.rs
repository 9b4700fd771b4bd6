//! The queue between appenders and the writer thread, bounded in bytes.

use std::{collections::VecDeque, sync::Arc, time::Instant};

use parking_lot::{Condvar, Mutex};
use tokio::sync::{Notify, watch};

use super::{AppendError, LogWatermarks, RawLogError, Record, segments::Progress};

/// Most bytes that the writer takes at once, so that space is released steadily.
const MAX_TAKEN_BYTES: u64 = 16_000_000;

/// The queue, and the state of records that have left it.
#[derive(Debug)]
pub(super) struct Queue {
    state: Mutex<State>,
    max_bytes: u64,
    /// Notified when a record or the end arrives.
    not_empty: Condvar,
    /// Notified when space is released or the log ends: for threads.
    not_full: Condvar,
    /// The same for async tasks.
    not_full_async: Notify,
    watch: watch::Sender<LogWatermarks>,
}

#[derive(Debug, Default)]
struct State {
    waiting: VecDeque<Record>,
    /// Bytes of records appended but not yet written, including those that the writer has taken.
    bytes: u64,
    marks: LogWatermarks,
    /// Set by closing: the writer ends once the queue is empty.
    closed: Option<Arc<RawLogError>>,
    /// Set by a failure: queued records are lost.
    failure: Option<Arc<RawLogError>>,
}

impl State {
    fn end(&self) -> Option<&Arc<RawLogError>> {
        self.failure.as_ref().or(self.closed.as_ref())
    }
}

/// What the writer has to do.
#[derive(Debug, PartialEq)]
pub(super) enum Job {
    /// Records to be written, in order.
    Records(Vec<Record>),
    /// The deadline has passed.
    Timeout,
    /// The queue is closed and empty.
    Closed,
}

impl Queue {
    pub fn new(max_bytes: u64, progress: Progress) -> Self {
        let mut state = State::default();
        state.marks.update(progress);
        let watch = watch::Sender::new(state.marks);
        Self {
            state: Mutex::new(state),
            max_bytes,
            not_empty: Condvar::new(),
            not_full: Condvar::new(),
            not_full_async: Notify::new(),
            watch,
        }
    }

    /// Appends a record if there is space. A record larger than the whole queue is accepted when the
    /// queue is empty.
    pub fn try_append(&self, record: Record) -> Result<u64, AppendError> {
        self.append_to(&mut self.state.lock(), record)
    }

    /// Appends a record, blocking until there is space.
    pub fn append_blocking(&self, mut record: Record) -> Result<u64, Arc<RawLogError>> {
        let mut state = self.state.lock();
        loop {
            match self.append_to(&mut state, record) {
                Ok(sequence) => return Ok(sequence),
                Err(AppendError::Failed(end)) => return Err(end),
                Err(AppendError::Full(back)) => record = back,
            }
            self.not_full.wait(&mut state);
        }
    }

    /// Appends a record, waiting until there is space.
    pub async fn append(&self, mut record: Record) -> Result<u64, Arc<RawLogError>> {
        loop {
            let mut not_full = std::pin::pin!(self.not_full_async.notified());
            // Registered before the check, so that a notification in between is not lost.
            not_full.as_mut().enable();
            match self.try_append(record) {
                Ok(sequence) => return Ok(sequence),
                Err(AppendError::Failed(end)) => return Err(end),
                Err(AppendError::Full(back)) => record = back,
            }
            not_full.await;
        }
    }

    fn append_to(&self, state: &mut State, record: Record) -> Result<u64, AppendError> {
        if let Some(end) = state.end() {
            return Err(AppendError::Failed(Arc::clone(end)));
        }
        if let Err(too_large) = record.image_size() {
            return Err(AppendError::Failed(Arc::new(too_large)));
        }
        let bytes = record.bytes();
        if state.bytes > 0 && state.bytes.saturating_add(bytes) > self.max_bytes {
            return Err(AppendError::Full(record));
        }
        state.bytes += bytes;
        state.waiting.push_back(record);
        state.marks.appended += 1;
        self.not_empty.notify_one();
        Ok(state.marks.appended - 1)
    }

    /// Waits for the next job, at most until `until`.
    pub fn next(&self, until: Option<Instant>) -> Job {
        let mut state = self.state.lock();
        while state.waiting.is_empty() {
            if state.closed.is_some() {
                return Job::Closed;
            }
            match until {
                None => self.not_empty.wait(&mut state),
                Some(until) if self.not_empty.wait_until(&mut state, until).timed_out() => {
                    return Job::Timeout;
                }
                Some(_) => {}
            }
        }
        let mut taken = Vec::new();
        let mut bytes = 0;
        while bytes < MAX_TAKEN_BYTES
            && let Some(record) = state.waiting.pop_front()
        {
            bytes += record.bytes();
            taken.push(record);
        }
        Job::Records(taken)
    }

    /// Releases the space of written records of this many bytes.
    pub fn written(&self, bytes: u64, progress: Progress) {
        let mut state = self.state.lock();
        state.bytes -= bytes;
        state.marks.bytes_in += bytes;
        state.marks.update(progress);
        drop(state);
        self.wake_appenders();
    }

    /// Publishes the watermarks after a sync.
    pub fn synced(&self, progress: Progress) {
        let mut state = self.state.lock();
        state.marks.update(progress);
        self.watch.send_replace(state.marks);
    }

    /// Stops the log: rejects further records, drops queued ones and wakes all waiters.
    pub fn fail(&self, reason: RawLogError, progress: Option<Progress>) {
        let mut state = self.state.lock();
        state.failure.get_or_insert_with(|| Arc::new(reason));
        state.waiting.clear();
        state.bytes = 0;
        if let Some(progress) = progress {
            state.marks.update(progress);
        }
        self.watch.send_replace(state.marks);
        drop(state);
        self.wake_appenders();
    }

    /// Closes the queue: rejects further records; the writer ends once it is empty.
    pub fn close(&self, reason: RawLogError) {
        self.state.lock().closed.get_or_insert_with(|| Arc::new(reason));
        self.not_empty.notify_all();
        self.wake_appenders();
    }

    fn wake_appenders(&self) {
        self.not_full.notify_all();
        self.not_full_async.notify_waiters();
    }

    /// Bytes in the queue.
    pub fn bytes(&self) -> u64 {
        self.state.lock().bytes
    }

    /// The current watermarks.
    pub fn watermarks(&self) -> LogWatermarks {
        self.state.lock().marks
    }

    /// LogWatermarks, updated at each sync.
    pub fn watch(&self) -> watch::Receiver<LogWatermarks> {
        self.watch.subscribe()
    }

    /// Why records are no longer accepted, if so.
    pub fn ended(&self) -> Option<Arc<RawLogError>> {
        self.state.lock().end().cloned()
    }

    /// The failure that stopped the log, if any.
    pub fn failure(&self) -> Option<Arc<RawLogError>> {
        self.state.lock().failure.clone()
    }
}

impl LogWatermarks {
    fn update(&mut self, progress: Progress) {
        self.written = progress.written;
        self.synced = progress.synced;
        self.bytes_written = progress.bytes_written;
        self.segments = progress.segments;
    }
}
