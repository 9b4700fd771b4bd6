//! OS-MART over grids from coarse to fine.
//!
//! The hull and a pass over a part of the views on the coarse grid leave the voxels near particles;
//! only these are split and corrected on the fine one.

use rayon::prelude::*;

use super::{
    BlockVolume, PassReport, ReconstructionSettings, SparseVolume,
    levels::{ViewLevels, dark_below},
    os_mart::{OsMart, Settled},
    probes::{ProjectedView, probes},
};
use crate::{
    Clock,
    clock::seconds_since,
    lightfield::{ViewLayout, ViewStack},
    model::{BlockModel, Darkness, ModelParts, ViewId, VolumeGrid},
};

/// How OS-MART works on one grid.
#[derive(Debug, Clone, Copy)]
struct Stage {
    /// Passes over `share_of_views` of the views.
    passes: usize,
    share_of_views: f64,
    /// Many small subsets find the light quickly, the mean of large ones settles its place.
    views_per_subset: usize,
    /// A voxel with less than this share of a particle's light, divided by the number of the
    /// stage's voxels in one voxel of the volume, is given up.
    prune_share: f32,
}

/// The coarse grid only has to find where light is, for which a part of the views is enough: the
/// fine one has no more to do after 0.2 of them than after 0.3.
const COARSE_STAGE: Stage =
    Stage { passes: 1, share_of_views: 0.2, views_per_subset: 2, prune_share: 0.1 };
const FINE_STAGE: Stage =
    Stage { passes: 1, share_of_views: 1.0, views_per_subset: 4, prune_share: 0.4 };
const ONLY_STAGE: Stage =
    Stage { passes: 2, share_of_views: 1.0, views_per_subset: 8, prune_share: 0.02 };

/// The hull asks the views on every third diagonal of the pupil. All of them leave a tenth (0.3 ppm)
/// to a fifth (1 ppm) fewer blocks, which the first views of OS-MART give up anyway, and cost three
/// times as much.
const HULL_DIAGONALS: i32 = 3;

/// Cameras with fewer views than this are asked for all of them.
const LEAST_VIEWS_TO_CHOOSE: usize = 120;

/// Views of a camera that may find a lit voxel dark: a few always, a share of them by noise.
const FORGIVEN: f64 = 1.0;
const NOISE_SHARE: f64 = 0.03;

/// β without noise weighting, in counts: far below any light, and no division by zero.
const UNWEIGHTED_COUNTS: f32 = 1e-3;

/// What OS-MART needs to know beside the models and the views.
#[derive(Debug, Clone, Copy)]
pub(super) struct CoarseToFine<'a> {
    pub settings: &'a ReconstructionSettings,
    pub parts: &'a ModelParts,
    /// Edge of the volume's own voxels.
    pub voxel_mm: f64,
    /// The order in which views are corrected.
    pub order: &'a [ViewId],
    /// Times the passes.
    pub clock: Clock,
}

impl CoarseToFine<'_> {
    /// Views per ordered subset on the finest of `levels` grids.
    pub fn views_per_subset(&self, levels: usize) -> usize {
        self.stage(levels - 1, levels).views_per_subset
    }

    /// Reconstructs a frame with `models`, coarse to fine, each of half the voxel's edge of the one
    /// before. `note` is called after each pass.
    pub fn reconstruct(
        &self,
        models: &[Box<dyn BlockModel>],
        views: &[ViewStack],
        levels: &[ViewLevels],
        note: &mut dyn FnMut(&PassReport),
    ) -> (SparseVolume, Vec<ProjectedView>) {
        let coarsest = models[0].as_ref();
        let lit = coarsest.lit(views, &darkness(coarsest.layouts(), levels));
        let mut volume = BlockVolume::evenly(coarsest.grid(), lit);
        scale_to_measured(coarsest, views, self.order[0], &mut volume);
        let mut done = 0;
        for (n, model) in models.iter().enumerate() {
            if n > 0 {
                volume = volume.split();
            }
            let stage = self.stage(n, models.len());
            let update = self.os_mart_update(levels, &stage, model.grid());
            let order = &self.order[..(self.order.len() as f64 * stage.share_of_views) as usize];
            let mut projector = model.projector(&volume.blocks);
            for pass in 0..stage.passes {
                let settled = if pass == 0 { Settled::No } else { Settled::Yes };
                let started = (self.clock)();
                let (model, projector) = (model.as_ref(), projector.as_mut());
                let residual = update.pass(model, views, order, &mut volume, projector, settled);
                done += 1;
                let active_voxels = volume.active_voxels();
                let seconds = seconds_since(self.clock, started);
                note(&PassReport { pass: done, residual, active_voxels, seconds });
            }
        }
        let projected = self.projected(models[models.len() - 1].as_ref(), &volume);
        (volume.into_voxels(), projected)
    }

    /// What the model makes of the volume in the views that it is judged by.
    fn projected(&self, model: &dyn BlockModel, volume: &BlockVolume) -> Vec<ProjectedView> {
        let projector = model.projector(&volume.blocks);
        probes(model.layouts())
            .into_par_iter()
            .map(|id| {
                let mut image = vec![0.0; model.image_len(id.camera)];
                projector.project(id, &volume.light, &mut image);
                image.truncate(model.layouts()[id.camera].window.len());
                ProjectedView { id, image }
            })
            .collect()
    }

    /// What to do on grid `level` of `levels`, coarse to fine.
    fn stage(&self, level: usize, levels: usize) -> Stage {
        let default = match (level, levels) {
            (_, 1) => ONLY_STAGE,
            (0, _) => COARSE_STAGE,
            _ => FINE_STAGE,
        };
        let finest = level + 1 == levels;
        Stage {
            passes: self.settings.passes.filter(|_| finest).unwrap_or(default.passes),
            views_per_subset: self.settings.views_per_subset.unwrap_or(default.views_per_subset),
            ..default
        }
    }

    fn os_mart_update(&self, levels: &[ViewLevels], stage: &Stage, grid: &VolumeGrid) -> OsMart {
        let brightest = levels.iter().map(|l| l.particle_counts).fold(0.0, f64::max) as f32;
        let refinement = (self.voxel_mm / grid.voxel_mm) as f32;
        OsMart {
            // Above 1 the multiplicative update turns intensities negative.
            relaxation: self.settings.relaxation.unwrap_or(1.0).min(1.0) as f32,
            views_per_subset: stage.views_per_subset,
            noise_counts: if self.parts.noise_weighting {
                levels.iter().map(|l| l.noise_counts as f32).collect()
            } else {
                vec![UNWEIGHTED_COUNTS; levels.len()]
            },
            prune_below: stage.prune_share * brightest / refinement.powi(3),
        }
    }
}

/// The hull's rule: see [`HULL_DIAGONALS`], [`FORGIVEN`] and [`NOISE_SHARE`].
fn darkness(layouts: &[ViewLayout], levels: &[ViewLevels]) -> Darkness {
    let asked: Vec<Vec<usize>> = layouts.iter().map(asked_views).collect();
    let forgiven = |asked: &Vec<usize>| (FORGIVEN + NOISE_SHARE * asked.len() as f64) as usize;
    Darkness {
        dark_below: dark_below(levels),
        forgiven: asked.iter().map(forgiven).collect(),
        asked,
    }
}

fn asked_views(layout: &ViewLayout) -> Vec<usize> {
    let all = layout.views.len();
    let is_asked = |&n: &usize| {
        let view = &layout.views[n];
        all < LEAST_VIEWS_TO_CHOOSE || (view.k + view.l).rem_euclid(HULL_DIAGONALS) == 0
    };
    (0..all).filter(is_asked).collect()
}

/// Scales the volume so that one view's light is right: the hull says nothing about brightness.
fn scale_to_measured(
    model: &dyn BlockModel,
    views: &[ViewStack],
    view: ViewId,
    volume: &mut BlockVolume,
) {
    let mut image = vec![0.0; model.image_len(view.camera)];
    model.projector(&volume.blocks).project(view, &volume.light, &mut image);
    let measured = views[view.camera].view(view.view);
    let sum = |values: &[f32]| values.iter().map(|&v| f64::from(v)).sum::<f64>();
    let (projected, measured) = (sum(&image[..measured.len()]), sum(measured));
    if projected > 0.0 && measured > 0.0 {
        let scale = (measured / projected) as f32;
        volume.light.as_flattened_mut().iter_mut().for_each(|light| *light *= scale);
    }
}
