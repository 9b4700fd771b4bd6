//! Damage to images.

use lfpiv_hw::{
    RawImage,
    device::{Frame, FrameStatus},
};
use rand::{Rng, RngExt};

use super::FrameFault;

/// The frame with a damaged image; unchanged if `fault` damages no image.
pub(super) fn damaged(
    frame: Frame,
    fault: Option<FrameFault>,
    corrupted_bits: u64,
    rng: &mut impl Rng,
) -> Frame {
    let (columns, rows) = (frame.image.columns(), frame.image.rows());
    let mut counts = frame.image.counts().to_vec();
    let (rows, status) = match fault {
        Some(FrameFault::Truncated) => {
            let whole_rows = rng.random_range(0..rows.max(1));
            counts[whole_rows * columns..].fill(0);
            (rows, FrameStatus::MissingPackets)
        }
        Some(FrameFault::Cropped) => {
            let rows = rng.random_range(0..rows.max(1));
            counts.truncate(rows * columns);
            (rows, frame.status)
        }
        Some(FrameFault::Corrupted) if !counts.is_empty() => {
            flip_bits(&mut counts, corrupted_bits, rng);
            (rows, frame.status)
        }
        _ => return frame,
    };
    match RawImage::new(columns, rows, counts) {
        Ok(image) => Frame { image, status, ..frame },
        // Unreachable: whole rows were zeroed or cut off.
        Err(_) => frame,
    }
}

/// Flips this many different bits among those that the brightest pixel uses.
fn flip_bits(counts: &mut [u16], bits: u64, rng: &mut impl Rng) {
    let brightest = counts.iter().copied().max().unwrap_or_default();
    let depth = (u16::BITS - brightest.leading_zeros()).max(1) as usize;
    let bits = usize::try_from(bits).unwrap_or(usize::MAX).min(counts.len() * depth);
    for place in rand::seq::index::sample(rng, counts.len() * depth, bits) {
        counts[place / depth] ^= 1 << (place % depth);
    }
}
