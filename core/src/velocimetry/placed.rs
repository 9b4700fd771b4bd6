//! The field that particles follow which were placed in the images.
//!
//! Their places are known to some thousandths of a voxel and their errors are their own, so the field may be
//! as fine as they are close, and what they leave open is known from those that are left out
//! (`spline_field`). Where there are too few of them the field is that of the windows.

use super::{
    DisplacementField, Interrogation, VectorStatus, VelocityField,
    judge::{Vector, field_of},
    spline_field::{self, Sample},
};
use crate::{
    particles::Neighbours,
    statistics::{NORMAL_OF_MEDIAN, median},
};

/// What the field before may be off, in voxels.
const FIRST_ERROR_VOX: f32 = 0.3;

/// A sphere about a vector holds so many particles on average.
const PARTICLES_ABOUT: f32 = 20.0;

/// Particles about a vector that are enough to accept it,
const LEAST_PARTICLES: usize = 6;

/// if the median of what they are missed by when left out is smaller, in voxels: those that were paired by
/// chance within half a voxel have a median of 0.17.
const LARGEST_MISSED_VOX: f64 = 0.12;

/// A particle agrees with those about it if they miss its displacement by no more standard deviations.
const AGREE_DEVIATIONS: f32 = 4.0;

impl Interrogation {
    /// The field through placed particles, `samples` in voxels of [`Self::cloud_grid`], near `everywhere`, whose
    /// vectors are `before`; and whether each particle agrees with those about it.
    pub fn through_placed(
        &self,
        before: &VelocityField,
        everywhere: &DisplacementField,
        samples: &[Sample],
    ) -> (VelocityField, Vec<bool>) {
        let grid = self.cloud_grid();
        let corners = [[-0.5; 3], grid.voxels.map(|count| count as f32 - 0.5)];
        let (field, missed) = spline_field::through(
            corners,
            samples,
            |at_vox| everywhere.at(at_vox),
            FIRST_ERROR_VOX,
            self.settings().incompressible,
        );
        let places: Vec<[f32; 3]> = samples.iter().map(|sample| sample.middle_vox).collect();
        let sphere = 4.0 / 3.0 * std::f32::consts::PI;
        let density = samples.len() as f32 / grid.voxels.iter().product::<usize>() as f32;
        let near = Neighbours::new(&places, (PARTICLES_ABOUT / (sphere * density)).cbrt());
        let is_measured = |at_vox: [f32; 3]| {
            let mut about = Vec::new();
            near.visit(at_vox, |n, _| about.push(n));
            let agree = |c: usize| {
                median(about.iter().map(|&n| f64::from(missed[n][c].abs())))
                    .is_some_and(|missed| missed <= LARGEST_MISSED_VOX)
            };
            about.len() >= LEAST_PARTICLES && (0..3).all(agree)
        };
        let vector = |n: usize| {
            let at_mm = before.grid.position_mm(n);
            let at_vox = std::array::from_fn(|axis| grid.index_of(axis, at_mm[axis]) as f32);
            if before.status[n] != VectorStatus::Masked && is_measured(at_vox) {
                Vector {
                    displacement_vox: field.value(at_vox),
                    uncertainty_vox: field.uncertainty_vox(at_vox),
                    status: VectorStatus::Valid,
                }
            } else {
                Vector {
                    displacement_vox: before.displacement_vox[n],
                    uncertainty_vox: before.uncertainty_vox[n],
                    status: before.status[n],
                }
            }
        };
        let vectors: Vec<Vector> = (0..before.grid.len()).map(vector).collect();
        let flow = self.flow_of_vectors();
        let field =
            field_of(before.grid.clone(), &grid, before.dt_s, (&vectors, &before.peak_ratio), flow);
        (field, agreeing(samples, &missed))
    }
}

/// Whether each sample is what the others predict, within their typical error and its own.
fn agreeing(samples: &[Sample], missed: &[[f32; 3]]) -> Vec<bool> {
    let typical: [f32; 3] = std::array::from_fn(|c| {
        let all = missed.iter().map(|missed| f64::from(missed[c].abs()));
        (NORMAL_OF_MEDIAN * median(all).unwrap_or_default()) as f32
    });
    let agrees = |(sample, missed): (&Sample, &[f32; 3])| {
        (0..3).all(|c| {
            let variance = sample.variance_vox2[c] + typical[c] * typical[c];
            missed[c] * missed[c] <= AGREE_DEVIATIONS * AGREE_DEVIATIONS * variance
        })
    };
    samples.iter().zip(missed).map(agrees).collect()
}
