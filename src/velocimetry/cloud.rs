//! Light as a cloud of weighted points, and its rendering onto a grid.
//!
//! A reconstructed volume is nearly empty, so it is deformed by moving its lit voxels and
//! rendering them again, not by interpolating a dense array: the deformation is exact and costs
//! nothing where there is no light. True particles take the same path, which is what makes them
//! the floor that a reconstruction is measured against.

use rayon::prelude::*;

use crate::{model::VolumeGrid, reconstruction::SparseVolume};

/// Points of light in units of a grid's voxels: voxel (i, j, k) has its centre at (i, j, k).
#[derive(Debug, Clone, PartialEq)]
pub struct PointCloud {
    /// Position of each point along x, y, z, in voxels.
    pub position_vox: Vec<[f32; 3]>,
    /// Light of each point, in any unit; finite and not negative.
    pub light: Vec<f32>,
}

impl PointCloud {
    /// The lit voxels of a volume, in voxels of `grid`, which may be coarser than the volume's own.
    pub fn from_volume(volume: &SparseVolume, grid: &VolumeGrid) -> Self {
        let own = &volume.grid;
        let maps: [Vec<f32>; 3] = std::array::from_fn(|axis| {
            (0..own.voxels[axis])
                .map(|n| grid.index_of(axis, own.coordinate_mm(axis, n as f64)) as f32)
                .collect()
        });
        let position_vox = (0..volume.voxels.len())
            .map(|n| {
                let index = volume.index_of(n);
                std::array::from_fn(|axis| maps[axis][index[axis]])
            })
            .collect();
        Self { position_vox, light: volume.intensity.clone() }
    }

    /// Particles at world positions (mm), in voxels of `grid`.
    pub fn from_particles(particles: &[([f64; 3], f64)], grid: &VolumeGrid) -> Self {
        Self {
            position_vox: particles
                .iter()
                .map(|(at, _)| std::array::from_fn(|axis| grid.index_of(axis, at[axis]) as f32))
                .collect(),
            light: particles.iter().map(|&(_, light)| light as f32).collect(),
        }
    }

    /// The cloud with every point moved by `shift_vox(position)`.
    pub fn moved(&self, shift_vox: impl Fn([f32; 3]) -> [f32; 3] + Sync) -> Self {
        let position_vox = self
            .position_vox
            .par_iter()
            .map(|&at| {
                let shift = shift_vox(at);
                std::array::from_fn(|axis| at[axis] + shift[axis])
            })
            .collect();
        Self { position_vox, light: self.light.clone() }
    }

    /// Renders the cloud onto a grid of `voxels` (x, y, z), stored z, y, x, each point as a cubic
    /// B-spline: close to a Gaussian of 0.58 voxels standard deviation, summing to the point's
    /// light wherever it lies, so that correlation peaks suit the three-point Gaussian fit.
    pub fn render(&self, voxels: [usize; 3]) -> Vec<f32> {
        let [nx, ny, nz] = voxels;
        let mut image = vec![0.0f32; nx * ny * nz];
        for (at, &light) in self.position_vox.iter().zip(&self.light) {
            let inside = (0..3).all(|a| at[a] >= 1.0 && at[a] < voxels[a] as f32 - 2.0);
            if !inside {
                continue;
            }
            let ([i, wx], [j, wy], [k, wz]) =
                (spline_taps(at[0]), spline_taps(at[1]), spline_taps(at[2]));
            let _ = (&i, &j, &k, nz);
            let first = [i[0] as usize, j[0] as usize, k[0] as usize];
            for (c, wz) in wz.iter().enumerate() {
                for (b, wy) in wy.iter().enumerate() {
                    let start = ((first[2] + c) * ny + first[1] + b) * nx + first[0];
                    let scaled = light * wz * wy;
                    for (pixel, wx) in image[start..start + 4].iter_mut().zip(wx) {
                        *pixel += scaled * wx;
                    }
                }
            }
        }
        image
    }
}

/// First of the four voxels under a cubic B-spline at `at`, and its weights on them.
fn spline_taps(at: f32) -> [[f32; 4]; 2] {
    let floor = at.floor();
    let t = at - floor;
    let s = 1.0 - t;
    let weights = [
        s * s * s / 6.0,
        2.0 / 3.0 - t * t * (2.0 - t) / 2.0,
        2.0 / 3.0 - s * s * (2.0 - s) / 2.0,
        t * t * t / 6.0,
    ];
    [[floor - 1.0; 4], weights]
}
