//! The field fitted to particles whose positions were fitted to the images.
//!
//! Their positions are accurate to some thousandths of a voxel and their errors are independent, so the field
//! is resolved down to the particle spacing, and its uncertainty is estimated by cross-validation
//! (`spline_field`). Where there are too few particles, the field is that of the windows.

use super::{
    DisplacementField, Interrogation, VectorStatus, VelocimetrySettings, VelocityField,
    judge::{Vector, field_of},
    spline_field::{self, Extent, Guess, Sample, SplineField},
};
use crate::{
    model::VolumeGrid,
    particles::Neighbours,
    statistics::{NORMAL_OF_MEDIAN, median},
};

/// Assumed error of the field by correlation, in voxels.
const FIRST_ERROR_VOX: f32 = 0.3;

/// Least number of particles that correct it.
const LEAST_CORRECTING: usize = 50;

/// Assumed error of the corrected field, in voxels.
const CORRECTED_ERROR_VOX: f32 = 0.05;

/// Least number of nodes along a window, also where the particle spacing is large. A window does not respond to
/// waves as long as itself, and cubic B-splines need about three nodes per wavelength.
pub const NODES_PER_WINDOW: f32 = 3.0;

/// Mean number of pairs in the sphere around a vector.
const PAIRS_PER_SPHERE: f32 = 20.0;

/// Least number of pairs in the sphere of an accepted vector.
const LEAST_PAIRS: usize = 6;

/// Least share of particles with a partner in the sphere of an accepted vector. By chance 7 to 15 % have one. The
/// residuals of pairs are not used as a criterion: in a rough flow those of correct pairs are large
/// (docs/decisions.md).
const LEAST_PAIRED_SHARE: f32 = 1.0 / 3.0;

/// Largest cross-validation residual of a particle that agrees with its neighbours, in standard deviations.
const AGREEMENT_SIGMA: f32 = 4.0;

/// The displacement field during the fit of particle positions, in voxels of [`Interrogation::cloud_grid`].
pub struct CorrectedField<'a> {
    extent: Extent,
    by_correlation: &'a DisplacementField,
    /// Its error, estimated from particles.
    correction: Option<SplineField>,
}

impl CorrectedField<'_> {
    /// The displacement of the particle with this mid-pair position.
    pub fn at(&self, at_vox: [f32; 3]) -> [f32; 3] {
        let known = self.by_correlation.at(at_vox);
        let missed = self.missed(at_vox);
        std::array::from_fn(|c| known[c] + missed[c])
    }

    /// Corrects it by displacements of particles at their mid-pair positions.
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
    /// A field to be corrected by particles.
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

    /// The field fitted to `samples`, starting from `known`, and whether each sample agrees with its neighbours. The
    /// field replaces the vectors `before` where there are enough samples and not too many particles without a
    /// partner: `alone` are the positions of those in frames a and b. All in voxels of [`Self::cloud_grid`].
    pub fn through_placed(
        &self,
        before: &VelocityField,
        known: &CorrectedField<'_>,
        samples: &[Sample],
        alone: [&[[f32; 3]]; 2],
    ) -> (VelocityField, Vec<bool>) {
        let grid = self.cloud_grid();
        let at = |at_vox| known.at(at_vox);
        let error_vox =
            if known.correction.is_some() { CORRECTED_ERROR_VOX } else { FIRST_ERROR_VOX };
        let guess = Guess { at: &at, error_vox, stiffness: None };
        let VelocimetrySettings { incompressible, largest_uncertainty_vox, .. } = *self.settings();
        let (field, missed) = spline_field::through(&known.extent, samples, &guess, incompressible);
        let paired: Vec<[f32; 3]> = samples.iter().map(|sample| sample.middle_vox).collect();
        let support = Support::new(&grid, &paired, alone);
        let vector = |n: usize| {
            let at_mm = before.grid.position_mm(n);
            let at_vox = std::array::from_fn(|axis| grid.index_of(axis, at_mm[axis]) as f32);
            let uncertainty_vox = field.uncertainty_vox(at_vox);
            let is_known =
                uncertainty_vox.iter().all(|&vox| f64::from(vox) <= largest_uncertainty_vox);
            if before.status[n] != VectorStatus::Masked && is_known && support.is_enough(at_vox) {
                Vector {
                    displacement_vox: field.value(at_vox),
                    uncertainty_vox,
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

/// The particles around a vector, with and without a partner.
struct Support {
    paired: Neighbours,
    alone: [Neighbours; 2],
}

impl Support {
    /// From positions in voxels of `grid`. Spheres around vectors contain [`PAIRS_PER_SPHERE`] pairs on average.
    fn new(grid: &VolumeGrid, paired: &[[f32; 3]], alone: [&[[f32; 3]]; 2]) -> Self {
        let sphere = 4.0 / 3.0 * std::f32::consts::PI;
        let density = paired.len().max(1) as f32 / grid.voxels.iter().product::<usize>() as f32;
        let reach = (PAIRS_PER_SPHERE / (sphere * density)).cbrt();
        let near = |places: &[[f32; 3]]| Neighbours::new(places, reach);
        Self { paired: near(paired), alone: alone.map(near) }
    }

    fn is_enough(&self, at_vox: [f32; 3]) -> bool {
        let about = |near: &Neighbours| {
            let mut count = 0;
            near.visit(at_vox, |_, _| count += 1);
            count
        };
        let paired = about(&self.paired);
        let alone: usize = self.alone.iter().map(about).sum();
        // A particle without a partner is in one frame only.
        let share = paired as f32 / (paired as f32 + alone as f32 / 2.0).max(1.0);
        paired >= LEAST_PAIRS && share >= LEAST_PAIRED_SHARE
    }
}

/// Whether each sample agrees with the prediction from the others, within the typical residual, the field's
/// uncertainty and the sample's.
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
            missed[c] * missed[c] <= AGREEMENT_SIGMA * AGREEMENT_SIGMA * variance
        })
    };
    samples.iter().zip(missed).map(agrees).collect()
}

#[cfg(test)]
mod tests {
    use rand::{RngExt, SeedableRng};
    use rand_pcg::Pcg64Mcg;

    use super::*;

    const EDGE_VOX: usize = 40;

    /// Share of positions in the volume with enough support, for these numbers of pairs and of particles without a
    /// partner per frame.
    fn measured_share(pairs: usize, alone: usize) -> f64 {
        let mut random = Pcg64Mcg::seed_from_u64(11);
        let mut places = |count: usize| -> Vec<[f32; 3]> {
            let place = |_| [0; 3].map(|_: i32| random.random_range(0.0..EDGE_VOX as f32));
            (0..count).map(place).collect()
        };
        let [paired, a, b, asked] = [pairs, alone, alone, 500].map(&mut places);
        let grid = VolumeGrid { voxels: [EDGE_VOX; 3], voxel_mm: 0.1, centre_mm: [0.0; 3] };
        let support = Support::new(&grid, &paired, [&a, &b]);
        asked.iter().filter(|&&at| support.is_enough(at)).count() as f64 / asked.len() as f64
    }

    #[test]
    fn vectors_are_measured_where_most_particles_have_a_partner() {
        assert!(measured_share(1000, 200) > 0.97);
        assert!(measured_share(1000, 700) > 0.9);
    }

    #[test]
    fn pairs_by_chance_measure_nothing() {
        assert_eq!(measured_share(80, 1000), 0.0);
        assert_eq!(measured_share(0, 1000), 0.0);
        assert_eq!(measured_share(0, 0), 0.0);
    }
}
