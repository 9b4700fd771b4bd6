//! Lossless storage of images.

mod packed;
mod planes;
#[cfg(test)]
mod tests;

use std::io;

use garde::Validate;
use lfpiv_hw::RawImage;
use serde::{Deserialize, Serialize};

/// Largest image that can be stored, in pixels. It bounds what a corrupt length makes a reader
/// allocate.
pub(super) const MAX_PIXELS: u64 = 1 << 28;

/// zstd level. Higher levels are slower and do not compress noisy images better.
const ZSTD_LEVEL: i32 = 1;

/// How a log stores its images.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq, Serialize, Deserialize, Validate)]
#[serde(rename_all = "kebab-case")]
#[garde(allow_unvalidated)]
pub enum Codec {
    /// Plain 16-bit counts.
    Raw,
    /// Frame-of-reference bit packing in blocks of counts.
    Packed,
    /// Byte shuffling, then zstd: smaller files at several times the processor time.
    Zstd,
    /// The recommended codec (`docs/raw-log.md`): packed.
    #[default]
    Auto,
}

/// The codec number in a record header.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum StoredAs {
    Raw = 1,
    Packed = 2,
    Zstd = 3,
}

/// Codec number of plain 16-bit little-endian counts.
pub(super) const STORED_RAW: u32 = StoredAs::Raw as u32;

/// Encodes images; reuses its buffers and compression context.
pub(super) struct Encoder {
    codec: Codec,
    planes: Vec<u8>,
    zstd: zstd::bulk::Compressor<'static>,
}

impl Encoder {
    /// # Errors
    /// zstd cannot allocate its context.
    pub fn new(codec: Codec) -> io::Result<Self> {
        let zstd = zstd::bulk::Compressor::new(ZSTD_LEVEL)?;
        Ok(Self { codec, planes: Vec::new(), zstd })
    }

    /// Appends the stored image to `stored` and returns the codec number for the record header. An
    /// image that the codec would enlarge is stored raw, so stored images never exceed their counts.
    ///
    /// # Errors
    /// zstd cannot allocate memory.
    pub fn encode(&mut self, image: &RawImage, stored: &mut Vec<u8>) -> io::Result<u32> {
        let start = stored.len();
        let counts = image.counts();
        let stored_as = match self.codec {
            Codec::Raw => StoredAs::Raw,
            Codec::Packed | Codec::Auto => {
                stored.reserve(2 * counts.len());
                packed::pack(counts, stored);
                StoredAs::Packed
            }
            Codec::Zstd => {
                planes::split(counts, &mut self.planes);
                stored.extend(self.zstd.compress(&self.planes)?);
                StoredAs::Zstd
            }
        };
        if stored_as == StoredAs::Raw || stored.len() - start >= 2 * counts.len() {
            stored.truncate(start);
            append_raw(counts, stored);
            return Ok(StoredAs::Raw as u32);
        }
        Ok(stored_as as u32)
    }
}

/// Decodes a stored image. `None` if codec number, size and bytes do not fit together.
pub(super) fn decode(stored: &[u8], codec: u32, columns: u32, rows: u32) -> Option<RawImage> {
    let pixels = u64::from(columns) * u64::from(rows);
    let pixels = usize::try_from(pixels).ok().filter(|pixels| *pixels as u64 <= MAX_PIXELS)?;
    let counts = match codec {
        1 => decode_raw(stored, pixels)?,
        2 => decode_packed(stored, pixels)?,
        3 => decode_zstd(stored, pixels)?,
        _ => return None,
    };
    RawImage::new(columns as usize, rows as usize, counts).ok()
}

fn append_raw(counts: &[u16], stored: &mut Vec<u8>) {
    stored.reserve(2 * counts.len());
    // In chunks: pushing byte by byte into a growing vector is several times slower.
    let mut bytes = [0; 4096];
    for counts in counts.chunks(bytes.len() / 2) {
        for (pair, count) in bytes.chunks_exact_mut(2).zip(counts) {
            pair.copy_from_slice(&count.to_le_bytes());
        }
        stored.extend_from_slice(&bytes[..2 * counts.len()]);
    }
}

fn decode_raw(stored: &[u8], pixels: usize) -> Option<Vec<u16>> {
    let (pairs, rest) = stored.as_chunks::<2>();
    let fits = rest.is_empty() && pairs.len() == pixels;
    fits.then(|| pairs.iter().map(|pair| u16::from_le_bytes(*pair)).collect())
}

fn decode_packed(stored: &[u8], pixels: usize) -> Option<Vec<u16>> {
    if pixels > packed::max_counts(stored.len()) {
        return None;
    }
    let mut counts = vec![0; pixels];
    packed::unpack(stored, &mut counts)?;
    Some(counts)
}

fn decode_zstd(stored: &[u8], pixels: usize) -> Option<Vec<u16>> {
    // The zstd frame states its content size, so a wrong size allocates nothing.
    let content_bytes = zstd::zstd_safe::get_frame_content_size(stored).ok()??;
    if content_bytes != 2 * pixels as u64 {
        return None;
    }
    let planes = zstd::bulk::decompress(stored, 2 * pixels).ok()?;
    if planes.len() != 2 * pixels {
        return None;
    }
    let mut counts = vec![0; pixels];
    planes::join(&planes, &mut counts);
    Some(counts)
}
