//! Light in active blocks of 2 × 2 × 2 voxels, used by the solvers on active voxels.

use super::SparseVolume;
use crate::model::{BlockLight, LitBlocks, VolumeGrid, child_voxel};

/// The blocks of a grid that contain light.
#[derive(Debug, Clone, PartialEq)]
pub struct BlockVolume {
    /// The voxel grid.
    pub grid: VolumeGrid,
    /// Indices in the block grid's z, y, x order, ascending.
    pub blocks: Vec<u32>,
    /// Intensities of each block's voxels, finite and not negative; 0 outside the grid.
    pub light: Vec<BlockLight>,
}

impl BlockVolume {
    /// The same light in every voxel of the lit blocks.
    pub fn with_uniform_light(grid: &VolumeGrid, lit: LitBlocks) -> Self {
        let even = |mask: &u8| std::array::from_fn(|child| f32::from(mask >> child & 1));
        Self {
            grid: grid.clone(),
            light: lit.children.iter().map(even).collect(),
            blocks: lit.blocks,
        }
    }

    /// Number of voxels that contain light.
    pub fn active_voxels(&self) -> usize {
        self.light.as_flattened().iter().filter(|&&light| light > 0.0).count()
    }

    /// The same light on a grid of half the voxel size: each lit voxel becomes a block with an
    /// eighth of its light in each voxel.
    pub fn split(&self) -> Self {
        let mut parts: Vec<(u32, BlockLight)> = Vec::with_capacity(self.active_voxels());
        for (&block, light) in self.blocks.iter().zip(&self.light) {
            for (child, &light) in light.iter().enumerate() {
                // A voxel's index in this grid is its block's index in the finer one.
                if let (true, Some(voxel)) = (light > 0.0, child_voxel(&self.grid, block, child)) {
                    parts.push((voxel, [light / 8.0; 8]));
                }
            }
        }
        parts.sort_unstable_by_key(|&(block, _)| block);
        let (blocks, light) = parts.into_iter().unzip();
        Self { grid: self.grid.refined(2), blocks, light }
    }

    /// The lit voxels, individually.
    pub fn into_voxels(self) -> SparseVolume {
        let mut lit: Vec<(u32, f32)> = Vec::with_capacity(self.active_voxels());
        for (&block, light) in self.blocks.iter().zip(&self.light) {
            for (child, &light) in light.iter().enumerate() {
                if let (true, Some(voxel)) = (light > 0.0, child_voxel(&self.grid, block, child)) {
                    lit.push((voxel, light));
                }
            }
        }
        lit.sort_unstable_by_key(|&(voxel, _)| voxel);
        let (voxels, intensity) = lit.into_iter().unzip();
        SparseVolume { grid: self.grid, voxels, intensity }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn splitting_keeps_the_light_where_it_was() {
        let grid = VolumeGrid { voxels: [5, 4, 3], voxel_mm: 0.2, centre_mm: [1.0, -1.0, 0.0] };
        let lit = LitBlocks { blocks: vec![1, 7], children: vec![0b1000_0001, 0b0000_0110] };
        let mut volume = BlockVolume::with_uniform_light(&grid, lit);
        volume.light[1][2] = 3.0;
        assert_eq!(volume.active_voxels(), 4);
        let fine = volume.split();
        assert_eq!(fine.blocks.len(), 4);
        assert!(fine.blocks.is_sorted());
        let (coarse, fine) = (volume.into_voxels(), fine.into_voxels());
        assert_eq!(fine.voxels.len(), 32);
        assert_eq!(fine.on_grid(&grid), coarse.on_grid(&grid));
    }
}
