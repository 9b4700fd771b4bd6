//! Penalty of a field's divergence: its square in the middle of every cell between the nodes.

use multiversion::multiversion;
use rayon::prelude::*;

use super::{
    super::{
        b_spline::{HALFWAY, HALFWAY_SLOPES},
        layout::Layout,
    },
    lanes::{LANES, Lane, Vectors},
    noise::Noise,
};

/// The penalty Σ μ (∇·c)² over half-node points, of a field that has a vector for each component.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Divergence {
    /// Node spacing, in voxels.
    pub step_vox: f32,
    /// μ, in 1/(voxel/voxel)².
    pub stiffness: f32,
}

impl Divergence {
    /// Adds sign · ∇·ᵀ μ (s − ∇·c); `noise` gives s √μ.
    pub fn add_forces(
        &self,
        layout: Layout,
        field: &Vectors,
        noise: Option<&Noise>,
        sign: f32,
        sums: &mut Vectors,
    ) {
        let mut parts: [Vec<Lane>; 3] = Default::default();
        parts.par_iter_mut().enumerate().for_each(|(c, part)| {
            *part = field[c].clone();
            for axis in 0..3 {
                gather(layout.stride(axis), self.weights(c, axis), part);
            }
        });
        let [mut force, y, z] = parts;
        let root = self.stiffness.sqrt();
        for (n, force) in force.iter_mut().enumerate() {
            let target = noise.map_or([0.0; LANES], |noise| noise.of_divergence(n));
            let inside = (0..3).all(|axis| layout.starts(axis, n));
            for l in 0..LANES {
                let divergence = force[l] + y[n][l] + z[n][l];
                let asked = sign * (root * target[l] - self.stiffness * divergence);
                force[l] = if inside { asked } else { 0.0 };
            }
        }
        sums.par_iter_mut().enumerate().for_each(|(c, sum)| {
            let mut part = force.clone();
            for axis in 0..3 {
                scatter(layout.stride(axis), self.weights(c, axis), &mut part);
            }
            for (sum, part) in sum.iter_mut().zip(part) {
                for l in 0..LANES {
                    sum[l] += part[l];
                }
            }
        });
    }

    /// Weights along `axis` of component `c`.
    fn weights(&self, c: usize, axis: usize) -> [f32; 4] {
        let weights = if axis == c {
            HALFWAY_SLOPES.map(|slope| slope / f64::from(self.step_vox))
        } else {
            HALFWAY
        };
        weights.map(|weight| weight as f32)
    }
}

/// Each value replaced by the weighted sum of itself and the three after it, `s` apart; what is beyond the end
/// counts as zero.
#[multiversion(targets("x86_64+avx512f+avx512vl", "x86_64+avx2"))]
fn gather(s: usize, weights: [f32; 4], values: &mut [Lane]) {
    for n in 0..values.len() {
        let mut sum = [0.0; LANES];
        for (place, weight) in weights.into_iter().enumerate() {
            if let Some(value) = values.get(n + place * s) {
                for l in 0..LANES {
                    sum[l] += weight * value[l];
                }
            }
        }
        values[n] = sum;
    }
}

/// The transpose of [`gather`].
#[multiversion(targets("x86_64+avx512f+avx512vl", "x86_64+avx2"))]
fn scatter(s: usize, weights: [f32; 4], values: &mut [Lane]) {
    for n in (0..values.len()).rev() {
        let mut sum = [0.0; LANES];
        for (place, weight) in weights.into_iter().enumerate() {
            if place * s <= n {
                for l in 0..LANES {
                    sum[l] += weight * values[n - place * s][l];
                }
            }
        }
        values[n] = sum;
    }
}
