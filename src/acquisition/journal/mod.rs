//! The run's own record: every frame as it came, and every decision, in the order in which the
//! run loop saw them.
//!
//! It is written to the raw log (`lfpiv_rawlog`), which knows records and bytes; this module
//! knows what they say. From it, `lfpiv process` finishes what was shed, `lfpiv export` makes image
//! files, and [`super::replay`] plays the run again.

mod books;
mod entry;
mod levels;
mod places;
mod recorded;

use std::sync::Arc;

use lfpiv_hw::RawImage;
use lfpiv_rawlog::{AppendError, RawLog, RawLogError, Record};
use parking_lot::Mutex;

pub use books::ledger as ledger_of;
pub use entry::{Description, Entry, FrameHead, FrameKey, JOURNAL_VERSION};
pub use levels::ShotMarks;
use levels::{LOST, Levels};
pub use places::FramePlaces;
pub use recorded::{
    Placed, RAW_FOLDER, RecordedRun, RecordedRunError, RecordedShot, RunEnd, RunIndex,
};

use crate::archive::RawLevel;

/// The record of a run, or of none. Clones write to the same one.
#[derive(Clone, Default)]
pub struct Journal {
    log: Option<RawLog>,
    levels: Arc<Mutex<Levels>>,
}

/// What became of an entry that was offered without waiting.
pub(super) enum Offered {
    /// It is on its way, with this number; `None` where no record is kept.
    Taken(Option<u64>),
    /// The disk is behind: no room before it has caught up.
    Full(Record),
}

impl Journal {
    /// A run whose raw data is not kept.
    pub fn none() -> Self {
        Self::default()
    }

    /// A run that is recorded in `log`.
    pub fn new(log: RawLog) -> Self {
        Self { log: Some(log), levels: Arc::default() }
    }

    /// The raw log; `None` where none is kept.
    pub fn log(&self) -> Option<&RawLog> {
        self.log.as_ref()
    }

    /// Adds an entry if there is room at once.
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

    /// Adds a record that found no room, as soon as there is.
    pub(super) async fn add(&self, record: Record) -> Result<Option<u64>, Arc<RawLogError>> {
        match &self.log {
            Some(log) => Ok(Some(log.append(record).await?)),
            None => Ok(None),
        }
    }

    /// A shot is paired, and the record that says so has this number: its frames lie before it.
    pub(super) fn paired(&self, shot: u64, number: Option<u64>) {
        // A shot that found the log failed is lost to it.
        let lost = self.log.is_some().then_some(LOST);
        self.levels.lock().paired(shot, number.or(lost));
    }

    /// How safe the raw data of a shot is now.
    pub fn level(&self, shot: u64) -> RawLevel {
        let Some(log) = &self.log else { return RawLevel::NotKept };
        let failed = log.failure().is_some();
        self.levels.lock().level(shot, log.watermarks(), failed)
    }

    /// How many shots have got how far.
    pub fn marks(&self) -> ShotMarks {
        let marks = self.log.as_ref().map(RawLog::watermarks).unwrap_or_default();
        self.levels.lock().marks(marks)
    }
}

fn record(entry: &Entry, image: Option<&RawImage>) -> Record {
    // An entry is numbers, text and lists of them: it cannot fail to be written as JSON.
    let head = serde_json::to_vec(entry).unwrap_or_default();
    Record { head, image: image.cloned() }
}
