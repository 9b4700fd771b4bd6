//! The durable raw log: an append-only, lossless, checksummed log of one run, in segments.
//!
//! [`RawLog`] accepts records without blocking the runtime, and a thread ([`RawLogWriter`]) writes
//! them. [`RawLogReader`] reads a log during or after the run. [`recover`] repairs a log after a
//! crash. The log does not interpret its records: a record is a small head (JSON by convention) and
//! an optional image.
//!
//! ```no_run
//! use lfpiv_rawlog::{RawLog, RawLogReader, RawLogSettings, Record};
//! # fn main() -> Result<(), lfpiv_rawlog::RawLogError> {
//! let folder = std::path::Path::new("run/raw");
//! let (log, writer) = RawLog::create(folder, b"{}", &RawLogSettings::default())?;
//! log.append_blocking(Record { head: br#"{"note":"lamps on"}"#.to_vec(), image: None })?;
//! writer.close()?;
//! for record in RawLogReader::open(folder)?.records() {
//!     let (sequence, record) = record?;
//!     println!("{sequence}: {} bytes", record.head.len());
//! }
//! # Ok(())
//! # }
//! ```
//!
//! # Durability
//!
//! A record whose sequence number is below a watermark is
//!
//! - *appended*: in memory, lost when the process dies;
//! - *written*: in the kernel, survives the death of the process at any instruction, but not a power
//!   cut;
//! - *synced*: on the disk, survives a power cut if the disk honours a flush.
//!
//! Raw data is never dropped: appending waits for queue space. When the disk fails (full, read-only,
//! removed), the log stops for good: written records stay readable, lost ones are counted
//! (`appended - written`), and the error says what to do.
//!
//! # Files
//!
//! `segment_000000.raw` and so on are *sealed*: they end in a footer and never change. The segment
//! being written is `segment_NNNNNN.raw.part`. Recovery keeps a torn tail as
//! `segment_NNNNNN.raw.torn`. `format` and `docs/raw-log.md` describe the bytes.

mod codec;
mod error;
mod format;
mod log;
pub mod measure;
mod names;
mod queue;
mod reader;
mod record;
mod recovery;
pub mod regular_file;
mod segments;
mod settings;
mod storage;
#[cfg(test)]
mod tests;
mod writer;

pub use codec::Codec;
pub use error::{AppendError, Damage, RawLogError};
pub use format::FORMAT_VERSION;
pub use log::RawLog;
pub use reader::{Head, RawLogReader, unpack};
pub use record::{LogWatermarks, Position, Record};
pub use recovery::{RecoveredSegment, Recovery, TornTail, recover};
pub use settings::RawLogSettings;
pub use writer::RawLogWriter;
