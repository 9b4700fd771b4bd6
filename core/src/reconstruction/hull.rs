//! The photo-hull: voxels that every line of sight finds lit.
//!
//! The MLOS start of tomographic PIV keeps a voxel when all the pixels it projects onto hold
//! light. Here a view speaks against a voxel when even the brightest pixel that the voxel reaches
//! is dark, and a voxel is dropped when more views do so than noise explains. A particle anywhere
//! inside a voxel always puts its light into that voxel's support, so the test is safe for
//! particles off the grid, at any voxel size.

use rayon::prelude::*;

use super::SparseVolume;
use crate::{
    lightfield::ViewStack,
    model::{ForwardModel, ViewId, retain},
};

/// Voxels worked on together: enough to pay for what each view prepares, few enough to bound the
/// memory that all voxels of a grid would need.
const SLAB_VOXELS: usize = 250_000;

/// Views asked between two clearances.
const VIEWS_PER_CLEARANCE: usize = 6;

/// Share of the views that may find a lit voxel dark by noise.
const NOISE_SHARE: f32 = 0.03;

/// Dark views that are always forgiven.
const FORGIVEN: f32 = 1.0;

/// The voxels of the model's grid that may hold light, each with the light that its dimmest view
/// allows, in counts. `dark_below` is, per camera, the count under which a pixel is dark. `order`
/// is the order in which views are asked.
pub fn photo_hull(
    model: &dyn ForwardModel,
    views: &[ViewStack],
    dark_below: &[f32],
    order: &[ViewId],
) -> SparseVolume {
    let total = model.grid().len();
    let slabs: Vec<(Vec<u32>, Vec<f32>)> = (0..total.div_ceil(SLAB_VOXELS))
        .into_par_iter()
        .map(|slab| {
            let start = slab * SLAB_VOXELS;
            let end = (start + SLAB_VOXELS).min(total);
            let voxels = (start as u32..end as u32).collect();
            lit_voxels(model, views, dark_below, order, voxels)
        })
        .collect();
    let mut hull =
        SparseVolume { grid: model.grid().clone(), voxels: Vec::new(), intensity: Vec::new() };
    for (voxels, intensity) in slabs {
        hull.voxels.extend(voxels);
        hull.intensity.extend(intensity);
    }
    hull
}

fn lit_voxels(
    model: &dyn ForwardModel,
    views: &[ViewStack],
    dark_below: &[f32],
    order: &[ViewId],
    mut voxels: Vec<u32>,
) -> (Vec<u32>, Vec<f32>) {
    let mut projector = model.projector(&voxels);
    let mut least = vec![f32::INFINITY; voxels.len()];
    let mut dark = vec![0.0f32; voxels.len()];
    let mut seen = vec![f32::INFINITY; voxels.len()];
    for (asked, batch) in order.chunks(VIEWS_PER_CLEARANCE).enumerate() {
        for &view in batch {
            let n = voxels.len();
            projector.brightest(view, views[view.camera].view(view.view), 0..n, &mut seen[..n]);
            let threshold = dark_below[view.camera];
            for ((least, dark), &seen) in least.iter_mut().zip(&mut dark).zip(&seen) {
                *least = least.min(seen);
                *dark += f32::from(u8::from(seen < threshold));
            }
        }
        let asked = ((asked + 1) * VIEWS_PER_CLEARANCE).min(order.len()) as f32;
        let keep: Vec<bool> =
            dark.iter().map(|&dark| dark <= FORGIVEN + NOISE_SHARE * asked).collect();
        if keep.iter().all(|&keep| keep) {
            continue;
        }
        projector.retain(&keep);
        retain(&mut voxels, &keep);
        retain(&mut least, &keep);
        retain(&mut dark, &keep);
        if voxels.is_empty() {
            break;
        }
    }
    // A voxel that no view sees holds no light that anybody could measure.
    let unseen: Vec<bool> = least.iter().map(|least| least.is_finite()).collect();
    retain(&mut voxels, &unseen);
    retain(&mut least, &unseen);
    (voxels, least)
}
