//! Coarse-to-fine iteration.
//!
//! The hull and a pass over some of the views on the coarse grid keep the voxels near particles. Only these are
//! refined and corrected on the fine grid.

use rayon::prelude::*;

use super::{
    BlockVolume, PassReport, ReconstructionSettings, SparseVolume,
    hull::some_views,
    levels::{ViewLevels, dark_below},
    os_mart::OsMart,
    os_sart::OsSart,
    pass::{InverseProblem, Pruning, Update},
    probes::{ProjectedView, probes},
    scheme::{Correction, Scheme, SolverStage},
};
use crate::{
    Clock,
    clock::seconds_since,
    lightfield::{ViewLayout, ViewStack},
    model::{BlockModel, ModelParts, ViewId, VolumeGrid},
};

/// β without noise weighting, in counts: negligible, but avoids division by zero.
const UNWEIGHTED_COUNTS: f32 = 1e-3;

/// Settings of a reconstruction besides models and views.
#[derive(Debug, Clone, Copy)]
pub(super) struct CoarseToFine<'a> {
    /// The solver.
    pub scheme: Scheme,
    pub settings: &'a ReconstructionSettings,
    pub parts: &'a ModelParts,
    /// Edge of the configured voxels.
    pub voxel_mm: f64,
    /// The order in which views are corrected.
    pub order: &'a [ViewId],
    /// Times the passes.
    pub clock: Clock,
}

impl CoarseToFine<'_> {
    /// Number of ordered subsets per pass on the finest of `levels` grids.
    pub fn subsets_per_pass(&self, layouts: &[ViewLayout], levels: usize) -> usize {
        self.subsets(&self.scheme.stage(levels - 1, levels, self.settings), layouts).len()
    }

    fn subsets(&self, stage: &SolverStage, layouts: &[ViewLayout]) -> Vec<Vec<ViewId>> {
        stage.subsets.of(layouts, self.order, stage.share_of_views)
    }

    /// Reconstructs a frame with `models` from coarse to fine, each with half the voxel size of the
    /// previous one. Calls `note` after each pass.
    pub fn reconstruct(
        &self,
        models: &[Box<dyn BlockModel>],
        views: &[ViewStack],
        levels: &[ViewLevels],
        note: &mut dyn FnMut(&PassReport),
    ) -> (SparseVolume, Vec<ProjectedView>) {
        let coarsest = models[0].as_ref();
        let lit = coarsest.lit(views, &some_views(coarsest.layouts(), views, dark_below(levels)));
        let mut volume = BlockVolume::with_uniform_light(coarsest.grid(), lit);
        scale_to_measured(coarsest, views, self.order[0], &mut volume);
        let mut done = 0;
        for (n, model) in models.iter().enumerate() {
            if n > 0 {
                volume = volume.split();
            }
            let stage = self.scheme.stage(n, models.len(), self.settings);
            let problem = InverseProblem { model: model.as_ref(), views };
            let mut run = StageRun { problem, stage, volume: &mut volume, done: &mut done };
            match self.scheme.correction {
                Correction::Multiplicative => {
                    self.passes(&self.os_mart(levels), levels, &mut run, note);
                }
                Correction::Additive => {
                    self.passes(&self.os_sart(levels, model.grid()), levels, &mut run, note);
                }
            }
        }
        let projected = self.projected(models[models.len() - 1].as_ref(), &volume);
        (volume.into_voxels(), projected)
    }

    /// Projects the volume into the views used for assessing the result.
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

    /// The passes of one stage.
    fn passes<U: Update>(
        &self,
        update: &U,
        levels: &[ViewLevels],
        run: &mut StageRun<'_>,
        note: &mut dyn FnMut(&PassReport),
    ) {
        let StageRun { problem, stage, volume, done } = run;
        let subsets = self.subsets(stage, problem.model.layouts());
        let particle = self.particle_counts_per_voxel(levels, problem.model.grid());
        let mut projector = problem.model.projector(&volume.blocks);
        for pass in 0..stage.passes {
            let pruning = Pruning {
                prune_below: stage.prune_share * particle.0 / particle.1,
                rising_passes: stage.rising_passes,
                passes_done: pass,
            };
            let started = (self.clock)();
            let residual = problem.pass(update, &subsets, pruning, volume, projector.as_mut());
            **done += 1;
            let active_voxels = volume.active_voxels();
            let seconds = seconds_since(self.clock, started);
            note(&PassReport { pass: **done, residual, active_voxels, seconds });
        }
    }

    /// Light of the brightest camera's particles, in counts, and voxels of `grid` per configured voxel.
    fn particle_counts_per_voxel(&self, levels: &[ViewLevels], grid: &VolumeGrid) -> (f32, f32) {
        let brightest = levels.iter().map(|l| l.particle_counts).fold(0.0, f64::max) as f32;
        let refinement = (self.voxel_mm / grid.voxel_mm) as f32;
        (brightest, refinement.powi(3))
    }

    fn os_mart(&self, levels: &[ViewLevels]) -> OsMart {
        OsMart {
            // Above 1, the multiplicative update gives negative intensities.
            relaxation: self.settings.relaxation.unwrap_or(1.0).min(1.0) as f32,
            noise_counts: if self.parts.noise_weighting {
                levels.iter().map(|l| l.noise_counts as f32).collect()
            } else {
                vec![UNWEIGHTED_COUNTS; levels.len()]
            },
        }
    }

    fn os_sart(&self, levels: &[ViewLevels], grid: &VolumeGrid) -> OsSart {
        let (brightest, voxels) = self.particle_counts_per_voxel(levels, grid);
        let weighted = self.parts.noise_weighting && brightest > 0.0;
        let share = |level: &ViewLevels| match weighted {
            true => level.noise_counts as f32 * voxels / brightest,
            false => 0.0,
        };
        OsSart {
            relaxation: self.settings.relaxation.unwrap_or(1.0) as f32,
            noise_share: levels.iter().map(share).collect(),
        }
    }
}

/// One stage of a reconstruction.
struct StageRun<'a> {
    problem: InverseProblem<'a>,
    stage: SolverStage,
    volume: &'a mut BlockVolume,
    /// Passes of all stages so far.
    done: &'a mut usize,
}

/// Scales the volume to the measured light in one view: the hull does not determine the brightness.
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
