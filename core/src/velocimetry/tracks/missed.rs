//! What a field misses of the flow, from residuals of single particles.
//!
//! A particle's residual is what the field misses at its position plus the particle's own error. Neighbours have the
//! first in common, and their own errors are nearly independent. The mean product of the residuals of neighbours is
//! therefore the variance of what the field misses. Neither the errors of single particles nor the smoothness of a
//! fitted field changes it. Each product weighs as the inverse of both particles' variances: faint and wide light
//! comes from overlapping particles, of which dense images are full.

use super::{super::lattice::Lattice, pairs::Pair, samples::relative_variances, spline::Spline};
use crate::particles::Neighbours;

/// Which neighbours are compared, and when what they have in common is significant (docs/decisions.md).
struct Comparison {
    /// Largest distance of neighbours, in spacings of the windows.
    reach: f32,
    /// Least mean product, in standard errors.
    least_significance: f64,
    /// Least mean product, relative to the variance of the residuals.
    least_correlation: f64,
}

/// Of residuals from the windows' field. Half-overlapping windows do not respond to waves of four times this reach and
/// shorter. Errors of neighbours are correlated, too: by up to 0.1 in a uniform flow, and by chance more among few
/// particles.
const FROM_WINDOWS: Comparison =
    Comparison { reach: 0.5, least_significance: 6.0, least_correlation: 0.15 };

/// Of residuals from the field through these same particles. It follows a part of what their errors have in common, so
/// that the mean product of a resolved flow is not positive, and a smaller one is significant.
const FROM_TRACKING: Comparison =
    Comparison { reach: 1.0, least_significance: 4.0, least_correlation: 0.0 };

/// Standard deviation of the displacement that each field misses, in voxels: that of the component where it is largest.
/// 0 where neighbours have no significant part of their residuals in common.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Missed {
    /// By the windows' field.
    pub by_windows_vox: f64,
    /// By the field through followed particles.
    pub by_tracking_vox: f64,
}

impl Missed {
    /// By the field of `windows` and the one through the particles `pairs`, `tracked`.
    pub fn of(windows: &Lattice, tracked: &Spline, pairs: &[Pair]) -> Self {
        let by_windows = |at| windows.at(at).map(f64::from);
        let by_tracking = |at| tracked.of(&tracked.taps(at));
        Self {
            by_windows_vox: missed_by(by_windows, windows.step_vox, pairs, &FROM_WINDOWS),
            by_tracking_vox: missed_by(by_tracking, windows.step_vox, pairs, &FROM_TRACKING),
        }
    }
}

/// What `field` misses where windows are `step_vox` apart.
fn missed_by(
    field: impl Fn([f32; 3]) -> [f64; 3],
    step_vox: f32,
    pairs: &[Pair],
    comparison: &Comparison,
) -> f64 {
    let residual = |pair: &Pair| -> [f64; 3] {
        let known = field(pair.middle_vox);
        std::array::from_fn(|c| f64::from(pair.displacement_vox[c]) - known[c])
    };
    let residuals: Vec<[f64; 3]> = pairs.iter().map(residual).collect();
    let variances = relative_variances(pairs);
    let places: Vec<[f32; 3]> = pairs.iter().map(|pair| pair.middle_vox).collect();
    let near = Neighbours::new(&places, comparison.reach * step_vox);
    let mut sums = [Sums::default(); 3];
    for (n, own) in residuals.iter().enumerate() {
        near.visit(places[n], |other, _| {
            if other > n {
                for (c, sums) in sums.iter_mut().enumerate() {
                    let weight = 1.0 / (variances[n][c] * variances[other][c]);
                    sums.add(weight, own[c], residuals[other][c]);
                }
            }
        });
    }
    let in_common = |sums: &Sums| sums.in_common(comparison);
    sums.iter().filter_map(in_common).fold(0.0, f64::max).sqrt()
}

/// Weighted sums over pairs of neighbours, of one component.
#[derive(Debug, Clone, Copy, Default)]
struct Sums {
    weight: f64,
    product: f64,
    squared_product: f64,
    square: f64,
}

impl Sums {
    fn add(&mut self, weight: f64, one: f64, other: f64) {
        let product = weight * one * other;
        self.weight += weight;
        self.product += product;
        self.squared_product += product * product;
        self.square += weight * (one * one + other * other) / 2.0;
    }

    /// Variance that neighbours have in common, in voxel², where it is significant.
    fn in_common(&self, comparison: &Comparison) -> Option<f64> {
        let is_significant = self.product
            > comparison.least_significance * self.squared_product.sqrt()
            && self.product > comparison.least_correlation * self.square;
        is_significant.then(|| self.product / self.weight)
    }
}

#[cfg(test)]
mod tests {
    use std::f32::consts::TAU;

    use rand::{RngExt, SeedableRng};
    use rand_distr::{Distribution, Normal};
    use rand_pcg::Pcg64Mcg;

    use super::*;

    const EDGE_VOX: f32 = 80.0;

    /// Particles at random positions in the flow `flow`, each with an error of this standard deviation, in voxels.
    fn particles(count: usize, error_vox: f32, flow: impl Fn([f32; 3]) -> [f32; 3]) -> Vec<Pair> {
        let mut random = Pcg64Mcg::seed_from_u64(5);
        let error = Normal::new(0.0, error_vox).unwrap();
        let mut pair = |_| {
            let middle_vox = [0; 3].map(|_: i32| random.random_range(0.0..EDGE_VOX));
            let displacement_vox = flow(middle_vox).map(|vox| vox + error.sample(&mut random));
            Pair { middle_vox, displacement_vox, spread_vox2: [0.01; 3], light: 1.0 }
        };
        (0..count).map(&mut pair).collect()
    }

    /// What fields at rest miss.
    fn missed_at_rest(pairs: &[Pair]) -> Missed {
        let nodes = [11; 3];
        let values = vec![[0.0; 3]; nodes.iter().product()];
        let windows = Lattice { nodes, first_vox: [0.0; 3], step_vox: 8.0, values };
        Missed::of(&windows, &Spline::through(&windows, None), pairs)
    }

    const NOTHING: Missed = Missed { by_windows_vox: 0.0, by_tracking_vox: 0.0 };

    fn wave(amplitude_vox: f32) -> impl Fn([f32; 3]) -> [f32; 3] {
        move |at| [0.0, amplitude_vox * (TAU * at[0] / 16.0).sin(), 0.0]
    }

    #[test]
    fn errors_of_particles_are_not_flow() {
        for error_vox in [0.02, 0.1, 0.5] {
            let particles = particles(5000, error_vox, |_| [0.0; 3]);
            assert_eq!(missed_at_rest(&particles), NOTHING, "{error_vox}");
        }
    }

    /// A wave of a window, of which windows show nothing.
    #[test]
    fn a_wave_is_found_below_the_errors_of_particles() {
        for (amplitude_vox, error_vox) in [(0.5, 0.1), (0.2, 0.15), (0.2, 0.0)] {
            let missed = missed_at_rest(&particles(5000, error_vox, wave(amplitude_vox)));
            // Neighbours within 4 and 8 voxels have less than the whole variance in common.
            let deviation = f64::from(amplitude_vox) / 2f64.sqrt();
            let shares = [missed.by_windows_vox, missed.by_tracking_vox].map(|vox| vox / deviation);
            let [windows, tracking] = shares;
            assert!((0.6..1.0).contains(&windows) && (0.2..0.8).contains(&tracking), "{shares:?}");
        }
    }

    /// A third of a particle's error. Within half a spacing there are too few neighbours to tell it.
    #[test]
    fn a_faint_wave_is_found_by_the_neighbours_farther_away() {
        let faint = |at: [f32; 3]| [0.0, 0.03 * (TAU * at[0] / 24.0).sin(), 0.0];
        let missed = missed_at_rest(&particles(5000, 0.1, faint));
        assert_eq!(missed.by_windows_vox, 0.0);
        assert!((0.01..0.022).contains(&missed.by_tracking_vox), "{missed:?}");
    }

    /// Light of overlapping particles is wide, and far from where either is.
    #[test]
    fn wide_light_does_not_hide_what_is_missed() {
        let mut mixed = particles(5000, 0.1, wave(0.2));
        for pair in particles(10_000, 0.4, |_| [0.0; 3]) {
            mixed.push(Pair { spread_vox2: [0.05; 3], ..pair });
        }
        let missed = missed_at_rest(&mixed).by_windows_vox;
        assert!(missed > 0.07 && missed < 0.15, "{missed}");
    }

    #[test]
    fn few_particles_tell_nothing() {
        for count in [0, 1, 40] {
            assert_eq!(missed_at_rest(&particles(count, 0.1, |_| [0.0; 3])), NOTHING);
        }
    }
}
