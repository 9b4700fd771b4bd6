//! What is recorded, and how far it has got.

use lfpiv_hw::RawImage;
use serde::Serialize;

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
