//! The field fitted to particles whose positions were fitted to the images.
//!
//! Their positions are accurate to some thousandths of a voxel and their errors are independent, so the field
//! is resolved down to the particle spacing, and its uncertainty is estimated by cross-validation
//! (`spline_field`). Where there are too few particles, the field is that of the windows.

use super::{
    DisplacementField, Interrogation, VectorStatus, VelocimetrySettings, VelocityField,
    judge::{Vector, field_of},
    local_mean::{LocalMean, Residual},
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

/// Largest cross-validation residual of a particle that agrees with its neighbours, in standard deviations, or, if that
/// is more, in voxels. Particles whose images overlap often have a larger error than is stated, and pairs within half a
/// voxel are seldom false (docs/decisions.md).
const AGREEMENT_SIGMA: f32 = 4.0;
const AGREEMENT_VOX: f32 = 0.5;

/// Least inverse variance of a prediction, relative to that of the sample.
const LEAST_KNOWN: f32 = 1e-6;

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

    /// Corrects it by displacements of particles at their mid-pair positions. It agrees with those of `near` within some
    /// voxels, and not with those of `far`, but these agree with each other.
    pub fn correct(
        &mut self,
        near: impl Iterator<Item = Sample>,
        far: impl Iterator<Item = Sample>,
    ) {
        let left_by_correlation = |mut sample: Sample| {
            let known = self.by_correlation.at(sample.middle_vox);
            sample
                .displacement_vox
                .iter_mut()
                .zip(known)
                .for_each(|(moved, known)| *moved -= known);
            sample
        };
        let mut missed: Vec<Sample> = near.map(left_by_correlation).collect();
        let first_far = missed.len();
        missed.extend(far.map(left_by_correlation));
        if missed.len() >= LEAST_CORRECTING {
            let stiffness = self.correction.as_ref().map(|field| field.stiffness);
            // Weights are reduced for large residuals: the fit would ignore samples that are far from where it starts.
            let far_mean = (first_far < missed.len())
                .then(|| LocalMean::new(&self.residuals(&missed), first_far));
            let at = |at_vox| {
                let known = self.missed(at_vox);
                let Some(far_mean) = &far_mean else { return known };
                let further = far_mean.at(at_vox);
                std::array::from_fn(|c| known[c] + further[c])
            };
            let guess = Guess { at: &at, error_vox: FIRST_ERROR_VOX, stiffness };
            self.correction = Some(spline_field::near(&self.extent, &missed, &guess));
        }
    }

    /// Positions and what the correction misses there.
    fn residuals(&self, samples: &[Sample]) -> Vec<Residual> {
        let residual = |sample: &Sample| {
            let known = self.missed(sample.middle_vox);
            let left_vox = std::array::from_fn(|c| sample.displacement_vox[c] - known[c]);
            Residual { at_vox: sample.middle_vox, left_vox }
        };
        samples.iter().map(residual).collect()
    }

    fn missed(&self, at_vox: [f32; 3]) -> [f32; 3] {
        self.correction.as_ref().map_or([0.0; 3], |correction| correction.value(at_vox))
    }
}

/// Mid-pair positions of placed particles, in voxels.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct PlacedPositions {
    /// Of the pairs that every camera sees in both frames. A single camera hardly knows the depth.
    pub paired: Vec<[f32; 3]>,
    /// Of the particles without a partner, in frames a and b.
    pub alone: [Vec<[f32; 3]>; 2],
}

/// What the other particles tell about the displacement of one, in voxels.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Prediction {
    /// The field fitted to the others.
    pub displacement_vox: [f32; 3],
    /// Its standard uncertainty.
    pub uncertainty_vox: [f32; 3],
    /// Whether the particle's own displacement agrees with it.
    pub agrees: bool,
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

    /// The field fitted to `samples`, starting from `known`, and the prediction of each sample from the others. The
    /// field replaces the vectors `before` where there are enough pairs and not too many particles without a partner.
    /// Positions are in voxels of [`Self::cloud_grid`].
    pub fn through_placed(
        &self,
        before: &VelocityField,
        known: &CorrectedField<'_>,
        samples: &[Sample],
        positions: &PlacedPositions,
    ) -> (VelocityField, Vec<Prediction>) {
        let grid = self.cloud_grid();
        let at = |at_vox| known.at(at_vox);
        let error_vox =
            if known.correction.is_some() { CORRECTED_ERROR_VOX } else { FIRST_ERROR_VOX };
        let guess = Guess { at: &at, error_vox, stiffness: None };
        let VelocimetrySettings { incompressible, largest_uncertainty_vox, .. } = *self.settings();
        let (field, missed) = spline_field::through(&known.extent, samples, &guess, incompressible);
        let support = Support::new(&grid, positions);
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
        let predictions = predictions(samples, &missed, |at_vox| field.uncertainty_vox(at_vox));
        let field =
            field_of(before.grid.clone(), &grid, before.dt_s, (&vectors, &before.peak_ratio), flow);
        (field, predictions)
    }
}

/// The particles around a vector, with and without a partner.
struct Support {
    paired: Neighbours,
    alone: [Neighbours; 2],
}

impl Support {
    /// From positions in voxels of `grid`. Spheres around vectors contain [`PAIRS_PER_SPHERE`] pairs on average.
    fn new(grid: &VolumeGrid, positions: &PlacedPositions) -> Self {
        let PlacedPositions { paired, alone } = positions;
        let sphere = 4.0 / 3.0 * std::f32::consts::PI;
        let density = paired.len().max(1) as f32 / grid.voxels.iter().product::<usize>() as f32;
        let reach = (PAIRS_PER_SPHERE / (sphere * density)).cbrt();
        let near = |places: &[[f32; 3]]| Neighbours::new(places, reach);
        Self { paired: near(paired), alone: alone.each_ref().map(|alone| near(alone)) }
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

/// Predictions of the samples from their cross-validation residuals `missed` and the field's uncertainty. A sample
/// agrees within the typical residual, the field's uncertainty and its own.
///
/// The field knows the sample. Without it, the inverse of the field's variance is smaller by the inverse of the
/// sample's.
fn predictions(
    samples: &[Sample],
    missed: &[[f32; 3]],
    field_vox: impl Fn([f32; 3]) -> [f32; 3],
) -> Vec<Prediction> {
    let typical: [f32; 3] = std::array::from_fn(|c| {
        let all = missed.iter().map(|missed| f64::from(missed[c].abs()));
        (NORMAL_OF_MEDIAN * median(all).unwrap_or_default()) as f32
    });
    let prediction = |(sample, missed): (&Sample, &[f32; 3])| {
        let (own, field_vox) = (sample.variance_vox2, field_vox(sample.middle_vox));
        let variance: [f32; 3] = std::array::from_fn(|c| {
            let known = 1.0 / (field_vox[c] * field_vox[c]) - 1.0 / own[c];
            1.0 / known.max(LEAST_KNOWN / own[c])
        });
        let within_deviations = (0..3).all(|c| {
            let expected = own[c] + typical[c].powi(2) + variance[c];
            missed[c] * missed[c] <= AGREEMENT_SIGMA * AGREEMENT_SIGMA * expected
        });
        let square: f32 = missed.iter().map(|missed| missed * missed).sum();
        let agrees = within_deviations || square <= AGREEMENT_VOX * AGREEMENT_VOX;
        let uncertainty_vox = variance.map(f32::sqrt);
        let displacement_vox = std::array::from_fn(|c| sample.displacement_vox[c] - missed[c]);
        Prediction { displacement_vox, uncertainty_vox, agrees }
    };
    samples.iter().zip(missed).map(prediction).collect()
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
        let support = Support::new(&grid, &PlacedPositions { paired, alone: [a, b] });
        asked.iter().filter(|&&at| support.is_enough(at)).count() as f64 / asked.len() as f64
    }

    /// Samples at rest with these standard deviations and residuals in a field with an uncertainty of 0.1 voxel.
    fn predicted(of: &[(f32, f32)]) -> Vec<Prediction> {
        let sample = |&(deviation, _): &(f32, f32)| Sample {
            middle_vox: [0.0; 3],
            displacement_vox: [0.0; 3],
            variance_vox2: [deviation * deviation; 3],
        };
        let samples: Vec<Sample> = of.iter().map(sample).collect();
        let missed: Vec<[f32; 3]> = of.iter().map(|&(_, missed)| [missed, 0.0, 0.0]).collect();
        predictions(&samples, &missed, |_| [0.1; 3])
    }

    /// Of two equally good sources of a value each has twice the variance of their mean.
    #[test]
    fn a_prediction_is_what_the_field_knows_without_the_particle() {
        let [even, sure, alone] = [0.1 * 2.0f32.sqrt(), 10.0, 0.05].map(|deviation| {
            let [prediction] = predicted(&[(deviation, 0.3)])[..] else { panic!() };
            assert_eq!(prediction.displacement_vox, [-0.3, 0.0, 0.0]);
            prediction.uncertainty_vox[0]
        });
        assert!((even - 0.1 * 2.0f32.sqrt()).abs() < 1e-6, "{even}");
        assert!((sure - 0.1).abs() < 1e-4, "{sure}");
        // A field that knows less than the particle tells says nothing of it.
        assert!(alone > 10.0, "{alone}");
    }

    #[test]
    fn particles_disagree_beyond_their_deviations_and_half_a_voxel() {
        let of = [(0.11, 0.0); 6].into_iter().chain([(0.11, 0.45), (0.11, 2.0), (1.0, 2.0)]);
        let predictions = predicted(&of.collect::<Vec<_>>());
        let agrees: Vec<bool> = predictions[5..].iter().map(|one| one.agrees).collect();
        assert_eq!(agrees, [true, true, false, true]);
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
