//! The header of a record.

use super::{fields::Fields, salted_crc};

/// Magic number of a record.
pub(in super::super) const RECORD_MAGIC: [u8; 4] = *b"LFRC";

/// Length of a record's header.
pub(in super::super) const RECORD_HEADER_BYTES: usize = 48;

/// Lengths, sequence number and checksums of a record.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(in super::super) struct RecordHeader {
    /// Bytes of the head.
    pub head_bytes: u32,
    /// Sequence number, counted from 0 over the whole log.
    pub sequence: u64,
    /// Columns of the image; 0 without one.
    pub columns: u32,
    /// Rows of the image; 0 without one.
    pub rows: u32,
    /// Codec number of the image; 0 without one.
    pub codec: u32,
    /// Bytes of the stored image.
    pub stored_bytes: u32,
    /// CRC of the head.
    pub head_crc: u32,
    /// CRC of the stored image.
    pub stored_crc: u32,
    /// CRC of the image's counts.
    pub image_crc: u32,
}

impl RecordHeader {
    /// Encodes the header with the segment's salt.
    pub fn encode(&self, salt: u32) -> [u8; RECORD_HEADER_BYTES] {
        let mut bytes = Vec::with_capacity(RECORD_HEADER_BYTES);
        bytes.extend(RECORD_MAGIC);
        bytes.extend(self.head_bytes.to_le_bytes());
        bytes.extend(self.sequence.to_le_bytes());
        for field in [
            self.columns,
            self.rows,
            self.codec,
            self.stored_bytes,
            self.head_crc,
            self.stored_crc,
            self.image_crc,
        ] {
            bytes.extend(field.to_le_bytes());
        }
        bytes.extend(salted_crc(salt, &bytes).to_le_bytes());
        let mut header = [0; RECORD_HEADER_BYTES];
        header.copy_from_slice(&bytes);
        header
    }

    /// Decodes the header at the start of `bytes`. `None` if there is none, if it is damaged, or if it
    /// belongs to another segment.
    pub fn decode(bytes: &[u8], salt: u32) -> Option<Self> {
        let bytes = bytes.get(..RECORD_HEADER_BYTES)?;
        let (content, stored_crc) = bytes.split_at(RECORD_HEADER_BYTES - 4);
        let mut fields = Fields(content);
        if fields.array()? != RECORD_MAGIC || salted_crc(salt, content).to_le_bytes() != stored_crc
        {
            return None;
        }
        Some(Self {
            head_bytes: fields.u32()?,
            sequence: fields.u64()?,
            columns: fields.u32()?,
            rows: fields.u32()?,
            codec: fields.u32()?,
            stored_bytes: fields.u32()?,
            head_crc: fields.u32()?,
            stored_crc: fields.u32()?,
            image_crc: fields.u32()?,
        })
    }

    /// Bytes of header, head and stored image.
    pub fn record_bytes(&self) -> u64 {
        RECORD_HEADER_BYTES as u64 + u64::from(self.head_bytes) + u64::from(self.stored_bytes)
    }

    /// Whether the record has an image.
    pub fn has_image(&self) -> bool {
        self.codec != 0
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_header_belongs_to_its_segment_and_every_flipped_bit_is_noticed() {
        let header = RecordHeader {
            head_bytes: 17,
            sequence: 1 << 33,
            columns: 2352,
            rows: 1768,
            codec: 2,
            stored_bytes: 5_000_000,
            head_crc: 1,
            stored_crc: 2,
            image_crc: 3,
        };
        let bytes = header.encode(99);
        assert_eq!(RecordHeader::decode(&bytes, 99), Some(header));
        assert_eq!(RecordHeader::decode(&bytes, 98), None);
        assert_eq!(RecordHeader::decode(&bytes[..47], 99), None);
        for bit in 0..8 * bytes.len() {
            let mut damaged = bytes;
            damaged[bit / 8] ^= 1 << (bit % 8);
            assert_eq!(RecordHeader::decode(&damaged, 99), None, "bit {bit}");
        }
    }
}
