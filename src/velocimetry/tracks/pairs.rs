//! Particles of one frame told in the other.

use rayon::prelude::*;

use super::{neighbours::Neighbours, spline::Spline};

/// A particle may be so far from where the field expects it, in voxels: some standard deviations of a
/// reconstructed particle's place, and less than the distance to its neighbours.
pub const PAIR_REACH_VOX: f32 = 0.7;

/// A particle seen in both frames.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Pair {
    /// Where it is in the middle of the pair, in voxels.
    pub middle_vox: [f32; 3],
    /// From frame a to frame b, in voxels.
    pub displacement_vox: [f32; 3],
}

/// The particles of frames a and b that are each other's nearest once both frames are moved to the
/// middle of the pair along `field`; in the order of frame a.
pub fn pairs(field: &Spline, [a, b]: [&[[f32; 3]]; 2]) -> Vec<Pair> {
    let moved = |particles: &[[f32; 3]], sign: f32| -> Vec<[f32; 3]> {
        particles.par_iter().map(|&at| field.middle_of_path(at, sign)).collect()
    };
    let (middle_a, middle_b) = (moved(a, 1.0), moved(b, -1.0));
    let (near_a, near_b) =
        (Neighbours::new(&middle_a, PAIR_REACH_VOX), Neighbours::new(&middle_b, PAIR_REACH_VOX));
    (0..a.len())
        .into_par_iter()
        .filter_map(|n| {
            let other = near_b.nearest(middle_a[n])?;
            let mutual = near_a.nearest(middle_b[other]) == Some(n);
            let middle = |axis: usize| (middle_a[n][axis] + middle_b[other][axis]) / 2.0;
            let pair = Pair {
                middle_vox: std::array::from_fn(middle),
                displacement_vox: std::array::from_fn(|axis| b[other][axis] - a[n][axis]),
            };
            (mutual && field.contains(pair.middle_vox)).then_some(pair)
        })
        .collect()
}
