//! Multi-pass cross-correlation with volume deformation.
//!
//! Each pass moves the light of both frames towards each other by half the displacement known so
//! far (symmetric, so the result belongs to the middle of the pair), renders them, correlates
//! interrogation windows, and adds what it finds. The first pass uses windows of at least four
//! times the largest expected displacement.

use rayon::prelude::*;

use super::{
    VectorGrid, VectorStatus, VelocimetrySettings, VelocityField,
    cloud::PointCloud,
    derived::curl_and_divergence,
    lattice::Lattice,
    peak::{Peak, highest_peak},
    spectrum::{Correlator, Workspace},
    validate::Candidates,
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
        let first_reach = (settings.max_displacement_vox * 1.25).ceil() as usize + 1;
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
        let mut status = Vec::new();
        let mut ratio = Vec::new();
        for pass in 0..self.settings.passes {
            // A window as long as the shortest wave on the lattice cannot see that wave: what noise
            // puts there would never be corrected, so it is taken out of the predictor.
            if pass > 0 {
                field = field.smoothed();
            }
            let residual = self.correlate(a, b, &field, pass);
            let present: Vec<bool> = residual.iter().map(Option::is_some).collect();
            for (value, residual) in field.values.iter_mut().zip(&residual) {
                if let Some(peak) = residual {
                    for (v, r) in value.iter_mut().zip(peak.shift_vox) {
                        *v += r;
                    }
                }
            }
            ratio = residual.iter().map(|r| r.map_or(0.0, |peak| peak.ratio)).collect();
            status = self.validate(&mut field, &present);
        }
        self.report(&field, &status, &ratio, dt_s)
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

    /// Residual displacement in every window after deformation by `field`.
    fn correlate(
        &self,
        a: &PointCloud,
        b: &PointCloud,
        field: &Lattice,
        pass: usize,
    ) -> Vec<Option<Peak>> {
        let first = pass == 0;
        let render = |cloud: &PointCloud, sign: f32| {
            let shift = |at| half_shift(field, at, sign);
            let voxels = self.cloud_grid().voxels;
            if first { cloud.render(voxels) } else { cloud.moved(shift).render(voxels) }
        };
        let (a, b) = rayon::join(|| render(a, 1.0), || render(b, -1.0));
        let correlator = &self.correlators[usize::from(!first)];
        let window = if first { self.first_window } else { self.window };
        let reach = if first {
            ((self.settings.max_displacement_vox * 1.25).ceil() as usize + 1).min(window / 2)
        } else {
            (window as f64 * LATER_REACH).ceil() as usize
        };
        // Overlapping pairs of voxels at lag s, relative to lag 0, along one axis: dividing by it
        // removes the bias towards zero of a finite window.
        let weight: Vec<f32> =
            (0..=reach + 1).map(|s| window as f32 / (window as f32 - s as f32).max(1.0)).collect();
        let [nx, ny, _] = field.nodes;
        (0..field.values.len())
            .into_par_iter()
            .map_init(
                || correlator.workspace(),
                |workspace, index| {
                    let node = [index % nx, index / nx % ny, index / (nx * ny)];
                    let corner = node.map(|n| {
                        let centred = (self.window as i64 - window as i64) / 2;
                        (self.margin + n * self.step) as i64 - (GUARD * self.step) as i64 + centred
                    });
                    self.fill(correlator, workspace, &a, &b, corner, window).then(|| {
                        correlator.correlate(workspace);
                        highest_peak(correlator, &workspace.a, reach, &weight)
                    })?
                },
            )
            .collect()
    }

    /// Copies a window of both frames into the workspace, without its mean, padded with zeros.
    /// False when either holds no light.
    fn fill(
        &self,
        correlator: &Correlator,
        workspace: &mut Workspace,
        a: &[f32],
        b: &[f32],
        corner: [i64; 3],
        window: usize,
    ) -> bool {
        let voxels = self.grid.voxels.map(|n| n + 2 * self.margin);
        let lit_a = copy_window(a, voxels, corner, window, &mut workspace.a, correlator.edge());
        let lit_b = copy_window(b, voxels, corner, window, &mut workspace.b, correlator.edge());
        lit_a && lit_b
    }

    /// Tests the field, puts interpolated vectors where it fails, and says which is which.
    fn validate(&self, field: &mut Lattice, present: &[bool]) -> Vec<VectorStatus> {
        let candidates = Candidates { nodes: field.nodes, values: &field.values, present };
        let pass =
            candidates.passing(self.settings.median_threshold, self.settings.median_epsilon_vox);
        let (values, status) = (0..pass.len())
            .map(|index| match (pass[index], candidates.interpolated(index, &pass)) {
                (true, _) => (field.values[index], VectorStatus::Valid),
                (false, Some(value)) => (value, VectorStatus::Replaced),
                (false, None) => ([0.0; 3], VectorStatus::Invalid),
            })
            .unzip();
        field.values = values;
        status
    }

    fn report(
        &self,
        field: &Lattice,
        status: &[VectorStatus],
        ratio: &[f32],
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
            curl_and_divergence(self.nodes, &displacement_vox, self.step as f64);
        VelocityField {
            grid: self.vector_grid(),
            status: kept.iter().map(|&n| status[n]).collect(),
            peak_ratio: kept.iter().map(|&n| ratio[n]).collect(),
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

/// Copies a cubic window of an image (`voxels` along x, y, z) into a zeroed cube of edge `edge`,
/// less the window's mean; what lies outside the image counts as dark. False when all is dark.
fn copy_window(
    image: &[f32],
    voxels: [usize; 3],
    corner: [i64; 3],
    window: usize,
    cube: &mut [f32],
    edge: usize,
) -> bool {
    cube.fill(0.0);
    let inside = |axis: usize| {
        let low = corner[axis].clamp(0, voxels[axis] as i64);
        let high = (corner[axis] + window as i64).clamp(low, voxels[axis] as i64);
        low as usize..high as usize
    };
    let (xs, ys, zs) = (inside(0), inside(1), inside(2));
    let to = |axis: usize, place: usize| (place as i64 - corner[axis]) as usize;
    let mut sum = 0.0f64;
    for z in zs.clone() {
        for y in ys.clone() {
            let from = (z * voxels[1] + y) * voxels[0];
            let row = &image[from + xs.start..from + xs.end];
            let start = (to(2, z) * edge + to(1, y)) * edge + to(0, xs.start);
            cube[start..start + row.len()].copy_from_slice(row);
            sum += row.iter().map(|&v| f64::from(v)).sum::<f64>();
        }
    }
    let count = xs.len() * ys.len() * zs.len();
    if sum <= 0.0 || count == 0 {
        return false;
    }
    let mean = (sum / count as f64) as f32;
    for z in zs {
        for y in ys.clone() {
            let start = (to(2, z) * edge + to(1, y)) * edge + to(0, xs.start);
            cube[start..start + xs.len()].iter_mut().for_each(|v| *v -= mean);
        }
    }
    true
}

/// The next edge at least `n` with factors 2 and 3 only: fast for the transform.
fn fast_edge(n: usize) -> usize {
    let smooth = |mut m: usize| {
        while m.is_multiple_of(2) {
            m /= 2;
        }
        while m.is_multiple_of(3) {
            m /= 3;
        }
        m == 1
    };
    (n..).find(|&m| smooth(m)).unwrap_or(n)
}
