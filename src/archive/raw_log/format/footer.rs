//! The last bytes of a sealed segment.

use super::{fields::Fields, salted_crc};

const MAGIC: [u8; 4] = *b"LFEN";

/// Length of a footer.
pub(in super::super) const FOOTER_BYTES: usize = 32;

/// What a segment must hold to be whole.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(in super::super) struct Footer {
    /// Number of the segment.
    pub segment: u32,
    /// Number of its records.
    pub records: u64,
    /// Bytes before the footer.
    pub length: u64,
    /// CRC of all record headers, in order.
    pub headers_crc: u32,
}

impl Footer {
    /// The footer's bytes in the segment with this salt.
    pub fn encode(&self, salt: u32) -> Vec<u8> {
        let mut bytes = Vec::with_capacity(FOOTER_BYTES);
        bytes.extend(MAGIC);
        bytes.extend(self.segment.to_le_bytes());
        bytes.extend(self.records.to_le_bytes());
        bytes.extend(self.length.to_le_bytes());
        bytes.extend(self.headers_crc.to_le_bytes());
        bytes.extend(salted_crc(salt, &bytes).to_le_bytes());
        bytes
    }

    /// The footer at the start of `bytes`, if there is one.
    pub fn decode(bytes: &[u8], salt: u32) -> Option<Self> {
        let (content, stored_crc) = bytes.get(..FOOTER_BYTES)?.split_at(FOOTER_BYTES - 4);
        let mut fields = Fields(content);
        if fields.array()? != MAGIC || salted_crc(salt, content).to_le_bytes() != stored_crc {
            return None;
        }
        Some(Self {
            segment: fields.u32()?,
            records: fields.u64()?,
            length: fields.u64()?,
            headers_crc: fields.u32()?,
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_footer_belongs_to_its_segment_and_every_flipped_bit_is_noticed() {
        let footer = Footer { segment: 7, records: 11, length: 1 << 35, headers_crc: 5 };
        let bytes = footer.encode(3);
        assert_eq!(bytes.len(), FOOTER_BYTES);
        assert_eq!(Footer::decode(&bytes, 3), Some(footer));
        assert_eq!(Footer::decode(&bytes, 4), None);
        for bit in 0..8 * bytes.len() {
            let mut damaged = bytes.clone();
            damaged[bit / 8] ^= 1 << (bit % 8);
            assert_eq!(Footer::decode(&damaged, 3), None, "bit {bit}");
        }
    }
}
