//! Polynomial map from rays to points on the card around one mark.

use lfpiv_hw::card::Card;
use nalgebra::{DMatrix, Point3};

use super::camera_model::CameraModel;

/// Number of terms of a second-degree polynomial in four variables.
const TERMS: usize = 15;

/// Sampling points of the fit along each variable.
const NODES: usize = 3;

/// Intersections of rays with the card around one mark, along `right` and `up` of the card from mark (0, 0).
///
/// A polynomial of second degree in the place on the microlens plane and the position on the pupil. Its error is a
/// thousandth of a microlens for marks of a millimetre.
#[derive(Debug, Clone)]
pub(super) struct MarkMap {
    /// Centre and half widths of the map's domain, in mm.
    place_mm: [f64; 2],
    half_mm: f64,
    pupil_mm: f64,
    terms: [[f64; 2]; TERMS],
}

fn monomials([x, y, u, v]: [f64; 4]) -> [f64; TERMS] {
    [1.0, x, y, u, v, x * x, x * y, x * u, x * v, y * y, y * u, y * v, u * u, u * v, v * v]
}

impl MarkMap {
    /// The map for rays within `half_mm` of `place_mm` and within a pupil of half width `pupil_mm`. `None` if
    /// one of them misses the card.
    pub(super) fn new(
        model: &CameraModel,
        card: &Card,
        origin_mm: &Point3<f64>,
        place_mm: [f64; 2],
        half_mm: f64,
        pupil_mm: f64,
    ) -> Option<Self> {
        let face_mm = card.place_mm(origin_mm, [0.0; 2], &model.axis());
        let normal = card.normal();
        let node = |n: usize| n as f64 / (NODES as f64 - 1.0) * 2.0 - 1.0;
        let nodes: Vec<[f64; 4]> = (0..NODES.pow(4))
            .map(|n| [n, n / NODES, n / NODES.pow(2), n / NODES.pow(3)].map(|n| node(n % NODES)))
            .collect();
        let mut values = DMatrix::zeros(nodes.len(), 2);
        for (row, [x, y, u, v]) in nodes.iter().enumerate() {
            let at_mm = [place_mm[0] + x * half_mm, place_mm[1] + y * half_mm];
            let met_mm =
                model.intersection_mm(at_mm, [u * pupil_mm, v * pupil_mm], &face_mm, &normal)?;
            let along_mm = met_mm - face_mm;
            values[(row, 0)] = along_mm.dot(&card.right);
            values[(row, 1)] = along_mm.dot(&card.up);
        }
        let rows: Vec<[f64; TERMS]> = nodes.iter().map(|&node| monomials(node)).collect();
        let matrix = DMatrix::from_fn(rows.len(), TERMS, |row, term| rows[row][term]);
        let normal_matrix = (matrix.transpose() * &matrix).cholesky()?;
        let solved = normal_matrix.solve(&(matrix.transpose() * values));
        let terms = std::array::from_fn(|term| [solved[(term, 0)], solved[(term, 1)]]);
        Some(Self { place_mm, half_mm, pupil_mm, terms })
    }

    /// Intersection of a ray with the card, in mm along `right` and `up`.
    #[inline]
    pub(super) fn along_mm(&self, place_mm: [f64; 2], pupil_mm: [f64; 2]) -> [f64; 2] {
        let powers = monomials([
            (place_mm[0] - self.place_mm[0]) / self.half_mm,
            (place_mm[1] - self.place_mm[1]) / self.half_mm,
            pupil_mm[0] / self.pupil_mm,
            pupil_mm[1] / self.pupil_mm,
        ]);
        let mut sums = [0.0; 2];
        for (power, [right, up]) in powers.iter().zip(&self.terms) {
            sums[0] += power * right;
            sums[1] += power * up;
        }
        sums
    }
}
