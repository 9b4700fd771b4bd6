//! The writer thread.

use std::{
    io,
    path::{Path, PathBuf},
    sync::Arc,
    thread::{self, JoinHandle},
    time::{Duration, Instant},
};

use super::{
    LogWatermarks, RawLogError, Record,
    queue::{Job, Queue},
    segments::Segments,
};

/// Owns the writer thread. Dropping it closes the log.
#[derive(Debug)]
pub struct RawLogWriter {
    queue: Arc<Queue>,
    folder: PathBuf,
    thread: Option<JoinHandle<()>>,
}

impl RawLogWriter {
    pub(super) fn start(
        queue: Arc<Queue>,
        folder: &Path,
        segments: Segments,
        sync_interval: Duration,
    ) -> io::Result<Self> {
        let work = Writing {
            queue: Arc::clone(&queue),
            folder: folder.into(),
            segments,
            sync_interval,
            sync_due: None,
            is_over: false,
        };
        let thread = thread::Builder::new().name("raw-log".into()).spawn(|| work.run())?;
        Ok(Self { queue, folder: folder.into(), thread: Some(thread) })
    }

    /// Writes and syncs all appended records, seals the last segment and joins the thread. Handles of
    /// the log then reject records.
    ///
    /// # Errors
    /// The failure that stopped the log, now or earlier.
    pub fn close(mut self) -> Result<LogWatermarks, RawLogError> {
        self.end()
    }

    fn end(&mut self) -> Result<LogWatermarks, RawLogError> {
        let Some(thread) = self.thread.take() else { return Ok(self.queue.watermarks()) };
        self.queue.close(RawLogError::Closed { folder: self.folder.clone() });
        // The queue has already been told of a panic.
        let _ = thread.join();
        match self.queue.failure() {
            Some(failure) => Err(RawLogError::Stopped(failure)),
            None => Ok(self.queue.watermarks()),
        }
    }
}

impl Drop for RawLogWriter {
    fn drop(&mut self) {
        if let Err(error) = self.end() {
            tracing::error!("{error}");
        }
    }
}

struct Writing {
    queue: Arc<Queue>,
    folder: PathBuf,
    segments: Segments,
    sync_interval: Duration,
    /// When the oldest unsynced record must be synced.
    sync_due: Option<Instant>,
    is_over: bool,
}

impl Writing {
    fn run(mut self) {
        let result = self.write_all();
        if let Err(error) = result {
            let failure = error.ends_recording();
            tracing::error!("{failure}");
            self.segments.rescue();
            self.queue.fail(failure, Some(self.segments.progress()));
        }
        self.is_over = true;
    }

    fn write_all(&mut self) -> Result<(), RawLogError> {
        loop {
            match self.queue.next(self.sync_due) {
                Job::Records(records) => self.write(&records)?,
                Job::Timeout => {}
                Job::Closed => break,
            }
            if self.sync_due.is_some_and(|due| due <= Instant::now()) {
                self.segments.sync()?;
                self.report_synced();
            }
        }
        self.segments.finish()?;
        self.report_synced();
        Ok(())
    }

    fn write(&mut self, records: &[Record]) -> Result<(), RawLogError> {
        for record in records {
            self.segments.append(record)?;
        }
        self.segments.flush()?;
        let bytes = records.iter().map(Record::bytes).sum();
        self.queue.written(bytes, self.segments.progress());
        if self.sync_due.is_none() {
            self.sync_due = Some(Instant::now() + self.sync_interval);
        }
        Ok(())
    }

    fn report_synced(&mut self) {
        self.sync_due = None;
        self.queue.synced(self.segments.progress());
    }
}

impl Drop for Writing {
    fn drop(&mut self) {
        // Appenders must not wait for a thread that has panicked.
        if !self.is_over {
            self.queue.fail(RawLogError::WriterPanicked { folder: self.folder.clone() }, None);
        }
    }
}
