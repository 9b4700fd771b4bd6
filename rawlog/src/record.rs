//! What is recorded, and how far it has got.

use lfpiv_hw::RawImage;
use serde::Serialize;

use super::{RawLogError, codec::MOST_PIXELS};

/// One record: a head that the log does not look into, and an image if there is one.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Record {
    /// A small JSON text by convention of the rooms above.
    pub head: Vec<u8>,
    /// The image; its memory is shared with whoever else holds it.
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
    /// Head or image is larger than the format allows.
    pub(super) fn image_size(&self) -> Result<[u32; 2], RawLogError> {
        if u32::try_from(self.head.len()).is_err() {
            let what = format!("a head of {} bytes", self.head.len());
            return Err(RawLogError::TooLarge { what, limit: "4294967295 bytes" });
        }
        let Some(image) = &self.image else { return Ok([0, 0]) };
        let sides = u32::try_from(image.columns()).ok().zip(u32::try_from(image.rows()).ok());
        match sides.filter(|_| image.counts().len() as u64 <= MOST_PIXELS) {
            Some((columns, rows)) => Ok([columns, rows]),
            None => {
                let what = format!("an image of {} x {} pixels", image.columns(), image.rows());
                Err(RawLogError::TooLarge { what, limit: "268435456 pixels" })
            }
        }
    }
}

/// Where a record lies.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct Position {
    /// Number of the segment.
    pub segment: u32,
    /// Its first byte in it.
    pub offset: u64,
}

/// How far the records have got: all with a sequence number below have got there.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq, Serialize)]
pub struct Watermarks {
    /// Taken into the queue.
    pub appended: u64,
    /// Handed to the operating system: they survive the death of this process.
    pub written: u64,
    /// On the disk: they survive a power cut.
    pub synced: u64,
    /// Bytes of heads and images written, as they were in memory.
    pub bytes_in: u64,
    /// Bytes of all segments.
    pub bytes_written: u64,
    /// Segments begun.
    pub segments: u32,
}
