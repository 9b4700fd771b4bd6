//! The reconstructor: views in, volume out, by the configured solver.

use std::time::Instant;

use lfpiv_hw::{Optics, Pose};

use super::{
    PassReport, ReconstructionSettings, SartOptions, Solver, SparseVolume,
    hull::photo_hull,
    levels::ViewLevels,
    os_mart::OsMart,
    pr_sart, sart,
    settings::Footprint,
    subsets::{alternating_views, balanced_subsets},
};
use crate::{
    lightfield::{ViewLayout, ViewStack},
    model::{ForwardModel, ModelError, ViewId, VolumeGrid, thin_lens_model},
};

/// OS-MART's passes over all views on the coarse grid and on the finest one.
const COARSE_PASSES: usize = 1;
const FINE_PASSES: usize = 2;

/// OS-MART's views per subset on the coarse grid, where many updates find the light quickly, and
/// on the finest one, where their mean settles its place.
const COARSE_SUBSET: usize = 4;
const FINE_SUBSET: usize = 8;

/// SART's passes by default. The paper takes 400 and more; these show the method at a bearable
/// cost.
const SART_PASSES: usize = 20;

/// Ordered subsets per camera by default: the paper's memory falls to 1/12.
const SUBSETS_PER_CAMERA: usize = 12;

/// Points on voxel centres are taken for the truth when the share of the views' light energy that
/// they leave unexplained is at most this; particles elsewhere leave nearly all of it.
const ON_GRID_UNEXPLAINED: f64 = 0.35;

/// A voxel with less than this share of a particle's light, divided by the number of the solver's
/// voxels in one voxel of the volume, is given up.
const PRUNE_SHARE: f32 = 0.02;

/// A reconstructed frame and how the solver got there.
#[derive(Debug, Clone)]
pub struct Reconstruction {
    /// The light.
    pub volume: SparseVolume,
    /// One report per pass over all views, coarse grids first. The residual of SART and its kin
    /// is that of the volume after the pass; that of OS-MART is what the pass itself met, each
    /// view's before its own correction.
    pub passes: Vec<PassReport>,
}

/// Models on one or more grids, coarse to fine, and the solver to run on them.
pub struct Reconstructor {
    settings: ReconstructionSettings,
    /// Voxels of the first model along the edge of a voxel of the volume.
    coarsest: usize,
    /// Coarse to fine.
    models: Vec<Box<dyn ForwardModel>>,
    /// Points on the volume's own grid, where the settings want them tried first.
    grid_points: Option<Box<dyn ForwardModel>>,
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
        let refinements = refinements(settings);
        let models = refinements
            .iter()
            .map(|&refinement| {
                let grid = grid.refined(refinement);
                let footprint_mm = match settings.footprint {
                    Footprint::Voxel | Footprint::Auto => grid.voxel_mm,
                    Footprint::Point => 0.0,
                };
                thin_lens_model(optics, poses, &grid, footprint_mm)
            })
            .collect::<Result<Vec<_>, _>>()?;
        let grid_points = (settings.footprint == Footprint::Auto)
            .then(|| thin_lens_model(optics, poses, grid, 0.0))
            .transpose()?;
        let order = alternating_views(models[0].layouts());
        let coarsest = refinements[0];
        Ok(Self { settings: settings.clone(), coarsest, models, grid_points, order })
    }

    /// How raw images are to be cut into views, per camera.
    pub fn layouts(&self) -> &[ViewLayout] {
        self.models[0].layouts()
    }

    /// Grids, coarse to fine.
    pub fn grids(&self) -> impl Iterator<Item = &VolumeGrid> {
        self.models.iter().map(|model| model.grid())
    }

    /// Bytes of all tables.
    pub fn memory_bytes(&self) -> usize {
        self.models.iter().chain(&self.grid_points).map(|model| model.memory_bytes()).sum()
    }

    /// Ordered subsets in one pass over all views on the finest grid.
    pub fn subsets_per_pass(&self) -> usize {
        match self.settings.solver {
            Solver::Mlos => 1,
            Solver::OsMart => {
                self.order.len().div_ceil(self.settings.views_per_subset.unwrap_or(FINE_SUBSET))
            }
            Solver::Sart | Solver::OsSart | Solver::PrSart => self.balanced().len(),
        }
    }

    /// Reconstructs one frame from its views, one stack per camera.
    pub fn reconstruct(&self, views: &[ViewStack], levels: &[ViewLevels]) -> Reconstruction {
        let on_grid = self.on_grid(views, levels);
        let explained = on_grid.is_some();
        if self.settings.solver == Solver::OsMart
            && let Some(reconstruction) = on_grid
        {
            return reconstruction;
        }
        let model = match &self.grid_points {
            Some(points) if explained => points.as_ref(),
            _ => self.models[0].as_ref(),
        };
        let all_voxels = || (0..model.grid().len() as u32).collect();
        let mut passes = Vec::new();
        let mut note = |report: &PassReport, _: &SparseVolume| passes.push(*report);
        let volume = match self.settings.solver {
            Solver::Mlos => self.hull(model, views, levels),
            Solver::OsMart => self.os_mart(&self.models, views, levels, &mut note),
            Solver::Sart | Solver::OsSart => {
                sart(model, views, all_voxels(), &self.sart_options(), &mut note)
            }
            Solver::PrSart => {
                pr_sart(model, views, &dark_below(levels), &self.sart_options(), &mut note)
            }
        };
        for report in &passes {
            tracing::debug!(
                pass = report.pass,
                residual = report.residual,
                active_voxels = report.active_voxels,
                seconds = report.seconds,
                "solver pass"
            );
        }
        Reconstruction { volume, passes }
    }

    fn sart_options(&self) -> SartOptions {
        SartOptions {
            relaxation: self.settings.relaxation.unwrap_or(1.0) as f32,
            passes: self.settings.passes.unwrap_or(SART_PASSES),
            subsets: self.balanced(),
        }
    }

    /// The paper's subsets; for SART and PR-SART all views of a camera at once.
    fn balanced(&self) -> Vec<Vec<ViewId>> {
        let per_camera = match (self.settings.solver, self.settings.views_per_subset) {
            (Solver::OsSart, None) => SUBSETS_PER_CAMERA,
            (Solver::OsSart, Some(views)) => self.layouts()[0].views.len().div_ceil(views),
            _ => 1,
        };
        balanced_subsets(self.layouts(), per_camera)
    }

    /// What points on the volume's own grid make of the views, if they explain them.
    fn on_grid(&self, views: &[ViewStack], levels: &[ViewLevels]) -> Option<Reconstruction> {
        let points = self.grid_points.as_ref()?;
        let mut passes = Vec::new();
        let mut note = |report: &PassReport, _: &SparseVolume| passes.push(*report);
        let volume = self.os_mart(std::slice::from_ref(points), views, levels, &mut note);
        let unexplained = unexplained_share(passes.last()?.residual, views, levels);
        let explained = unexplained <= ON_GRID_UNEXPLAINED;
        tracing::debug!(unexplained, explained, "points on voxel centres");
        explained.then_some(Reconstruction { volume, passes })
    }

    fn hull(
        &self,
        model: &dyn ForwardModel,
        views: &[ViewStack],
        levels: &[ViewLevels],
    ) -> SparseVolume {
        photo_hull(model, views, &dark_below(levels), &self.order)
    }

    /// Coarse to fine: the hull and a pass on the coarse grid leave the voxels near particles;
    /// only these are split.
    fn os_mart(
        &self,
        models: &[Box<dyn ForwardModel>],
        views: &[ViewStack],
        levels: &[ViewLevels],
        observer: &mut dyn FnMut(&PassReport, &SparseVolume),
    ) -> SparseVolume {
        let mut volume = self.hull(models[0].as_ref(), views, levels);
        scale_to_measured(models[0].as_ref(), views, self.order[0], &mut volume);
        let mut done = 0;
        for (n, model) in models.iter().enumerate() {
            let split = model.grid().voxels[0] / volume.grid.voxels[0];
            if split > 1 {
                volume = volume.refined(split);
            }
            let last = n + 1 == models.len();
            let passes =
                if last { self.settings.passes.unwrap_or(FINE_PASSES) } else { COARSE_PASSES };
            let refinement = self.refinement_of(model.as_ref());
            let update = self.os_mart_update(levels, refinement, last);
            let mut projector = model.projector(&volume.voxels);
            for _ in 0..passes {
                let started = Instant::now();
                let (model, projector) = (model.as_ref(), projector.as_mut());
                let residual = update.pass(model, views, &self.order, &mut volume, projector);
                done += 1;
                let active_voxels = volume.voxels.len();
                let seconds = started.elapsed().as_secs_f64();
                observer(&PassReport { pass: done, residual, active_voxels, seconds }, &volume);
            }
        }
        volume
    }

    /// Voxels of a model along the edge of a voxel of the volume.
    fn refinement_of(&self, model: &dyn ForwardModel) -> usize {
        let per_voxel = |model: &dyn ForwardModel| model.grid().voxels[0];
        per_voxel(model) * self.coarsest / per_voxel(self.models[0].as_ref())
    }

    fn os_mart_update(&self, levels: &[ViewLevels], refinement: usize, last: bool) -> OsMart {
        let brightest = levels.iter().map(|l| l.particle_counts).fold(0.0, f64::max) as f32;
        let subset = if last { FINE_SUBSET } else { COARSE_SUBSET };
        OsMart {
            // Above 1 the multiplicative update turns intensities negative.
            relaxation: self.settings.relaxation.unwrap_or(1.0).min(1.0) as f32,
            views_per_subset: self.settings.views_per_subset.unwrap_or(subset),
            noise_counts: levels.iter().map(|l| l.noise_counts as f32).collect(),
            prune_below: PRUNE_SHARE * brightest / refinement.pow(3) as f32,
        }
    }
}

/// The share of Σ I² that a residual stands for, less what noise alone would leave.
fn unexplained_share(residual: f64, views: &[ViewStack], levels: &[ViewLevels]) -> f64 {
    let square = |value: f32| f64::from(value).powi(2);
    let seen: f64 = views.iter().flat_map(|v| v.values()).map(|&value| square(value)).sum();
    let noise: f64 = views
        .iter()
        .zip(levels)
        .map(|(view, level)| view.values().len() as f64 * level.noise_counts.powi(2))
        .sum();
    if seen > noise { ((residual.powi(2) * seen - noise) / (seen - noise)).max(0.0) } else { 1.0 }
}

fn dark_below(levels: &[ViewLevels]) -> Vec<f32> {
    levels.iter().map(ViewLevels::dark_below).collect()
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
