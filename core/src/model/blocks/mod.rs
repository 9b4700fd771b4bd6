//! The model in blocks of 2 × 2 × 2 voxels, for solvers that work on active voxels only.
//!
//! Neighbouring voxels share most of what a projection costs: where the block's microlenses are,
//! and the pixels themselves. [`AlignedModel`] uses that where every camera is as drawn and looks
//! along an axis of the grid, [`mapped`] does for all others; [`VoxelwiseBlocks`] does the same
//! sums voxel by voxel through any [`ForwardModel`] and is the reference that they are tested
//! against.
//!
//! Voxel (i, j, k) is child `(i % 2) + 2 (j % 2) + 4 (k % 2)` of block (i/2, j/2, k/2). Where the
//! grid has an odd number of voxels, the children beyond its end stay dark.

mod aligned;
mod aligned_tables;
mod axis_table;
mod dark_counts;
mod kernels;
mod lit;
mod mapped;
mod pair_tap;
mod prefetch;
mod projector;
mod row_shares;
#[cfg(test)]
mod tests;
mod voxelwise;

use std::ops::Range;

use lfpiv_hw::{CameraName, Optics, Pose};

use super::{
    CameraCalibration, ModelError, ModelParts, ViewId, VolumeGrid, camera::CameraView,
    thin_lens_model_of,
};
use crate::lightfield::{ViewLayout, ViewStack};
use aligned::{DepthsPerBlock, aligned_views};
use aligned_tables::AlignedModel;
use mapped::mapped_model;
pub use voxelwise::VoxelwiseBlocks;

/// Light of a block's eight voxels, in the order of its children.
pub type BlockLight = [f32; 8];

/// Blocks that may hold light.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct LitBlocks {
    /// Positions in the block grid's z, y, x order, ascending.
    pub blocks: Vec<u32>,
    /// For each block a bit per child that may hold light; never 0.
    pub children: Vec<u8>,
}

/// What views must show for a voxel to be possible.
#[derive(Debug, Clone, PartialEq)]
pub struct Darkness {
    /// Per camera, the views that are asked, ascending.
    pub asked: Vec<Vec<usize>>,
    /// Per camera, the count under which a pixel is dark.
    pub dark_below: Vec<f32>,
    /// Per camera, how many of the asked views may find a lit voxel dark.
    pub forgiven: Vec<usize>,
}

/// A linear map from voxel intensities to pixels as [`super::ForwardModel`] defines it, block by
/// block.
pub trait BlockModel: Send + Sync {
    /// The voxels.
    fn grid(&self) -> &VolumeGrid;
    /// The views of every camera.
    fn layouts(&self) -> &[ViewLayout];
    /// A projector for these blocks (positions in the block grid's z, y, x order, ascending).
    fn projector(&self, blocks: &[u32]) -> Box<dyn BlockProjector + '_>;
    /// The voxels that no camera finds dark in more of the asked views than it forgives, and that
    /// some view, asked or not, sees. A view finds a voxel dark when every pixel of the voxel's
    /// support is dark; views that see too little of a voxel, and pixels less than half open, are no
    /// evidence (see [`super::Projector::brightest`]).
    fn lit(&self, views: &[ViewStack], darkness: &Darkness) -> LitBlocks;
    /// Values of a projected image: the pixels of the camera's window, row-major, and a few more
    /// that mean nothing and let the kernels write past a row's end.
    fn image_len(&self, camera: usize) -> usize;
    /// Bytes held for the whole life of the model.
    fn memory_bytes(&self) -> usize;
}

/// A [`BlockModel`] restricted to a list of active blocks.
pub trait BlockProjector: Send + Sync {
    /// Images the blocks into a view. Overwrites `image`, of [`BlockModel::image_len`] values.
    fn project(&self, view: ViewId, light: &[BlockLight], image: &mut [f32]);

    /// Makes a view of [`BlockModel::image_len`] finite values ready to be spread back: whatever is
    /// to be done to its pixels once and not again for every range of blocks.
    fn prepare(&self, view: ViewId, image: &mut [f32]);

    /// Spreads a view that went through [`Self::prepare`] back onto the voxels of the blocks in
    /// `range`: adds to `out[block − range.start]`.
    fn back_project(
        &self,
        view: ViewId,
        image: &[f32],
        range: Range<usize>,
        out: &mut [BlockLight],
    );

    /// Keeps only the blocks whose flag is set.
    fn retain(&mut self, keep: &[bool]);
}

/// The fastest block model of a bench: [`AlignedModel`] where all cameras are as drawn and look along
/// axes of the grid, else one whose cameras stand anyhow. See [`thin_lens_model`] for
/// `footprint_mm` and the errors.
pub fn block_model(
    optics: &Optics,
    poses: &[Pose],
    grid: &VolumeGrid,
    footprint_mm: f64,
    parts: &ModelParts,
) -> Result<Box<dyn BlockModel>, ModelError> {
    block_model_beside(optics, poses, &[], grid, footprint_mm, parts, &[])
}

/// [`block_model`] of cameras that are as drawn but for their `calibrations`, in their order, beside
/// another model of the same cameras and parts on another grid of the same volume: layouts
/// of the `known` ones are shared where their windows are the same.
pub fn block_model_beside(
    optics: &Optics,
    poses: &[Pose],
    calibrations: &[CameraCalibration],
    grid: &VolumeGrid,
    footprint_mm: f64,
    parts: &ModelParts,
    known: &[ViewLayout],
) -> Result<Box<dyn BlockModel>, ModelError> {
    if calibrations.iter().all(CameraCalibration::is_drawn)
        && let Some(views) = aligned_views(optics, poses, grid, footprint_mm)?
    {
        let layouts = parts.layouts(optics, &views, known);
        let model = match DepthsPerBlock::needed(optics, grid, footprint_mm) {
            DepthsPerBlock::One => aligned::<1>(optics, &views, layouts, grid, footprint_mm, parts),
            DepthsPerBlock::Two => aligned::<2>(optics, &views, layouts, grid, footprint_mm, parts),
        };
        if let Some(model) = model {
            return Ok(model);
        }
    }
    let model = mapped_model(optics, poses, calibrations, grid, footprint_mm, parts, known)?;
    if let Some(model) = model {
        return Ok(model);
    }
    if let Some(n) = calibrations.iter().position(|known| !known.is_drawn()) {
        return Err(ModelError::CalibratedTooWide { camera: CameraName(n), footprint_mm });
    }
    let model = thin_lens_model_of(optics, poses, grid, footprint_mm, parts)?;
    Ok(Box::new(VoxelwiseBlocks::new(model)))
}

/// The model with the narrowest tables that hold the footprints, if any do.
fn aligned<const D: usize>(
    optics: &Optics,
    views: &[CameraView],
    layouts: Vec<ViewLayout>,
    grid: &VolumeGrid,
    footprint_mm: f64,
    parts: &ModelParts,
) -> Option<Box<dyn BlockModel>> {
    let narrow =
        AlignedModel::<4, D>::new(optics, views, layouts.clone(), grid, footprint_mm, parts);
    if let Some(model) = narrow {
        return Some(Box::new(model));
    }
    let model = AlignedModel::<8, D>::new(optics, views, layouts, grid, footprint_mm, parts)?;
    Some(Box::new(model))
}

/// Blocks along each axis of a grid.
pub fn blocks_along(grid: &VolumeGrid) -> [usize; 3] {
    grid.voxels.map(|n| n.div_ceil(2))
}

/// Indices of a block.
pub fn block_indices(grid: &VolumeGrid, block: u32) -> [usize; 3] {
    let [nx, ny, _] = blocks_along(grid);
    let n = block as usize;
    [n % nx, n / nx % ny, n / (nx * ny)]
}

/// Position of a block's child in the grid's z, y, x order; `None` beyond the grid's end.
pub fn child_voxel(grid: &VolumeGrid, block: u32, child: usize) -> Option<u32> {
    let at = block_indices(grid, block);
    let ijk: [usize; 3] = std::array::from_fn(|axis| 2 * at[axis] + (child >> axis & 1));
    (0..3).all(|axis| ijk[axis] < grid.voxels[axis]).then(|| grid.linear(ijk) as u32)
}
