//! Where the entries of the explicit matrix come from.

use lfpiv_hw::{Optics, Pose};

use super::{
    ModelError, ModelParts, ViewId, VolumeGrid,
    thin_lens::{Tabulated, tabulated},
};
use crate::lightfield::ViewLayout;

/// What one voxel gives to one pixel of a view.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Weight {
    /// Pixel of the view, row-major over the camera's microlens window.
    pub pixel: u32,
    /// Count per intensity of the voxel, as [`super::ForwardModel`] defines it; 0 where the
    /// aperture hides the pixel's whole pupil cell.
    pub weight: f32,
    /// Whether the pixel would receive a notable share ([`super::SUPPORT_SHARE`]) of the voxel's
    /// light in this view through an aperture without limit.
    pub support: bool,
}

/// Weights, computed or looked up one voxel and view at a time.
pub trait WeightSource: Send + Sync {
    /// The voxels.
    fn grid(&self) -> &VolumeGrid;
    /// The views of every camera.
    fn layouts(&self) -> &[ViewLayout];
    /// Appends the weights of a voxel (position in the grid's z, y, x order) in a view, in
    /// ascending order of pixels. Panics when there is no such view.
    fn weights(&self, view: ViewId, voxel: u32, out: &mut Vec<Weight>);
    /// Bytes held.
    fn memory_bytes(&self) -> usize;
}

/// The weights of the thin-lens tables: the explicit matrix filled from the separable footprint.
pub struct TableWeights(Box<dyn Tabulated>);

impl TableWeights {
    /// The weights that [`super::thin_lens_model`] of the same arguments uses; the same errors.
    pub fn new(
        optics: &Optics,
        poses: &[Pose],
        grid: &VolumeGrid,
        footprint_mm: f64,
    ) -> Result<Self, ModelError> {
        Self::with_parts(optics, poses, grid, footprint_mm, &ModelParts::default())
    }

    /// [`Self::new`] with these parts of the model.
    pub fn with_parts(
        optics: &Optics,
        poses: &[Pose],
        grid: &VolumeGrid,
        footprint_mm: f64,
        parts: &ModelParts,
    ) -> Result<Self, ModelError> {
        tabulated(optics, poses, grid, footprint_mm, parts).map(Self)
    }
}

impl WeightSource for TableWeights {
    fn grid(&self) -> &VolumeGrid {
        WeightSource::grid(&*self.0)
    }

    fn layouts(&self) -> &[ViewLayout] {
        WeightSource::layouts(&*self.0)
    }

    fn weights(&self, view: ViewId, voxel: u32, out: &mut Vec<Weight>) {
        self.0.weights(view, voxel, out);
    }

    fn memory_bytes(&self) -> usize {
        WeightSource::memory_bytes(&*self.0)
    }
}
