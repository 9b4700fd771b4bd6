//! Blocks on top of any forward model, voxel by voxel.

use std::ops::Range;

use super::{
    BlockLight, BlockModel, BlockProjector, HullCriteria, LitBlocks, blocks_along, child_voxel,
};
use crate::{
    lightfield::{ViewLayout, ViewStack},
    model::{ForwardModel, Projector, ViewId, VolumeGrid, hull::photo_hull},
};

/// A [`ForwardModel`] used as a [`BlockModel`].
pub struct VoxelwiseBlocks(Box<dyn ForwardModel>);

impl VoxelwiseBlocks {
    /// The same map in blocks.
    pub fn new(model: Box<dyn ForwardModel>) -> Self {
        Self(model)
    }
}

impl BlockModel for VoxelwiseBlocks {
    fn grid(&self) -> &VolumeGrid {
        self.0.grid()
    }

    fn layouts(&self) -> &[ViewLayout] {
        self.0.layouts()
    }

    fn projector(&self, blocks: &[u32]) -> Box<dyn BlockProjector + '_> {
        let grid = self.0.grid();
        // Children outside the grid are represented by its first voxel and stay dark.
        let children = |&block| (0..8).map(move |child| child_voxel(grid, block, child));
        let inside = blocks.iter().flat_map(children).map(|voxel| voxel.is_some()).collect();
        let voxels: Vec<u32> =
            blocks.iter().flat_map(children).map(|voxel| voxel.unwrap_or(0)).collect();
        Box::new(VoxelwiseProjector { inside, projector: self.0.projector(&voxels) })
    }

    fn lit(&self, views: &[ViewStack], criteria: &HullCriteria) -> LitBlocks {
        let grid = self.0.grid();
        let block_count: usize = blocks_along(grid).into_iter().product();
        let mut children = vec![0u8; block_count];
        let [nx, ny, _] = blocks_along(grid);
        for voxel in photo_hull(self.0.as_ref(), views, criteria).voxels {
            let ijk = grid.indices(voxel);
            let block = (ijk[2] / 2 * ny + ijk[1] / 2) * nx + ijk[0] / 2;
            children[block] |= 1 << ((ijk[0] & 1) | (ijk[1] & 1) << 1 | (ijk[2] & 1) << 2);
        }
        let lit = |&(_, &mask): &(usize, &u8)| mask != 0;
        children.iter().enumerate().filter(lit).fold(LitBlocks::default(), |mut all, (n, &mask)| {
            all.blocks.push(n as u32);
            all.children.push(mask);
            all
        })
    }

    fn image_len(&self, camera: usize) -> usize {
        self.layouts()[camera].window.len()
    }

    fn memory_bytes(&self) -> usize {
        self.0.memory_bytes()
    }
}

/// Eight voxels for each block.
struct VoxelwiseProjector<'a> {
    inside: Vec<bool>,
    projector: Box<dyn Projector + 'a>,
}

impl BlockProjector for VoxelwiseProjector<'_> {
    fn project(&self, view: ViewId, light: &[BlockLight], image: &mut [f32]) {
        let flat = light.as_flattened();
        self.projector.project(view, flat, image);
    }

    /// Does nothing: the voxels' own projector weights the pixels.
    fn prepare(&self, _view: ViewId, _image: &mut [f32]) {}

    fn back_project(
        &self,
        view: ViewId,
        image: &[f32],
        range: Range<usize>,
        out: &mut [BlockLight],
    ) {
        let voxels = 8 * range.start..8 * range.end;
        let mut sums = vec![0.0; voxels.len()];
        self.projector.back_project(view, image, voxels.clone(), &mut sums);
        let inside = &self.inside[voxels];
        for ((out, sum), &inside) in out.as_flattened_mut().iter_mut().zip(sums).zip(inside) {
            *out += if inside { sum } else { 0.0 };
        }
    }

    fn retain(&mut self, keep: &[bool]) {
        let each: Vec<bool> = keep.iter().flat_map(|&keep| [keep; 8]).collect();
        let mut flags = each.iter();
        self.inside.retain(|_| flags.next().copied().unwrap_or(false));
        self.projector.retain(&each);
    }
}

#[cfg(test)]
mod tests {
    use super::{super::block_indices, *};

    #[test]
    fn children_of_a_block_are_its_eight_voxels() {
        let grid = VolumeGrid { voxels: [5, 4, 3], voxel_mm: 0.1, centre_mm: [0.0; 3] };
        assert_eq!(blocks_along(&grid), [3, 2, 2]);
        let block = 3 + 2; // Block (2, 1, 0): x beyond the end for odd children.
        assert_eq!(block_indices(&grid, block), [2, 1, 0]);
        assert_eq!(child_voxel(&grid, block, 0b110), Some(grid.linear([4, 3, 1]) as u32));
        assert_eq!(child_voxel(&grid, block, 0b001), None);
    }
}
