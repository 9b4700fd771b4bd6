//! Definitions of the iterative solvers: their update, subsets of views, and passes per grid.
//! Everything else is shared in [`InverseProblem::pass`](super::pass::InverseProblem::pass).

use super::{Solver, settings::ReconstructionSettings, subsets::balanced_subsets};
use crate::{lightfield::ViewLayout, model::ViewId};

/// Update of a solver.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Correction {
    /// [`OsMart`](super::os_mart::OsMart).
    Multiplicative,
    /// [`OsSart`](super::os_sart::OsSart).
    Additive,
}

/// Subsets of views that are corrected together.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Subsets {
    /// This many views in random order, cameras alternating within a subset.
    Random(usize),
    /// This many views of one camera, distributed evenly over the pupil; cameras
    /// alternate (Eq. 4).
    Balanced(usize),
    /// All views of a camera.
    Camera,
}

impl Subsets {
    /// Divides a share of the views. `order` contains all views in random order.
    pub fn of(self, layouts: &[ViewLayout], order: &[ViewId], share: f64) -> Vec<Vec<ViewId>> {
        let per_camera = match self {
            Self::Random(views) => {
                let selected = &order[..(order.len() as f64 * share) as usize];
                return selected.chunks(views.max(1)).map(<[ViewId]>::to_vec).collect();
            }
            Self::Balanced(views) => layouts[0].views.len().div_ceil(views.max(1)),
            Self::Camera => 1,
        };
        let mut subsets = balanced_subsets(layouts, per_camera);
        subsets.truncate((subsets.len() as f64 * share).ceil() as usize);
        subsets
    }
}

/// Passes of a solver on one grid.
#[derive(Debug, Clone, Copy)]
pub(super) struct SolverStage {
    /// Passes over `share_of_views` of the views.
    pub passes: usize,
    pub share_of_views: f64,
    /// Many small subsets locate the light quickly; averages over large ones refine its position.
    pub subsets: Subsets,
    /// Pruning threshold, as a share of a particle's light divided by the number of the stage's
    /// voxels per configured voxel.
    pub prune_share: f32,
    /// Passes over which the threshold rises to its full value.
    pub rising_passes: usize,
}

/// A solver on active voxels.
#[derive(Debug, Clone, Copy)]
pub(super) struct Scheme {
    pub correction: Correction,
    /// For the coarser of two grids.
    coarse: SolverStage,
    /// For the finer of two grids.
    fine: SolverStage,
    /// For a single grid.
    only: SolverStage,
}

/// A stage whose threshold rises over one pass. The coarse grid only has to locate the light, for which a part
/// of the views suffices: the result of OS-MART's fine stage is not better after 0.3 of them than after 0.2.
const fn stage(
    passes: usize,
    share_of_views: f64,
    subsets: Subsets,
    prune_share: f32,
) -> SolverStage {
    SolverStage { passes, share_of_views, subsets, prune_share, rising_passes: 1 }
}

const OS_SART: Scheme = Scheme {
    correction: Correction::Additive,
    coarse: stage(1, 0.2, Subsets::Balanced(2), 0.1),
    fine: stage(2, 1.0, Subsets::Balanced(4), 0.4),
    only: stage(3, 1.0, Subsets::Balanced(4), 0.02),
};

/// Two corrections per pass: dim voxels are identified only after several of them.
const SART: Scheme = Scheme {
    correction: Correction::Additive,
    coarse: SolverStage { rising_passes: 2, ..stage(2, 1.0, Subsets::Camera, 0.1) },
    fine: SolverStage { rising_passes: 8, ..stage(8, 1.0, Subsets::Camera, 0.4) },
    only: SolverStage { rising_passes: 20, ..stage(20, 1.0, Subsets::Camera, 0.02) },
};

/// SART on the photo-hull, without later pruning.
const PR_SART: Scheme = Scheme {
    correction: Correction::Additive,
    coarse: stage(0, 1.0, Subsets::Camera, 0.0),
    fine: stage(8, 1.0, Subsets::Camera, 0.0),
    only: stage(20, 1.0, Subsets::Camera, 0.0),
};

impl Scheme {
    /// OS-MART.
    pub const OS_MART: Self = Self {
        correction: Correction::Multiplicative,
        coarse: stage(1, 0.2, Subsets::Random(2), 0.1),
        fine: stage(1, 1.0, Subsets::Random(4), 0.4),
        only: stage(2, 1.0, Subsets::Random(8), 0.02),
    };

    /// `None` for a non-iterative solver.
    pub fn of(solver: Solver) -> Option<Self> {
        match solver {
            Solver::Mlos => None,
            Solver::OsMart => Some(Self::OS_MART),
            Solver::OsSart => Some(OS_SART),
            Solver::Sart => Some(SART),
            Solver::PrSart => Some(PR_SART),
        }
    }

    /// The stage for grid `level` of `levels`, coarse to fine, with the settings applied.
    pub fn stage(
        &self,
        level: usize,
        levels: usize,
        settings: &ReconstructionSettings,
    ) -> SolverStage {
        let default = match (level, levels) {
            (_, 1) => self.only,
            (0, _) => self.coarse,
            _ => self.fine,
        };
        let finest = level + 1 == levels;
        let subsets = match (default.subsets, settings.views_per_subset) {
            (Subsets::Random(_), Some(views)) => Subsets::Random(views),
            (Subsets::Balanced(_), Some(views)) => Subsets::Balanced(views),
            (subsets, _) => subsets,
        };
        let passes = settings.passes.filter(|_| finest).unwrap_or(default.passes);
        SolverStage { passes, subsets, ..default }
    }
}
