//! The durable raw log: records of one run, appended and never changed, lossless, checksummed, in
//! segments.
//!
//! [`RawLog`] takes records without blocking the runtime, a thread writes them
//! ([`RawLogWriter`]), [`RawLogReader`] reads them after the run or beside it, [`recover`] makes a
//! log whole after a crash. What a record means is no business of the log: a record is a small head
//! (JSON by convention) and, if there is one, an image.
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
//! # What is promised
//!
//! A record with a sequence number below a watermark
//!
//! - *appended* is in memory: it is lost when the process dies;
//! - *written* is in the kernel's hands: it survives the death of the process, at whatever
//!   instruction, but not a power cut;
//! - *synced* is on the disk: it survives a power cut, as far as the disk keeps what it says it has
//!   flushed.
//!
//! Raw data is never dropped: who appends waits for room. When the disk fails (full, read-only,
//! gone) the log has failed for good: what was written stays readable, what was not is counted
//! (`appended - written`), and the message says what to do.
//!
//! # Files
//!
//! `segment_000000.raw` and so on are *sealed*: they end in a footer and are not touched any more.
//! The one being written is `segment_NNNNNN.raw.part`. What recovery cuts off is kept as
//! `segment_NNNNNN.raw.torn`. The bytes are described in `format` and in `docs/raw-log.md`.

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
pub use reader::{Head, RawLogReader};
pub use record::{Position, Record, Watermarks};
pub use recovery::{RecoveredSegment, Recovery, TornTail, recover};
pub use settings::RawLogSettings;
pub use writer::RawLogWriter;
