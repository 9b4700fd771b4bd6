//! Records and watermarks.

use lfpiv_hw::RawImage;
use serde::Serialize;

use super::{RawLogError, codec::MAX_PIXELS};

/// One record: a head that the log does not interpret, and an optional image.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Record {
    /// A small JSON text, by convention of the callers.
    pub head: Vec<u8>,
    /// The image; its memory may be shared.
    pub image: Option<RawImage>,
}

impl Record {
    /// Memory of head and counts, in bytes.
    pub fn bytes(&self) -> u64 {
        let counts = self.image.as_ref().map_or(0, |image| image.counts().len());
        self.head.len() as u64 + 2 * counts as u64
    }

    /// Columns and rows of the image; 0 without one.
    ///
    /// # Errors
    /// Head or image exceeds the format's limits.
    pub(super) fn image_size(&self) -> Result<[u32; 2], RawLogError> {
        if u32::try_from(self.head.len()).is_err() {
            let what = format!("a head of {} bytes", self.head.len());
            return Err(RawLogError::TooLarge { what, limit: "4294967295 bytes" });
        }
        let Some(image) = &self.image else { return Ok([0, 0]) };
        let sides = u32::try_from(image.columns()).ok().zip(u32::try_from(image.rows()).ok());
        match sides.filter(|_| image.counts().len() as u64 <= MAX_PIXELS) {
            Some((columns, rows)) => Ok([columns, rows]),
            None => {
                let what = format!("an image of {} x {} pixels", image.columns(), image.rows());
                Err(RawLogError::TooLarge { what, limit: "268435456 pixels" })
            }
        }
    }
}

/// Position of a record.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct Position {
    /// Number of the segment.
    pub segment: u32,
    /// Offset of its first byte in the segment.
    pub offset: u64,
}

/// LogWatermarks: every record with a smaller sequence number has reached this level.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq, Serialize)]
pub struct LogWatermarks {
    /// Appended to the queue.
    pub appended: u64,
    /// Written to the operating system: survives the death of this process.
    pub written: u64,
    /// Synced to disk: survives a power cut.
    pub synced: u64,
    /// Bytes of heads and images written, before encoding.
    pub bytes_in: u64,
    /// Bytes of all segments.
    pub bytes_written: u64,
    /// Segments created.
    pub segments: u32,
}
