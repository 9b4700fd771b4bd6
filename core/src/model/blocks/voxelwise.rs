//! Blocks over any forward model, voxel by voxel.

use std::ops::Range;

use rayon::prelude::*;

use super::{
    BlockLight, BlockModel, BlockProjector, Darkness, LitBlocks, blocks_along, child_voxel,
};
use crate::{
    lightfield::{ViewLayout, ViewStack},
    model::{ForwardModel, Projector, ViewId, VolumeGrid, retain},
};

/// A [`ForwardModel`] seen as a [`BlockModel`].
pub struct VoxelwiseBlocks(Box<dyn ForwardModel>);

impl VoxelwiseBlocks {
    /// The same map in blocks.
    pub fn new(model: Box<dyn ForwardModel>) -> Self {
        Self(model)
    }
}

/// Voxels whose views are asked together: bounds the memory of a whole grid.
const SLAB_VOXELS: usize = 250_000;

impl BlockModel for VoxelwiseBlocks {
    fn grid(&self) -> &VolumeGrid {
        self.0.grid()
    }

    fn layouts(&self) -> &[ViewLayout] {
        self.0.layouts()
    }

    fn projector(&self, blocks: &[u32]) -> Box<dyn BlockProjector + '_> {
        let grid = self.0.grid();
        // Children beyond the grid's end stand for its first voxel and stay dark.
        let children = |&block| (0..8).map(move |child| child_voxel(grid, block, child));
        let inside = blocks.iter().flat_map(children).map(|voxel| voxel.is_some()).collect();
        let voxels: Vec<u32> =
            blocks.iter().flat_map(children).map(|voxel| voxel.unwrap_or(0)).collect();
        Box::new(VoxelwiseProjector { inside, projector: self.0.projector(&voxels) })
    }

    fn lit(&self, views: &[ViewStack], darkness: &Darkness) -> LitBlocks {
        let grid = self.0.grid();
        let block_count: usize = blocks_along(grid).into_iter().product();
        let mut children = vec![0u8; block_count];
        let [nx, ny, _] = blocks_along(grid);
        let slabs: Vec<Vec<u32>> = (0..grid.len().div_ceil(SLAB_VOXELS))
            .into_par_iter()
            .map(|slab| {
                let start = slab * SLAB_VOXELS;
                let end = (start + SLAB_VOXELS).min(grid.len());
                self.lit_voxels((start as u32..end as u32).collect(), views, darkness)
            })
            .collect();
        for voxel in slabs.into_iter().flatten() {
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

impl VoxelwiseBlocks {
    /// Those of `voxels` that are lit, in their order. Most voxels are dark in the first few views;
    /// the others need not be asked about them.
    fn lit_voxels(&self, voxels: Vec<u32>, views: &[ViewStack], darkness: &Darkness) -> Vec<u32> {
        let mut left = Left::new(self.0.as_ref(), voxels);
        for (camera, stack) in views.iter().enumerate() {
            left.dark.fill(0);
            for &view in &darkness.asked[camera] {
                let id = ViewId { camera, view };
                left.ask(id, stack.view(view), darkness.dark_below[camera]);
                left.drop_darker_than(darkness.forgiven[camera], SHARE_WORTH_DROPPING);
            }
            left.drop_darker_than(darkness.forgiven[camera], 0.0);
        }
        self.seen_by_another(&mut left, views, darkness);
        let seen = |&(_, &seen): &(&u32, &bool)| seen;
        left.voxels.iter().zip(&left.seen).filter(seen).map(|(&voxel, _)| voxel).collect()
    }

    /// Looks for a view that sees the voxels that no asked view saw.
    fn seen_by_another(&self, left: &mut Left, views: &[ViewStack], darkness: &Darkness) {
        let unseen: Vec<usize> = (0..left.voxels.len()).filter(|&n| !left.seen[n]).collect();
        if unseen.is_empty() {
            return;
        }
        let voxels: Vec<u32> = unseen.iter().map(|&n| left.voxels[n]).collect();
        let projector = self.0.projector(&voxels);
        let mut brightest = vec![0.0; voxels.len()];
        for (camera, stack) in views.iter().enumerate() {
            for view in (0..stack.len()).filter(|view| !darkness.asked[camera].contains(view)) {
                let id = ViewId { camera, view };
                projector.brightest(id, stack.view(view), 0..voxels.len(), &mut brightest);
                for (&n, light) in unseen.iter().zip(&brightest) {
                    left.seen[n] |= light.is_finite();
                }
            }
        }
    }
}

/// Share of dark voxels from which on dropping them costs less than asking about them again.
const SHARE_WORTH_DROPPING: f64 = 0.25;

/// Voxels that may be lit.
struct Left<'a> {
    projector: Box<dyn Projector + 'a>,
    voxels: Vec<u32>,
    /// Views of the present camera that find the voxel dark.
    dark: Vec<usize>,
    /// Whether a view has seen the voxel.
    seen: Vec<bool>,
    /// Of each voxel's support in the last view asked.
    brightest: Vec<f32>,
}

impl<'a> Left<'a> {
    fn new(model: &'a dyn ForwardModel, voxels: Vec<u32>) -> Self {
        let n = voxels.len();
        let projector = model.projector(&voxels);
        Self { projector, voxels, dark: vec![0; n], seen: vec![false; n], brightest: vec![0.0; n] }
    }

    fn ask(&mut self, id: ViewId, image: &[f32], dark_below: f32) {
        let n = self.voxels.len();
        let brightest = &mut self.brightest[..n];
        self.projector.brightest(id, image, 0..n, brightest);
        for ((dark, seen), &mut light) in self.dark.iter_mut().zip(&mut self.seen).zip(brightest) {
            *dark += usize::from(light < dark_below);
            *seen |= light.is_finite();
        }
    }

    /// Drops the voxels that more than `forgiven` views find dark, if their share exceeds `share`.
    fn drop_darker_than(&mut self, forgiven: usize, share: f64) {
        let keep: Vec<bool> = self.dark.iter().map(|&dark| dark <= forgiven).collect();
        let dropped = keep.iter().filter(|&&keep| !keep).count();
        if dropped as f64 <= share * keep.len() as f64 {
            return;
        }
        self.projector.retain(&keep);
        retain(&mut self.voxels, &keep);
        retain(&mut self.dark, &keep);
        retain(&mut self.seen, &keep);
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

    /// Nothing: the voxels' own projector weighs the pixels.
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
