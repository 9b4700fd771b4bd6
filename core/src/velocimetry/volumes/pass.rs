//! One pass over whole volumes: its windows, cells and lags.

use super::{
    correlation::Correlation, light::CellLight, profile::Profile,
    statistics::statistics_at_zero_lag, warp::warped,
};
use crate::{
    model::VolumeGrid,
    velocimetry::{
        lags::Lags,
        lattice::Lattice,
        peak::{Peak, highest_peak, nearest_peak, ratio_at_zero_lag},
        uncertainty::PeakStatistics,
        windows::Windows,
    },
};

/// Windows on cells of whole voxels, starting at the volume's corner, and the lags that are evaluated.
#[derive(Debug, Clone)]
pub struct Pass {
    /// The windows.
    pub windows: Windows,
    /// How they weigh their cells.
    pub profile: Profile,
    /// The lags.
    pub lags: Lags,
}

/// Result of a pass.
pub struct PassResult {
    /// The displacement of every window after the pass.
    pub field: Lattice,
    /// The correlation peak of every window, where there is one.
    pub peaks: Vec<Option<Peak>>,
}

/// Whether a grid is a single layer of voxels: a plane of a flow.
pub fn is_layer(grid: &VolumeGrid) -> bool {
    grid.voxels[2] == 1
}

/// Least edge of a window, in cells, that can contain a peak.
const LEAST_EDGE: usize = 4;

impl Pass {
    /// Windows of about `edge_vox` voxels, `step_vox` apart, on cells of `cell_vox` voxels. On a single layer of
    /// voxels windows are squares.
    pub fn new(
        grid: &VolumeGrid,
        cell_vox: usize,
        [edge_vox, step_vox]: [usize; 2],
        profile: impl Fn(usize) -> Profile,
        lags: Lags,
    ) -> Self {
        let cells = grid.voxels.map(|n| (n / cell_vox).max(1));
        let flat = is_layer(grid);
        let smallest = cells[..if flat { 2 } else { 3 }].iter().copied().min().unwrap_or(1);
        let in_cells = |voxels: usize| (voxels as f64 / cell_vox as f64).round() as usize;
        let edge = in_cells(edge_vox).max(LEAST_EDGE).min(smallest);
        let step = in_cells(step_vox).clamp(1, edge);
        let centre = cell_vox as f32 * edge as f32 / 2.0 - 0.5;
        let windows = Windows {
            nodes: cells.map(|n| n.saturating_sub(edge) / step + 1),
            edge,
            step,
            cell_vox: cell_vox as f32,
            first_vox: [centre, centre, if flat { 0.0 } else { centre }],
        };
        Self { windows, profile: profile(edge).on_layer(flat), lags }
    }

    /// Edge of a cell, in voxels.
    pub fn cell_vox(&self) -> usize {
        self.windows.cell_vox as usize
    }

    /// Correlates two frames as they are.
    pub fn search(&self, frames: [&CellLight; 2]) -> PassResult {
        self.found(self.windows.at_rest(), frames, |values| highest_peak(self.lags, values))
    }

    /// `field` on this stage's windows, and frame b warped by it.
    pub fn warp(&self, field: &Lattice, b: &CellLight) -> (Lattice, CellLight) {
        let own = self.windows.at_rest();
        let known =
            if own.is_over(field) { field.clone() } else { own.sampling(|at| field.at(at)) };
        let moved = warped(b, &known, self.lags.border());
        (known, moved)
    }

    /// Corrects the field by which frame b was warped, from the lags next to zero.
    pub fn correct(&self, known: Lattice, frames: [&CellLight; 2]) -> PassResult {
        self.found(known, frames, nearest_peak)
    }

    /// Ratio of every window's peak at zero lag to its secondary peaks (x component; see [`ratio_at_zero_lag`]),
    /// for warped frames.
    pub fn ratios(&self, frames: [&CellLight; 2]) -> Lattice {
        let ratio = |values: &[f32]| [ratio_at_zero_lag(self.lags, values), 0.0, 0.0];
        let values =
            Correlation::new(&self.windows, &self.profile, self.lags, frames).of_windows(ratio);
        Lattice { values, ..self.windows.at_rest() }
    }

    /// Standard uncertainty along x, y, z of every vector from [`Self::correct`], in cells,
    /// where the correlation coefficient of the frames is at least `least_correlation`.
    pub fn uncertainties(
        &self,
        frames: [&CellLight; 2],
        peaks: &[Option<Peak>],
        least_correlation: f64,
    ) -> Vec<Option<[f32; 3]>> {
        let of_window = |(peak, statistics): (&Option<Peak>, Option<PeakStatistics>)| {
            statistics?.trusted_vox(peak.as_ref()?.shift, least_correlation)
        };
        peaks
            .iter()
            .zip(statistics_at_zero_lag(frames, &self.windows, &self.profile))
            .map(of_window)
            .collect()
    }

    fn found(
        &self,
        mut field: Lattice,
        frames: [&CellLight; 2],
        peak: impl Fn(&[f32]) -> Option<Peak> + Sync,
    ) -> PassResult {
        let peaks =
            Correlation::new(&self.windows, &self.profile, self.lags, frames).of_windows(peak);
        field.add(&peaks, self.windows.cell_vox);
        PassResult { field, peaks }
    }
}
