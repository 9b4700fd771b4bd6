//! The photo-hull: voxels that are lit along every line of sight.
//!
//! The MLOS start of tomographic PIV keeps a voxel when all the pixels it projects onto hold
//! light. Here a voxel is dark in a view if even the brightest pixel within its projection is dark,
//! and it is dropped if it is dark in more views of a camera than noise explains. A particle
//! anywhere inside a voxel always puts its light into that voxel's support, so the test is safe for
//! particles off the grid, at any voxel size.
//!
//! This is the voxel-by-voxel form for any model. [`BlockModel::lit`](super::BlockModel::lit) has faster
//! forms for block models, which are tested against it: for cameras along the grid's axes (`blocks/lit`), and for
//! arbitrarily oriented and calibrated ones (`blocks/mapped`).

use rayon::prelude::*;

use super::{ForwardModel, HullCriteria, Projector, ViewId, retain};
use crate::lightfield::ViewStack;

/// Voxels worked on together: enough to pay for what each view prepares, few enough to bound the
/// memory that all voxels of a grid would need.
const SLAB_VOXELS: usize = 250_000;

/// Share of dark voxels above which removal is faster than repeated evaluation.
const SHARE_WORTH_DROPPING: f64 = 0.25;

/// Voxels that may hold light.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Hull {
    /// Positions in the grid's z, y, x order, ascending.
    pub voxels: Vec<u32>,
    /// Of each voxel, the light that the dimmest of the views allows, in counts: of the selected views,
    /// or of the others where no selected one sees the voxel.
    pub light: Vec<f32>,
}

/// The voxels of the model's grid that may hold light: see [`super::BlockModel::lit`] for the rule.
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

/// Those of `voxels` that are lit, in their order. Most voxels are dark in the first few views;
/// the others need not be evaluated for them.
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
            remaining.drop_darker_than(criteria.tolerated[camera], SHARE_WORTH_DROPPING);
        }
        remaining.drop_darker_than(criteria.tolerated[camera], 0.0);
    }
    remaining.evaluate_other_views(model, views, criteria);
    // A voxel that no view sees holds no light that anybody could measure.
    let seen: Vec<bool> = remaining.light.iter().map(|light| light.is_finite()).collect();
    retain(&mut remaining.voxels, &seen);
    retain(&mut remaining.light, &seen);
    Hull { voxels: remaining.voxels, light: remaining.light }
}

/// Voxels that may be lit.
struct RemainingVoxels<'a> {
    projector: Box<dyn Projector + 'a>,
    voxels: Vec<u32>,
    /// Views of the current camera that find the voxel dark.
    dark: Vec<usize>,
    /// Upper bound of the light from the dimmest view so far; infinite before any view.
    light: Vec<f32>,
    /// Of each voxel's support in the last evaluated view.
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

    /// Drops the voxels that more than `tolerated` views find dark, if their share exceeds `share`.
    fn drop_darker_than(&mut self, tolerated: usize, share: f64) {
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

    /// Evaluates other views for voxels that no selected view saw.
    fn evaluate_other_views(
        &mut self,
        model: &dyn ForwardModel,
        views: &[ViewStack],
        criteria: &HullCriteria,
    ) {
        let unseen: Vec<usize> =
            (0..self.voxels.len()).filter(|&n| self.light[n].is_infinite()).collect();
        if unseen.is_empty() {
            return;
        }
        let voxels: Vec<u32> = unseen.iter().map(|&n| self.voxels[n]).collect();
        let projector = model.projector(&voxels);
        let mut brightest = vec![0.0; voxels.len()];
        for (camera, stack) in views.iter().enumerate() {
            for view in (0..stack.len()).filter(|view| !criteria.selected[camera].contains(view)) {
                let id = ViewId { camera, view };
                projector.brightest(id, stack.view(view), 0..voxels.len(), &mut brightest);
                for (&n, &brightest) in unseen.iter().zip(&brightest) {
                    self.light[n] = self.light[n].min(brightest);
                }
            }
        }
    }
}
