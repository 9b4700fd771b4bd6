//! The measurement volume as a grid of cubic voxels.

use nalgebra::Point3;
use serde::{Deserialize, Serialize};

/// Placement and size of the voxel grid.
///
/// Voxel (i, j, k) is centred at `centre_mm + ((i, j, k) − (n − 1)/2)·voxel_mm`; arrays over the
/// grid are stored z, y, x (x fastest).
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct VolumeGrid {
    /// Voxel counts along x, y, z.
    pub voxels: [usize; 3],
    /// Edge length of a voxel, in mm.
    pub voxel_mm: f64,
    /// World position of the volume's centre, in mm.
    #[serde(default)]
    pub centre_mm: [f64; 3],
}

impl VolumeGrid {
    /// Number of voxels.
    pub fn len(&self) -> usize {
        self.voxels.iter().product()
    }

    /// Whether the grid has no voxel.
    pub fn is_empty(&self) -> bool {
        self.len() == 0
    }

    /// Coordinate of the centre of voxel `index` along axis 0 (x), 1 (y) or 2 (z), in mm.
    /// Fractional and outside indices extrapolate.
    pub fn coordinate_mm(&self, axis: usize, index: f64) -> f64 {
        self.centre_mm[axis] + (index - (self.voxels[axis] as f64 - 1.0) / 2.0) * self.voxel_mm
    }

    /// Fractional voxel index of a coordinate along an axis; inverse of [`Self::coordinate_mm`].
    pub fn index_of(&self, axis: usize, coordinate_mm: f64) -> f64 {
        (coordinate_mm - self.centre_mm[axis]) / self.voxel_mm
            + (self.voxels[axis] as f64 - 1.0) / 2.0
    }

    /// Centre of voxel (i, j, k), in mm.
    pub fn centre_of(&self, ijk: [usize; 3]) -> Point3<f64> {
        Point3::from(std::array::from_fn::<f64, 3, _>(|axis| {
            self.coordinate_mm(axis, ijk[axis] as f64)
        }))
    }

    /// Position of voxel (i, j, k) in an array stored z, y, x.
    pub fn linear(&self, [i, j, k]: [usize; 3]) -> usize {
        (k * self.voxels[1] + j) * self.voxels[0] + i
    }

    /// Indices (i, j, k) of the voxel at position `linear` of an array stored z, y, x; inverse of
    /// [`Self::linear`].
    pub fn indices(&self, linear: u32) -> [usize; 3] {
        let [nx, ny, _] = self.voxels;
        let n = linear as usize;
        [n % nx, n / nx % ny, n / (nx * ny)]
    }

    /// The same volume with `margin` more voxels on each side.
    pub fn padded(&self, margin: usize) -> Self {
        Self { voxels: self.voxels.map(|n| n + 2 * margin), ..self.clone() }
    }

    /// The same volume with each voxel split into `factor`³.
    pub fn refined(&self, factor: usize) -> Self {
        Self {
            voxels: self.voxels.map(|n| n * factor),
            voxel_mm: self.voxel_mm / factor as f64,
            centre_mm: self.centre_mm,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn refining_and_padding_keep_the_centre() {
        let grid = VolumeGrid { voxels: [10, 8, 6], voxel_mm: 0.1, centre_mm: [1.0, 0.0, -1.0] };
        for other in [grid.padded(3), grid.refined(2)] {
            for axis in 0..3 {
                let middle = (other.voxels[axis] as f64 - 1.0) / 2.0;
                assert!((other.coordinate_mm(axis, middle) - grid.centre_mm[axis]).abs() < 1e-12);
            }
        }
        assert!((grid.index_of(0, grid.coordinate_mm(0, 3.0)) - 3.0).abs() < 1e-12);
        assert_eq!(grid.linear([1, 2, 3]), 3 * 80 + 2 * 10 + 1);
        assert_eq!(grid.indices(3 * 80 + 2 * 10 + 1), [1, 2, 3]);
    }
}
