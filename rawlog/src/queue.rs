//! Records between those who append them and the thread that writes them: bounded in bytes.

use std::{collections::VecDeque, sync::Arc, time::Instant};

use parking_lot::{Condvar, Mutex};
use tokio::sync::{Notify, watch};

use super::{AppendError, RawLogError, Record, Watermarks, segments::Progress};

/// Most that the writer takes at once, so that room comes back steadily.
const TAKEN_BYTES: u64 = 16_000_000;

/// The queue, and what is known about what has left it.
#[derive(Debug)]
pub(super) struct Queue {
    state: Mutex<State>,
    most_bytes: u64,
    /// There is a record, or an end.
    work: Condvar,
    /// There is room, or an end: for threads.
    room: Condvar,
    /// The same for tasks.
    room_for_tasks: Notify,
    watch: watch::Sender<Watermarks>,
}

#[derive(Debug, Default)]
struct State {
    waiting: VecDeque<Record>,
    /// Bytes of records that are appended and not written, those in the writer's hands included.
    bytes: u64,
    marks: Watermarks,
    /// Set by closing: the writer ends when nothing waits any more.
    closed: Option<Arc<RawLogError>>,
    /// Set by a failure: what waited is lost.
    failure: Option<Arc<RawLogError>>,
}

impl State {
    fn end(&self) -> Option<&Arc<RawLogError>> {
        self.failure.as_ref().or(self.closed.as_ref())
    }
}

/// What the writer finds to do.
#[derive(Debug, PartialEq)]
pub(super) enum Work {
    /// Records to be written, in order.
    Records(Vec<Record>),
    /// The time waited for has come.
    Timeout,
    /// Nothing will come any more.
    Closed,
}

impl Queue {
    pub fn new(most_bytes: u64, progress: Progress) -> Self {
        let mut state = State::default();
        state.marks.update(progress);
        let watch = watch::Sender::new(state.marks);
        Self {
            state: Mutex::new(state),
            most_bytes,
            work: Condvar::new(),
            room: Condvar::new(),
            room_for_tasks: Notify::new(),
            watch,
        }
    }

    /// Takes a record if there is room. A record larger than the whole queue passes alone.
    pub fn try_append(&self, record: Record) -> Result<u64, AppendError> {
        self.append_to(&mut self.state.lock(), record)
    }

    /// Takes a record, waiting for room.
    pub fn append_blocking(&self, mut record: Record) -> Result<u64, Arc<RawLogError>> {
        let mut state = self.state.lock();
        loop {
            match self.append_to(&mut state, record) {
                Ok(sequence) => return Ok(sequence),
                Err(AppendError::Failed(end)) => return Err(end),
                Err(AppendError::Full(back)) => record = back,
            }
            self.room.wait(&mut state);
        }
    }

    /// Takes a record, waiting for room.
    pub async fn append(&self, mut record: Record) -> Result<u64, Arc<RawLogError>> {
        loop {
            let mut room = std::pin::pin!(self.room_for_tasks.notified());
            // Registered before looking: room that comes in between is not missed.
            room.as_mut().enable();
            match self.try_append(record) {
                Ok(sequence) => return Ok(sequence),
                Err(AppendError::Failed(end)) => return Err(end),
                Err(AppendError::Full(back)) => record = back,
            }
            room.await;
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
        if state.bytes > 0 && state.bytes.saturating_add(bytes) > self.most_bytes {
            return Err(AppendError::Full(record));
        }
        state.bytes += bytes;
        state.waiting.push_back(record);
        state.marks.appended += 1;
        self.work.notify_one();
        Ok(state.marks.appended - 1)
    }

    /// Waits for work, up to `until`.
    pub fn next(&self, until: Option<Instant>) -> Work {
        let mut state = self.state.lock();
        while state.waiting.is_empty() {
            if state.closed.is_some() {
                return Work::Closed;
            }
            match until {
                None => self.work.wait(&mut state),
                Some(until) if self.work.wait_until(&mut state, until).timed_out() => {
                    return Work::Timeout;
                }
                Some(_) => {}
            }
        }
        let mut taken = Vec::new();
        let mut bytes = 0;
        while bytes < TAKEN_BYTES
            && let Some(record) = state.waiting.pop_front()
        {
            bytes += record.bytes();
            taken.push(record);
        }
        Work::Records(taken)
    }

    /// Gives back the room of records that are written, `bytes` large.
    pub fn written(&self, bytes: u64, progress: Progress) {
        let mut state = self.state.lock();
        state.bytes -= bytes;
        state.marks.bytes_in += bytes;
        state.marks.update(progress);
        drop(state);
        self.wake_appenders();
    }

    /// Tells everybody how far records are safe.
    pub fn synced(&self, progress: Progress) {
        let mut state = self.state.lock();
        state.marks.update(progress);
        self.watch.send_replace(state.marks);
    }

    /// Ends the log: nothing is taken any more, what waits is dropped, whoever waits is told.
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

    /// Lets the writer end when everything is written; nothing is taken any more.
    pub fn close(&self, reason: RawLogError) {
        self.state.lock().closed.get_or_insert_with(|| Arc::new(reason));
        self.work.notify_all();
        self.wake_appenders();
    }

    fn wake_appenders(&self) {
        self.room.notify_all();
        self.room_for_tasks.notify_waiters();
    }

    /// Bytes that wait to be written.
    pub fn bytes(&self) -> u64 {
        self.state.lock().bytes
    }

    /// How far records have got.
    pub fn watermarks(&self) -> Watermarks {
        self.state.lock().marks
    }

    /// Watermarks that change with each sync.
    pub fn watch(&self) -> watch::Receiver<Watermarks> {
        self.watch.subscribe()
    }

    /// Why nothing is taken any more.
    pub fn ended(&self) -> Option<Arc<RawLogError>> {
        self.state.lock().end().cloned()
    }

    /// Why the log has failed.
    pub fn failure(&self) -> Option<Arc<RawLogError>> {
        self.state.lock().failure.clone()
    }
}

impl Watermarks {
    fn update(&mut self, progress: Progress) {
        self.written = progress.written;
        self.synced = progress.synced;
        self.bytes_written = progress.bytes_written;
        self.segments = progress.segments;
    }
}
