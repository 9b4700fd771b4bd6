//! Raw images.

mod pool;
mod record;

use std::sync::Arc;

use thiserror::Error;

use pool::Counts;
pub use pool::ImagePool;
pub use record::RecordedCamera;

/// A raw grey image, row-major, row 0 at the top (docs/theory.md, section 2: row `r` lies at
/// `((Ny−1)/2 − r)·p` along the camera's `up`).
///
/// Eight-bit images are widened to `u16` without scaling: the values are the counts in the file.
///
/// Clones share the counts, so that raw log, processing and server use the same memory. The memory of
/// an image from an [`ImagePool`] returns to the pool when its last clone is dropped.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct RawImage {
    columns: usize,
    rows: usize,
    counts: Arc<Counts>,
}

/// The buffer's length is not columns × rows.
#[derive(Debug, Error)]
#[error("image of {columns} x {rows} pixels needs {} counts, got {counts}", columns * rows)]
pub struct ImageSizeError {
    columns: usize,
    rows: usize,
    counts: usize,
}

impl RawImage {
    /// Wraps `counts` (length `columns * rows`, row-major).
    pub fn new(columns: usize, rows: usize, counts: Vec<u16>) -> Result<Self, ImageSizeError> {
        if counts.len() == columns * rows {
            Ok(Self { columns, rows, counts: Arc::new(Counts::from(counts)) })
        } else {
            Err(ImageSizeError { columns, rows, counts: counts.len() })
        }
    }

    /// Number of pixel columns.
    pub fn columns(&self) -> usize {
        self.columns
    }

    /// Number of pixel rows.
    pub fn rows(&self) -> usize {
        self.rows
    }

    /// All counts, row-major.
    pub fn counts(&self) -> &[u16] {
        self.counts.values()
    }

    /// One pixel row.
    pub fn row(&self, row: usize) -> &[u16] {
        &self.counts()[row * self.columns..(row + 1) * self.columns]
    }

    /// CRC-32 (ISO-HDLC) of the counts as little-endian bytes, to compare images.
    pub fn crc32(&self) -> u32 {
        let mut hasher = crc32fast::Hasher::new();
        let mut bytes = [0; 4096];
        for counts in self.counts().chunks(bytes.len() / 2) {
            for (pair, count) in bytes.chunks_exact_mut(2).zip(counts) {
                pair.copy_from_slice(&count.to_le_bytes());
            }
            hasher.update(&bytes[..2 * counts.len()]);
        }
        hasher.finalize()
    }
}
