use lfpiv_hw::RawImage;
use proptest::{collection::vec, prelude::*};

use super::{Codec, Encoder, decode};

const CODECS: [Codec; 4] = [Codec::Raw, Codec::Packed, Codec::Zstd, Codec::Auto];

fn image(columns: usize, counts: Vec<u16>) -> RawImage {
    RawImage::new(columns, counts.len() / columns, counts).unwrap()
}

fn stored(codec: Codec, image: &RawImage) -> (u32, Vec<u8>) {
    let mut stored = vec![0xAA; 5];
    let number = Encoder::new(codec).unwrap().encode(image, &mut stored).unwrap();
    (number, stored.split_off(5))
}

fn decoded(codec: u32, stored: &[u8], like: &RawImage) -> Option<RawImage> {
    decode(stored, codec, like.columns() as u32, like.rows() as u32)
}

/// Counts with all widths of differences and all magnitudes.
fn counts() -> impl Strategy<Value = Vec<u16>> {
    (0..=16_u32, any::<u16>(), 0..700_usize).prop_flat_map(|(width, base, length)| {
        let most = ((1_u32 << width) - 1) as u16;
        let base = base.min(u16::MAX - most);
        vec(base..=base + most, length)
    })
}

proptest! {
    #![proptest_config(ProptestConfig { rng_seed: prop::test_runner::RngSeed::Fixed(41), ..ProptestConfig::with_cases(400) })]

    #[test]
    fn every_codec_is_lossless_and_never_enlarges_an_image(counts in counts()) {
        let image = image(1, counts);
        for codec in CODECS {
            let (number, stored) = stored(codec, &image);
            prop_assert!(stored.len() <= 2 * image.counts().len());
            prop_assert_eq!(decoded(number, &stored, &image).unwrap(), image.clone());
        }
    }

    #[test]
    fn any_bytes_are_decoded_to_something_or_nothing(
        bytes in vec(any::<u8>(), 0..600), codec in 0..6_u32, columns in 0..40_u32, rows in 0..40_u32
    ) {
        if let Some(image) = decode(&bytes, codec, columns, rows) {
            prop_assert_eq!(image.counts().len() as u32, columns * rows);
        }
    }
}

#[test]
fn twelve_bits_take_twelve_and_eight_take_eight() {
    let ramp =
        |bits: u32| image(256, (0..65_536_u32).map(|n| (n * 7919 % (1 << bits)) as u16).collect());
    for (bits, share) in [(12, 0.77), (10, 0.64), (8, 0.52), (1, 0.08)] {
        let image = ramp(bits);
        let (_, stored) = stored(Codec::Packed, &image);
        let measured = stored.len() as f64 / (2.0 * 65_536.0);
        assert!(measured <= share, "{bits} bit: {measured}");
    }
}

#[test]
fn a_size_that_cannot_be_costs_no_memory() {
    let huge = (1 << 14, 1 << 14);
    for codec in 0..6 {
        for bytes in [&[][..], &[0; 3], &[0x28, 0xB5, 0x2F, 0xFD, 0, 0, 0, 0]] {
            assert!(decode(bytes, codec, huge.0, huge.1).is_none());
            assert!(decode(bytes, codec, u32::MAX, u32::MAX).is_none());
        }
    }
}

#[test]
fn stored_bytes_are_cut_or_too_long_and_that_is_noticed() {
    let image = image(20, (0..400).map(|n| n * 3 % 97).collect());
    for codec in CODECS {
        let (number, stored) = stored(codec, &image);
        for length in 0..stored.len() {
            assert!(decoded(number, &stored[..length], &image).is_none(), "{codec:?} {length}");
        }
        if codec != Codec::Zstd {
            let longer = [&stored[..], &[0]].concat();
            assert!(decoded(number, &longer, &image).is_none(), "{codec:?}");
        }
    }
}
