//! Particles that a flow moves, for tests of both kinds of interrogation.

use rand::{RngExt, SeedableRng};
use rand_pcg::Pcg64Mcg;

use super::{VectorStatus, VelocityField};
use crate::model::VolumeGrid;

/// Places (mm) and light of some particles.
pub type Particles = Vec<([f64; 3], f64)>;

/// Frames a and b of `count` particles of many brightnesses in and about `grid`, before and after `flow`
/// (voxels, of the place in the middle, in voxels) has moved them.
pub fn frames(
    seed: u64,
    grid: &VolumeGrid,
    count: usize,
    flow: impl Fn([f64; 3]) -> [f64; 3],
) -> [Particles; 2] {
    let mut random = Pcg64Mcg::seed_from_u64(seed);
    let particles: Particles = (0..count)
        .map(|_| {
            let at = grid.voxels.map(|n| random.random_range(-4.0..n as f64 + 4.0));
            (at, random.random_range(0.5..1.5))
        })
        .collect();
    [-0.5, 0.5].map(|half| {
        let moved = |&(middle, light): &([f64; 3], f64)| {
            // A quarter of the way by the flow in the middle, from there by what it is there.
            let start = flow(middle);
            let on_path = std::array::from_fn(|c| middle[c] + half * start[c] / 2.0);
            let whole = flow(on_path);
            (std::array::from_fn(|c| grid.coordinate_mm(c, middle[c] + half * whole[c])), light)
        };
        particles.iter().map(moved).collect()
    })
}

/// A smooth flow in all directions, up to 4 voxels, of a place in voxels.
pub fn waves([x, y, z]: [f64; 3]) -> [f64; 3] {
    let wave = |t: f64| 2.0 * (t * std::f64::consts::TAU / 100.0).sin();
    [wave(z) + wave(y + 25.0), wave(x) + wave(z + 25.0), wave(y) + wave(x + 25.0)]
}

/// Differences of vector `n` of a field on `grid` from `flow` at its place, in voxels.
pub fn error_vox(
    field: &VelocityField,
    grid: &VolumeGrid,
    flow: impl Fn([f64; 3]) -> [f64; 3],
    n: usize,
) -> [f64; 3] {
    let at = field.grid.position_mm(n);
    let truth = flow(std::array::from_fn(|c| grid.index_of(c, at[c])));
    std::array::from_fn(|c| f64::from(field.displacement_vox[n][c]) - truth[c])
}

/// A volume whose light ends after two thirds of its depth, and one that ends there.
pub struct DarkThird {
    /// 13 layers of windows of 16 voxels, half overlapping.
    pub whole: VolumeGrid,
    /// The first 9 of them.
    pub ended: VolumeGrid,
}

/// Voxels along z that are lit.
const LIT: usize = 80;

impl DarkThird {
    pub fn new() -> Self {
        let voxel_mm = 0.1;
        let whole = VolumeGrid { voxels: [56, 48, 112], voxel_mm, centre_mm: [0.0; 3] };
        let beyond = (whole.voxels[2] - LIT) as f64;
        let ended = VolumeGrid {
            voxels: [56, 48, LIT],
            centre_mm: [0.0, 0.0, -voxel_mm * beyond / 2.0],
            ..whole.clone()
        };
        Self { whole, ended }
    }

    /// Frames of particles that [`waves`] moves, as far as they are in the light.
    pub fn frames(&self, seed: u64) -> [Particles; 2] {
        let end_mm = self.whole.coordinate_mm(2, LIT as f64 - 0.5);
        frames(seed, &self.whole, 4000, waves).map(|mut particles| {
            particles.retain(|(at, _)| at[2] < end_mm);
            particles
        })
    }

    /// Checks that the vectors in the light are as good in the whole volume as in the one that ends with
    /// it, and that as many are valid.
    pub fn assert_same_error(&self, whole: &VelocityField, ended: &VelocityField) {
        let lit = ended.grid.len();
        let [whole, ended] = [whole, ended].map(|field| {
            let valid: Vec<usize> =
                (0..lit).filter(|&n| field.status[n] == VectorStatus::Valid).collect();
            let squares = valid.iter().flat_map(|&n| error_vox(field, &self.whole, waves, n));
            let mean = squares.map(|e| e * e).sum::<f64>() / (3 * valid.len()) as f64;
            (mean.sqrt(), valid.len())
        });
        println!("rms error and valid vectors: {whole:?}, where the volume ends {ended:?}");
        assert!(whole.0 <= 1.1 * ended.0, "{whole:?} {ended:?}");
        assert!(whole.1 as f64 >= 0.98 * ended.1 as f64, "{whole:?} {ended:?}");
    }
}
