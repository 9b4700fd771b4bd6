//! Disagreement of the cameras on displacements, relative to their covariances.
//!
//! Each camera alone measures a particle's displacement. The motion is the same, so the difference consists of
//! errors only, in any flow. It is larger than the covariances from the pixels predict (docs/decisions.md); the ratio
//! gives the factor on the covariances.

use std::ops::AddAssign;

use nalgebra::{Matrix3, Matrix4, Vector3, Vector4};

use super::normal::{CAMERAS, Normal};
use crate::statistics::{MEDIAN_OF_THREE_SQUARES, median};

/// Least number of pairs seen by both cameras; with fewer the factor is 1.
const LEAST_PAIRS: usize = 100;

/// The equations of one particle from one camera, or summed over the cameras.
#[derive(Debug, Clone, Default)]
pub struct ParticleEquations {
    /// Normal equations; zero where a camera does not see the particle across several microlenses.
    pub normal: Normal,
    /// The same with the covariance of the gradient as matrix.
    pub gradient: Normal,
}

impl AddAssign<&Self> for ParticleEquations {
    fn add_assign(&mut self, other: &Self) {
        self.normal += &other.normal;
        self.gradient += &other.gradient;
    }
}

impl ParticleEquations {
    /// The step to where camera number `camera` alone places the particle, in mm, and its covariance, in mm²; `None` if
    /// the camera does not see the particle.
    fn alone(&self, camera: usize) -> Option<(Vector3<f64>, Matrix3<f64>)> {
        let index = [0, 1, 2, 3 + camera];
        let of = |normal: &Normal| {
            Matrix4::from_fn(|row, column| normal.matrix[(index[row], index[column])])
        };
        let right = Vector4::from_fn(|row, _| self.normal.right[index[row]]);
        let inverse = of(&self.normal).try_inverse()?;
        let covariance = inverse * of(&self.gradient) * inverse;
        let step = inverse * right;
        Some((step.fixed_rows::<3>(0).into(), covariance.fixed_view::<3, 3>(0, 0).into()))
    }
}

/// The factor by which covariances of places have to be multiplied to explain how far the cameras disagree; at least 1,
/// and 1 with one camera. `equations` holds, per frame and camera, the particles of the pairs in the same order.
///
/// Let u be the displacement by the first camera less that by the second, each from its own pixels, and C the sum of
/// the four covariances. If these are right, uᵀ C⁻¹ u is chi-squared with three degrees of freedom; the factor brings
/// its median there. A median is hardly changed by false pairs. An error of both frames alike, such as that of a
/// camera's pose, cancels in u.
pub fn variance_factor(equations: &[Vec<Vec<ParticleEquations>>; 2]) -> f64 {
    let (Some(pairs), CAMERAS) = (equations[0].first().map(Vec::len), equations[0].len()) else {
        return 1.0;
    };
    let squared = |n: usize| {
        let (mut apart, mut covariance) = (Vector3::zeros(), Matrix3::zeros());
        for (frame, sign) in equations.iter().zip([-1.0, 1.0]) {
            for (c, sign) in [sign, -sign].into_iter().enumerate() {
                let (step, known) = frame[c][n].alone(c)?;
                apart += step * sign;
                covariance += known;
            }
        }
        let squared = (apart.transpose() * covariance.try_inverse()? * apart)[0];
        squared.is_finite().then_some(squared)
    };
    let squared: Vec<f64> = (0..pairs).filter_map(squared).collect();
    if squared.len() < LEAST_PAIRS {
        return 1.0;
    }
    median(squared).map_or(1.0, |middle| (middle / MEDIAN_OF_THREE_SQUARES).max(1.0))
}

#[cfg(test)]
mod tests {
    use rand::{RngExt, SeedableRng};
    use rand_distr::StandardNormal;
    use rand_pcg::Pcg64Mcg;

    use super::*;

    /// A camera that sees well across and badly along its depth, with errors `larger` times those it states.
    fn one_camera(random: &mut Pcg64Mcg, camera: usize, larger: f64) -> ParticleEquations {
        let mut deviations = [0.001, 0.001, 0.001, 0.5];
        deviations[2 * (1 - camera)] = 0.02;
        let mut equations = ParticleEquations::default();
        for (n, deviation) in [0, 1, 2, 3 + camera].into_iter().zip(deviations) {
            let weight = 1.0 / (deviation * deviation);
            let error: f64 = random.sample(StandardNormal);
            equations.normal.matrix[(n, n)] = weight;
            equations.gradient.matrix[(n, n)] = weight;
            equations.normal.right[n] = weight * larger * deviation * error;
        }
        equations
    }

    fn pairs(count: usize, larger: f64) -> [Vec<Vec<ParticleEquations>>; 2] {
        let mut random = Pcg64Mcg::seed_from_u64(5);
        [0, 1].map(|_| {
            (0..CAMERAS)
                .map(|camera| (0..count).map(|_| one_camera(&mut random, camera, larger)).collect())
                .collect()
        })
    }

    #[test]
    fn errors_larger_than_stated_are_found() {
        for larger in [1.0, 1.4, 3.0] {
            let factor = variance_factor(&pairs(4000, larger));
            assert!((factor / (larger * larger) - 1.0).abs() < 0.08, "{larger}: {factor}");
        }
    }

    #[test]
    fn small_errors_and_few_pairs_change_nothing() {
        assert_eq!(variance_factor(&pairs(4000, 0.5)), 1.0);
        assert_eq!(variance_factor(&pairs(LEAST_PAIRS - 1, 3.0)), 1.0);
        assert_eq!(variance_factor(&pairs(0, 1.0)), 1.0);
    }

    #[test]
    fn a_tenth_of_false_pairs_hardly_changes_it() {
        let mut pairs = pairs(4000, 1.4);
        pairs[0][0][..400].iter_mut().for_each(|equations| equations.normal.right *= 1000.0);
        let factor = variance_factor(&pairs);
        assert!((1.4 * 1.4..1.4 * 1.4 * 1.3).contains(&factor), "{factor}");
    }

    #[test]
    fn an_error_of_both_frames_alike_cancels() {
        let mut pairs = pairs(4000, 1.0);
        for frame in &mut pairs {
            for equations in &mut frame[1] {
                equations.normal.right[1] += equations.normal.matrix[(1, 1)] * 0.05;
            }
        }
        assert!(variance_factor(&pairs) < 1.08);
    }

    #[test]
    fn a_single_camera_changes_nothing() {
        let mut pairs = pairs(4000, 3.0);
        pairs[1][0].fill(ParticleEquations::default());
        assert_eq!(variance_factor(&pairs), 1.0);
        pairs.iter_mut().for_each(|frame| frame.truncate(1));
        assert_eq!(variance_factor(&pairs), 1.0);
    }
}
