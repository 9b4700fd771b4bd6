//! Random signs as right-hand sides, for samples of the field's error.
//!
//! The solution of Σ w (ε/√w − B c)² + Σ λ (ε/√λ − Δ³c)², with independent ε of mean 0 and variance 1, has
//! mean 0 and the covariance of the field's error under the model: the inverse of the equations' matrix
//! (Papandreou and Yuille, Gaussian sampling by local perturbations, NIPS 2010). Signs ±1 suffice
//! for ε, because only the covariance is needed.

use super::lanes::{LANES, Lane};

/// Signs for all lanes except the first, whose field is the result.
#[derive(Debug, Clone, Copy)]
pub struct Noise;

/// First stream of each kind of sign.
const SAMPLES: usize = 0;
const DIFFERENCES: usize = 3;
const DIVERGENCE: usize = 12;
const ANCHORS: usize = 13;

impl Noise {
    /// ε of sample `n` in component `c`.
    pub fn of_sample(self, c: usize, n: usize) -> Lane {
        signs(SAMPLES + c, n)
    }

    /// ε of the third difference along an axis of component `c` that starts at coefficient `n`.
    pub fn of_difference(self, c: usize, axis: usize, n: usize) -> Lane {
        signs(DIFFERENCES + 3 * c + axis, n)
    }

    /// ε of coefficient `n` of component `c` about the field before.
    pub fn of_anchor(self, c: usize, n: usize) -> Lane {
        signs(ANCHORS + c, n)
    }

    /// ε of the divergence in cell `n`.
    pub fn of_divergence(self, n: usize) -> Lane {
        signs(DIVERGENCE, n)
    }
}

/// Lane 0 is 0, the others ±1.
fn signs(kind: usize, n: usize) -> Lane {
    // The output function of SplitMix64 (Steele, Lea and Flood 2014).
    let mut word =
        ((kind as u64) << 40 | n as u64).wrapping_add(1).wrapping_mul(0x9e37_79b9_7f4a_7c15);
    word = (word ^ (word >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
    word = (word ^ (word >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
    word ^= word >> 31;
    let mut signs = [0.0; LANES];
    for (l, sign) in signs.iter_mut().enumerate().skip(1) {
        *sign = if word >> (5 * l) & 1 == 1 { 1.0 } else { -1.0 };
    }
    signs
}
