//! The last bytes of a sealed segment.

use super::{fields::Fields, salted_crc};

/// How a footer begins.
pub(in super::super) const FOOTER_MAGIC: [u8; 4] = *b"LFEN";

const FOOTER_BYTES: usize = 36;
const FOOTER_BYTES_V1: usize = 32;

/// What a segment must hold to be whole.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(in super::super) struct Footer {
    /// Number of the segment.
    pub segment: u32,
    /// Number of its records, those that cannot be read any more included.
    pub records: u64,
    /// Bytes before the footer.
    pub length: u64,
    /// CRC of all record headers, in order.
    pub headers_crc: u32,
    /// What comes behind the segment.
    pub ending: Ending,
}

/// What comes behind a segment.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(in super::super) enum Ending {
    /// Version 1 does not say.
    Unknown,
    /// The log goes on in the next segment, which existed before this one got its final name.
    GoesOn,
    /// The log ends here as it should.
    Closed,
    /// The log ends here because it was cut off: recovery has sealed the segment.
    CutOff,
}

impl Ending {
    fn number(self) -> u32 {
        match self {
            Self::Unknown => 0,
            Self::GoesOn => 1,
            Self::Closed => 2,
            Self::CutOff => 3,
        }
    }
}

impl Footer {
    /// Length of a footer in this version of the format.
    pub fn bytes(version: u32) -> usize {
        if version == 1 { FOOTER_BYTES_V1 } else { FOOTER_BYTES }
    }

    /// The footer's bytes in the segment with this salt.
    pub fn encode(&self, version: u32, salt: u32) -> Vec<u8> {
        let mut bytes = self.content(version);
        bytes.extend(salted_crc(salt, &bytes).to_le_bytes());
        bytes
    }

    /// The footer's checksum: what the next segment knows this one by.
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

    /// The footer at the start of `bytes`, if there is one.
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
                Some(1) => Ending::GoesOn,
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
            [(1, Ending::Unknown), (2, Ending::GoesOn), (2, Ending::Closed), (2, Ending::CutOff)]
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
