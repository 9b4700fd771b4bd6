//! Multi-pass cross-correlation with volume deformation.
//!
//! A search on coarse cells measures displacements of several voxels. Each further pass moves the light of both
//! frames towards each other by half the current displacement (symmetric, so the result refers to mid-pair),
//! renders it, correlates interrogation windows, and adds the residual displacement.

use std::sync::Arc;

use rayon::prelude::*;

use super::{
    VectorGrid, VelocimetrySettings, VelocityField,
    cloud::PointCloud,
    correlation::Frames,
    displacement::DisplacementField,
    flow_geometry::{FlowGeometry, InFlow},
    flow_nodes::FlowNodes,
    judge::{Judge, Vector, field_of, settled},
    lags::Lags,
    lattice::Lattice,
    layout::Layout,
    peak::{Peak, highest_peak},
    raster::{Image, Raster},
    report::Report,
    settings::Sizes,
    tracks::{Refined, follow, is_fine},
    uncertainty::{Cutouts, PeakStatistics},
    windows::Windows,
};
use crate::model::{VolumeGrid, VolumeMask};

/// Interrogation windows on a volume.
pub struct Interrogation {
    grid: VolumeGrid,
    margin: usize,
    settings: VelocimetrySettings,
    nodes: [usize; 3],
    /// Requested positions of vectors; the windows' centres if absent.
    spacing_mm: Option<f64>,
    search: Windows,
    search_lags: Lags,
    windows: Windows,
    /// The flow, where the volume has a mask.
    flow: Option<FlowGeometry>,
}

/// Layers of windows around the volume, on the margin: they extend the deformation field beyond the volume's faces
/// and are not reported.
const GUARD: usize = 1;

/// Largest search range in cells: the cell size follows from it.
const SEARCH_REACH: usize = Lags::FARTHEST - 1;

/// Lags of the first and the last pass after the search: sufficient for a secondary peak.
const WIDE: Lags = Lags { reach: 4 };

/// Lags of the passes between: their corrections are less than a voxel.
const NARROW: Lags = Lags { reach: 2 };

/// Frames a and b of a pass, moved towards each other.
struct Rendered {
    lags: Lags,
    raster: Raster,
    /// First cell with known light along each axis, and the one after the last.
    lit: [[i64; 2]; 3],
    images: [Vec<f32>; 2],
}

/// Result of a pass in every window.
struct WindowResults {
    peaks: Vec<Option<Peak>>,
    /// See [`Interrogation::uncertainties`].
    uncertainty_vox: Vec<Option<[f32; 3]>>,
}

/// A cloud and how it is moved before it is rendered.
type Moved<'a> = (&'a PointCloud, Option<&'a Lattice>);

impl Interrogation {
    /// Windows on `grid`; light up to `margin` voxels outside it is used where it is known.
    /// Windows larger than the volume shrink to it.
    pub fn new(grid: &VolumeGrid, margin: usize, settings: &VelocimetrySettings) -> Self {
        let Sizes { window, step, search, reach } = settings.in_voxels(grid);
        let nodes = grid.voxels.map(|n| n.saturating_sub(window) / step + 1);
        let centre = margin as f32 + (window as f32 - 1.0) / 2.0;
        let windows = Windows {
            nodes: nodes.map(|n| n + 2 * GUARD),
            edge: window,
            step,
            cell_vox: 1.0,
            first_vox: [centre - (GUARD * step) as f32; 3],
        };
        let (search, search_lags) = search_windows(&windows, search, reach);
        let (grid, settings) = (grid.clone(), settings.clone());
        Self {
            grid,
            margin,
            settings,
            nodes,
            spacing_mm: None,
            search,
            search_lags,
            windows,
            flow: None,
        }
    }

    /// With vectors this far apart from the first window's centre to the last's, in mm, and not on the
    /// centres.
    pub fn with_spacing_mm(self, spacing_mm: Option<f64>) -> Self {
        let mask = self.flow.as_ref().map(|flow| flow.mask().clone());
        Self { spacing_mm, ..self }.with_mask(mask)
    }

    /// With the flow of `mask` only; that of the whole volume without one.
    ///
    /// Windows then contain only the light in the flow. Windows with their centre outside the flow have no vector,
    /// vectors are not compared, replaced or smoothed across bodies, and vectors outside the flow are masked.
    pub fn with_mask(self, mask: Option<Arc<VolumeMask>>) -> Self {
        let flow = mask.map(|mask| {
            let windows = [&self.search, &self.windows];
            FlowGeometry::new(mask, self.cloud_grid(), windows, &self.vector_grid())
        });
        Self { flow, ..self }
    }

    /// The vectors that are flow, where the volume has a mask.
    pub(super) fn flow_of_vectors(&self) -> Option<&FlowNodes> {
        self.flow.as_ref().map(|flow| &flow.vectors)
    }

    /// How volumes are correlated.
    pub(super) fn settings(&self) -> &VelocimetrySettings {
        &self.settings
    }

    /// The grid, with margin, in whose voxels clouds are given.
    pub fn cloud_grid(&self) -> VolumeGrid {
        self.grid.padded(self.margin)
    }

    /// Grid of the vectors.
    pub fn vector_grid(&self) -> VectorGrid {
        let first = (self.windows.edge as f64 - 1.0) / 2.0;
        let windows = VectorGrid {
            vectors: self.nodes,
            first_mm: std::array::from_fn(|axis| self.grid.coordinate_mm(axis, first)),
            spacing_mm: self.windows.step as f64 * self.grid.voxel_mm,
        };
        match self.spacing_mm {
            Some(spacing_mm) => windows.with_spacing_mm(spacing_mm),
            None => windows,
        }
    }

    /// Edges of the first and the final windows, in voxels.
    pub fn windows_vox(&self) -> [usize; 2] {
        [&self.search, &self.windows].map(|w| w.edge * w.cell_vox as usize)
    }

    /// What of the vectors and windows is flow, where the volume has a mask.
    pub fn in_flow(&self) -> Option<InFlow> {
        self.flow.as_ref().map(|flow| flow.in_flow(&self.windows))
    }

    /// The displacement from `a` to `b`, both in voxels of [`Self::cloud_grid`].
    pub fn measure(&self, a: &PointCloud, b: &PointCloud, dt_s: f64) -> VelocityField {
        self.measure_everywhere(a, b, dt_s).0
    }

    /// [`Self::measure`], and the continuous field.
    pub fn measure_everywhere(
        &self,
        a: &PointCloud,
        b: &PointCloud,
        dt_s: f64,
    ) -> (VelocityField, DisplacementField) {
        let particles = self.settings.follow_particles && [a, b].into_iter().all(is_fine);
        self.measured([a, b], particles, dt_s)
    }

    /// The same by windows alone, without particle tracking: the error that remains with a perfect reconstruction.
    pub fn measure_by_windows(&self, a: &PointCloud, b: &PointCloud, dt_s: f64) -> VelocityField {
        self.measured([a, b], false, dt_s).0
    }

    fn measured(
        &self,
        all_light: [&PointCloud; 2],
        particles: bool,
        dt_s: f64,
    ) -> (VelocityField, DisplacementField) {
        let in_flow = self.flow.as_ref().map(|flow| all_light.map(|cloud| flow.within(cloud)));
        let [a, b] = in_flow.as_ref().map_or(all_light, |clouds| clouds.each_ref());
        let mut field = self.searched(a, b);
        let last = self.settings.passes.max(2) - 1;
        for pass in 1..last {
            let lags = if pass == 1 { WIDE } else { NARROW };
            let found = self.pass(a, b, &mut field, lags);
            // A window does not respond to a wave as long as itself. Noise at that wavelength would never be
            // corrected, so it must be removed from the predictor.
            field = self.judge(&field, &found.peaks).predictor(&found.uncertainty_vox);
        }
        let found = self.pass(a, b, &mut field, WIDE);
        let vectors = self.judge(&field, &found.peaks).vectors(&found.uncertainty_vox);
        self.report(&vectors, &found.peaks, particles.then_some(all_light), dt_s)
    }

    /// Deforms by `field` and adds the residual displacement to it.
    fn pass(
        &self,
        a: &PointCloud,
        b: &PointCloud,
        field: &mut Lattice,
        lags: Lags,
    ) -> WindowResults {
        let frames = self.deformed(a, b, field, lags);
        let shares = self.flow.as_ref().map(|flow| flow.window_shares.as_slice());
        let mut peaks = self.correlate(&self.windows, &frames, shares);
        if let Some(flow) = &self.flow {
            flow.drop_outside(&mut peaks);
        }
        field.add(&peaks, self.windows.cell_vox);
        WindowResults { uncertainty_vox: self.uncertainties(&frames, &peaks), peaks }
    }

    /// Result of the search on coarse cells, on the nodes of the windows.
    fn searched(&self, a: &PointCloud, b: &PointCloud) -> Lattice {
        let frames = self.render(&self.search, self.search_lags, [(a, None), (b, None)]);
        let shares = self.flow.as_ref().map(|flow| flow.search_shares.as_slice());
        let peaks = self.correlate(&self.search, &frames, shares);
        let mut coarse = self.search.at_rest();
        coarse.add(&peaks, self.search.cell_vox);
        // Windows of the search are large: their neighbours give a search position, also across bodies.
        let judge = Judge { settings: &self.settings, field: &coarse, peaks: &peaks, flow: None };
        coarse = judge.with_outliers_replaced();
        self.windows.at_rest().sampling(|at| coarse.at(at))
    }

    /// Both frames rendered for the windows after each is moved half way towards the other along
    /// `field`.
    fn deformed(&self, a: &PointCloud, b: &PointCloud, field: &Lattice, lags: Lags) -> Rendered {
        let paths = [1.0, -1.0].map(|sign| field.half_paths(sign));
        self.render(&self.windows, lags, [(a, Some(&paths[0])), (b, Some(&paths[1]))])
    }

    /// Both clouds, deformed, on the cells that `windows` need for `lags`.
    fn render(&self, windows: &Windows, lags: Lags, clouds: [Moved; 2]) -> Rendered {
        let raster = windows.raster(lags.border());
        let [(a, a_paths), (b, b_paths)] = clouds;
        let (a, b) = rayon::join(|| raster.render(a, a_paths), || raster.render(b, b_paths));
        let known = self.cloud_grid().voxels;
        let lit = std::array::from_fn(|axis| raster.within(axis, -0.5, known[axis] as f32 - 0.5));
        Rendered { lags, raster, lit, images: [a, b] }
    }

    /// Residual displacement in every window of two rendered frames, of which these shares are flow.
    fn correlate(
        &self,
        windows: &Windows,
        frames: &Rendered,
        flow_shares: Option<&[f32]>,
    ) -> Vec<Option<Peak>> {
        let images = frames.images.each_ref().map(Vec::as_slice);
        Frames::new(windows, frames.lags, &frames.raster, images, frames.lit)
            .with_flow_shares(flow_shares)
            .correlate(|correlation| highest_peak(frames.lags, correlation))
    }

    /// Standard uncertainty of every vector along x, y, z, in voxels, where the frames correlate sufficiently.
    fn uncertainties(&self, frames: &Rendered, peaks: &[Option<Peak>]) -> Vec<Option<[f32; 3]>> {
        let windows = Layout { nodes: self.windows.nodes };
        let images = frames.images.each_ref().map(|light| Image {
            light,
            cells: frames.raster.cells,
            lit: frames.lit,
        });
        let border = frames.lags.border();
        peaks
            .par_iter()
            .enumerate()
            .map_init(Cutouts::default, |cutouts, (n, peak)| {
                let Peak { shift, lag, .. } = peak.as_ref()?;
                let node = windows.place(n);
                // Windows are centred on the pairs of cells they compare.
                let corner = std::array::from_fn(|axis| {
                    (node[axis] * self.windows.step + border) as i64 - lag[axis].div_euclid(2)
                });
                let statistics =
                    PeakStatistics::of(images, corner, self.windows.edge, *lag, cutouts)?;
                statistics.trusted_vox(*shift, self.settings.least_correlation)
            })
            .collect()
    }

    fn judge<'a>(&'a self, field: &'a Lattice, peaks: &'a [Option<Peak>]) -> Judge<'a> {
        let flow = self.flow.as_ref().map(|flow| &flow.windows);
        Judge { settings: &self.settings, field, peaks, flow }
    }

    /// The most probable field, given the last pass's vectors, or the field fitted to the particles of `frames`, at the
    /// requested positions.
    fn report(
        &self,
        vectors: &[Vector],
        peaks: &[Option<Peak>],
        frames: Option<[&PointCloud; 2]>,
        dt_s: f64,
    ) -> (VelocityField, DisplacementField) {
        let (flow, settings) = (self.flow.as_ref(), &self.settings);
        let (windows, uncertainty_vox) =
            settled(vectors, self.windows.at_rest(), flow.map(|flow| &flow.windows));
        let refined = frames.map(|frames| {
            follow(&windows, &uncertainty_vox, frames, settings.incompressible, flow)
        });
        let grid = self.vector_grid();
        let report = Report {
            windows: &windows,
            vectors,
            peaks,
            refined: refined.as_ref(),
            flow,
            max_displacement_vox: settings.max_displacement_vox,
        };
        let cloud_grid = self.cloud_grid();
        let places: Vec<[f32; 3]> = (0..grid.len())
            .map(|n| {
                let at_mm = grid.position_mm(n);
                std::array::from_fn(|axis| cloud_grid.index_of(axis, at_mm[axis]) as f32)
            })
            .collect();
        let (reported, ratios): (Vec<Vector>, Vec<f32>) =
            places.iter().map(|&at_vox| report.at(at_vox)).unzip();
        let in_flow = self.flow_of_vectors();
        let field = field_of(grid, &self.grid, dt_s, (&reported, &ratios), in_flow);
        let everywhere = match refined {
            Some(Refined { spline, missed, .. }) => DisplacementField::Particles { spline, missed },
            None => DisplacementField::Windows(windows),
        };
        (field, everywhere)
    }
}

/// Windows of at least `edge_vox` voxels, half overlapping, over the centres of `windows`, and
/// lags that reach `reach_vox`. The cells are coarse, so that few lags are needed: points
/// can be rendered at any cell size.
fn search_windows(windows: &Windows, edge_vox: usize, reach_vox: f64) -> (Windows, Lags) {
    let cell = (reach_vox / SEARCH_REACH as f64).ceil().max(1.0) as usize;
    let edge = edge_vox.div_ceil(cell).next_multiple_of(2).max(4);
    let step = edge / 2;
    let step_vox = (step * cell) as f32;
    let mut nodes = [1; 3];
    let mut first_vox = windows.first_vox;
    for axis in 0..3 {
        let length = ((windows.nodes[axis] - 1) * windows.step) as f32;
        let steps = (length / step_vox).round();
        nodes[axis] = steps as usize + 1;
        first_vox[axis] += (length - steps * step_vox) / 2.0;
    }
    let search = Windows { nodes, edge, step, cell_vox: cell as f32, first_vox };
    (search, Lags { reach: (reach_vox / cell as f64).ceil() as usize + 1 })
}

#[cfg(test)]
mod tests;
