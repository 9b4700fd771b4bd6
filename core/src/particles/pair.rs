//! A particle in both frames, and its motion.

use nalgebra::{Matrix3, Vector3};

use super::normal::CAMERAS;

/// A particle in both frames whose displacement agrees with the flow.
#[derive(Debug, Clone, PartialEq)]
pub struct ParticlePair {
    /// Its position in frames a and b, in mm.
    pub places_mm: [[f64; 3]; 2],
    /// Covariance of each, in mm². Errors common to both frames, such as that of a camera's pose, are not
    /// included.
    pub covariances_mm2: [[[f64; 3]; 3]; 2],
    /// Its light in each frame and camera, in counts if all of it reached one open pixel.
    pub light: [[f64; CAMERAS]; 2],
}

/// A displacement that is expected of a particle without looking at it.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ExpectedDisplacement {
    /// In mm.
    pub displacement_mm: [f64; 3],
    /// Variance along x, y, z, in mm².
    pub variance_mm2: [f64; 3],
}

/// The motion of a particle.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Motion {
    /// Its position in the middle of the pair, in mm.
    pub middle_mm: [f64; 3],
    /// From frame a to frame b, in mm.
    pub displacement_mm: [f64; 3],
    /// Variances along x, y, z, in mm².
    pub middle_variance_mm2: [f64; 3],
    pub displacement_variance_mm2: [f64; 3],
}

impl ParticlePair {
    /// Its mid-pair position, in mm.
    pub fn middle_mm(&self) -> [f64; 3] {
        let [a, b] = self.places_mm;
        std::array::from_fn(|axis| (a[axis] + b[axis]) / 2.0)
    }

    /// Its displacement, in mm.
    pub fn displacement_mm(&self) -> [f64; 3] {
        let [a, b] = self.places_mm;
        std::array::from_fn(|axis| b[axis] - a[axis])
    }

    /// Standard uncertainty of the displacement along x, y, z, in mm.
    pub fn uncertainty_mm(&self) -> [f64; 3] {
        let [a, b] = self.covariances_mm2;
        std::array::from_fn(|axis| (a[axis][axis] + b[axis][axis]).sqrt())
    }

    /// Its motion from its images alone.
    pub fn motion(&self) -> Motion {
        let variance_mm2 = self.uncertainty_mm().map(|mm| mm * mm);
        Motion {
            middle_mm: self.middle_mm(),
            displacement_mm: self.displacement_mm(),
            middle_variance_mm2: variance_mm2.map(|variance| variance / 4.0),
            displacement_variance_mm2: variance_mm2,
        }
    }

    /// Its motion from its images and from what is expected of it.
    ///
    /// Let C_a and C_b be the covariances of its positions, F that of the expected displacement f and d its
    /// displacement in the images. With S = C_a + C_b + F the most probable displacement is
    /// d + (C_a + C_b) S⁻¹ (f − d), and the position between the frames moves by ½ (C_b − C_a) S⁻¹ (f − d): towards
    /// what the frame says that knows the particle better (Kalman, J. Basic Eng. 82, 1960).
    pub fn motion_given(&self, expected: &ExpectedDisplacement) -> Motion {
        let [a, b] = self.covariances_mm2.map(|rows| Matrix3::from_fn(|i, j| rows[i][j]));
        let (moved, middle) = (a + b, (b - a) / 2.0);
        let own = Vector3::from(self.displacement_mm());
        let surprise = Vector3::from(expected.displacement_mm) - own;
        let sum = moved + Matrix3::from_diagonal(&Vector3::from(expected.variance_mm2));
        let Some(inverse) = sum.try_inverse() else { return self.motion() };
        let [moved_gain, middle_gain] = [moved * inverse, middle * inverse];
        let diagonal = |matrix: Matrix3<f64>| std::array::from_fn(|n| matrix[(n, n)].max(0.0));
        Motion {
            middle_mm: (Vector3::from(self.middle_mm()) + middle_gain * surprise).into(),
            displacement_mm: (own + moved_gain * surprise).into(),
            middle_variance_mm2: diagonal(moved / 4.0 - middle_gain * middle.transpose()),
            displacement_variance_mm2: diagonal(moved - moved_gain * moved),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn diagonal(variances: [f64; 3]) -> [[f64; 3]; 3] {
        std::array::from_fn(|i| std::array::from_fn(|j| if i == j { variances[i] } else { 0.0 }))
    }

    fn pair(covariances_mm2: [[[f64; 3]; 3]; 2]) -> ParticlePair {
        let places_mm = [[1.0, 2.0, 3.0], [1.2, 2.4, 3.8]];
        ParticlePair { places_mm, covariances_mm2, light: [[1.0; CAMERAS]; 2] }
    }

    fn assert_near(found: [f64; 3], expected: [f64; 3]) {
        assert!(found.iter().zip(expected).all(|(a, b)| (a - b).abs() < 1e-12), "{found:?}");
    }

    /// Along x both frames know the particle equally well, along y only frame a does, along z what is expected is
    /// worth nothing.
    #[test]
    fn each_frame_moves_as_far_as_it_is_uncertain() {
        let pair = pair([diagonal([1.0, 0.0, 1.0]), diagonal([1.0, 1.0, 1.0])]);
        let expected = ExpectedDisplacement {
            displacement_mm: [0.4, 0.2, 0.0],
            variance_mm2: [0.0, 1.0, 1e30],
        };
        let motion = pair.motion_given(&expected);
        assert_near(motion.displacement_mm, [0.4, 0.3, 0.8]);
        assert_near(motion.displacement_variance_mm2, [0.0, 0.5, 2.0]);
        // Along y frame b moves back by 0.1, and the middle by half of it.
        assert_near(motion.middle_mm, [1.1, 2.15, 3.4]);
        assert_near(motion.middle_variance_mm2, [0.5, 0.125, 0.5]);
    }

    /// An uncertain depth that is tied to x: what is expected along x tells the depth, too.
    #[test]
    fn what_is_expected_along_one_axis_tells_what_is_tied_to_it() {
        let tied = [[1.0, 0.0, 2.0], [0.0, 1.0, 0.0], [2.0, 0.0, 5.0]];
        let expected = ExpectedDisplacement {
            displacement_mm: [0.3, 0.4, 0.8],
            variance_mm2: [0.0, 1e30, 1e30],
        };
        let motion = pair([tied, tied]).motion_given(&expected);
        assert_near(motion.displacement_mm, [0.3, 0.4, 1.0]);
        assert_near(motion.displacement_variance_mm2, [0.0, 2.0, 2.0]);
        assert_near(motion.middle_mm, pair([tied, tied]).middle_mm());
    }

    #[test]
    fn without_expectations_it_is_that_of_the_images() {
        let pair = pair([diagonal([0.1, 0.2, 0.3]), diagonal([0.3, 0.2, 0.1])]);
        let nothing = ExpectedDisplacement { displacement_mm: [0.0; 3], variance_mm2: [1e30; 3] };
        let (found, own) = (pair.motion_given(&nothing), pair.motion());
        assert_near(found.displacement_mm, own.displacement_mm);
        assert_near(found.middle_mm, own.middle_mm);
        assert_near(found.middle_variance_mm2, [0.1; 3]);
        assert_near(found.displacement_variance_mm2, own.displacement_variance_mm2);
    }
}
