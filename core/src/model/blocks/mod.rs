//! The model in blocks of 2 × 2 × 2 voxels, for solvers that work on active voxels only.
//!
//! Neighbouring voxels share most of a projection's cost: finding their microlenses, and accessing the pixels.
//! [`AlignedModel`] is used if every camera is ideal and along an axis of the grid, [`mapped`] for all others.
//! [`VoxelwiseBlocks`] computes the same sums voxel by voxel through any [`ForwardModel`], and is the reference
//! in tests.
//!
//! Voxel (i, j, k) is child `(i % 2) + 2 (j % 2) + 4 (k % 2)` of block (i/2, j/2, k/2). If the grid
//! has an odd number of voxels, the children outside it stay dark.

mod aligned;
mod aligned_tables;
mod axis_table;
mod child_order;
mod dark_counts;
#[expect(clippy::needless_range_loop, reason = "plain loops become vector instructions")]
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

/// Blocks that may contain light.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct LitBlocks {
    /// Indices in the block grid's z, y, x order, ascending.
    pub blocks: Vec<u32>,
    /// For each block a bit per child that may contain light; never 0.
    pub children: Vec<u8>,
}

/// Criteria of the photo-hull.
#[derive(Debug, Clone, PartialEq)]
pub struct HullCriteria {
    /// Per camera, the selected views, ascending.
    pub selected: Vec<Vec<usize>>,
    /// Per camera, the count below which a pixel is dark.
    pub dark_below: Vec<f32>,
    /// Per camera, the number of selected views in which a lit voxel may be dark.
    pub tolerated: Vec<usize>,
    /// Per camera, the largest displacement of voxels in any view, in microlenses, for the joint evaluation of
    /// several voxels. Their supports are widened by the actual displacement.
    pub displacement: Vec<f64>,
}

/// A linear map from voxel intensities to pixels as [`super::ForwardModel`] defines it, block by block.
pub trait BlockModel: Send + Sync {
    /// The voxel grid.
    fn grid(&self) -> &VolumeGrid;
    /// The views of every camera.
    fn layouts(&self) -> &[ViewLayout];
    /// A projector for these blocks (indices in the block grid's z, y, x order, ascending).
    fn projector(&self, blocks: &[u32]) -> Box<dyn BlockProjector + '_>;
    /// The photo-hull: voxels that are visible in any view, selected or not, and in no camera dark in more of
    /// the selected views than tolerated. A voxel is dark in a view if every pixel of its support is dark.
    /// Views with too little of a voxel's light, and pixels less than half open, are no evidence (see
    /// [`super::Projector::brightest`]).
    fn lit(&self, views: &[ViewStack], criteria: &HullCriteria) -> LitBlocks;
    /// Length of a projected image: the pixels of the camera's window, row-major, followed by
    /// padding that lets the kernels write past a row's end.
    fn image_len(&self, camera: usize) -> usize;
    /// Bytes held by the model.
    fn memory_bytes(&self) -> usize;
}

/// A [`BlockModel`] restricted to a list of active blocks.
pub trait BlockProjector: Send + Sync {
    /// Projects the blocks into a view. Overwrites `image`, of [`BlockModel::image_len`] values.
    fn project(&self, view: ViewId, light: &[BlockLight], image: &mut [f32]);

    /// Prepares a view of [`BlockModel::image_len`] finite values for back-projection: operations
    /// on pixels that are needed once and not for every range of blocks.
    fn prepare(&self, view: ViewId, image: &mut [f32]);

    /// Back-projects a prepared view onto the voxels of the blocks in `range`: adds to `out[block −
    /// range.start]`.
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

/// The fastest block model of a bench: [`AlignedModel`] if all cameras are ideal and along axes of the
/// grid, otherwise one for arbitrarily oriented cameras. See [`thin_lens_model`] for
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

/// As [`block_model`], for cameras that are ideal except for their `calibrations` (in the order of
/// the cameras). Shares the `known` layouts of a model of the same cameras and parts on another
/// grid of the same volume, if their windows are the same.
pub fn block_model_beside(
    optics: &Optics,
    poses: &[Pose],
    calibrations: &[CameraCalibration],
    grid: &VolumeGrid,
    footprint_mm: f64,
    parts: &ModelParts,
    known: &[ViewLayout],
) -> Result<Box<dyn BlockModel>, ModelError> {
    if calibrations.iter().all(CameraCalibration::is_nominal)
        && let Some(views) = aligned_views(optics, poses, grid, footprint_mm)?
    {
        let layouts = parts.layouts(optics, views.iter().map(|view| &view.window), known);
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
    if let Some(n) = calibrations.iter().position(|known| !known.is_nominal()) {
        return Err(ModelError::CalibratedTooWide { camera: CameraName(n), footprint_mm });
    }
    let model = thin_lens_model_of(optics, poses, grid, footprint_mm, parts)?;
    Ok(Box::new(VoxelwiseBlocks::new(model)))
}

/// The model with the narrowest sufficient tables, if there is one.
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

/// Number of blocks along each axis of a grid.
pub fn blocks_along(grid: &VolumeGrid) -> [usize; 3] {
    grid.voxels.map(|n| n.div_ceil(2))
}

/// Indices of a block.
pub fn block_indices(grid: &VolumeGrid, block: u32) -> [usize; 3] {
    let [nx, ny, _] = blocks_along(grid);
    let n = block as usize;
    [n % nx, n / nx % ny, n / (nx * ny)]
}

/// Index of a block's child in the grid's z, y, x order; `None` outside the grid.
pub fn child_voxel(grid: &VolumeGrid, block: u32, child: usize) -> Option<u32> {
    let at = block_indices(grid, block);
    let ijk: [usize; 3] = std::array::from_fn(|axis| 2 * at[axis] + (child >> axis & 1));
    (0..3).all(|axis| ijk[axis] < grid.voxels[axis]).then(|| grid.linear(ijk) as u32)
}
