//! How far the cameras disagree on displacements, against how far their covariances say they may.
//!
//! Each camera alone places a particle. Where both see it, their displacements differ by noise only, whatever
//! the flow is. The covariances of the pixels' noise are too small for that: the images of neighbours overlap, and
//! each is fitted while the others move. So the cameras' disagreement says by how much.

use std::ops::AddAssign;

use nalgebra::{Matrix3, Matrix4, Vector3, Vector4};

use super::normal::{CAMERAS, Normal};
use crate::statistics::median;

/// Median of chi-squared with three degrees of freedom.
const CHI_SQUARED_MEDIAN: f64 = 2.366;

/// Least number of pairs that both cameras see of which a median is taken.
const LEAST_PAIRS: usize = 100;

/// What pixels say of a particle.
#[derive(Debug, Clone, Default)]
pub struct Seen {
    /// Its equations; zero where a camera does not see it across several microlenses.
    pub normal: Normal,
    /// The same with the covariance of the gradient as matrix.
    pub gradient: Normal,
}

impl AddAssign<&Self> for Seen {
    fn add_assign(&mut self, other: &Self) {
        self.normal += &other.normal;
        self.gradient += &other.gradient;
    }
}

impl Seen {
    /// Where camera number `camera` alone would move the particle, in mm, and the covariance of that, in mm²; `None` if
    /// it does not see the particle.
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

/// The factor of the variances with which the cameras disagree as far as these say; at least 1. `seen` holds, per frame
/// and camera, the particles of the pairs in the same order.
///
/// With u the displacement by the first camera less that by the second, each from its own pixels, and C the sum of
/// their four covariances, uᵀ C⁻¹ u is chi-squared with three degrees of freedom; the median is not led by false
/// pairs. What is wrong in both frames alike, such as a camera's pose, is not in it. It is 1 with one camera.
pub fn widening(seen: &[Vec<Vec<Seen>>; 2]) -> f64 {
    let (Some(pairs), CAMERAS) = (seen[0].first().map(Vec::len), seen[0].len()) else {
        return 1.0;
    };
    let squared = |n: usize| {
        let (mut apart, mut covariance) = (Vector3::zeros(), Matrix3::zeros());
        for (frame, sign) in seen.iter().zip([-1.0, 1.0]) {
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
    median(squared).map_or(1.0, |middle| (middle / CHI_SQUARED_MEDIAN).max(1.0))
}

#[cfg(test)]
mod tests {
    use rand::{RngExt, SeedableRng};
    use rand_pcg::Pcg64Mcg;

    use super::*;

    /// Standard normal, by the sum of twelve uniform numbers.
    fn normal(random: &mut Pcg64Mcg) -> f64 {
        (0..12).map(|_| random.random::<f64>()).sum::<f64>() - 6.0
    }

    /// A camera that sees well across and badly along its depth, with errors `larger` times those it states.
    fn seen(random: &mut Pcg64Mcg, camera: usize, larger: f64) -> Seen {
        let mut deviations = [0.001, 0.001, 0.001, 0.5];
        deviations[2 * (1 - camera)] = 0.02;
        let mut seen = Seen::default();
        for (n, deviation) in [0, 1, 2, 3 + camera].into_iter().zip(deviations) {
            let weight = 1.0 / (deviation * deviation);
            seen.normal.matrix[(n, n)] = weight;
            seen.gradient.matrix[(n, n)] = weight;
            seen.normal.right[n] = weight * larger * deviation * normal(random);
        }
        seen
    }

    fn pairs(count: usize, larger: f64) -> [Vec<Vec<Seen>>; 2] {
        let mut random = Pcg64Mcg::seed_from_u64(5);
        [0, 1].map(|_| {
            (0..CAMERAS)
                .map(|camera| (0..count).map(|_| seen(&mut random, camera, larger)).collect())
                .collect()
        })
    }

    #[test]
    fn variances_are_widened_by_what_the_errors_are_larger() {
        for larger in [1.0, 1.4, 3.0] {
            let widening = widening(&pairs(4000, larger));
            assert!((widening / (larger * larger) - 1.0).abs() < 0.08, "{larger}: {widening}");
        }
    }

    #[test]
    fn they_are_never_narrowed_nor_widened_by_a_few_pairs() {
        assert_eq!(widening(&pairs(4000, 0.5)), 1.0);
        assert_eq!(widening(&pairs(LEAST_PAIRS - 1, 3.0)), 1.0);
        assert_eq!(widening(&pairs(0, 1.0)), 1.0);
    }

    #[test]
    fn a_tenth_of_false_pairs_does_not_lead() {
        let mut pairs = pairs(4000, 1.4);
        pairs[0][0][..400].iter_mut().for_each(|seen| seen.normal.right *= 1000.0);
        let widening = widening(&pairs);
        assert!((1.4 * 1.4..1.4 * 1.4 * 1.3).contains(&widening), "{widening}");
    }

    #[test]
    fn what_is_wrong_in_both_frames_alike_is_not_in_it() {
        let mut pairs = pairs(4000, 1.0);
        for frame in &mut pairs {
            for seen in &mut frame[1] {
                seen.normal.right[1] += seen.normal.matrix[(1, 1)] * 0.05;
            }
        }
        assert!(widening(&pairs) < 1.08);
    }

    #[test]
    fn one_camera_or_one_that_does_not_see_says_nothing() {
        let mut pairs = pairs(4000, 3.0);
        pairs[1][0].fill(Seen::default());
        assert_eq!(widening(&pairs), 1.0);
        pairs.iter_mut().for_each(|frame| frame.truncate(1));
        assert_eq!(widening(&pairs), 1.0);
    }
}
