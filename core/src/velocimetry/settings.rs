//! The `[velocimetry]` table of the configuration.

use garde::Validate;
use serde::{Deserialize, Serialize};

use super::Placing;
use crate::model::VolumeGrid;

/// Displacements are searched and accepted up to this multiple of the largest expected one.
pub const SEARCH_MARGIN: f64 = 1.25;

/// How volumes are correlated.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, Validate)]
#[serde(deny_unknown_fields, default)]
pub struct VelocimetrySettings {
    /// Edge of the final interrogation windows, in mm.
    #[garde(range(min = 0.01, max = 100.0))]
    pub window_mm: f64,
    /// Overlap of neighbouring windows, as a share of their edge.
    #[garde(range(min = 0.0, max = 0.9))]
    pub overlap: f64,
    /// Correlation passes: a search on coarse cells, then passes that each deform the volumes by the
    /// last result, at least one.
    #[garde(range(min = 1, max = 20))]
    pub passes: usize,
    /// Largest displacement component to expect, in voxels. The first pass uses windows of at
    /// least four times this.
    #[garde(range(min = 0.1, max = 100.0))]
    pub max_displacement_vox: f64,
    /// Edge of the first pass's windows, in mm; derived from `max_displacement_vox` when absent.
    #[garde(inner(range(min = 0.01, max = 100.0)))]
    pub first_window_mm: Option<f64>,
    /// Track single particles between the frames after the last pass, with rejection of outliers. Not done if the
    /// reconstruction's voxels are larger than half of the configured ones.
    #[garde(skip)]
    pub follow_particles: bool,
    /// Fit particle positions to the images after correlation, and the field to the particles in both frames. Rough
    /// flows are resolved down to the particle spacing; this takes about four times as long. With
    /// [`Placing::Auto`] only for pairs that need it, and never if single particles are not tracked.
    #[garde(skip)]
    pub place_particles: Placing,
    /// The flow is incompressible: the field fitted to particles is constrained to be nearly divergence-free, which
    /// reduces its error. Not for a plane of a flow, nor for compressible gas flows.
    #[garde(skip)]
    pub incompressible: bool,
    /// Threshold of the normalised median test (Westerweel and Scarano 2005).
    #[garde(range(min = 0.5, max = 100.0))]
    pub median_threshold: f64,
    /// Fluctuation level ε of the normalised median test, in voxels.
    #[garde(range(min = 0.0, max = 10.0))]
    pub median_epsilon_vox: f64,
    /// Least ratio of the highest correlation peak to the next of an accepted vector.
    #[garde(range(min = 1.0, max = 100.0))]
    pub least_peak_ratio: f64,
    /// Least correlation coefficient of the two deformed frames at the peak of an accepted vector.
    #[garde(range(min = 0.0, max = 1.0))]
    pub least_correlation: f64,
    /// Largest standard uncertainty of a component of an accepted vector, in voxels.
    #[garde(range(min = 0.001, max = 100.0))]
    pub largest_uncertainty_vox: f64,
}

/// Window sizes and search range, in voxels of a grid.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Sizes {
    /// Edge of the final windows.
    pub window: usize,
    /// Distance between neighbouring windows.
    pub step: usize,
    /// Least edge of the search's windows.
    pub search: usize,
    /// Search range along an axis.
    pub reach: f64,
}

impl VelocimetrySettings {
    /// The sizes on `grid`; windows larger than the volume shrink to it.
    pub fn in_voxels(&self, grid: &VolumeGrid) -> Sizes {
        let smallest = grid.voxels.into_iter().min().unwrap_or(1);
        let voxels = |mm: f64| ((mm / grid.voxel_mm).round() as usize).clamp(2, smallest.max(2));
        let window = voxels(self.window_mm);
        let search = self
            .first_window_mm
            .map_or_else(|| (4.0 * self.max_displacement_vox).ceil() as usize, voxels)
            .max(window);
        Sizes {
            window,
            step: ((window as f64 * (1.0 - self.overlap)).round() as usize).max(1),
            search,
            reach: (self.max_displacement_vox * SEARCH_MARGIN).min(search as f64 / 2.0),
        }
    }
}

impl VelocimetrySettings {
    /// Voxels around the volume that are reconstructed, too: light that crosses a face between the frames must have
    /// voxels on both sides of it.
    pub fn margin_vox(&self) -> usize {
        (self.max_displacement_vox / 2.0).ceil() as usize + 1
    }

    /// Whether particles may have to be placed in the images of a volume with or without a mask, whose flows on
    /// both sides of a body the field through placed particles would mix.
    pub fn may_place(&self, has_mask: bool) -> bool {
        match self.place_particles {
            Placing::Never => false,
            Placing::Auto => self.follow_particles && !has_mask,
            Placing::Always => true,
        }
    }
}

impl Default for VelocimetrySettings {
    fn default() -> Self {
        Self {
            window_mm: 1.6,
            overlap: 0.5,
            passes: 5,
            max_displacement_vox: 6.0,
            first_window_mm: None,
            follow_particles: true,
            place_particles: Placing::Auto,
            incompressible: false,
            median_threshold: 2.0,
            median_epsilon_vox: 0.1,
            least_peak_ratio: 1.2,
            least_correlation: 0.4,
            largest_uncertainty_vox: 1.0,
        }
    }
}
