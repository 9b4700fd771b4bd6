//! Reconstructed light intensity, sparse and dense.

use nalgebra::Point3;

use crate::model::VolumeGrid;

/// A volume of light intensity, stored z, y, x (x fastest).
#[derive(Debug, Clone, PartialEq)]
pub struct DenseVolume {
    /// The voxel grid.
    pub grid: VolumeGrid,
    /// One intensity per voxel, finite and not negative.
    pub intensity: Vec<f32>,
}

/// The voxels of a grid that contain light.
#[derive(Debug, Clone, PartialEq)]
pub struct SparseVolume {
    /// The voxel grid.
    pub grid: VolumeGrid,
    /// Indices in the grid's z, y, x order, ascending.
    pub voxels: Vec<u32>,
    /// Intensity of each of `voxels`, finite and not negative.
    pub intensity: Vec<f32>,
}

impl SparseVolume {
    /// Grid indices of entry `n`.
    pub fn index_of(&self, n: usize) -> [usize; 3] {
        let [nx, ny, _] = self.grid.voxels;
        let voxel = self.voxels[n] as usize;
        [voxel % nx, voxel / nx % ny, voxel / (nx * ny)]
    }

    /// World position of the centre of entry `n`, in mm.
    pub fn position_mm(&self, n: usize) -> Point3<f64> {
        self.grid.centre_of(self.index_of(n))
    }

    /// The same light with each voxel split into `factor`³ equal parts.
    pub fn refined(&self, factor: usize) -> Self {
        let grid = self.grid.refined(factor);
        let share = 1.0 / (factor * factor * factor) as f32;
        let mut parts: Vec<(u32, f32)> = Vec::with_capacity(self.voxels.len() * factor.pow(3));
        for (n, &light) in self.intensity.iter().enumerate() {
            let [i, j, k] = self.index_of(n).map(|c| c * factor);
            for c in 0..factor {
                for b in 0..factor {
                    let row = grid.linear([i, j + b, k + c]) as u32;
                    parts.extend((0..factor as u32).map(|a| (row + a, light * share)));
                }
            }
        }
        parts.sort_unstable_by_key(|&(voxel, _)| voxel);
        let (voxels, intensity) = parts.into_iter().unzip();
        Self { grid, voxels, intensity }
    }

    /// Sums the light onto the voxels of a coarser or smaller grid. Light outside `grid` is dropped.
    pub fn on_grid(&self, grid: &VolumeGrid) -> DenseVolume {
        let mut intensity = vec![0.0; grid.len()];
        let maps: [Vec<Option<usize>>; 3] = std::array::from_fn(|axis| {
            (0..self.grid.voxels[axis])
                .map(|n| {
                    let at = grid.index_of(axis, self.grid.coordinate_mm(axis, n as f64)).round();
                    (at >= 0.0 && at < grid.voxels[axis] as f64).then_some(at as usize)
                })
                .collect()
        });
        for (n, &light) in self.intensity.iter().enumerate() {
            let [i, j, k] = self.index_of(n);
            if let (Some(i), Some(j), Some(k)) = (maps[0][i], maps[1][j], maps[2][k]) {
                intensity[grid.linear([i, j, k])] += light;
            }
        }
        DenseVolume { grid: grid.clone(), intensity }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn light_is_kept_when_fine_voxels_are_summed_onto_coarse_ones() {
        let coarse = VolumeGrid { voxels: [4, 3, 2], voxel_mm: 0.2, centre_mm: [1.0, -1.0, 0.0] };
        let fine = coarse.refined(2);
        let voxels: Vec<u32> = (0..fine.len() as u32).collect();
        let intensity: Vec<f32> = voxels.iter().map(|&n| n as f32).collect();
        let total: f32 = intensity.iter().sum();
        let sparse = SparseVolume { grid: fine.clone(), voxels, intensity };
        let summed = sparse.on_grid(&coarse);
        assert_eq!(summed.intensity.iter().sum::<f32>(), total);
        let expected: usize = [
            [0, 0, 0],
            [1, 0, 0],
            [0, 1, 0],
            [1, 1, 0],
            [0, 0, 1],
            [1, 0, 1],
            [0, 1, 1],
            [1, 1, 1],
        ]
        .iter()
        .map(|&[a, b, c]| fine.linear([2 + a, 2 + b, 2 + c]))
        .sum();
        assert_eq!(summed.intensity[coarse.linear([1, 1, 1])], expected as f32);
    }
}
