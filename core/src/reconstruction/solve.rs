//! Reconstruction of a volume from views with the configured solver.

use lfpiv_hw::{CameraName, Optics, Pose};

use super::{
    PassReport, ReconstructionSettings, SartOptions, Solver, SparseVolume,
    coarse_to_fine::CoarseToFine,
    hull::mlos,
    levels::{ViewLevels, dark_below},
    pr_sart,
    probes::{ProjectedView, projected},
    sart,
    scheme::Scheme,
    settings::Footprint,
    subsets::{alternating_views, balanced_subsets},
};
use crate::{
    Clock,
    clock::untimed,
    lightfield::{ViewLayout, ViewStack},
    model::{
        BlockModel, CameraCalibration, ForwardModel, ModelError, ModelParts, ViewId, VolumeGrid,
        block_model_beside, thin_lens_model_of,
    },
};

/// Default number of ordered subsets per camera over the whole volume: reduces the paper's memory
/// to 1/12.
const SUBSETS_PER_CAMERA: usize = 12;

/// Particles are assumed to be on voxel centres if points there leave at most this share of the
/// views' light energy unexplained; for particles elsewhere nearly all of it is unexplained
/// (docs/decisions.md, "Fitted constants").
const ON_GRID_UNEXPLAINED: f64 = 0.35;

/// A reconstructed frame with its convergence.
#[derive(Debug, Clone)]
pub struct Reconstruction {
    /// The light.
    pub volume: SparseVolume,
    /// One report per pass over all views, coarse grids first. On the whole volume the residual is
    /// that after the pass; on active voxels it is that during the pass, each view measured before
    /// its own correction.
    pub passes: Vec<PassReport>,
    /// Projections of the volume into some views of every camera, for comparison with the images.
    pub projected: Vec<ProjectedView>,
}

/// Models on one or more grids, coarse to fine, with the solver.
pub struct Reconstructor {
    settings: ReconstructionSettings,
    parts: ModelParts,
    /// Edge of the configured voxels.
    voxel_mm: f64,
    models: Models,
    /// Points on the configured grid, if they are to be tried first.
    grid_points: Option<Box<dyn BlockModel>>,
    order: Vec<ViewId>,
    clock: Clock,
}

/// Models of the solver.
enum Models {
    /// Blocks of active voxels, coarse to fine.
    Blocks(Vec<Box<dyn BlockModel>>),
    /// Individual voxels of the configured grid, filled or as points.
    Voxels { filled: Box<dyn ForwardModel>, points: Option<Box<dyn ForwardModel>> },
}

impl Models {
    fn layouts(&self) -> &[ViewLayout] {
        match self {
            Self::Blocks(models) => models[0].layouts(),
            Self::Voxels { filled, .. } => filled.layouts(),
        }
    }

    fn memory_bytes(&self) -> usize {
        match self {
            Self::Blocks(models) => models.iter().map(|model| model.memory_bytes()).sum(),
            Self::Voxels { filled, points } => {
                filled.memory_bytes() + points.as_ref().map_or(0, |model| model.memory_bytes())
            }
        }
    }
}

impl Reconstructor {
    /// Builds the models for a volume on `grid`, refined as configured.
    pub fn new(
        optics: &Optics,
        poses: &[Pose],
        grid: &VolumeGrid,
        settings: &ReconstructionSettings,
    ) -> Result<Self, ModelError> {
        Self::with_parts(optics, poses, &[], grid, settings, ModelParts::default())
    }

    /// As [`Self::new`], with these parts of the forward model. Cameras are ideal except for their
    /// `calibrations`, which are in the order of the cameras.
    ///
    /// # Errors The volume is not in the field of a camera, or cameras are calibrated and the solver works on
    /// the whole volume.
    pub fn with_parts(
        optics: &Optics,
        poses: &[Pose],
        calibrations: &[CameraCalibration],
        grid: &VolumeGrid,
        settings: &ReconstructionSettings,
        parts: ModelParts,
    ) -> Result<Self, ModelError> {
        let auto = settings.footprint == Footprint::Auto;
        let points = || thin_lens_model_of(optics, poses, grid, 0.0, &parts);
        let models = if settings.on_active_voxels() {
            let mut models: Vec<Box<dyn BlockModel>> = Vec::new();
            for refinement in refinements(settings) {
                let grid = grid.refined(refinement);
                let footprint_mm = footprint_mm(settings, &grid);
                let known = models.first().map_or(&[][..], |model| model.layouts());
                models.push(block_model_beside(
                    optics,
                    poses,
                    calibrations,
                    &grid,
                    footprint_mm,
                    &parts,
                    known,
                )?);
            }
            Models::Blocks(models)
        } else if let Some(n) = calibrations.iter().position(|known| !known.is_nominal()) {
            return Err(ModelError::CalibratedWholeVolume { camera: CameraName(n) });
        } else {
            Models::Voxels {
                filled: thin_lens_model_of(
                    optics,
                    poses,
                    grid,
                    footprint_mm(settings, grid),
                    &parts,
                )?,
                points: auto.then(points).transpose()?,
            }
        };
        let grid_points = auto
            .then(|| block_model_beside(optics, poses, calibrations, grid, 0.0, &parts, &[]))
            .transpose()?;
        let order = alternating_views(models.layouts());
        Ok(Self {
            settings: settings.clone(),
            parts,
            voxel_mm: grid.voxel_mm,
            models,
            grid_points,
            order,
            clock: untimed,
        })
    }

    /// Times the passes with `clock`.
    pub fn timed_by(self, clock: Clock) -> Self {
        Self { clock, ..self }
    }

    /// Layout of the views per camera.
    pub fn layouts(&self) -> &[ViewLayout] {
        self.models.layouts()
    }

    /// Grids, coarse to fine.
    pub fn grids(&self) -> Vec<&VolumeGrid> {
        match &self.models {
            Models::Blocks(models) => models.iter().map(|model| model.grid()).collect(),
            Models::Voxels { filled, .. } => vec![filled.grid()],
        }
    }

    /// Bytes of all tables.
    pub fn memory_bytes(&self) -> usize {
        self.models.memory_bytes() + self.grid_points.as_ref().map_or(0, |m| m.memory_bytes())
    }

    /// Ordered subsets per pass over all views on the finest grid.
    pub fn subsets_per_pass(&self) -> usize {
        match (&self.models, self.settings.solver) {
            (Models::Blocks(models), _) => {
                self.coarse_to_fine().subsets_per_pass(self.layouts(), models.len())
            }
            (_, Solver::Mlos) => 1,
            _ => self.balanced().len(),
        }
    }

    /// Reconstructs one frame from its views, one stack per camera.
    pub fn reconstruct(&self, views: &[ViewStack], levels: &[ViewLevels]) -> Reconstruction {
        let on_grid = self.on_grid(views, levels);
        let mut passes = Vec::new();
        let mut note = |report: &PassReport| passes.push(*report);
        let (volume, projected) = match &self.models {
            Models::Blocks(models) => match on_grid {
                Some(reconstruction) => return reconstruction,
                None => self.coarse_to_fine().reconstruct(models, views, levels, &mut note),
            },
            Models::Voxels { filled, points } => {
                let model = match points {
                    Some(points) if on_grid.is_some() => points,
                    _ => filled,
                };
                let volume = self.voxelwise(model.as_ref(), views, levels, &mut note);
                let projected = projected(model.as_ref(), &volume);
                (volume, projected)
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
        Reconstruction { volume, passes, projected }
    }

    /// The solvers on the configured voxels.
    fn voxelwise(
        &self,
        model: &dyn ForwardModel,
        views: &[ViewStack],
        levels: &[ViewLevels],
        note: &mut dyn FnMut(&PassReport),
    ) -> SparseVolume {
        let mut note = |report: &PassReport, _: &SparseVolume| note(report);
        match self.settings.solver {
            Solver::Sart | Solver::OsSart => {
                let all_voxels = (0..model.grid().len() as u32).collect();
                sart(model, views, all_voxels, &self.sart_options(), &mut note)
            }
            Solver::PrSart => {
                pr_sart(model, views, &dark_below(levels), &self.sart_options(), &mut note)
            }
            // OS-MART needs blocks; only its initial volume is available here.
            Solver::Mlos | Solver::OsMart => mlos(model, views, &dark_below(levels)),
        }
    }

    fn sart_options(&self) -> SartOptions {
        SartOptions {
            relaxation: self.settings.relaxation.unwrap_or(1.0) as f32,
            passes: self.settings.sart_passes(),
            subsets: self.balanced(),
            clock: self.clock,
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

    fn coarse_to_fine(&self) -> CoarseToFine<'_> {
        CoarseToFine {
            scheme: self.scheme(),
            settings: &self.settings,
            parts: &self.parts,
            voxel_mm: self.voxel_mm,
            order: &self.order,
            clock: self.clock,
        }
    }

    /// The solver on active voxels. For solvers on the whole volume OS-MART decides whether
    /// particles are on voxel centres.
    fn scheme(&self) -> Scheme {
        let own = Scheme::of(self.settings.solver).filter(|_| self.settings.on_active_voxels());
        own.unwrap_or(Scheme::OS_MART)
    }

    /// The reconstruction with points on the configured grid, if it explains the views.
    fn on_grid(&self, views: &[ViewStack], levels: &[ViewLevels]) -> Option<Reconstruction> {
        let points = self.grid_points.as_ref()?;
        let mut passes = Vec::new();
        let mut note = |report: &PassReport| passes.push(*report);
        let models = std::slice::from_ref(points);
        let (volume, projected) =
            self.coarse_to_fine().reconstruct(models, views, levels, &mut note);
        let unexplained = unexplained_share(passes.last()?.residual, views, levels);
        let explained = unexplained <= ON_GRID_UNEXPLAINED;
        tracing::debug!(unexplained, explained, "points on voxel centres");
        explained.then_some(Reconstruction { volume, passes, projected })
    }
}

/// The unexplained share of Σ I² for a residual, minus the expected noise.
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

/// Refinements of the solver's grids, coarse to fine. The coarsest has half the finest voxel count:
/// on a coarser one, particles between voxels fit so poorly that no voxel can be pruned.
fn refinements(settings: &ReconstructionSettings) -> Vec<usize> {
    match settings.refinement {
        n if n.is_multiple_of(4) => vec![n / 2, n],
        n => vec![n],
    }
}

/// Edge of the light source represented by a voxel of `grid`.
fn footprint_mm(settings: &ReconstructionSettings, grid: &VolumeGrid) -> f64 {
    match settings.footprint {
        Footprint::Voxel | Footprint::Auto => grid.voxel_mm,
        Footprint::Point => 0.0,
    }
}
