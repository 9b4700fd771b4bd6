//! The field that particles follow which were placed in the images.
//!
//! Their places are known to some thousandths of a voxel and their errors are their own, so the field may be
//! as fine as they are close, and what they leave open is known from those that are left out
//! (`spline_field`). Where there are too few of them the field is that of the windows.

use super::{
    DisplacementField, Interrogation, VectorStatus, VelocityField,
    judge::{Vector, field_of},
    spline_field::{self, Extent, Guess, Sample, SplineField},
};
use crate::{
    particles::Neighbours,
    statistics::{NORMAL_OF_MEDIAN, median},
};

/// What the field by correlation may be off, in voxels.
const FIRST_ERROR_VOX: f32 = 0.3;

/// Fewer particles do not correct it.
const LEAST_CORRECTING: usize = 50;

/// What the field that particles corrected may be off, in voxels.
const CORRECTED_ERROR_VOX: f32 = 0.05;

/// Nodes along a window, where particles are so far apart that there would be fewer. Windows do not show waves
/// that are shorter than they are, and cubic B-splines need some three nodes for one.
const NODES_PER_WINDOW: f32 = 3.0;

/// A sphere about a vector holds so many particles on average.
const PARTICLES_ABOUT: f32 = 20.0;

/// Particles about a vector that are enough to accept it,
const LEAST_PARTICLES: usize = 6;

/// if the median of what they are missed by when left out is smaller, in voxels: those that were paired by
/// chance within half a voxel have a median of 0.17.
const LARGEST_MISSED_VOX: f64 = 0.12;

/// A particle agrees with those about it if they miss its displacement by no more standard deviations.
const AGREE_DEVIATIONS: f32 = 4.0;

/// The displacement in the volume while particles are placed, in voxels of [`Interrogation::cloud_grid`].
pub struct CorrectedField<'a> {
    extent: Extent,
    by_correlation: &'a DisplacementField,
    /// What particles say that it misses.
    correction: Option<SplineField>,
}

impl CorrectedField<'_> {
    /// The displacement of the particle that is here in the middle of the pair.
    pub fn at(&self, at_vox: [f32; 3]) -> [f32; 3] {
        let known = self.by_correlation.at(at_vox);
        let missed = self.missed(at_vox);
        std::array::from_fn(|c| known[c] + missed[c])
    }

    /// Corrects it by displacements of particles, near their places in the middle of the pair.
    pub fn correct(&mut self, moved: impl Iterator<Item = Sample>) {
        let left_by_correlation = |mut sample: Sample| {
            let known = self.by_correlation.at(sample.middle_vox);
            sample
                .displacement_vox
                .iter_mut()
                .zip(known)
                .for_each(|(moved, known)| *moved -= known);
            sample
        };
        let missed: Vec<Sample> = moved.map(left_by_correlation).collect();
        if missed.len() >= LEAST_CORRECTING {
            let stiffness = self.correction.as_ref().map(|field| field.stiffness);
            let at = |at_vox| self.missed(at_vox);
            let guess = Guess { at: &at, error_vox: FIRST_ERROR_VOX, stiffness };
            self.correction = Some(spline_field::near(&self.extent, &missed, &guess));
        }
    }

    fn missed(&self, at_vox: [f32; 3]) -> [f32; 3] {
        self.correction.as_ref().map_or([0.0; 3], |correction| correction.value(at_vox))
    }
}

impl Interrogation {
    /// A field that particles will correct.
    pub fn to_correct<'a>(&self, by_correlation: &'a DisplacementField) -> CorrectedField<'a> {
        let corners_vox = [[-0.5; 3], self.cloud_grid().voxels.map(|count| count as f32 - 0.5)];
        let [_, window_vox] = self.windows_vox();
        let coarsest_vox = window_vox as f32 / NODES_PER_WINDOW;
        CorrectedField {
            extent: Extent { corners_vox, coarsest_vox },
            by_correlation,
            correction: None,
        }
    }

    /// The field through placed particles, `samples` in voxels of [`Self::cloud_grid`], near `known`; it takes the
    /// place of the vectors `before` where there are enough of them. And whether each particle agrees with those
    /// about it.
    pub fn through_placed(
        &self,
        before: &VelocityField,
        known: &CorrectedField<'_>,
        samples: &[Sample],
    ) -> (VelocityField, Vec<bool>) {
        let grid = self.cloud_grid();
        let at = |at_vox| known.at(at_vox);
        let error_vox =
            if known.correction.is_some() { CORRECTED_ERROR_VOX } else { FIRST_ERROR_VOX };
        let guess = Guess { at: &at, error_vox, stiffness: None };
        let incompressible = self.settings().incompressible;
        let (field, missed) = spline_field::through(&known.extent, samples, &guess, incompressible);
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
        let agrees = agreeing(samples, &missed, |at_vox| field.uncertainty_vox(at_vox));
        let field =
            field_of(before.grid.clone(), &grid, before.dt_s, (&vectors, &before.peak_ratio), flow);
        (field, agrees)
    }
}

/// Whether each sample is what the others predict, within their typical error, the field's own there, and the
/// sample's.
fn agreeing(
    samples: &[Sample],
    missed: &[[f32; 3]],
    field_vox: impl Fn([f32; 3]) -> [f32; 3],
) -> Vec<bool> {
    let typical: [f32; 3] = std::array::from_fn(|c| {
        let all = missed.iter().map(|missed| f64::from(missed[c].abs()));
        (NORMAL_OF_MEDIAN * median(all).unwrap_or_default()) as f32
    });
    let agrees = |(sample, missed): (&Sample, &[f32; 3])| {
        let field = field_vox(sample.middle_vox);
        (0..3).all(|c| {
            let variance = sample.variance_vox2[c] + typical[c].powi(2) + field[c].powi(2);
            missed[c] * missed[c] <= AGREE_DEVIATIONS * AGREE_DEVIATIONS * variance
        })
    };
    samples.iter().zip(missed).map(agrees).collect()
}
