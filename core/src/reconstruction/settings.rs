//! The `[reconstruction]` table of the configuration.

use std::fmt;

use garde::Validate;
use serde::{Deserialize, Serialize};

/// The algorithm that turns views into a volume.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum Solver {
    /// Product of the line-of-sight intensities: where the other solvers start.
    Mlos,
    /// All views of a camera at once (paper, Eq. 2).
    Sart,
    /// SART over ordered subsets of views, cameras alternating (paper, Eq. 4 and Fig. 6).
    OsSart,
    /// SART on the voxels that pre-recognition keeps (paper's reference 23).
    PrSart,
    /// Multiplicative updates over ordered subsets on active voxels, pruned as it goes.
    OsMart,
}

impl fmt::Display for Solver {
    /// The solver's name in the configuration.
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        self.serialize(f)
    }
}

/// The voxels that a solver of the SART family works on.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum Domain {
    /// Those that may hold light, coarse to fine, as OS-MART does.
    Active,
    /// All voxels of the volume, none of them refined: the paper's own form (PR-SART: those that
    /// pre-recognition keeps). OS-MART has no such form.
    Volume,
}

/// What a voxel of the model looks like to the cameras.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum Footprint {
    /// A cube that glows evenly: particles may be anywhere in it.
    Voxel,
    /// A point while that explains the images, a cube otherwise: tried frame by frame.
    Auto,
    /// A point at the voxel's centre: particles known to sit on voxel centres, as in the paper's
    /// numerical cases.
    Point,
}

impl Footprint {
    /// What is modelled, and why, in one sentence.
    pub fn reason(self) -> &'static str {
        match self {
            Self::Voxel => {
                "a voxel is an evenly filled cube, because particles may be anywhere in it"
            }
            Self::Point => {
                "a voxel is a point, because the configuration says that particles sit on voxel \
                 centres"
            }
            Self::Auto => {
                "a voxel is a point while that explains the images, an evenly filled cube otherwise"
            }
        }
    }
}

/// How a volume is reconstructed.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, Validate)]
#[serde(deny_unknown_fields, default)]
pub struct ReconstructionSettings {
    /// The algorithm.
    #[garde(skip)]
    pub solver: Solver,
    /// The voxels that SART, OS-SART and PR-SART work on.
    #[garde(skip)]
    pub domain: Domain,
    /// Passes over all views; the solver's own default when absent.
    #[garde(inner(range(min = 1, max = 100_000)))]
    pub passes: Option<usize>,
    /// Views per ordered subset; the solver's own default when absent.
    #[garde(inner(range(min = 1, max = 10_000)))]
    pub views_per_subset: Option<usize>,
    /// Relaxation factor μ; the solver's own default when absent.
    #[garde(inner(range(min = 0.01, max = 1.99)))]
    pub relaxation: Option<f64>,
    /// How many voxels the solver uses along the edge of a voxel of the volume: particles between
    /// the voxels of a coarse grid fit none of them, and a finer one costs time. Solvers on
    /// active voxels start coarse and refine only what holds light; `mlos` and `domain = "volume"`
    /// work on the volume's own voxels.
    #[garde(range(min = 1, max = 4))]
    pub refinement: usize,
    /// What a voxel looks like to the cameras.
    #[garde(skip)]
    pub footprint: Footprint,
}

/// SART's passes over the whole volume by default. The paper takes 400 and more; these show the method at a bearable
/// cost.
const SART_PASSES: usize = 20;

impl ReconstructionSettings {
    /// Whether the solver works on active voxels in blocks, coarse to fine.
    pub fn on_active_voxels(&self) -> bool {
        match self.solver {
            Solver::Mlos => false,
            Solver::OsMart => true,
            Solver::Sart | Solver::OsSart | Solver::PrSart => self.domain == Domain::Active,
        }
    }

    /// Passes of SART and its kin over the whole volume.
    pub fn sart_passes(&self) -> usize {
        self.passes.unwrap_or(SART_PASSES)
    }
}

impl Default for ReconstructionSettings {
    fn default() -> Self {
        Self {
            solver: Solver::OsMart,
            domain: Domain::Active,
            passes: None,
            views_per_subset: None,
            relaxation: None,
            refinement: 4,
            footprint: Footprint::Voxel,
        }
    }
}
