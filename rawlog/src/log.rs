//! The handle for appending records.

use std::{
    path::{Path, PathBuf},
    sync::Arc,
};

use tokio::sync::watch;

use super::{
    AppendError, LogWatermarks, RawLogError, RawLogSettings, RawLogWriter, Record,
    queue::Queue,
    segments::Segments,
    settings::{Limits, megabytes},
    storage::{Disk, Storage},
};

/// The log of a run that is being recorded. Clones share the log.
#[derive(Debug, Clone)]
pub struct RawLog {
    queue: Arc<Queue>,
    storage: Arc<dyn Storage>,
    folder: PathBuf,
    queue_bytes: u64,
    reserve_bytes: u64,
}

impl RawLog {
    /// Creates a log in `folder`, which is created if needed. Every segment repeats `description`.
    ///
    /// # Errors
    /// The folder already contains a log, a file operation fails, or the thread cannot be started.
    pub fn create(
        folder: &Path,
        description: &[u8],
        settings: &RawLogSettings,
    ) -> Result<(Self, RawLogWriter), RawLogError> {
        Self::create_on(Arc::new(Disk), folder, description, &settings.into())
    }

    pub(super) fn create_on(
        storage: Arc<dyn Storage>,
        folder: &Path,
        description: &[u8],
        limits: &Limits,
    ) -> Result<(Self, RawLogWriter), RawLogError> {
        let segments = Segments::create(Arc::clone(&storage), folder, description, limits)?;
        let queue = Arc::new(Queue::new(limits.queue_bytes, segments.progress()));
        let writer =
            RawLogWriter::start(Arc::clone(&queue), folder, segments, limits.sync_interval)
                .map_err(RawLogError::io("start the thread that writes to", folder))?;
        let log = Self {
            queue,
            storage,
            folder: folder.into(),
            queue_bytes: limits.queue_bytes,
            reserve_bytes: limits.reserve_bytes,
        };
        Ok((log, writer))
    }

    /// Appends a record if the queue has space and returns its sequence number. Never waits.
    ///
    /// # Errors
    /// [`AppendError::Full`] returns the record; [`AppendError::Failed`] is permanent.
    pub fn try_append(&self, record: Record) -> Result<u64, AppendError> {
        self.queue.try_append(record)
    }

    /// Appends a record, waiting for queue space, and returns its sequence number.
    ///
    /// # Errors
    /// The log has failed or is closed, or the record exceeds the format's limits.
    pub async fn append(&self, record: Record) -> Result<u64, RawLogError> {
        self.queue.append(record).await.map_err(RawLogError::Stopped)
    }

    /// As [`Self::append`], for threads: blocks while the queue is full.
    ///
    /// # Errors
    /// As [`Self::append`].
    pub fn append_blocking(&self, record: Record) -> Result<u64, RawLogError> {
        self.queue.append_blocking(record).map_err(RawLogError::Stopped)
    }

    /// The current watermarks. After a failure, `appended - written` records are lost.
    pub fn watermarks(&self) -> LogWatermarks {
        self.queue.watermarks()
    }

    /// LogWatermarks, updated at each sync and on failure.
    pub fn watch(&self) -> watch::Receiver<LogWatermarks> {
        self.queue.watch()
    }

    /// Checks that `bytes` of further images can be recorded, uncompressed in the worst case, besides
    /// queued records and the reserved disk space.
    ///
    /// # Errors
    /// Too little disk space ([`RawLogError::NoSpace`]), a queue more than half full
    /// ([`RawLogError::Backlog`]), or a log that has failed or is closed ([`RawLogError::Stopped`]).
    pub fn reserve(&self, bytes: u64) -> Result<(), RawLogError> {
        if let Some(end) = self.queue.ended() {
            return Err(RawLogError::Stopped(end));
        }
        let folder = &self.folder;
        let queued_bytes = self.queue.bytes();
        let queued_mb = megabytes(queued_bytes);
        if queued_bytes > self.queue_bytes / 2 {
            let queue_mb = megabytes(self.queue_bytes);
            return Err(RawLogError::Backlog { folder: folder.clone(), queued_mb, queue_mb });
        }
        let free_bytes = self
            .storage
            .free_bytes(folder)
            .map_err(RawLogError::io("query the free space of", folder))?;
        let needed_bytes = bytes.saturating_add(queued_bytes).saturating_add(self.reserve_bytes);
        if free_bytes < needed_bytes {
            return Err(RawLogError::NoSpace {
                folder: folder.clone(),
                free_mb: free_bytes / 1_000_000,
                needed_mb: megabytes(needed_bytes),
                wanted_mb: megabytes(bytes),
                queued_mb,
                reserve_mb: megabytes(self.reserve_bytes),
            });
        }
        Ok(())
    }

    /// Bytes of heads and images in the queue.
    pub fn queued_bytes(&self) -> u64 {
        self.queue.bytes()
    }

    /// The failure that stopped the log, if any. It is permanent: no records are accepted any more.
    pub fn failure(&self) -> Option<Arc<RawLogError>> {
        self.queue.failure()
    }
}
