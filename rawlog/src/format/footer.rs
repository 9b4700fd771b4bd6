//! The footer of a sealed segment.

use super::{fields::Fields, salted_crc};

/// Magic number of a footer.
pub(in super::super) const FOOTER_MAGIC: [u8; 4] = *b"LFEN";

const FOOTER_BYTES: usize = 36;
const FOOTER_BYTES_V1: usize = 32;

/// Size and checksum of a sealed segment.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(in super::super) struct Footer {
    /// Number of the segment.
    pub segment: u32,
    /// Number of its records, including unreadable ones.
    pub records: u64,
    /// Bytes before the footer.
    pub length: u64,
    /// CRC over all record headers, in order.
    pub headers_crc: u32,
    /// Whether another segment follows.
    pub ending: Ending,
}

/// Whether another segment follows.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(in super::super) enum Ending {
    /// Not stored by version 1.
    Unknown,
    /// The next segment follows. It existed before this one got its final name.
    Continues,
    /// Last segment of a log that was closed.
    Closed,
    /// Last segment of a log that was not closed; sealed by recovery.
    CutOff,
}

impl Ending {
    fn number(self) -> u32 {
        match self {
            Self::Unknown => 0,
            Self::Continues => 1,
            Self::Closed => 2,
            Self::CutOff => 3,
        }
    }
}

impl Footer {
    /// Length of a footer in this format version.
    pub fn bytes(version: u32) -> usize {
        if version == 1 { FOOTER_BYTES_V1 } else { FOOTER_BYTES }
    }

    /// Encodes the footer with the segment's salt.
    pub fn encode(&self, version: u32, salt: u32) -> Vec<u8> {
        let mut bytes = self.content(version);
        bytes.extend(salted_crc(salt, &bytes).to_le_bytes());
        bytes
    }

    /// The footer's checksum, by which the next segment identifies this one.
    pub fn digest(&self, version: u32, salt: u32) -> u32 {
        salted_crc(salt, &self.content(version))
    }

    fn content(&self, version: u32) -> Vec<u8> {
        let mut bytes = Vec::with_capacity(FOOTER_BYTES);
        bytes.extend(FOOTER_MAGIC);
        bytes.extend(self.segment.to_le_bytes());
        bytes.extend(self.records.to_le_bytes());
        bytes.extend(self.length.to_le_bytes());
        bytes.extend(self.headers_crc.to_le_bytes());
        if version > 1 {
            bytes.extend(self.ending.number().to_le_bytes());
        }
        bytes
    }

    /// Decodes the footer at the start of `bytes`, if there is one.
    pub fn decode(bytes: &[u8], version: u32, salt: u32) -> Option<Self> {
        let (content, stored_crc) = bytes.get(..Self::bytes(version))?.split_last_chunk()?;
        let mut fields = Fields(content);
        if fields.array()? != FOOTER_MAGIC || salted_crc(salt, content).to_le_bytes() != *stored_crc
        {
            return None;
        }
        Some(Self {
            segment: fields.u32()?,
            records: fields.u64()?,
            length: fields.u64()?,
            headers_crc: fields.u32()?,
            ending: match fields.u32() {
                Some(1) => Ending::Continues,
                Some(2) => Ending::Closed,
                Some(3) => Ending::CutOff,
                _ => Ending::Unknown,
            },
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_footer_belongs_to_its_segment_and_every_flipped_bit_is_noticed() {
        for (version, ending) in
            [(1, Ending::Unknown), (2, Ending::Continues), (2, Ending::Closed), (2, Ending::CutOff)]
        {
            let footer =
                Footer { segment: 7, records: 11, length: 1 << 35, headers_crc: 5, ending };
            let bytes = footer.encode(version, 3);
            assert_eq!(bytes.len(), Footer::bytes(version));
            assert_eq!(bytes[bytes.len() - 4..], footer.digest(version, 3).to_le_bytes());
            assert_eq!(Footer::decode(&bytes, version, 3), Some(footer));
            assert_eq!(Footer::decode(&bytes, version, 4), None);
            for bit in 0..8 * bytes.len() {
                let mut damaged = bytes.clone();
                damaged[bit / 8] ^= 1 << (bit % 8);
                assert_eq!(Footer::decode(&damaged, version, 3), None, "bit {bit}");
            }
        }
    }
}
