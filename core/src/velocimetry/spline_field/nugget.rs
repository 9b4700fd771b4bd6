//! Errors of particles, estimated from pairs that are close together.
//!
//! Displacements of particles that are very close together differ by the field's gradient and by the particles'
//! errors (the nugget of a variogram: Matheron, Econ. Geol. 58, 1963).

use super::{Sample, field::SplineField};
use crate::{
    particles::Neighbours,
    statistics::{MEDIAN_SQUARE, median},
};

/// Largest distance of a pair, in mean particle spacings.
const CLOSE: f32 = 0.3;

/// Weight of the stated variance, as a number of pairs.
const PRIOR_PAIRS: f64 = 20.0;

/// Limits of the ratio of the samples' variance to the stated one.
const LIMITS: [f64; 2] = [1e-4, 9.0];

/// Ratio of the samples' variance to the stated one, per component.
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
        // Shrinkage of the logarithm: stated variances may be too large or too small by a factor.
        let found = found.clamp(LIMITS[0], LIMITS[1]);
        libm::exp(libm::log(found) * count / (PRIOR_PAIRS + count)) as f32
    })
}
