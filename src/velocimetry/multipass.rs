//! Multi-pass cross-correlation with volume deformation.
//!
//! A search on coarse cells finds displacements of several voxels. Each pass after it moves the
//! light of both frames towards each other by half the displacement known so far (symmetric, so
//! the result belongs to the middle of the pair), renders them, correlates interrogation windows,
//! and adds what it finds.

use super::{
    VectorGrid, VectorStatus, VelocimetrySettings, VelocityField, cloud::PointCloud,
    correlation::Frames, derived::curl_and_divergence, lags::Lags, lattice::Lattice,
    peak::highest_peak, raster::Raster, validate::Candidates, windows::Windows,
};
use crate::model::VolumeGrid;

/// Interrogation windows on a volume.
pub struct Interrogation {
    grid: VolumeGrid,
    margin: usize,
    settings: VelocimetrySettings,
    nodes: [usize; 3],
    search: Windows,
    search_lags: Lags,
    windows: Windows,
}

/// Layers of windows around the volume's own, on the margin: they carry the deformation to the
/// volume's faces and are not reported.
const GUARD: usize = 1;

/// The search looks this many cells far at most: its cells are as coarse as that asks for.
const SEARCH_REACH: usize = Lags::FARTHEST - 1;

/// Lags of the first and the last pass after the search: far enough for a second peak beside the
/// highest.
const WIDE: Lags = Lags { reach: 4 };

/// Lags of the passes between: what they correct is less than a voxel.
const NARROW: Lags = Lags { reach: 2 };

/// Frames a and b of a pass, moved towards each other.
struct Rendered {
    raster: Raster,
    images: [Vec<f32>; 2],
}

/// A cloud and how it is moved before it is rendered.
type Moved<'a> = (&'a PointCloud, Option<&'a Lattice>);

impl Interrogation {
    /// Windows on `grid`; light up to `margin` voxels outside it is used where it is known.
    /// Windows larger than the volume shrink to it.
    pub fn new(grid: &VolumeGrid, margin: usize, settings: &VelocimetrySettings) -> Self {
        let smallest = grid.voxels.into_iter().min().unwrap_or(1);
        let voxels = |mm: f64| ((mm / grid.voxel_mm).round() as usize).clamp(2, smallest.max(2));
        let window = voxels(settings.window_mm);
        let step = ((window as f64 * (1.0 - settings.overlap)).round() as usize).max(1);
        let nodes = grid.voxels.map(|n| n.saturating_sub(window) / step + 1);
        let centre = margin as f32 + (window as f32 - 1.0) / 2.0;
        let windows = Windows {
            nodes: nodes.map(|n| n + 2 * GUARD),
            edge: window,
            step,
            cell_vox: 1.0,
            first_vox: [centre - (GUARD * step) as f32; 3],
        };
        let wanted = settings
            .first_window_mm
            .map_or_else(|| (4.0 * settings.max_displacement_vox).ceil() as usize, voxels)
            .max(window);
        let reach = (settings.max_displacement_vox * 1.25).min(wanted as f64 / 2.0);
        let (search, search_lags) = search_windows(&windows, wanted, reach);
        let (grid, settings) = (grid.clone(), settings.clone());
        Self { grid, margin, settings, nodes, search, search_lags, windows }
    }

    /// The grid, with margin, in whose voxels clouds are given.
    pub fn cloud_grid(&self) -> VolumeGrid {
        self.grid.padded(self.margin)
    }

    /// Where the vectors will be.
    pub fn vector_grid(&self) -> VectorGrid {
        let first = (self.windows.edge as f64 - 1.0) / 2.0;
        VectorGrid {
            vectors: self.nodes,
            first_mm: std::array::from_fn(|axis| self.grid.coordinate_mm(axis, first)),
            spacing_mm: self.windows.step as f64 * self.grid.voxel_mm,
        }
    }

    /// Edges of the first and the final windows, in voxels.
    pub fn windows_vox(&self) -> [usize; 2] {
        [&self.search, &self.windows].map(|w| w.edge * w.cell_vox as usize)
    }

    /// The displacement from `a` to `b`, both in voxels of [`Self::cloud_grid`].
    pub fn measure(&self, a: &PointCloud, b: &PointCloud, dt_s: f64) -> VelocityField {
        let mut field = self.search.at_rest();
        let mut frames = self.render(&self.search, self.search_lags, [(a, None), (b, None)]);
        self.advance(&self.search, self.search_lags, &frames, &mut field);
        field = self.windows.at_rest().sampling(|at| field.at(at));
        let mut measured = Vec::new();
        let last = self.settings.passes.max(2) - 1;
        for pass in 1..=last {
            // A window as long as the shortest wave on the lattice cannot see that wave: what noise
            // puts there would never be corrected, so it is taken out of the predictor.
            field = field.smoothed();
            let paths = [1.0, -1.0].map(|sign| field.half_paths(sign));
            let moved = [(a, Some(&paths[0])), (b, Some(&paths[1]))];
            let lags = if pass == 1 || pass == last { WIDE } else { NARROW };
            frames = self.render(&self.windows, lags, moved);
            measured = self.advance(&self.windows, lags, &frames, &mut field);
        }
        self.report(&field, &measured, dt_s)
    }

    /// Both clouds, deformed, on the cells that `windows` need for `lags`.
    fn render(&self, windows: &Windows, lags: Lags, clouds: [Moved; 2]) -> Rendered {
        let raster = windows.raster(lags.border());
        let [(a, a_paths), (b, b_paths)] = clouds;
        let (a, b) = rayon::join(|| raster.render(a, a_paths), || raster.render(b, b_paths));
        Rendered { raster, images: [a, b] }
    }

    /// One pass: adds the residual displacement that deformed frames show in every window, tests the
    /// sum, and puts interpolated vectors where it fails.
    fn advance(
        &self,
        windows: &Windows,
        lags: Lags,
        frames: &Rendered,
        field: &mut Lattice,
    ) -> Vec<(VectorStatus, f32)> {
        let known = self.cloud_grid().voxels;
        let lit =
            std::array::from_fn(|axis| frames.raster.within(axis, -0.5, known[axis] as f32 - 0.5));
        let images = frames.images.each_ref().map(Vec::as_slice);
        let residual = Frames::new(windows, lags, &frames.raster, images, lit)
            .correlate(|correlation| highest_peak(lags, correlation));
        let present: Vec<bool> = residual.iter().map(Option::is_some).collect();
        for (value, residual) in field.values.iter_mut().zip(&residual) {
            if let Some(peak) = residual {
                for (v, r) in value.iter_mut().zip(peak.shift) {
                    *v += r * windows.cell_vox;
                }
            }
        }
        let status = self.validate(field, &present);
        let ratio = residual.iter().map(|r| r.map_or(0.0, |peak| peak.ratio));
        status.into_iter().zip(ratio).collect()
    }

    /// Tests the field, puts interpolated vectors where it fails, and says which is which.
    fn validate(&self, field: &mut Lattice, present: &[bool]) -> Vec<VectorStatus> {
        let candidates = Candidates { nodes: field.nodes, values: &field.values, present };
        let pass =
            candidates.passing(self.settings.median_threshold, self.settings.median_epsilon_vox);
        let (values, status) = (0..pass.len())
            .map(|index| {
                if pass[index] {
                    return (field.values[index], VectorStatus::Valid);
                }
                match candidates.interpolated(index, &pass) {
                    Some(value) => (value, VectorStatus::Replaced),
                    None => ([0.0; 3], VectorStatus::Invalid),
                }
            })
            .unzip();
        field.values = values;
        status
    }

    fn report(
        &self,
        field: &Lattice,
        measured: &[(VectorStatus, f32)],
        dt_s: f64,
    ) -> VelocityField {
        let [nx, ny, nz] = self.nodes;
        let mut kept = Vec::with_capacity(nx * ny * nz);
        for k in GUARD..nz + GUARD {
            for j in GUARD..ny + GUARD {
                let row = (k * field.nodes[1] + j) * field.nodes[0];
                kept.extend(row + GUARD..row + GUARD + nx);
            }
        }
        let displacement_vox: Vec<[f32; 3]> = kept.iter().map(|&n| field.values[n]).collect();
        let (vorticity, divergence) =
            curl_and_divergence(self.nodes, &displacement_vox, self.windows.step as f64);
        VelocityField {
            grid: self.vector_grid(),
            status: kept.iter().map(|&n| measured[n].0).collect(),
            peak_ratio: kept.iter().map(|&n| measured[n].1).collect(),
            displacement_vox,
            vorticity,
            divergence,
            voxel_mm: self.grid.voxel_mm,
            dt_s,
        }
    }
}

/// Windows of at least `edge_vox` voxels, half overlapping, over the centres of `windows`, and
/// lags that reach `reach_vox`. Their cells are so coarse that few lags are needed: points are
/// rendered at any cell size.
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
