//! The photo-hull: voxels that are lit along every line of sight.
//!
//! The MLOS initialisation of tomographic PIV keeps a voxel if all pixels of its projection contain light. Here
//! a voxel is dark in a view if even the brightest pixel of its projection is dark, and it is removed if it is
//! dark in more views of a camera than noise explains. The light of a particle inside a voxel is always in the
//! voxel's support, so that no voxel with a particle is removed, at any voxel size.
//!
//! This is the voxel-by-voxel form for any model. [`BlockModel::lit`](super::BlockModel::lit) has faster
//! forms for block models, which are tested against it: for cameras along the grid's axes (`blocks/lit`), and for
//! arbitrarily oriented and calibrated ones (`blocks/mapped`).

use rayon::prelude::*;

use super::{ForwardModel, HullCriteria, Projector, ViewId, retain};
use crate::lightfield::ViewStack;

/// Number of voxels that are evaluated together: large enough to amortise the preparation of each view, small
/// enough to limit memory.
const SLAB_VOXELS: usize = 250_000;

/// Share of dark voxels above which removal is faster than repeated evaluation.
const LEAST_REMOVED_SHARE: f64 = 0.25;

/// Voxels that may contain light.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Hull {
    /// Positions in the grid's z, y, x order, ascending.
    pub voxels: Vec<u32>,
    /// Upper limit of each voxel's light from its dimmest view, in counts. Unselected views are used only for
    /// voxels that are not visible in a selected one.
    pub light: Vec<f32>,
}

/// The voxels of the model's grid that may contain light, by the criterion of [`super::BlockModel::lit`].
pub fn photo_hull(model: &dyn ForwardModel, views: &[ViewStack], criteria: &HullCriteria) -> Hull {
    let total = model.grid().len();
    let slabs: Vec<Hull> = (0..total.div_ceil(SLAB_VOXELS))
        .into_par_iter()
        .map(|slab| {
            let start = slab * SLAB_VOXELS;
            let end = (start + SLAB_VOXELS).min(total);
            lit_voxels(model, (start as u32..end as u32).collect(), views, criteria)
        })
        .collect();
    let mut hull = Hull::default();
    for slab in slabs {
        hull.voxels.extend(slab.voxels);
        hull.light.extend(slab.light);
    }
    hull
}

/// The lit ones of `voxels`, in order. Most voxels are removed after a few views and need no further evaluation.
fn lit_voxels(
    model: &dyn ForwardModel,
    voxels: Vec<u32>,
    views: &[ViewStack],
    criteria: &HullCriteria,
) -> Hull {
    let mut remaining = RemainingVoxels::new(model, voxels);
    for (camera, stack) in views.iter().enumerate() {
        remaining.dark.fill(0);
        for &view in &criteria.selected[camera] {
            let id = ViewId { camera, view };
            remaining.evaluate(id, stack.view(view), criteria.dark_below[camera]);
            remaining.remove_darker_than(criteria.tolerated[camera], LEAST_REMOVED_SHARE);
        }
        remaining.remove_darker_than(criteria.tolerated[camera], 0.0);
    }
    remaining.evaluate_other_views(model, views, criteria);
    // Voxels that are not visible in any view are not measured.
    let visible: Vec<bool> = remaining.light.iter().map(|light| light.is_finite()).collect();
    retain(&mut remaining.voxels, &visible);
    retain(&mut remaining.light, &visible);
    Hull { voxels: remaining.voxels, light: remaining.light }
}

/// Voxels that may be lit.
struct RemainingVoxels<'a> {
    projector: Box<dyn Projector + 'a>,
    voxels: Vec<u32>,
    /// Number of views of the current camera in which each voxel is dark.
    dark: Vec<usize>,
    /// Upper bound of the light from the dimmest view so far; infinite before any view.
    light: Vec<f32>,
    /// Brightest pixel of each voxel's support in the last evaluated view.
    brightest: Vec<f32>,
}

impl<'a> RemainingVoxels<'a> {
    fn new(model: &'a dyn ForwardModel, voxels: Vec<u32>) -> Self {
        let n = voxels.len();
        let projector = model.projector(&voxels);
        let light = vec![f32::INFINITY; n];
        Self { projector, voxels, dark: vec![0; n], light, brightest: vec![0.0; n] }
    }

    fn evaluate(&mut self, id: ViewId, image: &[f32], dark_below: f32) {
        let n = self.voxels.len();
        let brightest = &mut self.brightest[..n];
        self.projector.brightest(id, image, 0..n, brightest);
        for ((dark, light), &brightest) in
            self.dark.iter_mut().zip(&mut self.light).zip(&*brightest)
        {
            *dark += usize::from(brightest < dark_below);
            *light = light.min(brightest);
        }
    }

    /// Removes the voxels that are dark in more than `tolerated` views, if their share exceeds `share`.
    fn remove_darker_than(&mut self, tolerated: usize, share: f64) {
        let keep: Vec<bool> = self.dark.iter().map(|&dark| dark <= tolerated).collect();
        let dropped = keep.iter().filter(|&&keep| !keep).count();
        if dropped as f64 <= share * keep.len() as f64 {
            return;
        }
        self.projector.retain(&keep);
        retain(&mut self.voxels, &keep);
        retain(&mut self.dark, &keep);
        retain(&mut self.light, &keep);
    }

    /// Evaluates the other views for voxels that are not visible in any selected view.
    fn evaluate_other_views(
        &mut self,
        model: &dyn ForwardModel,
        views: &[ViewStack],
        criteria: &HullCriteria,
    ) {
        let invisible: Vec<usize> =
            (0..self.voxels.len()).filter(|&n| self.light[n].is_infinite()).collect();
        if invisible.is_empty() {
            return;
        }
        let voxels: Vec<u32> = invisible.iter().map(|&n| self.voxels[n]).collect();
        let projector = model.projector(&voxels);
        let mut brightest = vec![0.0; voxels.len()];
        for (camera, stack) in views.iter().enumerate() {
            for view in (0..stack.len()).filter(|view| !criteria.selected[camera].contains(view)) {
                let id = ViewId { camera, view };
                projector.brightest(id, stack.view(view), 0..voxels.len(), &mut brightest);
                for (&n, &brightest) in invisible.iter().zip(&brightest) {
                    self.light[n] = self.light[n].min(brightest);
                }
            }
        }
    }
}
