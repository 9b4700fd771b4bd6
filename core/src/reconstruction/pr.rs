//! PR-SART: pre-recognition before SART.

use super::{PassReport, SartOptions, SparseVolume, hull::mlos, sart};
use crate::{lightfield::ViewStack, model::ForwardModel};

/// SART on the voxels that pre-recognition keeps (the paper's reference 23).
///
/// Pre-recognition zeroes every voxel that lines of sight find dark, and removes it from the weight
/// matrix: no light can be smeared into such voxels, and the row sums of Eq. 2 run over the others.
/// The reference drops a voxel for a single dark line of sight; here [`mlos`] tolerates as many as
/// noise explains.
///
/// `views` and `dark_below`, the count under which a pixel is dark, are per camera of the model.
/// `observer` is called after each pass.
pub fn pr_sart(
    model: &dyn ForwardModel,
    views: &[ViewStack],
    dark_below: &[f32],
    options: &SartOptions,
    observer: &mut dyn FnMut(&PassReport, &SparseVolume),
) -> SparseVolume {
    let recognised = mlos(model, views, dark_below);
    sart(model, views, recognised.voxels, options, observer)
}
