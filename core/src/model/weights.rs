//! Where the entries of the explicit matrix come from.

use super::{ViewId, VolumeGrid};
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
