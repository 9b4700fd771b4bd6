//! Reads a segment's header from whichever copy is intact.

use std::io;

use super::super::{
    format::{
        DecodedHeader, HeaderFault, MAX_HEADER_BYTES, RECORD_MAGIC, SEGMENT_MAGIC, SegmentHeader,
    },
    storage::LogFile,
};
use super::search::find_bytes;

/// Why a segment cannot be opened.
pub(in super::super) enum OpenFault {
    /// The header is unusable.
    Header(HeaderFault),
    /// A file operation failed.
    Io(io::Error),
}

/// A header, and which of its copies is damaged.
pub(super) struct HeaderCopies {
    pub decoded: DecodedHeader,
    /// Offset of the damaged copy, if there is one.
    pub damaged: Option<u64>,
}

/// Reads the header of a segment.
pub(super) fn read_header(file: &dyn LogFile) -> Result<HeaderCopies, OpenFault> {
    let length = file.length().map_err(OpenFault::Io)?;
    let found = match decode_at(file, 0)? {
        Ok(decoded) => {
            let second = decoded.length as u64;
            let is_whole =
                decoded.header.copies() == 1 || decode_at(file, second)?.as_ref() == Ok(&decoded);
            HeaderCopies { decoded, damaged: (!is_whole).then_some(second) }
        }
        Err(fault @ HeaderFault::NewerVersion(_)) => return Err(OpenFault::Header(fault)),
        Err(_) => match second_copy(file)? {
            Some(decoded) => HeaderCopies { decoded, damaged: Some(0) },
            None => return Err(without_header(file)?),
        },
    };
    // Both copies are one write, and records are written after it.
    let all = found.decoded.length as u64 * found.decoded.header.copies() as u64;
    if length < all {
        return Err(without_header(file)?);
    }
    Ok(found)
}

/// The second copy, after a damaged first one: it begins where the first ended.
fn second_copy(file: &dyn LogFile) -> Result<Option<DecodedHeader>, OpenFault> {
    let mut from = 1;
    loop {
        let found = find_bytes(file, from, MAX_HEADER_BYTES as u64, &[&SEGMENT_MAGIC]);
        let Some(at) = found.map_err(OpenFault::Io)? else { return Ok(None) };
        match decode_at(file, at)? {
            Ok(decoded) if decoded.length as u64 == at => return Ok(Some(decoded)),
            Err(fault @ HeaderFault::NewerVersion(_)) => return Err(OpenFault::Header(fault)),
            _ => from = at + 1,
        }
    }
}

/// The fault of a file without a header. A program that died while creating a segment left neither
/// header nor records.
fn without_header(file: &dyn LogFile) -> Result<OpenFault, OpenFault> {
    let record = find_bytes(file, 0, u64::MAX, &[&RECORD_MAGIC]).map_err(OpenFault::Io)?;
    let fault = if record.is_some() { HeaderFault::Damaged } else { HeaderFault::Incomplete };
    Ok(OpenFault::Header(fault))
}

fn decode_at(
    file: &dyn LogFile,
    offset: u64,
) -> Result<Result<DecodedHeader, HeaderFault>, OpenFault> {
    let read = |length: usize| {
        let mut bytes = vec![0; length];
        let read = file.read_at(offset, &mut bytes).map_err(OpenFault::Io)?;
        bytes.truncate(read);
        Ok(bytes)
    };
    let needed = SegmentHeader::needed_bytes(&read(SegmentHeader::START_BYTES)?) as u64;
    // A corrupt length must not allocate more memory than the file has bytes.
    let there = file.length().map_err(OpenFault::Io)?.saturating_sub(offset);
    Ok(SegmentHeader::decode(&read(needed.min(there) as usize)?))
}
