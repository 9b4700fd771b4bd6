//! Source of the entries of the explicit matrix.

use super::{ViewId, VolumeGrid};
use crate::lightfield::ViewLayout;

/// Weight of a voxel in a pixel of a view.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Weight {
    /// Pixel of the view, row-major over the camera's microlens window.
    pub pixel: u32,
    /// Count per intensity of the voxel, as defined by [`super::ForwardModel`]; 0 if the pixel's pupil cell is
    /// closed.
    pub weight: f32,
    /// Whether the pixel would receive more than [`super::SUPPORT_SHARE`] of the voxel's light in this view
    /// through an unlimited aperture.
    pub support: bool,
}

/// Weights, computed or looked up one voxel and view at a time.
pub trait WeightSource: Send + Sync {
    /// The voxel grid.
    fn grid(&self) -> &VolumeGrid;
    /// The views of every camera.
    fn layouts(&self) -> &[ViewLayout];
    /// Appends the weights of a voxel (position in the grid's z, y, x order) in a view, in
    /// ascending order of pixels. Panics if there is no such view.
    fn weights(&self, view: ViewId, voxel: u32, out: &mut Vec<Weight>);
    /// Bytes held.
    fn memory_bytes(&self) -> usize;
}
