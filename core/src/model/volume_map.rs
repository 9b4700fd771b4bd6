//! Smooth map from the points of the volume to equivalent points of an ideal thin lens.

use lfpiv_hw::Optics;
use nalgebra::{DMatrix, Point3};
use serde::{Deserialize, Serialize};

/// The object point of an ideal thin lens whose rays have the same intersections with the microlens plane as
/// those of a real point.
///
/// A camera with a distorting lens or behind a tilted wall is astigmatic: the apparent depths along columns and
/// rows differ.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct EquivalentPoint {
    /// Coordinates along the camera's `right` and `up`, in mm.
    pub lateral_mm: [f64; 2],
    /// Depths along the camera's axis, positive towards it, in mm: for the array's columns and for its rows.
    pub depth_mm: [f64; 2],
}

impl EquivalentPoint {
    /// The equivalent point of a real point's rays.
    ///
    /// `place_mm` is the intersection of the ray through the middle of the pupil with the microlens plane,
    /// `slopes` its derivative with respect to the pupil position: b ξ and a of x = a U + b ξ (docs/theory.md,
    /// section 2), along `right` and `up`.
    pub fn of_rays(optics: &Optics, place_mm: [f64; 2], slopes: [f64; 2]) -> Self {
        let image_mm = optics.image_distance_mm();
        // a = 1 - s_i/s' with 1/s' = 1/F - 1/s, solved for s.
        let distance_mm =
            slopes.map(|slope| 1.0 / (1.0 / optics.focal_length_mm - (1.0 - slope) / image_mm));
        Self {
            lateral_mm: std::array::from_fn(|axis| -place_mm[axis] * distance_mm[axis] / image_mm),
            depth_mm: distance_mm.map(|distance_mm| optics.object_distance_mm - distance_mm),
        }
    }
}

/// [`EquivalentPoint`]s by polynomials in the world's coordinates.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct VolumeMap {
    /// Centre of the map's domain, in mm.
    centre_mm: [f64; 3],
    /// Half widths of the map's domain, in mm.
    half_mm: [f64; 3],
    /// Highest sum of a term's exponents.
    degree: usize,
    /// For each term of [`exponents`] the coefficients of both lateral coordinates and both depths.
    terms: Vec<[f64; 4]>,
}

/// Root-mean-square residuals of a map over its domain, in mm.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct MapResidual {
    /// Residual of the lateral coordinates.
    pub lateral_mm: f64,
    /// Residual of the depths.
    pub depth_mm: f64,
}

/// Exponents of x, y and z in each term, by falling exponents of x, then y.
fn exponents(degree: usize) -> impl Iterator<Item = [usize; 3]> {
    (0..=degree).flat_map(move |x| {
        (0..=degree - x).flat_map(move |y| (0..=degree - x - y).map(move |z| [x, y, z]))
    })
}

impl VolumeMap {
    /// Least-squares fit of a map to `equivalent`, a function of the position in mm.
    ///
    /// `centre_mm` and `half_mm` are centre and half widths of the domain; `degree` is the highest sum of
    /// exponents. The positions are Chebyshev nodes, so that the error is even over the domain. `None` if the
    /// domain has no volume or `equivalent` is `None` at a position.
    pub fn fit(
        centre_mm: [f64; 3],
        half_mm: [f64; 3],
        degree: usize,
        equivalent: impl Fn([f64; 3]) -> Option<EquivalentPoint>,
    ) -> Option<(Self, MapResidual)> {
        if half_mm.iter().any(|&half| !(half.is_finite() && half > 0.0)) {
            return None;
        }
        let nodes = degree + 3;
        let node = |n: usize| ((n as f64 + 0.5) / nodes as f64 * std::f64::consts::PI).cos();
        let places: Vec<[f64; 3]> = (0..nodes.pow(3))
            .map(|n| [n % nodes, n / nodes % nodes, n / (nodes * nodes)].map(node))
            .collect();
        let terms: Vec<[usize; 3]> = exponents(degree).collect();
        let matrix = DMatrix::from_fn(places.len(), terms.len(), |row, term| {
            monomial(places[row], terms[term])
        });
        let mut values = DMatrix::zeros(places.len(), 4);
        for (row, place) in places.iter().enumerate() {
            let world: [f64; 3] = std::array::from_fn(|n| centre_mm[n] + place[n] * half_mm[n]);
            let EquivalentPoint { lateral_mm: [xi, eta], depth_mm: [columns, rows] } =
                equivalent(world)?;
            values.row_mut(row).copy_from_slice(&[xi, eta, columns, rows]);
        }
        let solved = matrix.clone().svd(true, true).solve(&values, 1e-12).ok()?;
        let apart = &matrix * &solved - &values;
        let rms = |columns: std::ops::Range<usize>| {
            let squares: f64 = columns.clone().map(|n| apart.column(n).norm_squared()).sum();
            (squares / (columns.len() * places.len()) as f64).sqrt()
        };
        let residual = MapResidual { lateral_mm: rms(0..2), depth_mm: rms(2..4) };
        let terms = (0..terms.len())
            .map(|term| std::array::from_fn(|value| solved[(term, value)]))
            .collect();
        Some((Self { centre_mm, half_mm, degree, terms }, residual))
    }

    /// Domain of the map along x, y and z, in mm: from, to.
    pub fn holds_mm(&self) -> [[f64; 2]; 3] {
        std::array::from_fn(|n| {
            [self.centre_mm[n] - self.half_mm[n], self.centre_mm[n] + self.half_mm[n]]
        })
    }

    /// Equivalent point of a world point, in mm. Errors increase rapidly outside of the domain.
    pub fn at(&self, world_mm: &Point3<f64>) -> EquivalentPoint {
        let [x, y, z]: [f64; 3] =
            std::array::from_fn(|n| (world_mm[n] - self.centre_mm[n]) / self.half_mm[n]);
        let mut sums = [0.0; 4];
        let mut terms = self.terms.iter();
        let mut power_x = 1.0;
        for along_x in 0..=self.degree {
            let mut power_xy = power_x;
            for along_y in 0..=self.degree - along_x {
                let mut power = power_xy;
                for _ in 0..=self.degree - along_x - along_y {
                    let Some(term) = terms.next() else { break };
                    for (sum, factor) in sums.iter_mut().zip(term) {
                        *sum += factor * power;
                    }
                    power *= z;
                }
                power_xy *= y;
            }
            power_x *= x;
        }
        let [xi, eta, columns, rows] = sums;
        EquivalentPoint { lateral_mm: [xi, eta], depth_mm: [columns, rows] }
    }
}

fn monomial(place: [f64; 3], exponents: [usize; 3]) -> f64 {
    (0..3).map(|n| place[n].powi(exponents[n] as i32)).product()
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;

    fn cubic(p: &Point3<f64>) -> EquivalentPoint {
        EquivalentPoint {
            lateral_mm: [p.x + 1e-3 * p.x * p.y * p.z, p.y - 2e-3 * p.x * p.x],
            depth_mm: [0.75 * p.z + 0.01 * p.x, 0.74 * p.z + 1e-4 * p.y.powi(3)],
        }
    }

    proptest! {
        #[test]
        fn polynomials_are_fitted_exactly(x in -5.0..7.0f64, y in -4.0..4.0f64, z in -6.0..2.0f64) {
            let (map, residual) =
                VolumeMap::fit([1.0, 0.0, -2.0], [6.0, 4.0, 4.0], 3, |p| Some(cubic(&p.into()))).unwrap();
            prop_assert!(residual.lateral_mm < 1e-12 && residual.depth_mm < 1e-12);
            let (point, expected) = (map.at(&Point3::new(x, y, z)), cubic(&Point3::new(x, y, z)));
            for n in 0..2 {
                prop_assert!((point.lateral_mm[n] - expected.lateral_mm[n]).abs() < 1e-11);
                prop_assert!((point.depth_mm[n] - expected.depth_mm[n]).abs() < 1e-11);
            }
        }
    }

    #[test]
    fn the_residual_contains_terms_of_higher_degree() {
        let steep = |[x, _, _]: [f64; 3]| {
            Some(EquivalentPoint { lateral_mm: [x.powi(4), 0.0], depth_mm: [0.0; 2] })
        };
        let (_, residual) = VolumeMap::fit([0.0; 3], [1.0; 3], 2, steep).unwrap();
        assert!(residual.lateral_mm > 0.01 && residual.depth_mm < 1e-12);
        assert!(VolumeMap::fit([0.0; 3], [1.0, 0.0, 1.0], 2, steep).is_none());
        assert!(VolumeMap::fit([0.0; 3], [1.0; 3], 2, |_| None).is_none());
    }
}
