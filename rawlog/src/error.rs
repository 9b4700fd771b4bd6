//! Errors of writing and reading the raw log.

use std::{
    fmt,
    io::{self, ErrorKind},
    ops::{Range, RangeInclusive},
    path::{Path, PathBuf},
    sync::Arc,
};

use thiserror::Error;

use super::{FORMAT_VERSION, Record, format::HeaderFault, names::sealed_path};

/// Errors of writing and reading the raw log.
///
/// Every message is complete: it includes the reason, so `source` need not be printed.
#[derive(Debug, Error)]
pub enum RawLogError {
    /// A file operation failed.
    #[error("cannot {action} {}: {reason}", path.display())]
    Io {
        /// The operation that failed.
        action: &'static str,
        /// The file or folder.
        path: PathBuf,
        /// The operating system's error.
        reason: io::Error,
    },
    /// A file operation failed while recording. Recording has stopped for good.
    #[error(
        "recording of raw data has stopped: cannot {action} {}: {reason}; what was written before \
         is kept; {}", path.display(), advice(reason, path)
    )]
    DiskFailed {
        /// The operation that failed.
        action: &'static str,
        /// The file or folder.
        path: PathBuf,
        /// The operating system's error.
        reason: io::Error,
    },
    /// An earlier failure stopped the log.
    #[error("{0}")]
    Stopped(Arc<RawLogError>),
    /// The log's writer has been closed.
    #[error("the raw log in {} is closed: start a new run to record more", folder.display())]
    Closed {
        /// The log's folder.
        folder: PathBuf,
    },
    /// The writer thread panicked.
    #[error(
        "recording of raw data has stopped: the writer thread of {} panicked; what was written \
         before is kept; report the panic message above and start a new run", folder.display()
    )]
    WriterPanicked {
        /// The log's folder.
        folder: PathBuf,
    },
    /// The folder already contains a log.
    #[error(
        "{} already holds a raw log: choose another folder or move it away", folder.display()
    )]
    AlreadyUsed {
        /// The folder.
        folder: PathBuf,
    },
    /// A record exceeds a limit of the format.
    #[error(
        "{what} cannot be recorded, a raw log holds up to {limit}: record smaller images or \
         shorter notes"
    )]
    TooLarge {
        /// The part that is too large, and its size.
        what: String,
        /// The limit.
        limit: &'static str,
    },
    /// The disk has too little free space for the images about to be recorded.
    #[error(
        "{} has {free_mb} MB free and {needed_mb} MB are needed ({wanted_mb} MB of images, \
         {queued_mb} MB queued, {reserve_mb} MB reserved): free space, \
         record fewer shots, or lower raw_log.reserve_mb", folder.display()
    )]
    NoSpace {
        /// The log's folder.
        folder: PathBuf,
        /// Free space on the disk, in MB.
        free_mb: u64,
        /// Sum of the next three fields, in MB.
        needed_mb: u64,
        /// Images about to be recorded, in MB.
        wanted_mb: u64,
        /// Images recorded but not yet written, in MB.
        queued_mb: u64,
        /// Space that must stay free, in MB.
        reserve_mb: u64,
    },
    /// The disk is too slow: the queue is more than half full.
    #[error(
        "{queued_mb} MB are queued for {}, more than half of raw_log.queue_mb = {queue_mb}: \
         wait until they are written; if this happens often, the disk is too slow for this rate",
        folder.display()
    )]
    Backlog {
        /// The log's folder.
        folder: PathBuf,
        /// Images recorded but not yet written, in MB.
        queued_mb: u64,
        /// Capacity of the queue, in MB.
        queue_mb: u64,
    },
    /// The folder contains no log.
    #[error(
        "{} contains no raw log: give the folder `raw` of a recorded run, which holds segment_000000.raw",
        folder.display()
    )]
    NoSegment {
        /// The folder.
        folder: PathBuf,
    },
    /// The log was written by a newer program.
    #[error(
        "{} is in version {found} of the raw log's format and this program reads up to \
         {FORMAT_VERSION}: use the lfpiv that recorded it, or a newer one", path.display()
    )]
    NewerVersion {
        /// The segment.
        path: PathBuf,
        /// Its format version.
        found: u32,
    },
    /// Bytes differ from what was written.
    #[error(
        "{0}; the rest is still read: item_at for another copy of this file, and at the \
         disk"
    )]
    Damaged(Damage),
    /// Records are in no segment.
    #[error(
        "records {} to {} are missing in {}: {}; item_at for another copy of the folder",
        records.start(), records.end(), folder.display(), lost_segments(segments.as_ref())
    )]
    Missing {
        /// The log's folder.
        folder: PathBuf,
        /// The missing records.
        records: RangeInclusive<u64>,
        /// The segments that held them, where those cannot be read.
        segments: Option<RangeInclusive<u32>>,
    },
    /// The log continued in a missing segment, so the number of lost records is unknown.
    #[error(
        "all records from {first} on are missing in {}: the log continued in {}, which is missing; \
         item_at for another copy of the folder",
        folder.display(), segment_name(*segment)
    )]
    MissingEnd {
        /// The log's folder.
        folder: PathBuf,
        /// First missing record.
        first: u64,
        /// First missing segment.
        segment: u32,
    },
}

/// A damaged range of a segment.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Damage {
    /// The segment.
    pub path: PathBuf,
    /// The damaged bytes.
    pub bytes: Range<u64>,
    /// The lost records, if known.
    pub records: Option<RangeInclusive<u64>>,
    /// The kind of damage.
    pub what: &'static str,
}

impl fmt::Display for Damage {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { path, bytes, records, what } = self;
        let path = path.display();
        write!(formatter, "{path} is damaged from byte {} to byte {}", bytes.start, bytes.end)?;
        match records {
            Some(records) if records.start() == records.end() => {
                write!(formatter, " (record {})", records.start())?;
            }
            Some(records) => {
                write!(formatter, " (records {} to {})", records.start(), records.end())?;
            }
            None => {}
        }
        write!(formatter, ": {what}")
    }
}

/// Why a record was not accepted.
#[derive(Debug, Error)]
pub enum AppendError {
    /// The queue is full. Contains the rejected record.
    #[error("the raw log's queue is full: wait until records are written")]
    Full(Record),
    /// The log has failed or is closed, or the record exceeds the format's limits.
    #[error("{0}")]
    Failed(Arc<RawLogError>),
}

impl RawLogError {
    /// Adapter for `map_err`: adds the operation and the path.
    pub(super) fn io(
        action: &'static str,
        path: impl Into<PathBuf>,
    ) -> impl FnOnce(io::Error) -> Self {
        let path = path.into();
        move |reason| Self::Io { action, path, reason }
    }

    /// The same failure, reported as the one that stopped recording.
    pub(super) fn ends_recording(self) -> Self {
        match self {
            Self::Io { action, path, reason } => Self::DiskFailed { action, path, reason },
            other => other,
        }
    }

    /// The error for a segment whose header cannot be read.
    pub(super) fn header(path: impl Into<PathBuf>, fault: HeaderFault) -> Self {
        let path = path.into();
        let damaged = |path, what| Self::Damaged(Damage { path, bytes: 0..0, records: None, what });
        match fault {
            HeaderFault::NewerVersion(found) => Self::NewerVersion { path, found },
            HeaderFault::Incomplete => damaged(path, "the segment's header is incomplete"),
            HeaderFault::Damaged => damaged(
                path,
                "both copies of the segment's header are damaged: its records are lost",
            ),
        }
    }

    /// Whether this reports damaged or missing data: other records can still be read.
    pub fn is_damage(&self) -> bool {
        matches!(
            self,
            Self::Damaged(_) | Self::Missing { .. } | Self::MissingEnd { .. } | Self::Io { .. }
        )
    }
}

fn lost_segments(segments: Option<&RangeInclusive<u32>>) -> String {
    let Some(segments) = segments else { return "their segments are unknown".into() };
    let (first, last) = (segment_name(*segments.start()), segment_name(*segments.end()));
    if first == last {
        return format!("{first} is lost or cannot be read");
    }
    format!("{first} to {last} are lost or cannot be read")
}

fn segment_name(number: u32) -> String {
    sealed_path(Path::new(""), number).display().to_string()
}

fn advice(reason: &io::Error, path: &Path) -> String {
    match reason.kind() {
        ErrorKind::StorageFull | ErrorKind::QuotaExceeded => format!(
            "free space on the disk of {}, then `lfpiv process RUN` measures what was recorded",
            path.display()
        ),
        ErrorKind::ReadOnlyFilesystem => {
            "the disk is or has become read-only: item_at for its faults \
            in the kernel's log (dmesg) and record the next run on another disk; `lfpiv process \
            RUN` measures what was recorded"
                .into()
        }
        _ => {
            "item_at for the disk's faults in the kernel's log (dmesg) and record the next run on \
            another disk; `lfpiv process RUN` measures what was recorded"
                .into()
        }
    }
}
