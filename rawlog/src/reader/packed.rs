//! Records as they are on disk, to be decoded elsewhere: compressed, with their checksums.

use lfpiv_hw::RawImage;

use super::{
    super::{
        Damage, Position, RawLogError, Record,
        codec::decode,
        format::{RECORD_HEADER_BYTES, RecordHeader},
    },
    RawLogReader,
    segment_file::{SegmentFile, SegmentItem},
};

/// Bytes of the salt, which precedes the record.
const SALT_BYTES: usize = 4;

impl RawLogReader {
    /// The record at a position that [`Self::heads`] returned, as it is on disk, behind the salt of its
    /// segment (4 bytes, little-endian). [`unpack`] reads and checks it.
    ///
    /// # Errors
    /// There is no record at this position. Head and image are not checked.
    pub fn packed(&self, position: Position) -> Result<Vec<u8>, RawLogError> {
        let (segment, header) = self.locate(position)?;
        let mut bytes = segment.salt.to_le_bytes().to_vec();
        bytes.extend(segment.bytes(position.offset, header.record_bytes())?);
        Ok(bytes)
    }

    /// CRC-32 of the image of the record at a position, as [`RawImage::crc32`]; the image is not read.
    ///
    /// # Errors
    /// There is no record at this position.
    pub fn image_crc32(&self, position: Position) -> Result<u32, RawLogError> {
        Ok(self.locate(position)?.1.image_crc)
    }

    pub(super) fn locate(
        &self,
        position: Position,
    ) -> Result<(SegmentFile, RecordHeader), RawLogError> {
        let Position { segment: number, offset } = position;
        let segment = self.segment(number)?.ok_or_else(|| self.no_record(position))?;
        match segment.item_at(offset)? {
            SegmentItem::Record(header) => Ok((segment, header)),
            SegmentItem::Torn(_) | SegmentItem::Footer(_) | SegmentItem::Nothing => {
                Err(self.no_record(position))
            }
        }
    }

    /// The error for a position at which there is no record.
    pub(super) fn no_record(&self, position: Position) -> RawLogError {
        let Position { segment, offset } = position;
        let path = super::names::sealed_path(self.folder(), segment);
        let (bytes, what) = (offset..offset, "there is no record");
        RawLogError::Damaged(Damage { path, bytes, records: None, what })
    }
}

/// The record in bytes that [`RawLogReader::packed`] has made.
///
/// # Errors
/// What is damaged, in words.
pub fn unpack(bytes: &[u8]) -> Result<Record, &'static str> {
    let Some((salt, record)) = bytes.split_first_chunk::<SALT_BYTES>() else {
        return Err("the record is too short");
    };
    let header = RecordHeader::decode(record, u32::from_le_bytes(*salt))
        .ok_or("the header of the record has changed")?;
    if record.len() as u64 != header.record_bytes() {
        return Err("the record is not whole");
    }
    let (head, stored) = record[RECORD_HEADER_BYTES..].split_at(header.head_bytes as usize);
    if crc32fast::hash(head) != header.head_crc {
        return Err("the head of the record has changed");
    }
    Ok(Record { head: head.to_vec(), image: image(&header, stored)? })
}

fn image(header: &RecordHeader, stored: &[u8]) -> Result<Option<RawImage>, &'static str> {
    if !header.has_image() {
        return Ok(None);
    }
    if crc32fast::hash(stored) != header.stored_crc {
        return Err("the image of the record has changed");
    }
    decode(stored, header.codec, header.columns, header.rows)
        .filter(|image| image.crc32() == header.image_crc)
        .map(Some)
        .ok_or("the image cannot be decoded")
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{RawLog, RawLogSettings};

    #[test]
    fn a_packed_record_is_unpacked_as_it_is_read_and_every_changed_byte_is_noticed() {
        let root = tempfile::tempdir().unwrap();
        let (log, writer) =
            RawLog::create(root.path(), b"a run", &RawLogSettings::default()).unwrap();
        let image = RawImage::new(5, 4, (0..20).map(|n| 7 * n).collect()).unwrap();
        for image in [None, Some(image)] {
            log.append_blocking(Record { head: b"{}".to_vec(), image }).unwrap();
        }
        writer.close().unwrap();
        let reader = RawLogReader::open(root.path()).unwrap();
        for head in reader.heads() {
            let (_, position, _, has_image) = head.unwrap();
            let packed = reader.packed(position).unwrap();
            let record = reader.read(position).unwrap();
            assert_eq!(unpack(&packed), Ok(record.clone()));
            let crc = record.image.map_or(0, |image| image.crc32());
            assert!(!has_image || reader.image_crc32(position).unwrap() == crc);
            for at in 0..packed.len() {
                let mut changed = packed.clone();
                changed[at] ^= 1;
                assert!(unpack(&changed).is_err(), "byte {at}");
                assert!(unpack(&packed[..at]).is_err(), "{at} bytes");
            }
            let beside = Position { offset: position.offset + 1, ..position };
            assert!(reader.packed(beside).unwrap_err().is_damage());
        }
    }
}
