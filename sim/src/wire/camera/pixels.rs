//! Packs counts into the bytes that a camera sends. Independent of the driver's unpacking, so that each
//! tests the other.

use lfpiv_hw::{RawImage, gige::PixelFormat};

/// The transmitted part of the sensor.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) struct Region {
    pub(super) x: usize,
    pub(super) y: usize,
    pub(super) columns: usize,
    pub(super) rows: usize,
}

/// Writes the region's counts, of `count_bits` significant bits, into `bytes` until it is full.
///
/// A format with fewer bits gets the upper ones: Mono8 of a 12-bit count is the count shifted right by
/// four, as in a camera. A format with more bits gets the count unchanged.
pub(super) fn pack(
    format: PixelFormat,
    image: &RawImage,
    region: Region,
    count_bits: u32,
    bytes: &mut [u8],
) {
    let shift = count_bits.saturating_sub(format.significant_bits());
    let counts = cut_out(image, region, shift);
    match format {
        PixelFormat::Mono8 => {
            for (byte, count) in bytes.iter_mut().zip(counts) {
                *byte = count as u8;
            }
        }
        PixelFormat::Mono12Packed => pack_12(&counts, bytes),
        PixelFormat::Mono10 | PixelFormat::Mono12 | PixelFormat::Mono16 => {
            for (word, count) in bytes.chunks_exact_mut(2).zip(counts) {
                word.copy_from_slice(&count.to_le_bytes());
            }
        }
    }
}

/// The region's counts; dark outside the image.
fn cut_out(image: &RawImage, region: Region, shift: u32) -> Vec<u16> {
    let mut counts = vec![0; region.columns * region.rows];
    let rows = (region.y..image.rows()).zip(counts.chunks_exact_mut(region.columns.max(1)));
    for (row, cut) in rows {
        let seen = image.row(row).get(region.x..).unwrap_or_default();
        for (count, seen) in cut.iter_mut().zip(seen) {
            *count = seen >> shift;
        }
    }
    counts
}

fn pack_12(counts: &[u16], bytes: &mut [u8]) {
    let packed = |first: u16, second: u16| {
        [(first >> 4) as u8, (first & 0xf | (second & 0xf) << 4) as u8, (second >> 4) as u8]
    };
    let mut triples = bytes.chunks_exact_mut(3);
    let mut pairs = counts.chunks_exact(2);
    for (triple, pair) in (&mut triples).zip(&mut pairs) {
        triple.copy_from_slice(&packed(pair[0], pair[1]));
    }
    // Half a pair, for which the fake sends one byte and a driver may expect two.
    if let [last] = pairs.remainder() {
        let rest = triples.into_remainder();
        let length = rest.len();
        rest.copy_from_slice(&packed(*last, 0)[..length]);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn image() -> RawImage {
        let counts = (0..48_u16).map(|n| n * 87 % 4096).collect();
        RawImage::new(8, 6, counts).unwrap()
    }

    #[test]
    fn the_driver_reads_back_what_is_packed() {
        let region = Region { x: 2, y: 1, columns: 5, rows: 4 };
        for format in PixelFormat::ALL {
            let mut bytes = vec![0; format.payload_bytes(20)];
            pack(format, &image(), region, 12, &mut bytes);
            let mut counts = [0; 20];
            format.unpack(&bytes, &mut counts);
            let shift = 12 - format.significant_bits().min(12);
            for (index, count) in counts.into_iter().enumerate() {
                let (row, column) = (1 + index / 5, 2 + index % 5);
                assert_eq!(count, image().row(row)[column] >> shift, "{format:?} {row} {column}");
            }
        }
    }

    #[test]
    fn a_region_beyond_the_image_leaves_the_rest_dark() {
        let region = Region { x: 6, y: 5, columns: 4, rows: 4 };
        let mut bytes = [0; 16];
        pack(PixelFormat::Mono8, &image(), region, 12, &mut bytes);
        assert_eq!(bytes[2..], [0; 14]);
    }
}
