//! The reconstructor: views in, volume out, by the configured solver.

use std::time::Instant;

use lfpiv_hw::{Optics, Pose};

use super::{
    ReconstructionSettings, Solver, SparseVolume, hull::photo_hull, os_mart::OsMart,
    settings::Footprint, subsets::alternating_views,
};
use crate::{
    lightfield::{ViewLayout, ViewStack},
    model::{ForwardModel, ModelError, ViewId, VolumeGrid, thin_lens_model},
};

/// Passes over all views on the coarse grid and on the finest one.
const COARSE_PASSES: usize = 1;
const FINE_PASSES: usize = 2;

/// Views per subset on the coarse grid, where many updates find the light quickly, and on the
/// finest one, where their mean settles its place.
const COARSE_SUBSET: usize = 4;
const FINE_SUBSET: usize = 8;

/// A voxel with less than this share of a particle's light, spread over the voxels of its own
/// size inside one voxel of the volume, is given up.
const PRUNE_SHARE: f32 = 0.01;

/// A pixel is dark below this many noise widths plus this share of a particle's light.
const DARK_NOISE_WIDTHS: f64 = 3.0;
const DARK_PARTICLE_SHARE: f64 = 0.06;

/// The light of one particle and the noise, in one camera's views.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ViewLevels {
    /// Light of a particle in an open view, in counts.
    pub particle_counts: f64,
    /// Standard deviation of a dark pixel, in counts.
    pub noise_counts: f64,
}

impl ViewLevels {
    /// Estimates a particle's light as the views' light-weighted mean, Σ I² / Σ I less what the
    /// noise adds: for single particles their own light, for overlapping ones a little more.
    pub fn of(views: &ViewStack, noise_counts: f64) -> Self {
        let (mut sum, mut squares) = (0.0f64, 0.0f64);
        for &value in views.values() {
            sum += f64::from(value);
            squares += f64::from(value).powi(2);
        }
        let noise = views.values().len() as f64 * noise_counts.powi(2);
        let particle_counts = if sum > 0.0 { ((squares - noise) / sum).max(0.0) } else { 0.0 };
        Self { particle_counts, noise_counts }
    }

    fn dark_below(&self) -> f32 {
        (DARK_NOISE_WIDTHS * self.noise_counts + DARK_PARTICLE_SHARE * self.particle_counts) as f32
    }
}

/// Models on one or more grids, coarse to fine, and the solver to run on them.
pub struct Reconstructor {
    settings: ReconstructionSettings,
    levels: Vec<Box<dyn ForwardModel>>,
    order: Vec<ViewId>,
}

impl Reconstructor {
    /// Builds the models for a volume, which is reconstructed on `grid` refined as configured.
    pub fn new(
        optics: &Optics,
        poses: &[Pose],
        grid: &VolumeGrid,
        settings: &ReconstructionSettings,
    ) -> Result<Self, ModelError> {
        let levels = refinements(settings)
            .into_iter()
            .map(|refinement| {
                let grid = grid.refined(refinement);
                let footprint_mm = match settings.footprint {
                    Footprint::Voxel => grid.voxel_mm,
                    Footprint::Point => 0.0,
                };
                thin_lens_model(optics, poses, &grid, footprint_mm)
            })
            .collect::<Result<Vec<_>, _>>()?;
        let order = alternating_views(levels[0].layouts());
        Ok(Self { settings: settings.clone(), levels, order })
    }

    /// How raw images are to be cut into views, per camera.
    pub fn layouts(&self) -> &[ViewLayout] {
        self.levels[0].layouts()
    }

    /// Grids, coarse to fine.
    pub fn grids(&self) -> impl Iterator<Item = &VolumeGrid> {
        self.levels.iter().map(|model| model.grid())
    }

    /// Bytes of all tables.
    pub fn memory_bytes(&self) -> usize {
        self.levels.iter().map(|model| model.memory_bytes()).sum()
    }

    /// Reconstructs one frame from its views, one stack per camera.
    pub fn reconstruct(&self, views: &[ViewStack], levels: &[ViewLevels]) -> SparseVolume {
        let started = Instant::now();
        let volume = match self.settings.solver {
            Solver::Mlos => self.hull(views, levels),
            _ => self.os_mart(views, levels),
        };
        tracing::debug!(
            voxels = volume.voxels.len(),
            seconds = started.elapsed().as_secs_f64(),
            "reconstructed a frame"
        );
        volume
    }

    fn hull(&self, views: &[ViewStack], levels: &[ViewLevels]) -> SparseVolume {
        let dark_below: Vec<f32> = levels.iter().map(ViewLevels::dark_below).collect();
        photo_hull(self.levels[0].as_ref(), views, &dark_below, &self.order)
    }

    /// Coarse to fine: the hull and a pass on the coarse grid leave the voxels near particles;
    /// only these are split.
    fn os_mart(&self, views: &[ViewStack], levels: &[ViewLevels]) -> SparseVolume {
        let mut volume = self.hull(views, levels);
        let brightest = levels.iter().map(|l| l.particle_counts).fold(0.0, f64::max) as f32;
        for (n, model) in self.levels.iter().enumerate() {
            if n > 0 {
                let factor = model.grid().voxels[0] / volume.grid.voxels[0];
                volume = volume.refined(factor);
            } else {
                scale_to_measured(model.as_ref(), views, self.order[0], &mut volume);
            }
            let last = n + 1 == self.levels.len();
            let refinement = self.levels.len().min(2).pow(n as u32 + 1) as f32;
            let (passes, subset) =
                if last { (FINE_PASSES, FINE_SUBSET) } else { (COARSE_PASSES, COARSE_SUBSET) };
            let update = OsMart {
                relaxation: self.settings.relaxation.unwrap_or(1.0).min(1.0) as f32,
                views_per_subset: self.settings.views_per_subset.unwrap_or(subset),
                noise_counts: levels.iter().map(|l| l.noise_counts as f32).collect(),
                prune_below: PRUNE_SHARE * brightest / refinement.powi(3),
            };
            let passes = if last { self.settings.passes.unwrap_or(passes) } else { passes };
            let mut projector = model.projector(&volume.voxels);
            for _ in 0..passes {
                update.pass(model.as_ref(), views, &self.order, &mut volume, projector.as_mut());
            }
        }
        volume
    }
}

/// Refinements of the solver's grids, coarse to fine. The coarsest is half the finest: on a
/// coarser one particles between voxels fit so badly that nothing can be given up.
fn refinements(settings: &ReconstructionSettings) -> Vec<usize> {
    match (settings.solver, settings.refinement) {
        (Solver::OsMart, n) if n.is_multiple_of(4) => vec![n / 2, n],
        (Solver::OsMart, n) => vec![n],
        _ => vec![1],
    }
}

/// Scales the volume so that one view's light is right: the hull counts every particle's light
/// in many voxels.
fn scale_to_measured(
    model: &dyn ForwardModel,
    views: &[ViewStack],
    view: ViewId,
    volume: &mut SparseVolume,
) {
    let mut image = vec![0.0; model.layouts()[view.camera].window.len()];
    model.projector(&volume.voxels).project(view, &volume.intensity, &mut image);
    let sum = |values: &[f32]| values.iter().map(|&v| f64::from(v)).sum::<f64>();
    let (projected, measured) = (sum(&image), sum(views[view.camera].view(view.view)));
    if projected > 0.0 && measured > 0.0 {
        let scale = (measured / projected) as f32;
        volume.intensity.iter_mut().for_each(|e| *e *= scale);
    }
}
