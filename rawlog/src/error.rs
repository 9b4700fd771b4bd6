//! Why the raw log cannot be written or read.

use std::{
    fmt,
    io::{self, ErrorKind},
    ops::{Range, RangeInclusive},
    path::{Path, PathBuf},
    sync::Arc,
};

use thiserror::Error;

use super::{FORMAT_VERSION, Record, format::HeaderFault, names::sealed_path};

/// Why the raw log cannot be written or read.
///
/// Every message is complete: the reason is part of it, not a `source` to be printed after it.
#[derive(Debug, Error)]
pub enum RawLogError {
    /// The operating system refused.
    #[error("cannot {action} {}: {reason}", path.display())]
    Io {
        /// What was tried.
        action: &'static str,
        /// On which file or folder.
        path: PathBuf,
        /// The system's reason.
        reason: io::Error,
    },
    /// The disk refused while a run was being recorded: nothing is recorded any more.
    #[error(
        "raw data is not recorded any more: cannot {action} {}: {reason}; what was written before \
         is kept; {}", path.display(), advice(reason, path)
    )]
    DiskFailed {
        /// What was tried.
        action: &'static str,
        /// On which file or folder.
        path: PathBuf,
        /// The system's reason.
        reason: io::Error,
    },
    /// An earlier failure ended the log.
    #[error("{0}")]
    Stopped(Arc<RawLogError>),
    /// The log's writer has been closed.
    #[error("the raw log in {} is closed: start a new run to record more", folder.display())]
    Closed {
        /// The log's folder.
        folder: PathBuf,
    },
    /// The writer's thread ended by a panic.
    #[error(
        "raw data is not recorded any more: the writer of {} has panicked; what was written \
         before is kept; report the panic message above and start a new run", folder.display()
    )]
    WriterPanicked {
        /// The log's folder.
        folder: PathBuf,
    },
    /// A run's folder is already in use.
    #[error(
        "{} already holds a raw log: choose another folder or move it away", folder.display()
    )]
    AlreadyUsed {
        /// The folder.
        folder: PathBuf,
    },
    /// A record that the format cannot hold.
    #[error(
        "{what} cannot be recorded, a raw log holds up to {limit}: record smaller images or \
         shorter notes"
    )]
    TooLarge {
        /// Which part, and its size.
        what: String,
        /// What is allowed.
        limit: &'static str,
    },
    /// There is not room for what is about to be recorded.
    #[error(
        "{} has room for {free_mb} MB and {needed_mb} MB are needed ({wanted_mb} MB of images, \
         {queued_mb} MB that wait to be written, {reserve_mb} MB that stay free): make room, \
         record fewer shots, or lower raw_log.reserve_mb", folder.display()
    )]
    NoRoom {
        /// The log's folder.
        folder: PathBuf,
        /// Room on the disk, in MB.
        free_mb: u64,
        /// Sum of the next three, in MB.
        needed_mb: u64,
        /// Images about to be recorded, in MB.
        wanted_mb: u64,
        /// Images recorded and not written yet, in MB.
        queued_mb: u64,
        /// Room that must stay free, in MB.
        reserve_mb: u64,
    },
    /// The disk does not keep up.
    #[error(
        "{queued_mb} MB wait to be written to {}, more than half of raw_log.queue_mb = {queue_mb}: \
         wait until they are written; if this happens often, the disk is too slow for this rate",
        folder.display()
    )]
    Behind {
        /// The log's folder.
        folder: PathBuf,
        /// Images recorded and not written yet, in MB.
        queued_mb: u64,
        /// Most that may wait, in MB.
        queue_mb: u64,
    },
    /// There is nothing to read.
    #[error(
        "{} holds no raw log: give the folder raw of a recorded run, with segment_000000.raw in it",
        folder.display()
    )]
    NoSegment {
        /// The folder.
        folder: PathBuf,
    },
    /// Written by a newer program.
    #[error(
        "{} is in version {found} of the raw log's format and this program reads up to \
         {FORMAT_VERSION}: use the lfpiv that recorded it, or a newer one", path.display()
    )]
    NewerVersion {
        /// The segment.
        path: PathBuf,
        /// Its version.
        found: u32,
    },
    /// Bytes that are not what was written.
    #[error(
        "{0}; what lies around them is still read: look for another copy of this file, and at the \
         disk"
    )]
    Damaged(Damage),
    /// Records that are in no segment.
    #[error(
        "records {} to {} are missing in {}: {}; look for another copy of the folder",
        records.start(), records.end(), folder.display(), lost_segments(segments.as_ref())
    )]
    Missing {
        /// The log's folder.
        folder: PathBuf,
        /// The records that are not there.
        records: RangeInclusive<u64>,
        /// The segments that they were in, where those cannot be read.
        segments: Option<RangeInclusive<u32>>,
    },
    /// The log went on, and how far is not known.
    #[error(
        "all records from {first} on are missing in {}: the log went on in {}, which is not there; \
         look for another copy of the folder",
        folder.display(), segment_name(*segment)
    )]
    MissingEnd {
        /// The log's folder.
        folder: PathBuf,
        /// First record that is not there.
        first: u64,
        /// First segment that is not there.
        segment: u32,
    },
}

/// Bytes of a segment that are not what was written.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Damage {
    /// The segment.
    pub path: PathBuf,
    /// Which bytes of it.
    pub bytes: Range<u64>,
    /// The records that are lost with them, as far as they are known.
    pub records: Option<RangeInclusive<u64>>,
    /// What is wrong there.
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

/// Why a record was not taken.
#[derive(Debug, Error)]
pub enum AppendError {
    /// As many bytes as allowed wait to be written; here is the record.
    #[error("the raw log's queue is full: wait for room")]
    Full(Record),
    /// The log has failed or is closed, or could never hold this record.
    #[error("{0}")]
    Failed(Arc<RawLogError>),
}

impl RawLogError {
    /// Adapter for `map_err`: adds what was tried and on which path.
    pub(super) fn io(
        action: &'static str,
        path: impl Into<PathBuf>,
    ) -> impl FnOnce(io::Error) -> Self {
        let path = path.into();
        move |reason| Self::Io { action, path, reason }
    }

    /// The same failure as the end of a log that was being written.
    pub(super) fn ends_recording(self) -> Self {
        match self {
            Self::Io { action, path, reason } => Self::DiskFailed { action, path, reason },
            other => other,
        }
    }

    /// Why the first bytes of a segment are no header.
    pub(super) fn header(path: impl Into<PathBuf>, fault: HeaderFault) -> Self {
        let path = path.into();
        let damaged = |path, what| Self::Damaged(Damage { path, bytes: 0..0, records: None, what });
        match fault {
            HeaderFault::NewerVersion(found) => Self::NewerVersion { path, found },
            HeaderFault::Incomplete => damaged(path, "the segment's header is not complete"),
            HeaderFault::Damaged => {
                damaged(path, "no copy of the segment's header is whole: its records are lost")
            }
        }
    }

    /// Whether recorded data is damaged or missing: other records can still be read.
    pub fn is_damage(&self) -> bool {
        matches!(
            self,
            Self::Damaged(_) | Self::Missing { .. } | Self::MissingEnd { .. } | Self::Io { .. }
        )
    }
}

fn lost_segments(segments: Option<&RangeInclusive<u32>>) -> String {
    let Some(segments) = segments else { return "nothing says where they were".into() };
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
            "make room on the disk of {}, then `lfpiv process RUN` measures what was recorded",
            path.display()
        ),
        ErrorKind::ReadOnlyFilesystem => {
            "the disk is or has become read-only: look for its faults \
            in the kernel's log (dmesg) and record the next run on another disk; `lfpiv process \
            RUN` measures what was recorded"
                .into()
        }
        _ => "look for the disk's faults in the kernel's log (dmesg) and record the next run on \
            another disk; `lfpiv process RUN` measures what was recorded"
            .into(),
    }
}
