//! Random streams that depend on their key, never on time or thread.

use rand::SeedableRng;
use rand_pcg::Pcg64Mcg;

/// Purpose of a stream: equal keys for different purposes give different streams.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Purpose {
    Seeding = 1,
    Rays = 2,
    Sensor = 3,
    Box = 4,
    Diffraction = 5,
    CameraFaults = 6,
    LineFaults = 7,
    FrameLight = 8,
    CameraLight = 9,
    Dust = 10,
    DeadMicrolenses = 11,
    White = 12,
    Turbulence = 13,
    Card = 14,
    RoundJet = 15,
    PlanarSeeding = 16,
}

/// An independent generator for every (purpose, key).
pub(crate) fn random_stream(purpose: Purpose, key: &[u64]) -> Pcg64Mcg {
    let start = mix(purpose as u64);
    Pcg64Mcg::seed_from_u64(key.iter().fold(start, |state, word| mix(state ^ mix(*word))))
}

/// Output function of SplitMix64 (Steele, Lea and Flood 2014): a bijection in which every input bit
/// affects every output bit.
fn mix(word: u64) -> u64 {
    let word = word.wrapping_add(0x9e37_79b9_7f4a_7c15);
    let word = (word ^ (word >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
    let word = (word ^ (word >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
    word ^ (word >> 31)
}

#[cfg(test)]
mod tests {
    use std::collections::HashSet;

    use rand::Rng;

    use super::*;

    #[test]
    fn neighbouring_keys_give_unrelated_streams() {
        let mut firsts = HashSet::new();
        for a in 0..100 {
            for b in 0..100 {
                firsts.insert(random_stream(Purpose::Rays, &[a, b]).next_u64());
            }
        }
        assert_eq!(firsts.len(), 10_000);
        let other = random_stream(Purpose::Sensor, &[0, 0]).next_u64();
        assert!(!firsts.contains(&other));
        assert!(firsts.contains(&random_stream(Purpose::Rays, &[0, 0]).next_u64()));
    }
}
