//! Correlation of whole volumes, voxel by voxel.
//!
//! Our reconstructed volumes are sparse and are deformed point by point ([`super::Interrogation`]). Volumes of
//! other programs are dense arrays, for which warping costs less.
//!
//! A search on coarse cells is followed by passes on cells of two voxels and one on voxels. Each pass warps
//! frame b onto frame a by the current displacement; both frames are represented by B-splines. Vectors refer
//! to frame a and are moved to mid-pair at the end.
//!
//! A grid of a single layer along z is a plane: its images are correlated in squares, by the same code.

mod bricks;
mod cells;
mod correlation;
mod expansion;
mod light;
mod pass;
mod profile;
mod statistics;
mod warp;

use std::sync::Arc;

use super::{
    VectorGrid, VectorStatus, VelocimetrySettings, VelocityField,
    flow_nodes::FlowNodes,
    judge::{Judge, Vector, field_of, move_to, settled},
    lags::Lags,
    lattice::Lattice,
    layout::Layout,
    peak::Peak,
};
use crate::{
    model::{VolumeGrid, VolumeMask},
    reconstruction::DenseVolume,
};
use light::CellLight;
use pass::{Pass, is_layer};
use profile::Profile;

/// Interrogation windows on whole volumes.
pub struct VolumeInterrogation {
    grid: VolumeGrid,
    settings: VelocimetrySettings,
    search: Pass,
    coarse: Pass,
    fine: Pass,
    /// The search's windows with the lags [`BESIDE`].
    beside: Pass,
    /// The flow, where the volume has a mask, and the final windows in it.
    flow: Option<(Arc<VolumeMask>, FlowNodes)>,
}

/// Search range in cells: the cell size follows from it.
const SEARCH_REACH: f64 = 3.0;

/// The same on a single layer: there a window needs finer cells to contain as many as a cube.
const LAYER_SEARCH_REACH: f64 = 12.0;

/// Edge of the cells in the passes between the search and the last one, in voxels. Used if windows then have at
/// least [`COARSE_WINDOW`] cells and the cells of the search are not smaller.
const COARSE_VOX: usize = 2;

/// Least number of cells along a window for which coarse passes improve on the search.
const COARSE_WINDOW: usize = 8;

/// Lags of a correcting pass: the residual displacement is less than a cell.
const NEAREST: Lags = Lags { reach: 1 };

/// Lags, on the search's cells, for secondary peaks: one cell beyond those of the main peak.
const BESIDE: Lags = Lags { reach: 3 };

/// Standard uncertainty of vectors on coarse cells, in cells, for the predictor (docs/decisions.md,
/// "Fitted constants").
const COARSE_UNCERTAINTY: f32 = 0.05;

/// Factor by which smoothing reduces a vector's standard uncertainty: with it, intervals contain 70 and 94 % of
/// the errors for true particles (see the tests) and 74 and 96 % for volumes reconstructed from noisy images,
/// instead of 68 and 95 %. In a vortex core, where windows are as large as the flow, 53 and 79 %.
const SMOOTHING_FACTOR: f32 = 0.8;

impl VolumeInterrogation {
    /// Windows on `grid`. Windows larger than the volume shrink to it.
    pub fn new(grid: &VolumeGrid, settings: &VelocimetrySettings) -> Self {
        let sizes = settings.in_voxels(&without_thickness(grid));
        let search_reach = if is_layer(grid) { LAYER_SEARCH_REACH } else { SEARCH_REACH };
        let search_cell = (sizes.reach / search_reach).ceil().max(1.0) as usize;
        let search_lags = Lags { reach: (sizes.reach / search_cell as f64).ceil() as usize + 1 };
        let search = Pass::new(
            grid,
            search_cell,
            [sizes.search, sizes.search / 2],
            Profile::uniform,
            search_lags,
        );
        let coarse = sizes.window >= COARSE_WINDOW * COARSE_VOX && search_cell >= COARSE_VOX;
        let [coarse, fine] = [if coarse { COARSE_VOX } else { 1 }, 1].map(|cell| {
            Pass::new(grid, cell, [sizes.window, sizes.step], Profile::peaked, NEAREST)
        });
        let beside = Pass { lags: BESIDE, ..search.clone() };
        let (grid, settings) = (grid.clone(), settings.clone());
        Self { grid, settings, search, coarse, fine, beside, flow: None }
    }

    /// With the flow of `mask` only; that of the whole volume without one. See
    /// [`super::Interrogation::with_mask`]; voxels that are not flow get the mean light of those that are,
    /// which correlates with nothing.
    pub fn with_mask(self, mask: Option<Arc<VolumeMask>>) -> Self {
        let grid = self.vector_grid();
        let flow = mask.map(|mask| {
            let place = |place: [usize; 3]| {
                std::array::from_fn(|axis| {
                    grid.first_mm[axis] + place[axis] as f64 * grid.spacing_mm
                })
            };
            let nodes = FlowNodes::new(Layout { nodes: grid.vectors }, &mask, place);
            (mask, nodes)
        });
        Self { flow, ..self }
    }

    /// Grid of the vectors.
    pub fn vector_grid(&self) -> VectorGrid {
        let windows = &self.fine.windows;
        VectorGrid {
            vectors: windows.nodes,
            first_mm: std::array::from_fn(|axis| {
                self.grid.coordinate_mm(axis, f64::from(windows.first_vox[axis]))
            }),
            spacing_mm: windows.step as f64 * self.grid.voxel_mm,
        }
    }

    /// Edges of the first and the final windows, in voxels.
    pub fn windows_vox(&self) -> [usize; 2] {
        [&self.search, &self.fine].map(|stage| stage.windows.edge * stage.cell_vox())
    }

    /// The displacement from `a` to `b`, both on the grid of this, over `dt_s` seconds.
    ///
    /// # Panics
    /// When a volume does not have the grid's voxels.
    pub fn measure(&self, a: &DenseVolume, b: &DenseVolume, dt_s: f64) -> VelocityField {
        self.measured([a, b], dt_s, |frames| self.searched(frames))
    }

    /// The same with a `known` field, on any nodes and voxels, in place of the search: displacements that vary within
    /// a window of the search are measured from coarse images to fine ones.
    ///
    /// # Panics
    /// When a volume does not have the grid's voxels.
    pub fn measure_from(
        &self,
        known: &VelocityField,
        a: &DenseVolume,
        b: &DenseVolume,
        dt_s: f64,
    ) -> VelocityField {
        self.measured([a, b], dt_s, |_| self.start(known, dt_s))
    }

    fn measured(
        &self,
        [a, b]: [&DenseVolume; 2],
        dt_s: f64,
        start: impl FnOnce([&CellLight; 2]) -> Lattice,
    ) -> VelocityField {
        for volume in [a, b] {
            assert_eq!(volume.grid.voxels, self.grid.voxels, "one grid for volumes and windows");
            assert_eq!(volume.intensity.len(), volume.grid.len(), "one number per voxel");
        }
        let Pass { windows, profile, lags } = &self.fine;
        let level = |volume: &DenseVolume| {
            let in_flow = self.flow.as_ref().map(|(mask, _)| within(volume, mask));
            let volume = in_flow.as_ref().unwrap_or(volume);
            CellLight::without_mean(volume, windows, profile, lags.border())
        };
        let (a, b) = rayon::join(|| level(a), || level(b));
        let mut field = start([&a, &b]);
        if self.settings.passes > 2 {
            let binned = |light: &CellLight| light.binned(self.coarse.cell_vox(), NEAREST.border());
            let (a, b) = rayon::join(|| binned(&a).splined(), || binned(&b));
            for _ in 2..self.settings.passes {
                let (known, moved) = self.coarse.warp(&field, &b);
                let found = self.coarse.correct(known, [&a, &moved]);
                field = self.predictor(&self.coarse, &found.field, &found.peaks);
            }
        }
        self.last([&a.splined(), &b], &field, dt_s)
    }

    /// A mid-pair field, moved so that its vectors refer to frame a.
    fn start(&self, known: &VelocityField, dt_s: f64) -> Lattice {
        let (grid, voxel_mm) = (&known.grid, self.grid.voxel_mm);
        let scale = (known.voxel_mm / voxel_mm * dt_s / known.dt_s) as f32;
        let has_value: Vec<bool> = known.status.iter().map(|status| status.has_value()).collect();
        let in_voxels =
            |axis: usize| (grid.first_mm[axis] - self.grid.coordinate_mm(axis, 0.0)) / voxel_mm;
        let middle = Lattice {
            nodes: grid.vectors,
            first_vox: std::array::from_fn(|axis| in_voxels(axis) as f32),
            step_vox: (grid.spacing_mm / voxel_mm) as f32,
            values: known.displacement_vox.iter().map(|d| d.map(|d| d * scale)).collect(),
        }
        .filled(&has_value, None);
        middle.clone().sampling(|at| {
            let half = middle.at(at).map(|d| d / 2.0);
            middle.at(std::array::from_fn(|c| at[c] + half[c]))
        })
    }

    /// The predictor from the search.
    fn searched(&self, frames: [&CellLight; 2]) -> Lattice {
        let stage = &self.search;
        let [a, b] = frames.map(|light| light.binned(stage.cell_vox(), stage.lags.border()));
        let found = stage.search([&a, &b]);
        self.predictor(stage, &found.field, &found.peaks)
    }

    /// The most probable field, given the vectors of a stage on coarse cells.
    fn predictor(&self, stage: &Pass, field: &Lattice, peaks: &[Option<Peak>]) -> Lattice {
        let uncertainty_vox = COARSE_UNCERTAINTY * stage.windows.cell_vox;
        let known = vec![Some([uncertainty_vox; 3]); peaks.len()];
        Judge { settings: &self.settings, field, peaks, flow: None }.predictor(&known)
    }

    /// The pass on voxels, and its result.
    fn last(&self, [a, b]: [&CellLight; 2], field: &Lattice, dt_s: f64) -> VelocityField {
        let (known, moved) = self.fine.warp(field, b);
        let mut found = self.fine.correct(known, [a, &moved]);
        let ratios = self.peak_ratios([a, &moved]);
        for (peak, ratio) in found.peaks.iter_mut().zip(&ratios) {
            if let Some(peak) = peak {
                peak.ratio = *ratio;
            }
        }
        let least = self.settings.least_correlation;
        let flow = self.flow.as_ref().map(|(_, nodes)| nodes);
        let is_flow = |n: usize| flow.is_none_or(|flow| flow.is_flow(n));
        let not_flow = found.peaks.iter_mut().enumerate().filter(|(n, _)| !is_flow(*n));
        not_flow.for_each(|(_, peak)| *peak = None);
        let uncertainty_vox = self.fine.uncertainties([a, &moved], &found.peaks, least);
        let judge =
            Judge { settings: &self.settings, field: &found.field, peaks: &found.peaks, flow };
        let mut vectors = judge.vectors(&uncertainty_vox);
        self.to_likeliest(&mut vectors, flow);
        for (n, vector) in vectors.iter_mut().enumerate().filter(|(n, _)| !is_flow(*n)) {
            debug_assert!(!vector.status.has_value(), "vector {n} has no neighbours");
            vector.status = VectorStatus::Masked;
        }
        let ratios: Vec<f32> =
            found.peaks.iter().map(|peak| peak.map_or(0.0, |peak| peak.ratio)).collect();
        field_of(self.vector_grid(), &self.grid, dt_s, (&vectors, &ratios), flow)
    }

    /// Peak ratio of every window. The lags of the last pass contain one peak only, so secondary peaks are
    /// searched with the search's windows and cells, in the warped frames.
    fn peak_ratios(&self, frames: [&CellLight; 2]) -> Vec<f32> {
        let stage = &self.beside;
        let [a, b] = frames.map(|light| light.binned(stage.cell_vox(), stage.lags.border()));
        let of_search = stage.ratios([&a, &b]);
        let nearest = self.fine.windows.at_rest().sampling(|at| of_search.nearest(at));
        nearest.values.iter().map(|ratio| ratio[0]).collect()
    }

    /// Replaces vectors by the most probable field at mid-pair. Invalid vectors are unchanged.
    fn to_likeliest(&self, vectors: &mut [Vector], flow: Option<&FlowNodes>) {
        let (field, _) = settled(vectors, self.fine.windows.at_rest(), flow);
        let middle = field.carried_to_middle();
        move_to(&middle, vectors, |_, vector| {
            vector.uncertainty_vox = vector.uncertainty_vox.map(|sigma| SMOOTHING_FACTOR * sigma);
        });
    }
}

/// The volume with light outside the flow replaced by the flow's mean light.
fn within(volume: &DenseVolume, mask: &VolumeMask) -> DenseVolume {
    let grid = &volume.grid;
    let flow: Vec<bool> = (0..grid.len())
        .map(|n| mask.is_flow(grid.centre_of(grid.indices(n as u32)).into()))
        .collect();
    let light = volume.intensity.iter().zip(&flow);
    let (sum, count) = light
        .clone()
        .filter(|(_, flow)| **flow)
        .fold((0.0, 0usize), |(sum, count), (light, _)| (sum + f64::from(*light), count + 1));
    let mean = (sum / count.max(1) as f64) as f32;
    let intensity = light.map(|(light, flow)| if *flow { *light } else { mean }).collect();
    DenseVolume { grid: grid.clone(), intensity }
}

/// A grid whose single layer does not limit the window size.
fn without_thickness(grid: &VolumeGrid) -> VolumeGrid {
    let [nx, ny, nz] = grid.voxels;
    let nz = if is_layer(grid) { nx.min(ny) } else { nz };
    VolumeGrid { voxels: [nx, ny, nz], ..grid.clone() }
}

#[cfg(test)]
mod tests;
