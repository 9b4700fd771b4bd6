//! The bytes of a segment, version 2. Everything is little-endian; every CRC is CRC-32 (ISO-HDLC).
//!
//! A segment is a [`SegmentHeader`], twice, then records one after the other, then, once it is
//! sealed, a [`Footer`]. A record is a [`RecordHeader`], its head, and its image as the codec stored
//! it.
//!
//! Segment header, 52 bytes with an empty description:
//!
//! | offset | bytes | field |
//! |---|---|---|
//! | 0 | 8 | magic `LFPIVRAW` |
//! | 8 | 4 | format version, 2 |
//! | 12 | 4 | L, bytes of the header |
//! | 16 | 8 | when the log was begun, UTC in ns, the same in every segment |
//! | 24 | 4 | number of the segment, from 0 |
//! | 28 | 4 | digest of the segment before: the CRC at the end of its footer; 0 in the first |
//! | 32 | 8 | number of records of the segment before; 0 in the first |
//! | 40 | 8 | sequence number of its first record |
//! | 48 | L - 52 | description of the run, the same in every segment |
//! | L - 4 | 4 | CRC of all bytes before it: the segment's *salt* |
//! | L | L | the same bytes again |
//!
//! Every later version keeps magic, version and L where they are, and ends in the CRC: whether a
//! header is damaged is judged before its version.
//!
//! Record, 48 bytes, the head and the stored image:
//!
//! | offset | bytes | field |
//! |---|---|---|
//! | 0 | 4 | magic `LFRC` |
//! | 4 | 4 | H, bytes of the head |
//! | 8 | 8 | sequence number, from 0 through the whole log |
//! | 16 | 4 | columns of the image |
//! | 20 | 4 | rows |
//! | 24 | 4 | how it is stored: 0 no image, 1 raw, 2 packed, 3 zstd |
//! | 28 | 4 | S, bytes of the stored image |
//! | 32 | 4 | CRC of the head |
//! | 36 | 4 | CRC of the stored image |
//! | 40 | 4 | CRC of the image's counts as 16-bit numbers, whatever the codec |
//! | 44 | 4 | CRC of the salt and of bytes 0 to 43 |
//! | 48 | H | head |
//! | 48 + H | S | stored image |
//!
//! Footer, 36 bytes:
//!
//! | offset | bytes | field |
//! |---|---|---|
//! | 0 | 4 | magic `LFEN` |
//! | 4 | 4 | number of the segment |
//! | 8 | 8 | number of records, those that recovery found damaged included |
//! | 16 | 8 | bytes before the footer |
//! | 24 | 4 | CRC of all record headers, in order |
//! | 28 | 4 | what follows: 1 the next segment, 2 nothing, the log was closed, 3 nothing, it was cut off |
//! | 32 | 4 | CRC of the salt and of bytes 0 to 31 |
//!
//! The salt binds records to their segment: after a power cut a block of the disk may hold what an
//! older file left there, and its records are whole.
//!
//! Version 1 has another header (magic, version, number of the segment, first sequence number, bytes
//! of the description, description, CRC), once, and a footer without bytes 28 to 31.

mod fields;
mod footer;
mod record_header;
mod segment_header;

pub(super) use footer::{Ending, FOOTER_MAGIC, Footer};
pub(super) use record_header::{RECORD_HEADER_BYTES, RECORD_MAGIC, RecordHeader};
pub(super) use segment_header::{
    DecodedHeader, HeaderFault, MOST_HEADER_BYTES, Predecessor, SEGMENT_MAGIC, SegmentHeader,
};

/// The version this program writes, and the newest it reads.
pub const FORMAT_VERSION: u32 = 2;

/// CRC of a segment's salt and of `bytes`.
fn salted_crc(salt: u32, bytes: &[u8]) -> u32 {
    let mut hasher = crc32fast::Hasher::new();
    hasher.update(&salt.to_le_bytes());
    hasher.update(bytes);
    hasher.finalize()
}
