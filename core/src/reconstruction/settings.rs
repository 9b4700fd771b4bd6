//! The `[reconstruction]` table of the configuration.

use std::fmt;

use garde::Validate;
use serde::{Deserialize, Serialize};

/// The reconstruction algorithm.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum Solver {
    /// Product of the line-of-sight intensities; the initial volume of the other solvers.
    Mlos,
    /// All views of a camera at once (paper, Eq. 2).
    Sart,
    /// SART over ordered subsets of views, cameras alternating (paper, Eq. 4 and Fig. 6).
    OsSart,
    /// SART on the voxels that pre-recognition keeps (paper's reference 23).
    PrSart,
    /// Multiplicative updates over ordered subsets, on active voxels, with pruning.
    OsMart,
}

impl fmt::Display for Solver {
    /// Name in the configuration.
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        self.serialize(f)
    }
}

/// The voxels on which a solver of the SART family works.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum Domain {
    /// Voxels that may contain light, coarse to fine, as OS-MART.
    Active,
    /// All voxels of the volume without refinement, as in the paper (PR-SART: those kept by
    /// pre-recognition). Not available for OS-MART.
    Volume,
}

/// Light source represented by a voxel.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum Footprint {
    /// A uniformly glowing cube: particles may be anywhere in it.
    Voxel,
    /// A point if that explains the images, otherwise a cube; decided frame by frame.
    Auto,
    /// A point at the voxel's centre: particles known to be on voxel centres, as in the paper's
    /// numerical cases.
    Point,
}

impl Footprint {
    /// The reason for this choice, in one sentence.
    pub fn reason(self) -> &'static str {
        match self {
            Self::Voxel => {
                "a voxel is a cube filled evenly with light, because particles may be anywhere in it"
            }
            Self::Point => {
                "a voxel is a point, because the configuration says that particles sit on voxel \
                 centres"
            }
            Self::Auto => {
                "a voxel is a point while that explains the images, a cube filled evenly with light otherwise"
            }
        }
    }
}

/// Settings of the reconstruction.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, Validate)]
#[serde(deny_unknown_fields, default)]
pub struct ReconstructionSettings {
    /// The algorithm.
    #[garde(skip)]
    pub solver: Solver,
    /// The voxels on which SART, OS-SART and PR-SART work.
    #[garde(skip)]
    pub domain: Domain,
    /// Passes over all views; the solver's default when absent.
    #[garde(inner(range(min = 1, max = 100_000)))]
    pub passes: Option<usize>,
    /// Views per ordered subset; the solver's default when absent.
    #[garde(inner(range(min = 1, max = 10_000)))]
    pub views_per_subset: Option<usize>,
    /// Relaxation factor μ; the solver's default when absent.
    #[garde(inner(range(min = 0.01, max = 1.99)))]
    pub relaxation: Option<f64>,
    /// Number of solver voxels along the edge of a configured voxel. On a coarse grid, particles
    /// between voxels fit none of them; a fine one costs time. Solvers on active voxels start
    /// coarse and refine only lit voxels; `mlos` and `domain = "volume"` use the configured voxels.
    #[garde(range(min = 1, max = 4))]
    pub refinement: usize,
    /// Light source represented by a voxel.
    #[garde(skip)]
    pub footprint: Footprint,
}

/// Default passes of SART over the whole volume. The paper uses 400 and more; this shows the method
/// at an acceptable cost.
const SART_PASSES: usize = 20;

impl ReconstructionSettings {
    /// Whether the solver works on blocks of active voxels, coarse to fine.
    pub fn on_active_voxels(&self) -> bool {
        match self.solver {
            Solver::Mlos => false,
            Solver::OsMart => true,
            Solver::Sart | Solver::OsSart | Solver::PrSart => self.domain == Domain::Active,
        }
    }

    /// Passes of SART, OS-SART and PR-SART over the whole volume.
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
