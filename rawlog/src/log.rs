//! The handle through which records are appended.

use std::{
    path::{Path, PathBuf},
    sync::Arc,
};

use tokio::sync::watch;

use super::{
    AppendError, RawLogError, RawLogSettings, RawLogWriter, Record, Watermarks,
    queue::Queue,
    segments::Segments,
    settings::{Limits, megabytes},
    storage::{Disk, Storage},
};

/// The log of a run that is being recorded. Clones append to the same log.
#[derive(Debug, Clone)]
pub struct RawLog {
    queue: Arc<Queue>,
    storage: Arc<dyn Storage>,
    folder: PathBuf,
    queue_bytes: u64,
    reserve_bytes: u64,
}

impl RawLog {
    /// Begins a log in `folder`, which is created if need be. `description` is repeated in every
    /// segment.
    ///
    /// # Errors
    /// The folder holds a log already, the disk refuses, or no thread can be started.
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

    /// Takes a record if there is room in the queue; its sequence number. Never waits.
    ///
    /// # Errors
    /// [`AppendError::Full`] gives the record back; [`AppendError::Failed`] is for good.
    pub fn try_append(&self, record: Record) -> Result<u64, AppendError> {
        self.queue.try_append(record)
    }

    /// Takes a record, waiting for room in the queue; its sequence number.
    ///
    /// # Errors
    /// The log has failed or is closed, or could never hold this record.
    pub async fn append(&self, record: Record) -> Result<u64, RawLogError> {
        self.queue.append(record).await.map_err(RawLogError::Stopped)
    }

    /// Takes a record, waiting for room in the queue; its sequence number. Not for async code.
    ///
    /// # Errors
    /// The log has failed or is closed, or could never hold this record.
    pub fn append_blocking(&self, record: Record) -> Result<u64, RawLogError> {
        self.queue.append_blocking(record).map_err(RawLogError::Stopped)
    }

    /// How far records have got, now. After a failure `appended - written` records are lost.
    pub fn watermarks(&self) -> Watermarks {
        self.queue.watermarks()
    }

    /// Watermarks that change with each sync, and with a failure.
    pub fn watch(&self) -> watch::Receiver<Watermarks> {
        self.queue.watch()
    }

    /// Whether `bytes` of images more can be recorded, uncompressed in the worst case, beside what
    /// waits to be written and the room that must stay free.
    ///
    /// # Errors
    /// There is no room ([`RawLogError::NoRoom`]), the queue is more than half full
    /// ([`RawLogError::Behind`]), or the log has failed or is closed ([`RawLogError::Stopped`]).
    pub fn reserve(&self, bytes: u64) -> Result<(), RawLogError> {
        if let Some(end) = self.queue.ended() {
            return Err(RawLogError::Stopped(end));
        }
        let folder = &self.folder;
        let queued_bytes = self.queue.bytes();
        let queued_mb = megabytes(queued_bytes);
        if queued_bytes > self.queue_bytes / 2 {
            let queue_mb = megabytes(self.queue_bytes);
            return Err(RawLogError::Behind { folder: folder.clone(), queued_mb, queue_mb });
        }
        let free_bytes = self
            .storage
            .free_bytes(folder)
            .map_err(RawLogError::io("ask for the free room of", folder))?;
        let needed_bytes = bytes.saturating_add(queued_bytes).saturating_add(self.reserve_bytes);
        if free_bytes < needed_bytes {
            return Err(RawLogError::NoRoom {
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

    /// Bytes of heads and images that wait to be written.
    pub fn queued_bytes(&self) -> u64 {
        self.queue.bytes()
    }

    /// Why the log has failed, if it has. That is for good: nothing is taken any more.
    pub fn failure(&self) -> Option<Arc<RawLogError>> {
        self.queue.failure()
    }
}
