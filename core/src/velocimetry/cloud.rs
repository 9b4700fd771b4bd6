//! Light as a cloud of weighted points.
//!
//! A reconstructed volume is nearly empty, so it is deformed by moving its lit voxels and
//! rendering them again (`raster`), not by interpolating a dense array: the deformation is exact and costs
//! nothing where there is no light. True particles take the same path, which is what makes them
//! the floor that a reconstruction is measured against.

use crate::{model::VolumeGrid, reconstruction::SparseVolume};

/// Points of light in units of a grid's voxels: voxel (i, j, k) has its centre at (i, j, k).
#[derive(Debug, Clone, PartialEq)]
pub struct PointCloud {
    /// Position of each point along x, y, z, in voxels.
    pub position_vox: Vec<[f32; 3]>,
    /// Light of each point, in any unit; finite and not negative.
    pub light: Vec<f32>,
    /// Edge of the voxels that the points stand for, in voxels; 0 for points as such.
    pub grain_vox: f32,
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
        let grain_vox = (own.voxel_mm / grid.voxel_mm) as f32;
        Self { position_vox, light: volume.intensity.clone(), grain_vox }
    }

    /// Particles at world positions (mm), in voxels of `grid`.
    pub fn from_particles(particles: &[([f64; 3], f64)], grid: &VolumeGrid) -> Self {
        Self {
            position_vox: particles
                .iter()
                .map(|(at, _)| std::array::from_fn(|axis| grid.index_of(axis, at[axis]) as f32))
                .collect(),
            light: particles.iter().map(|&(_, light)| light as f32).collect(),
            grain_vox: 0.0,
        }
    }
}
