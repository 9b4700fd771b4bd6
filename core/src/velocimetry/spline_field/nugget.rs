//! How large the errors of particles are, from pairs of them that are close together.
//!
//! Particles much closer to each other than most move alike but for the field's gradient: what else tells
//! their displacements apart is their own errors (the nugget of a variogram: Matheron, Econ. Geol. 58, 1963).

use super::{Sample, field::SplineField};
use crate::{
    particles::Neighbours,
    statistics::{MEDIAN_SQUARE, median},
};

/// Particles this close count as a pair, in mean distances.
const CLOSE: f32 = 0.3;

/// The stated variance counts as so many pairs.
const PRIOR_PAIRS: f64 = 20.0;

/// The least and the most that the samples' variance may be of what they state.
const LIMITS: [f64; 2] = [1e-4, 9.0];

/// Variance of the samples over what they state, per component.
pub fn excess(samples: &[Sample], field: &SplineField) -> [f32; 3] {
    let places: Vec<[f32; 3]> = samples.iter().map(|sample| sample.middle_vox).collect();
    let reach = CLOSE * field.volume_vox3().cbrt() / (samples.len().max(1) as f32).cbrt();
    let near = Neighbours::new(&places, reach);
    let mut squares: [Vec<f64>; 3] = Default::default();
    for (n, one) in samples.iter().enumerate() {
        near.visit(one.middle_vox, |other, _| {
            if other <= n {
                return;
            }
            let two = &samples[other];
            let middle = std::array::from_fn(|a| (one.middle_vox[a] + two.middle_vox[a]) / 2.0);
            let gradient = field.gradient(middle);
            for c in 0..3 {
                let along: f32 =
                    (0..3).map(|a| gradient[a][c] * (two.middle_vox[a] - one.middle_vox[a])).sum();
                let apart = two.displacement_vox[c] - one.displacement_vox[c] - along;
                squares[c]
                    .push(f64::from(apart * apart / (one.variance_vox2[c] + two.variance_vox2[c])));
            }
        });
    }
    squares.map(|squares| {
        let count = squares.len() as f64;
        let found = median(squares).unwrap_or_default() / MEDIAN_SQUARE;
        // By the logarithm: what is stated may be off by a factor either way.
        let found = found.clamp(LIMITS[0], LIMITS[1]);
        libm::exp(libm::log(found) * count / (PRIOR_PAIRS + count)) as f32
    })
}
