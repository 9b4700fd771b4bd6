//! The first bytes of a segment.

use super::{FORMAT_VERSION, fields::Fields};

const MAGIC: [u8; 8] = *b"LFPIVRAW";

/// Bytes before the description.
const FIXED_BYTES: usize = 28;

/// What a segment says about itself before its first record.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(in super::super) struct SegmentHeader {
    /// Number of the segment, from 0.
    pub segment: u32,
    /// Sequence number of its first record.
    pub first_sequence: u64,
    /// Description of the run.
    pub description: Vec<u8>,
}

/// Why bytes are no header that this program can use.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(in super::super) enum HeaderFault {
    /// Fewer bytes than the header has.
    Incomplete,
    /// Another file, or damaged.
    Damaged,
    /// Written by a newer program, in this version of the format.
    NewerVersion(u32),
}

impl SegmentHeader {
    /// All bytes of the header and the segment's salt.
    pub fn encode(&self) -> (Vec<u8>, u32) {
        let mut bytes = Vec::with_capacity(FIXED_BYTES + self.description.len() + 4);
        bytes.extend(MAGIC);
        bytes.extend(FORMAT_VERSION.to_le_bytes());
        bytes.extend(self.segment.to_le_bytes());
        bytes.extend(self.first_sequence.to_le_bytes());
        bytes.extend((self.description.len() as u32).to_le_bytes());
        bytes.extend(&self.description);
        let salt = crc32fast::hash(&bytes);
        bytes.extend(salt.to_le_bytes());
        (bytes, salt)
    }

    /// Length of the whole header whose first bytes these are. The version is judged first: a newer
    /// one may have another layout behind it.
    pub fn length(start: &[u8]) -> Result<usize, HeaderFault> {
        let mut fields = Fields(start);
        if fields.array().ok_or(HeaderFault::Incomplete)? != MAGIC {
            return Err(HeaderFault::Damaged);
        }
        let version = fields.u32().ok_or(HeaderFault::Incomplete)?;
        if version > FORMAT_VERSION {
            return Err(HeaderFault::NewerVersion(version));
        }
        let length = fields.bytes(12).and_then(|_| fields.u32());
        Ok(FIXED_BYTES + length.ok_or(HeaderFault::Incomplete)? as usize + 4)
    }

    /// The header at the start of `bytes` and the segment's salt.
    pub fn decode(bytes: &[u8]) -> Result<(Self, u32), HeaderFault> {
        let length = Self::length(bytes)?;
        let bytes = bytes.get(..length).ok_or(HeaderFault::Incomplete)?;
        let (content, stored_crc) = bytes.split_at(length - 4);
        let salt = crc32fast::hash(content);
        if salt.to_le_bytes() != stored_crc {
            return Err(HeaderFault::Damaged);
        }
        let mut fields = Fields(&content[12..]);
        let mut header = || {
            let (segment, first_sequence) = (fields.u32()?, fields.u64()?);
            let description_bytes = fields.u32()? as usize;
            let description = fields.bytes(description_bytes)?.to_vec();
            Some(Self { segment, first_sequence, description })
        };
        Ok((header().ok_or(HeaderFault::Damaged)?, salt))
    }
}

impl SegmentHeader {
    /// Enough bytes from a segment's start to know its header's length.
    pub const START_BYTES: usize = FIXED_BYTES;
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_header_is_read_as_written_and_every_flipped_bit_is_noticed() {
        let header =
            SegmentHeader { segment: 3, first_sequence: 1 << 40, description: b"{}".to_vec() };
        let (bytes, salt) = header.encode();
        assert_eq!(SegmentHeader::length(&bytes[..SegmentHeader::START_BYTES]), Ok(bytes.len()));
        assert_eq!(SegmentHeader::decode(&bytes), Ok((header, salt)));
        for bit in 0..8 * bytes.len() {
            let mut damaged = bytes.clone();
            damaged[bit / 8] ^= 1 << (bit % 8);
            assert!(SegmentHeader::decode(&damaged).is_err(), "bit {bit}");
        }
        for length in 0..bytes.len() {
            assert_eq!(SegmentHeader::decode(&bytes[..length]), Err(HeaderFault::Incomplete));
        }
    }

    #[test]
    fn a_newer_version_is_called_that_before_anything_else_is_judged() {
        let header = SegmentHeader { segment: 0, first_sequence: 0, description: Vec::new() };
        let (mut bytes, _) = header.encode();
        bytes[8..12].copy_from_slice(&2_u32.to_le_bytes());
        assert_eq!(SegmentHeader::decode(&bytes), Err(HeaderFault::NewerVersion(2)));
    }
}
