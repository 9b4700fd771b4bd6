//! Matching of particles between the frames.

use rayon::prelude::*;

use super::{particles::LightPeak, spline::Spline};
use crate::particles::Neighbours;

/// Largest search radius about the position that the field predicts, in voxels: about the particle spacing at
/// 1 ppm.
pub const FARTHEST_VOX: f32 = 1.2;

/// A particle seen in both frames.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Pair {
    /// Its position at mid-pair, in voxels.
    pub middle_vox: [f32; 3],
    /// From frame a to frame b, in voxels.
    pub displacement_vox: [f32; 3],
    /// Variance of its light along x, y, z: the mean of both frames.
    pub spread_vox2: [f32; 3],
    /// Its light in the frame where that is less.
    pub light: f32,
}

/// The particles of frames a and b that are each other's nearest once both frames are moved to the
/// middle of the pair along `field`, no further apart than `reach_vox`, which is at most
/// [`FARTHEST_VOX`]; in the order of frame a.
pub fn pairs(field: &Spline, [a, b]: [&[LightPeak]; 2], reach_vox: f32) -> Vec<Pair> {
    let moved = |particles: &[LightPeak], sign: f32| -> Vec<[f32; 3]> {
        particles.par_iter().map(|p| field.middle_of_path(p.at_vox, sign)).collect()
    };
    let (middle_a, middle_b) = (moved(a, 1.0), moved(b, -1.0));
    let near_a = Neighbours::new(&middle_a, FARTHEST_VOX);
    let near_b = Neighbours::new(&middle_b, FARTHEST_VOX);
    (0..a.len())
        .into_par_iter()
        .filter_map(|n| {
            let other = near_b.nearest(middle_a[n], reach_vox)?;
            let mutual = near_a.nearest(middle_b[other], reach_vox) == Some(n);
            let (from, to) = (&a[n], &b[other]);
            let mean = |one: &[f32; 3], two: &[f32; 3]| {
                std::array::from_fn(|axis| (one[axis] + two[axis]) / 2.0)
            };
            let pair = Pair {
                middle_vox: mean(&middle_a[n], &middle_b[other]),
                displacement_vox: std::array::from_fn(|axis| to.at_vox[axis] - from.at_vox[axis]),
                spread_vox2: mean(&from.spread_vox2, &to.spread_vox2),
                light: from.light.min(to.light),
            };
            (mutual && field.contains(pair.middle_vox)).then_some(pair)
        })
        .collect()
}
