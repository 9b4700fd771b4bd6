//! Pixel formats of the cameras and their conversion to counts.
//!
//! Names and layouts are those of GigE Vision's pixel formats (EMVA PFNC): `Mono10`, `Mono12` and
//! `Mono16` are 16-bit little-endian words, `Mono12Packed` puts two pixels into three bytes.

use serde::{Deserialize, Serialize};

/// Pixel format of a camera.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
pub enum PixelFormat {
    /// One byte per pixel.
    Mono8,
    /// 10 significant bits in a word.
    Mono10,
    /// 12 significant bits in a word.
    Mono12,
    /// 12 bits per pixel: the upper eight of the first, the lower four of both, the upper eight of the
    /// second.
    Mono12Packed,
    /// 16 significant bits in a word.
    Mono16,
}

impl PixelFormat {
    /// Every format.
    pub const ALL: [Self; 5] =
        [Self::Mono8, Self::Mono10, Self::Mono12, Self::Mono12Packed, Self::Mono16];

    /// GenICam name.
    pub fn name(self) -> &'static str {
        match self {
            Self::Mono8 => "Mono8",
            Self::Mono10 => "Mono10",
            Self::Mono12 => "Mono12",
            Self::Mono12Packed => "Mono12Packed",
            Self::Mono16 => "Mono16",
        }
    }

    /// PFNC number.
    pub fn code(self) -> u32 {
        match self {
            Self::Mono8 => 0x0108_0001,
            Self::Mono10 => 0x0110_0003,
            Self::Mono12 => 0x0110_0005,
            Self::Mono12Packed => 0x010c_0006,
            Self::Mono16 => 0x0110_0007,
        }
    }

    /// The format with this number, if known.
    pub fn from_code(code: u32) -> Option<Self> {
        Self::ALL.into_iter().find(|format| format.code() == code)
    }

    /// Significant bits of a count.
    pub fn significant_bits(self) -> u32 {
        match self {
            Self::Mono8 => 8,
            Self::Mono10 => 10,
            Self::Mono12 | Self::Mono12Packed => 12,
            Self::Mono16 => 16,
        }
    }

    /// Bytes of `pixels` pixels. An odd number of packed pixels is padded to a whole byte.
    pub fn payload_bytes(self, pixels: usize) -> usize {
        match self {
            Self::Mono8 => pixels,
            Self::Mono12Packed => (pixels * 3).div_ceil(2),
            Self::Mono10 | Self::Mono12 | Self::Mono16 => pixels * 2,
        }
    }

    /// Reads `counts.len()` pixels from `bytes`. If `bytes` is shorter than
    /// [`payload_bytes`](Self::payload_bytes), the remaining counts are unchanged.
    pub fn unpack(self, bytes: &[u8], counts: &mut [u16]) {
        let bytes = bytes.get(..self.payload_bytes(counts.len())).unwrap_or(bytes);
        match self {
            Self::Mono8 => unpack_bytes(bytes, counts),
            Self::Mono12Packed => unpack_12_packed(bytes, counts),
            Self::Mono10 | Self::Mono12 | Self::Mono16 => unpack_words(bytes, counts),
        }
    }
}

fn unpack_bytes(bytes: &[u8], counts: &mut [u16]) {
    for (count, byte) in counts.iter_mut().zip(bytes) {
        *count = u16::from(*byte);
    }
}

fn unpack_words(bytes: &[u8], counts: &mut [u16]) {
    for (count, word) in counts.iter_mut().zip(bytes.chunks_exact(2)) {
        *count = u16::from_le_bytes([word[0], word[1]]);
    }
}

fn unpack_12_packed(bytes: &[u8], counts: &mut [u16]) {
    let mut pairs = counts.chunks_exact_mut(2);
    let mut triples = bytes.chunks_exact(3);
    for (pair, triple) in (&mut pairs).zip(&mut triples) {
        let [high_0, low, high_1] = [triple[0], triple[1], triple[2]].map(u16::from);
        pair[0] = high_0 << 4 | low & 0xf;
        pair[1] = high_1 << 4 | low >> 4;
    }
    if let ([last], [high, low]) = (pairs.into_remainder(), triples.remainder()) {
        *last = u16::from(*high) << 4 | u16::from(*low) & 0xf;
    }
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;

    /// The definition of the format, one pixel at a time.
    fn pixel(format: PixelFormat, bytes: &[u8], index: usize) -> u16 {
        let bit = |at: usize| u16::from(bytes[at / 8] >> (at % 8) & 1);
        let bits = |from: usize, number: usize| {
            (0..number).fold(0, |value, shift| value | bit(from + shift) << shift)
        };
        match format {
            PixelFormat::Mono8 => bits(index * 8, 8),
            PixelFormat::Mono12Packed => {
                let pair = index / 2 * 24;
                let (low, high) = if index.is_multiple_of(2) { (8, 0) } else { (12, 16) };
                bits(pair + low, 4) | bits(pair + high, 8) << 4
            }
            _ => bits(index * 16, 16),
        }
    }

    proptest! {
        #[test]
        fn pixels_are_where_the_definition_says(
            format in proptest::sample::select(PixelFormat::ALL.to_vec()),
            bytes in proptest::collection::vec(any::<u8>(), 0..200),
            fewer in 0..4_usize,
        ) {
            let pixels = (0..=200).rev().find(|n| format.payload_bytes(*n) <= bytes.len()).unwrap();
            let pixels = pixels.saturating_sub(fewer);
            let mut counts = vec![0xaaaa; pixels];
            format.unpack(&bytes, &mut counts);
            let expected: Vec<u16> = (0..pixels).map(|i| pixel(format, &bytes, i)).collect();
            prop_assert_eq!(counts, expected);
        }
    }

    #[test]
    fn two_packed_pixels_written_out() {
        let mut counts = [0; 3];
        PixelFormat::Mono12Packed.unpack(&[0xab, 0x3c, 0x12, 0xff, 0x07], &mut counts);
        assert_eq!(counts, [0xabc, 0x123, 0xff7]);
    }

    #[test]
    fn a_code_names_its_format_and_its_size() {
        for format in PixelFormat::ALL {
            assert_eq!(PixelFormat::from_code(format.code()), Some(format));
            // Bits per pixel are part of the number.
            let bits = (format.code() >> 16 & 0xff) as usize;
            assert_eq!(format.payload_bytes(1000), 1000 * bits / 8);
        }
        assert_eq!(PixelFormat::from_code(0x0218_0014), None);
    }
}
