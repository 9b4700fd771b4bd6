//! The segment format, version 2. All integers are little-endian; every CRC is CRC-32 (ISO-HDLC).
//!
//! A segment consists of two copies of a [`SegmentHeader`], records, and, once it is sealed, a
//! [`Footer`]. A record consists of a [`RecordHeader`], its head, and its encoded image.
//!
//! Segment header, 52 bytes with an empty description:
//!
//! | offset | bytes | field |
//! |---|---|---|
//! | 0 | 8 | magic `LFPIVRAW` |
//! | 8 | 4 | format version, 2 |
//! | 12 | 4 | L, bytes of the header |
//! | 16 | 8 | creation time of the log, UTC in ns; the same in every segment |
//! | 24 | 4 | number of the segment, from 0 |
//! | 28 | 4 | digest of the previous segment: the CRC at the end of its footer; 0 in the first |
//! | 32 | 8 | number of records in the previous segment; 0 in the first |
//! | 40 | 8 | sequence number of the first record |
//! | 48 | L - 52 | description of the run, the same in every segment |
//! | L - 4 | 4 | CRC of all bytes before it: the segment's *salt* |
//! | L | L | the same bytes again |
//!
//! Later versions keep magic, version, L and the trailing CRC in place, so that damage can be told
//! from a newer version.
//!
//! Record header, 48 bytes, followed by head and stored image:
//!
//! | offset | bytes | field |
//! |---|---|---|
//! | 0 | 4 | magic `LFRC` |
//! | 4 | 4 | H, bytes of the head |
//! | 8 | 8 | sequence number, counted from 0 over the whole log |
//! | 16 | 4 | columns of the image |
//! | 20 | 4 | rows |
//! | 24 | 4 | codec: 0 no image, 1 raw, 2 packed, 3 zstd |
//! | 28 | 4 | S, bytes of the stored image |
//! | 32 | 4 | CRC of the head |
//! | 36 | 4 | CRC of the stored image |
//! | 40 | 4 | CRC of the image's counts as 16-bit integers, independent of the codec |
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
//! | 8 | 8 | number of records, including those that recovery found damaged |
//! | 16 | 8 | bytes before the footer |
//! | 24 | 4 | CRC of all record headers, in order |
//! | 28 | 4 | what follows: 1 the next segment, 2 nothing (closed), 3 nothing (cut off by a crash) |
//! | 32 | 4 | CRC of the salt and of bytes 0 to 31 |
//!
//! The salt binds records to their segment: after a power cut, a disk block may still hold intact
//! records of an older file.
//!
//! Version 1 has another header, stored once (magic, version, segment number, first sequence number,
//! length of the description, description, CRC), and a footer without bytes 28 to 31.

mod fields;
mod footer;
mod record_header;
mod segment_header;

pub(super) use footer::{Ending, FOOTER_MAGIC, Footer};
pub(super) use record_header::{RECORD_HEADER_BYTES, RECORD_MAGIC, RecordHeader};
pub(super) use segment_header::{
    DecodedHeader, HeaderFault, MAX_HEADER_BYTES, Predecessor, SEGMENT_MAGIC, SegmentHeader,
};

/// The version that this program writes, and the newest that it reads.
pub const FORMAT_VERSION: u32 = 2;

/// CRC over a segment's salt and `bytes`.
fn salted_crc(salt: u32, bytes: &[u8]) -> u32 {
    let mut hasher = crc32fast::Hasher::new();
    hasher.update(&salt.to_le_bytes());
    hasher.update(bytes);
    hasher.finalize()
}
