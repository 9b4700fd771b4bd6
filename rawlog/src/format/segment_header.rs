//! The header of a segment.

use super::{FORMAT_VERSION, fields::Fields};

/// Magic number of a segment.
pub(in super::super) const SEGMENT_MAGIC: [u8; 8] = *b"LFPIVRAW";

/// Bytes before the description.
const FIXED_BYTES: usize = 48;
const FIXED_BYTES_V1: usize = 28;

/// Longest header: a bound for the search in a damaged file.
pub(in super::super) const MAX_HEADER_BYTES: usize = 1 << 26;

/// The header of a segment.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(in super::super) struct SegmentHeader {
    /// Version of the format.
    pub version: u32,
    /// Creation time of the log, UTC in ns. It tells logs with the same description apart. 0 in
    /// version 1.
    pub created_ns: u64,
    /// Number of the segment, from 0.
    pub segment: u32,
    /// The previous segment; `None` in the first segment and in version 1.
    pub predecessor: Predecessor,
    /// Sequence number of its first record.
    pub first_sequence: u64,
    /// Description of the run.
    pub description: Vec<u8>,
}

/// What a segment stores about the previous one.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq)]
pub(in super::super) struct Predecessor {
    /// Number of its records.
    pub records: u64,
    /// The checksum of its footer, which covers all record checksums.
    pub digest: u32,
}

/// Why bytes are not a usable header.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(in super::super) enum HeaderFault {
    /// The header is cut off and no record follows: the program died while creating the segment.
    Incomplete,
    /// Damaged, or another kind of file.
    Damaged,
    /// Written by a newer program, in this format version.
    NewerVersion(u32),
}

/// An intact header.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(in super::super) struct DecodedHeader {
    pub header: SegmentHeader,
    /// The checksum, to which the segment's records are bound.
    pub salt: u32,
    /// Length of one copy in bytes.
    pub length: usize,
}

impl SegmentHeader {
    /// Bytes from which the length of any header can be read.
    pub const START_BYTES: usize = FIXED_BYTES_V1;

    /// Encodes one copy of the header; returns it with the segment's salt.
    pub fn encode(&self) -> (Vec<u8>, u32) {
        let length = FIXED_BYTES + self.description.len() + 4;
        let mut bytes = Vec::with_capacity(length);
        bytes.extend(SEGMENT_MAGIC);
        bytes.extend(self.version.to_le_bytes());
        bytes.extend((length as u32).to_le_bytes());
        bytes.extend(self.created_ns.to_le_bytes());
        bytes.extend(self.segment.to_le_bytes());
        bytes.extend(self.predecessor.digest.to_le_bytes());
        bytes.extend(self.predecessor.records.to_le_bytes());
        bytes.extend(self.first_sequence.to_le_bytes());
        bytes.extend(&self.description);
        let salt = crc32fast::hash(&bytes);
        bytes.extend(salt.to_le_bytes());
        (bytes, salt)
    }

    /// Number of bytes needed to decode the header that begins like this, in any version.
    pub fn needed_bytes(start: &[u8]) -> usize {
        let number = |at: usize| Some(Fields(start.get(at..)?).u32()? as usize);
        let since_v2 = number(12).unwrap_or_default();
        let v1 = number(24).map_or(0, |length| FIXED_BYTES_V1.saturating_add(length) + 4);
        let allowed = |length: usize| if length <= MAX_HEADER_BYTES { length } else { 0 };
        allowed(since_v2).max(allowed(v1)).max(start.len())
    }

    /// Decodes the header at the start of `bytes`. The checksum is checked before the version, so that
    /// a flipped bit is not taken for a newer program.
    pub fn decode(bytes: &[u8]) -> Result<DecodedHeader, HeaderFault> {
        if !bytes.starts_with(&SEGMENT_MAGIC) {
            return Err(HeaderFault::Damaged);
        }
        match since_v2(bytes) {
            Some((FORMAT_VERSION, content, salt)) => {
                let header = decode_v2(content).ok_or(HeaderFault::Damaged)?;
                Ok(DecodedHeader { header, salt, length: content.len() + 4 })
            }
            Some((newer, ..)) if newer > FORMAT_VERSION => Err(HeaderFault::NewerVersion(newer)),
            _ => decode_v1(bytes).ok_or(HeaderFault::Damaged),
        }
    }

    /// Number of copies of the header before the first record.
    pub fn copies(&self) -> usize {
        if self.version == 1 { 1 } else { 2 }
    }
}

/// Version, checked bytes and checksum of a header of version 2 or later. All of these store their
/// length at the same place and end in their checksum.
fn since_v2(bytes: &[u8]) -> Option<(u32, &[u8], u32)> {
    let mut fields = Fields(bytes.get(SEGMENT_MAGIC.len()..)?);
    let (version, length) = (fields.u32()?, fields.u32()? as usize);
    let (content, stored_crc) = bytes.get(..length)?.split_last_chunk()?;
    let salt = crc32fast::hash(content);
    (version >= 2 && salt.to_le_bytes() == *stored_crc).then_some((version, content, salt))
}

fn decode_v2(content: &[u8]) -> Option<SegmentHeader> {
    let mut fields = Fields(content.get(16..)?);
    let (created_ns, segment) = (fields.u64()?, fields.u32()?);
    let digest = fields.u32()?;
    let predecessor = Predecessor { records: fields.u64()?, digest };
    let first_sequence = fields.u64()?;
    let description = fields.0.to_vec();
    Some(SegmentHeader {
        version: 2,
        created_ns,
        segment,
        predecessor,
        first_sequence,
        description,
    })
}

fn decode_v1(bytes: &[u8]) -> Option<DecodedHeader> {
    let mut fields = Fields(bytes.get(SEGMENT_MAGIC.len()..)?);
    let version = fields.u32()?;
    let (segment, first_sequence) = (fields.u32()?, fields.u64()?);
    let description_bytes = fields.u32()? as usize;
    let description = fields.bytes(description_bytes)?.to_vec();
    let stored = fields.u32()?;
    let length = FIXED_BYTES_V1 + description_bytes + 4;
    let salt = crc32fast::hash(&bytes[..length - 4]);
    let predecessor = Predecessor::default();
    let header =
        SegmentHeader { version, created_ns: 0, segment, predecessor, first_sequence, description };
    (version == 1 && salt == stored).then_some(DecodedHeader { header, salt, length })
}

#[cfg(test)]
mod tests {
    use super::*;

    fn header() -> SegmentHeader {
        SegmentHeader {
            version: FORMAT_VERSION,
            created_ns: 1 << 60,
            segment: 3,
            predecessor: Predecessor { records: 17, digest: 5 },
            first_sequence: 1 << 40,
            description: b"{}".to_vec(),
        }
    }

    #[test]
    fn a_header_is_read_as_written_and_every_flipped_bit_is_noticed() {
        let (bytes, salt) = header().encode();
        let start = &bytes[..SegmentHeader::START_BYTES];
        assert!(SegmentHeader::needed_bytes(start) >= bytes.len());
        let decoded = DecodedHeader { header: header(), salt, length: bytes.len() };
        assert_eq!(SegmentHeader::decode(&bytes), Ok(decoded));
        for bit in 0..8 * bytes.len() {
            let mut damaged = bytes.clone();
            damaged[bit / 8] ^= 1 << (bit % 8);
            assert_eq!(SegmentHeader::decode(&damaged), Err(HeaderFault::Damaged), "bit {bit}");
        }
        for length in 0..bytes.len() {
            assert_eq!(SegmentHeader::decode(&bytes[..length]), Err(HeaderFault::Damaged));
        }
    }

    #[test]
    fn a_newer_version_is_one_only_with_the_right_checksum() {
        let (mut bytes, _) = header().encode();
        bytes[8..12].copy_from_slice(&9_u32.to_le_bytes());
        assert_eq!(SegmentHeader::decode(&bytes), Err(HeaderFault::Damaged));
        let end = bytes.len() - 4;
        let salt = crc32fast::hash(&bytes[..end]);
        bytes[end..].copy_from_slice(&salt.to_le_bytes());
        assert_eq!(SegmentHeader::decode(&bytes), Err(HeaderFault::NewerVersion(9)));
    }

    #[test]
    fn a_header_of_version_1_is_read() {
        let mut bytes = SEGMENT_MAGIC.to_vec();
        bytes.extend([1_u32, 3].map(u32::to_le_bytes).concat());
        bytes.extend(7_u64.to_le_bytes());
        bytes.extend(2_u32.to_le_bytes());
        bytes.extend(b"{}");
        bytes.extend(crc32fast::hash(&bytes).to_le_bytes());
        let decoded = SegmentHeader::decode(&bytes).unwrap();
        assert_eq!(decoded.length, bytes.len());
        let SegmentHeader { version, segment, first_sequence, description, .. } = decoded.header;
        assert_eq!((version, segment, first_sequence, &description[..]), (1, 3, 7, &b"{}"[..]));
    }
}
