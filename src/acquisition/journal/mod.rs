//! The journal of a run: every frame and every decision, in the order in which the run loop saw
//! them.
//!
//! It is written to the raw log (`lfpiv_rawlog`), which only knows records and bytes; this module
//! defines their meaning. From the journal, `lfpiv process` measures shed shots, `lfpiv export` writes
//! image files, and [`super::replay`] replays the run.

mod entry;
mod levels;
mod places;
mod rebuilt_ledger;
mod recorded;

use std::sync::Arc;

use lfpiv_hw::RawImage;
use lfpiv_rawlog::{AppendError, RawLog, RawLogError, Record};
use parking_lot::Mutex;

pub use entry::{Description, Entry, FrameHead, FrameKey, JOURNAL_VERSION};
pub use levels::ShotMarks;
use levels::{LOST, Levels};
pub use places::FramePlaces;
pub use rebuilt_ledger::ledger as ledger_of;
pub use recorded::{
    LocatedEntry, RAW_FOLDER, RecordedRun, RecordedRunError, RecordedShot, RunEnd, RunIndex,
};

use crate::archive::RawLevel;

/// The journal of a run; it may be disabled. Clones write to the same one.
#[derive(Clone, Default)]
pub struct Journal {
    log: Option<RawLog>,
    levels: Arc<Mutex<Levels>>,
}

/// Result of offering an entry without waiting.
pub(super) enum Offered {
    /// Queued under this number; `None` if no record is kept.
    Taken(Option<u64>),
    /// The queue is full because the disk is behind.
    Full(Record),
}

impl Journal {
    /// A disabled journal.
    pub fn none() -> Self {
        Self::default()
    }

    /// A journal recorded in `log`.
    pub fn new(log: RawLog) -> Self {
        Self { log: Some(log), levels: Arc::default() }
    }

    /// The raw log; `None` if disabled.
    pub fn log(&self) -> Option<&RawLog> {
        self.log.as_ref()
    }

    /// Appends an entry if the queue has space.
    pub(super) fn offer(
        &self,
        entry: &Entry,
        image: Option<&RawImage>,
    ) -> Result<Offered, Arc<RawLogError>> {
        let Some(log) = &self.log else { return Ok(Offered::Taken(None)) };
        match log.try_append(record(entry, image)) {
            Ok(number) => Ok(Offered::Taken(Some(number))),
            Err(AppendError::Full(record)) => Ok(Offered::Full(record)),
            Err(AppendError::Failed(error)) => Err(error),
        }
    }

    /// Appends a record that found the queue full, waiting for space.
    pub(super) async fn add(&self, record: Record) -> Result<Option<u64>, Arc<RawLogError>> {
        match &self.log {
            Some(log) => Ok(Some(log.append(record).await?)),
            None => Ok(None),
        }
    }

    /// Registers a paired shot with the number of its record, which follows those of its frames.
    pub(super) fn paired(&self, shot: u64, number: Option<u64>) {
        // The log had failed: the shot has no record.
        let lost = self.log.is_some().then_some(LOST);
        self.levels.lock().paired(shot, number.or(lost));
    }

    /// Durability of a shot's raw data now.
    pub fn level(&self, shot: u64) -> RawLevel {
        let Some(log) = &self.log else { return RawLevel::NotKept };
        let failed = log.failure().is_some();
        self.levels.lock().level(shot, log.watermarks(), failed)
    }

    /// Number of shots per durability level.
    pub fn marks(&self) -> ShotMarks {
        let marks = self.log.as_ref().map(RawLog::watermarks).unwrap_or_default();
        self.levels.lock().marks(marks)
    }
}

fn record(entry: &Entry, image: Option<&RawImage>) -> Record {
    // Entries consist of numbers, strings and lists, whose serialisation to JSON cannot fail.
    let head = serde_json::to_vec(entry).unwrap_or_default();
    Record { head, image: image.cloned() }
}
