//! Particles of a reconstructed volume, and the windows that contain particles.

use nalgebra::Point3;

use super::disparity::Source;
use crate::{
    model::VolumeGrid,
    reconstruction::SparseVolume,
    statistics::median,
    velocimetry::{PointCloud, VectorGrid, particles},
};

/// Sufficient number of particles: for the number of parameters of a bench error it leaves 0.05
/// voxel of noise on the bench.
const ENOUGH: usize = 1500;

/// Approximate number of lit voxels per particle, to choose the examined part of a volume.
const VOXELS_PER_PARTICLE: usize = 30;

/// Edge of the sampled boxes and width of their rim, in which particles may be cut, in configured
/// voxels.
const BOX_VOX: f64 = 10.0;
const RIM_VOX: f64 = 1.0;

/// Particles with less than this share of the median particle's light are reconstruction artefacts.
const MIN_LIGHT: f64 = 0.5;

/// Minimum number of windows with particles for a statement about the correlation.
const MIN_WINDOWS: usize = 8;

/// A window is expected to give a vector if it contains at least this many particles ...
const MIN_PARTICLES: f64 = 3.0;

/// ... and at least this share of the mean window's light: the rest is artefacts.
const MIN_SHARE_OF_MEAN: f64 = 0.25;

/// Bright particles of `light`, evenly distributed over `volume`, at most a few times [`ENOUGH`].
/// Dense particles give noisy positions: at 1 ppm, 1500 particles do not reveal a camera rotated by
/// one degree.
pub fn sources(light: &SparseVolume, volume: &VolumeGrid) -> Vec<Source> {
    let every = (light.voxels.len() / (VOXELS_PER_PARTICLE * ENOUGH)).max(1);
    let cloud = in_some_boxes(&PointCloud::from_volume(light, volume), every);
    let found = particles(&cloud);
    let Some(median) = median(found.iter().map(|particle| particle.light)) else {
        return Vec::new();
    };
    found
        .iter()
        .filter(|particle| {
            f64::from(particle.light) > MIN_LIGHT * median
                && (0..3).all(|axis| {
                    let at = f64::from(particle.at_vox[axis]);
                    let inside = (-0.5..volume.voxels[axis] as f64 - 0.5).contains(&at);
                    inside && (every == 1 || !in_rim(at))
                })
        })
        .map(|particle| Source {
            at_mm: Point3::from(std::array::from_fn(|axis| {
                volume.coordinate_mm(axis, f64::from(particle.at_vox[axis]))
            })),
            counts: f64::from(particle.light),
        })
        .collect()
}

/// The points of one in `every` boxes.
fn in_some_boxes(cloud: &PointCloud, every: usize) -> PointCloud {
    if every == 1 {
        return cloud.clone();
    }
    let chosen = |at: &[f32; 3]| {
        let [i, j, k] = at.map(|place| (f64::from(place) / BOX_VOX).floor() as i64);
        (i + 3 * j + 5 * k).rem_euclid(every as i64) == 0
    };
    let points = cloud.position_vox.iter().zip(&cloud.light).filter(|(at, _)| chosen(at));
    let (position_vox, light) = points.map(|(&at, &light)| (at, light)).unzip();
    PointCloud { position_vox, light, grain_vox: cloud.grain_vox }
}

fn in_rim(at_vox: f64) -> bool {
    let in_box = at_vox.rem_euclid(BOX_VOX);
    !(RIM_VOX..=BOX_VOX - RIM_VOX).contains(&in_box)
}

/// Indices in `grid` of the windows of edge `window_mm` that contain the light of some particles.
/// `None` with too few of them.
pub fn lit_windows(
    light: &SparseVolume,
    grid: &VectorGrid,
    window_mm: f64,
    particle_counts: f64,
) -> Option<Vec<usize>> {
    let [nx, ny, _] = grid.vectors;
    let mut cells = vec![0.0f64; grid.len()];
    // Every voxel counts for the nearest node; cells are smaller than windows if windows overlap.
    for (n, &intensity) in light.intensity.iter().enumerate() {
        let at = light.position_mm(n);
        let node: [f64; 3] = std::array::from_fn(|axis| {
            ((at[axis] - grid.first_mm[axis]) / grid.spacing_mm).round()
        });
        if (0..3).all(|axis| node[axis] >= 0.0 && node[axis] < grid.vectors[axis] as f64) {
            let [i, j, k] = node.map(|index| index as usize);
            cells[(k * ny + j) * nx + i] += f64::from(intensity);
        }
    }
    let mean = cells.iter().sum::<f64>() / cells.len().max(1) as f64;
    let cells_per_window = (window_mm / grid.spacing_mm).powi(3).max(1.0);
    let least = (MIN_PARTICLES * particle_counts / cells_per_window).max(MIN_SHARE_OF_MEAN * mean);
    let lit: Vec<usize> = (0..cells.len()).filter(|&n| cells[n] > least).collect();
    (lit.len() >= MIN_WINDOWS).then_some(lit)
}
