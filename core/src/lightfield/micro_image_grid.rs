//! The grid of micro-image centres on a camera's sensor.

use lfpiv_hw::Optics;
use serde::{Deserialize, Serialize};

/// Centres of all micro-images, as an affine map of the microlens indices.
///
/// Microlens (i, j) is counted along the array's own axes: i along its columns from left to right,
/// j along its rows upwards, from (0, 0) in the lower left corner. Its micro-image is centred at
/// column a₀ + a₁ i + a₂ j and row b₀ + b₁ i + b₂ j. Pixel centres are at integers from 0, and
/// pixel rows count downwards.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct MicroImageGrid {
    /// Number of microlenses along i and j.
    pub microlenses: [usize; 2],
    /// a₀, a₁, a₂, in pixels.
    pub column_px: [f64; 3],
    /// b₀, b₁, b₂, in pixels.
    pub row_px: [f64; 3],
}

/// Largest deviation of the axes from a right angle for a square array, in degrees: far from the
/// 60° of a hexagonal one.
const SQUARE_WITHIN_DEG: f64 = 10.0;

impl MicroImageGrid {
    /// The ideal grid: centred on the sensor, along its axes.
    pub fn nominal(optics: &Optics) -> Self {
        let (lenses, sensor) = (&optics.microlens, &optics.sensor);
        let pitch_px = optics.micro_image_pitch_mm() / optics.pixel_pitch_mm();
        let first = |pixels: usize, lenses: usize, pitch_px: f64| {
            (pixels as f64 - 1.0) / 2.0 - (lenses as f64 - 1.0) / 2.0 * pitch_px
        };
        Self {
            microlenses: [lenses.columns, lenses.rows],
            column_px: [first(sensor.columns, lenses.columns, pitch_px), pitch_px, 0.0],
            row_px: [first(sensor.rows, lenses.rows, -pitch_px), 0.0, -pitch_px],
        }
    }

    /// Column and row of the centre of a microlens' micro-image, in pixels.
    pub fn centre_px(&self, i: f64, j: f64) -> [f64; 2] {
        [self.column_px, self.row_px].map(|[first, by_i, by_j]| first + by_i * i + by_j * j)
    }

    /// The fractional microlens index of a micro-image centred at a pixel: the inverse of
    /// [`Self::centre_px`].
    pub fn lens_at(&self, column_px: f64, row_px: f64) -> [f64; 2] {
        let [[a0, a1, a2], [b0, b1, b2]] = [self.column_px, self.row_px];
        let (column, row, determinant) = (column_px - a0, row_px - b0, a1 * b2 - a2 * b1);
        [(b2 * column - a2 * row) / determinant, (a1 * row - b1 * column) / determinant]
    }

    /// Centre-to-centre distances of the micro-images along i and along j, in pixels.
    pub fn pitch_px(&self) -> [f64; 2] {
        [1, 2].map(|axis| self.column_px[axis].hypot(self.row_px[axis]))
    }

    /// Rotation of the array's columns and rows on the sensor, from `right` towards `up`, in
    /// degrees: angle of i relative to `right`, and of j relative to `up`.
    pub fn turned_deg(&self) -> [f64; 2] {
        let along_i = (-self.row_px[1]).atan2(self.column_px[1]);
        let along_j = (-self.column_px[2]).atan2(-self.row_px[2]);
        [along_i.to_degrees(), along_j.to_degrees()]
    }

    /// Whether the array's axes are perpendicular, as for a square array.
    pub fn is_square(&self) -> bool {
        let [i, j] = self.turned_deg();
        (i - j).abs() < SQUARE_WITHIN_DEG
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::test_bench;

    #[test]
    fn the_nominal_grid_is_centred_and_numbered_upwards() {
        let optics = test_bench::optics();
        let grid = MicroImageGrid::nominal(&optics);
        let [column, row] = grid.centre_px(64.0, 48.0);
        assert!((column - 1175.5).abs() < 1e-9 && (row - 883.5).abs() < 1e-9);
        let [_, above] = grid.centre_px(64.0, 49.0);
        assert!((above - (883.5 - 0.1004 / 0.0055)).abs() < 1e-9);
        assert!(grid.is_square());
        assert!(grid.turned_deg().iter().all(|angle| angle.abs() < 1e-12));
    }

    #[test]
    fn the_rotation_and_the_inverse_of_a_grid_are_correct() {
        let (sine, cosine) = 0.5f64.to_radians().sin_cos();
        let grid = MicroImageGrid {
            microlenses: [50, 40],
            column_px: [7.5, 18.0 * cosine, -18.0 * sine],
            row_px: [700.0, -18.0 * sine, -18.0 * cosine],
        };
        assert!(grid.turned_deg().iter().all(|angle| (angle - 0.5).abs() < 1e-9));
        assert!(grid.pitch_px().iter().all(|pitch| (pitch - 18.0).abs() < 1e-9));
        let [column, row] = grid.centre_px(12.3, 31.7);
        let [i, j] = grid.lens_at(column, row);
        assert!((i - 12.3).abs() < 1e-9 && (j - 31.7).abs() < 1e-9);
    }

    #[test]
    fn a_hexagonal_grid_is_not_square() {
        let height = 15.0 * 0.75f64.sqrt();
        let grid = MicroImageGrid {
            microlenses: [50, 40],
            column_px: [7.5, 15.0, 7.5],
            row_px: [700.0, 0.0, -height],
        };
        assert!(!grid.is_square());
    }
}
