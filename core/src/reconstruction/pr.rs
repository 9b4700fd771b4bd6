//! PR-SART: pre-recognition before SART.

use super::{PassReport, SartOptions, SparseVolume, hull::mlos, sart};
use crate::{lightfield::ViewStack, model::ForwardModel};

/// SART on the voxels that pre-recognition keeps (the paper's reference 23).
///
/// Pre-recognition removes every voxel with dark lines of sight from the weight matrix. Such voxels receive no
/// light, and the row sums of Eq. 2 are over the other voxels. The reference removes a voxel for a single dark
/// line of sight; here [`mlos`] tolerates the number that noise explains.
///
/// `views` and `dark_below`, the count below which a pixel is dark, are per camera of the model.
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
