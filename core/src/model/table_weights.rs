//! Entries of the explicit matrix from the thin-lens tables.

use lfpiv_hw::{Optics, Pose};

use super::{
    ModelError, ModelParts, ViewId, VolumeGrid,
    thin_lens::{Tabulated, tabulated},
    weights::{Weight, WeightSource},
};
use crate::lightfield::ViewLayout;

/// The weights of the thin-lens tables: the explicit matrix filled from the separable footprint.
pub struct TableWeights(Box<dyn Tabulated>);

impl TableWeights {
    /// The weights of [`super::thin_lens_model`] with the same arguments.
    ///
    /// # Errors
    /// As [`super::thin_lens_model`].
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
