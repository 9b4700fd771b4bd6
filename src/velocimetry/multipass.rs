//! Multi-pass cross-correlation with volume deformation.
//!
//! Each pass moves the light of both frames towards each other by half the displacement known so
//! far (symmetric, so the result belongs to the middle of the pair), renders them, correlates
//! interrogation windows, and adds what it finds. The first pass uses windows of at least four
//! times the largest expected displacement.

use rayon::prelude::*;

use super::{
    VectorGrid, VelocimetrySettings, VelocityField,
    cloud::PointCloud,
    derived::curl_and_divergence,
    judge::{Judge, ROOM, Vector},
    lattice::Lattice,
    peak::{Peak, highest_peak},
    spectrum::Correlator,
    uncertainty::PeakStatistics,
    window::{Rendered, fast_edge},
};
use crate::model::VolumeGrid;

/// Interrogation windows on a volume, and the plans to correlate them.
pub struct Interrogation {
    grid: VolumeGrid,
    margin: usize,
    settings: VelocimetrySettings,
    nodes: [usize; 3],
    step: usize,
    window: usize,
    first_window: usize,
    correlators: [Correlator; 2],
}

/// Layers of windows around the volume's own, on the margin: they carry the deformation to the
/// volume's faces and are not reported.
const GUARD: usize = 1;

/// Later passes look for residual displacements up to this share of the window.
const LATER_REACH: f64 = 0.25;

impl Interrogation {
    /// Windows on `grid`; light up to `margin` voxels outside it is used where it is known.
    /// Windows larger than the volume shrink to it.
    pub fn new(grid: &VolumeGrid, margin: usize, settings: &VelocimetrySettings) -> Self {
        let smallest = grid.voxels.into_iter().min().unwrap_or(1);
        let voxels = |mm: f64| ((mm / grid.voxel_mm).round() as usize).clamp(2, smallest.max(2));
        let window = voxels(settings.window_mm);
        let step = ((window as f64 * (1.0 - settings.overlap)).round() as usize).max(1);
        let wanted = settings
            .first_window_mm
            .map_or_else(|| (4.0 * settings.max_displacement_vox).ceil() as usize, voxels);
        let first_window = wanted.next_multiple_of(2).max(window);
        let nodes = grid.voxels.map(|n| n.saturating_sub(window) / step + 1);
        let reach = |window: usize, passes: f64| (window as f64 * passes).ceil() as usize;
        let first_reach = (settings.max_displacement_vox * ROOM).ceil() as usize + 1;
        let correlators = [
            Correlator::new(fast_edge(first_window + first_reach.min(first_window / 2) + 1)),
            Correlator::new(fast_edge(window + reach(window, LATER_REACH) + 1)),
        ];
        let (grid, settings) = (grid.clone(), settings.clone());
        Self { grid, margin, settings, nodes, step, window, first_window, correlators }
    }

    /// The grid, with margin, in whose voxels clouds are given.
    pub fn cloud_grid(&self) -> VolumeGrid {
        self.grid.padded(self.margin)
    }

    /// Where the vectors will be.
    pub fn vector_grid(&self) -> VectorGrid {
        let first = (self.window as f64 - 1.0) / 2.0;
        VectorGrid {
            vectors: self.nodes,
            first_mm: std::array::from_fn(|axis| self.grid.coordinate_mm(axis, first)),
            spacing_mm: self.step as f64 * self.grid.voxel_mm,
        }
    }

    /// Edges of the first and the final windows, in voxels.
    pub fn windows_vox(&self) -> [usize; 2] {
        [self.first_window, self.window]
    }

    /// The displacement from `a` to `b`, both in voxels of [`Self::cloud_grid`].
    pub fn measure(&self, a: &PointCloud, b: &PointCloud, dt_s: f64) -> VelocityField {
        let mut field = self.at_rest();
        let last = self.settings.passes.saturating_sub(1);
        for pass in 0..last {
            let images = self.deformed(a, b, &field, pass);
            let peaks = self.correlate(&images, pass);
            field.add(&peaks);
            field = self.judge(&field, &peaks).predictor();
            // A window as long as the shortest wave on the lattice cannot see that wave: what noise
            // puts there would never be corrected, so it is taken out of the predictor.
            field = field.smoothed();
        }
        let images = self.deformed(a, b, &field, last);
        let peaks = self.correlate(&images, last);
        let uncertainty_vox = self.uncertainties(&images, &peaks, last);
        field.add(&peaks);
        let vectors = self.judge(&field, &peaks).vectors(&uncertainty_vox);
        self.report(&vectors, &peaks, dt_s)
    }

    fn at_rest(&self) -> Lattice {
        let nodes = self.nodes.map(|n| n + 2 * GUARD);
        Lattice {
            nodes,
            first_vox: self.margin as f32 + (self.window as f32 - 1.0) / 2.0
                - (GUARD * self.step) as f32,
            step_vox: self.step as f32,
            values: vec![[0.0; 3]; nodes.iter().product()],
        }
    }

    /// Both frames rendered after each is moved half way towards the other along `field`.
    fn deformed(
        &self,
        a: &PointCloud,
        b: &PointCloud,
        field: &Lattice,
        pass: usize,
    ) -> [Vec<f32>; 2] {
        let voxels = self.cloud_grid().voxels;
        let render = |cloud: &PointCloud, sign: f32| {
            let shift = |at| half_shift(field, at, sign);
            if pass == 0 { cloud.render(voxels) } else { cloud.moved(shift).render(voxels) }
        };
        let (a, b) = rayon::join(|| render(a, 1.0), || render(b, -1.0));
        [a, b]
    }

    /// Residual displacement in every window of two rendered frames.
    fn correlate(&self, images: &[Vec<f32>; 2], pass: usize) -> Vec<Option<Peak>> {
        let first = pass == 0;
        let correlator = &self.correlators[usize::from(!first)];
        let window = self.window_of(pass);
        let reach = if first {
            ((self.settings.max_displacement_vox * ROOM).ceil() as usize + 1).min(window / 2)
        } else {
            (window as f64 * LATER_REACH).ceil() as usize
        };
        // Overlapping pairs of voxels at lag s, relative to lag 0, along one axis: dividing by it
        // removes the bias towards zero of a finite window.
        let weight: Vec<f32> =
            (0..=reach + 1).map(|s| window as f32 / (window as f32 - s as f32).max(1.0)).collect();
        let [a, b] = self.rendered(images);
        self.nodes_with_guard()
            .into_par_iter()
            .map_init(
                || correlator.workspace(),
                |workspace, node| {
                    let (corner, edge) = (self.corner(node, window), correlator.edge());
                    let lit = a.copy_window(corner, window, &mut workspace.a, edge)
                        && b.copy_window(corner, window, &mut workspace.b, edge);
                    lit.then(|| {
                        correlator.correlate(workspace);
                        highest_peak(correlator, &workspace.a, reach, &weight)
                    })?
                },
            )
            .collect()
    }

    /// Standard uncertainty of every vector along x, y, z, in voxels, where the frames agree well
    /// enough to tell.
    fn uncertainties(
        &self,
        images: &[Vec<f32>; 2],
        peaks: &[Option<Peak>],
        pass: usize,
    ) -> Vec<Option<[f32; 3]>> {
        let window = self.window_of(pass);
        let [a, b] = self.rendered(images);
        self.nodes_with_guard()
            .into_par_iter()
            .zip(peaks)
            .map(|(node, peak)| {
                let peak = peak.as_ref()?;
                let corner = self.corner(node, window);
                let statistics = PeakStatistics::of(a, b, corner, window, peak.lag)?;
                let agree = f64::from(statistics.coefficient) >= self.settings.least_correlation;
                agree.then(|| statistics.uncertainty_vox(peak.shift_vox))?
            })
            .collect()
    }

    fn judge<'a>(&'a self, field: &'a Lattice, peaks: &'a [Option<Peak>]) -> Judge<'a> {
        Judge { settings: &self.settings, field, peaks }
    }

    /// Edge of the windows of a pass, in voxels.
    fn window_of(&self, pass: usize) -> usize {
        if pass == 0 { self.first_window } else { self.window }
    }

    fn rendered<'a>(&self, images: &'a [Vec<f32>; 2]) -> [Rendered<'a>; 2] {
        let voxels = self.grid.voxels.map(|n| n + 2 * self.margin);
        images.each_ref().map(|light| Rendered { light, voxels })
    }

    /// Lattice indices of all windows, those in the guard layers among them, in storage order.
    fn nodes_with_guard(&self) -> Vec<[usize; 3]> {
        let [nx, ny, nz] = self.nodes.map(|n| n + 2 * GUARD);
        (0..nx * ny * nz).map(|n| [n % nx, n / nx % ny, n / (nx * ny)]).collect()
    }

    /// First voxel of the window of edge `window` about a node of the lattice.
    fn corner(&self, node: [usize; 3], window: usize) -> [i64; 3] {
        let centred = (self.window as i64 - window as i64) / 2;
        node.map(|n| (self.margin + n * self.step) as i64 - (GUARD * self.step) as i64 + centred)
    }

    fn report(&self, vectors: &[Vector], peaks: &[Option<Peak>], dt_s: f64) -> VelocityField {
        let [nx, ny, nz] = self.nodes;
        let all = self.nodes.map(|n| n + 2 * GUARD);
        let mut kept = Vec::with_capacity(nx * ny * nz);
        for k in GUARD..nz + GUARD {
            for j in GUARD..ny + GUARD {
                let row = (k * all[1] + j) * all[0];
                kept.extend(row + GUARD..row + GUARD + nx);
            }
        }
        let displacement_vox: Vec<[f32; 3]> =
            kept.iter().map(|&n| vectors[n].displacement_vox).collect();
        let (vorticity, divergence) =
            curl_and_divergence(self.nodes, &displacement_vox, self.step as f64);
        VelocityField {
            grid: self.vector_grid(),
            uncertainty_vox: kept.iter().map(|&n| vectors[n].uncertainty_vox).collect(),
            status: kept.iter().map(|&n| vectors[n].status).collect(),
            peak_ratio: kept.iter().map(|&n| peaks[n].map_or(0.0, |peak| peak.ratio)).collect(),
            displacement_vox,
            vorticity,
            divergence,
            voxel_mm: self.grid.voxel_mm,
            dt_s,
        }
    }
}

/// The way from where the light is in its own frame, `at`, to where it is in the middle of the
/// pair: half a displacement, forwards for frame a (`sign` 1) and backwards for frame b (−1).
///
/// The path is curved: it is followed through the field by the midpoint rule, so that the field
/// stands for the velocity in the middle of the pair at that very place. Half the chord would miss
/// it by (d·∇)d/8.
fn half_shift(field: &Lattice, at: [f32; 3], sign: f32) -> [f32; 3] {
    let start = field.at(at);
    let halfway = std::array::from_fn(|c| at[c] + sign * start[c] / 4.0);
    field.at(halfway).map(|d| sign * d / 2.0)
}
