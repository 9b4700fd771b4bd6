//! Reconstructed light for display: the volume on the configured grid, and its projections.

use super::SparseVolume;
use crate::model::VolumeGrid;

/// Maximum intensity along one axis, for every position on the other two.
#[derive(Debug, Clone, PartialEq)]
pub struct MaximumProjection {
    /// Pixels along the first and second remaining axis.
    pub size: [usize; 2],
    /// One intensity per pixel, the first axis fastest.
    pub intensity: Vec<f32>,
}

impl MaximumProjection {
    fn dark(size: [usize; 2]) -> Self {
        Self { size, intensity: vec![0.0; size[0] * size[1]] }
    }

    fn raise(&mut self, [a, b]: [usize; 2], light: f32) {
        let pixel = &mut self.intensity[b * self.size[0] + a];
        *pixel = pixel.max(light);
    }
}

/// The light of one frame on the configured grid.
#[derive(Debug, Clone, PartialEq)]
pub struct FrameLight {
    /// Its lit voxels; `None` if only the projections are stored.
    pub volume: Option<SparseVolume>,
    /// Maxima along z, y and x: the planes xy, xz and yz.
    pub projections: [MaximumProjection; 3],
}

impl FrameLight {
    /// Sums a finer or larger volume onto `grid`. One pass over the lit voxels and one over the
    /// grid: 20 to 50 ms per million lit voxels (measured on two busy cores), compared with a
    /// second for their reconstruction.
    pub fn new(volume: &SparseVolume, grid: &VolumeGrid) -> Self {
        let dense = volume.on_grid(grid);
        let lit = dense.intensity.iter().enumerate().filter(|(_, light)| **light > 0.0);
        let (voxels, intensity) = lit.map(|(voxel, &light)| (voxel as u32, light)).unzip();
        let volume = SparseVolume { grid: grid.clone(), voxels, intensity };
        let projections = projections(&volume);
        Self { volume: Some(volume), projections }
    }

    /// Memory of the volume in bytes.
    pub fn volume_bytes(&self) -> usize {
        let voxels = self.volume.as_ref().map_or(0, |volume| volume.voxels.len());
        voxels * (size_of::<u32>() + size_of::<f32>())
    }

    /// Memory of the projections in bytes.
    pub fn projection_bytes(&self) -> usize {
        self.projections.iter().map(|plane| plane.intensity.len() * size_of::<f32>()).sum()
    }
}

fn projections(volume: &SparseVolume) -> [MaximumProjection; 3] {
    let [nx, ny, nz] = volume.grid.voxels;
    let mut planes = [[nx, ny], [nx, nz], [ny, nz]].map(MaximumProjection::dark);
    for (n, &light) in volume.intensity.iter().enumerate() {
        let [i, j, k] = volume.index_of(n);
        for (plane, at) in planes.iter_mut().zip([[i, j], [i, k], [j, k]]) {
            plane.raise(at, light);
        }
    }
    planes
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_projection_holds_the_largest_sum_along_its_axis() {
        let grid = VolumeGrid { voxels: [4, 3, 2], voxel_mm: 0.2, centre_mm: [0.0; 3] };
        let fine = grid.padded(1).refined(2);
        // Two fine voxels in coarse (1, 2, 0), one in (1, 2, 1), one in the margin.
        let at = |i: usize, j: usize, k: usize| fine.linear([i, j, k]) as u32;
        let voxels = vec![at(0, 0, 0), at(4, 6, 2), at(5, 7, 3), at(4, 6, 4)];
        let volume = SparseVolume { grid: fine, voxels, intensity: vec![9.0, 1.0, 2.0, 2.5] };
        let light = FrameLight::new(&volume, &grid);
        let expected = [grid.linear([1, 2, 0]) as u32, grid.linear([1, 2, 1]) as u32];
        assert_eq!(light.volume_bytes(), 16);
        let volume = light.volume.as_ref().unwrap();
        assert_eq!(volume.voxels, expected);
        assert_eq!(volume.intensity, [3.0, 2.5]);
        let [xy, xz, yz] = &light.projections;
        assert_eq!((xy.size, xz.size, yz.size), ([4, 3], [4, 2], [3, 2]));
        let lit = |plane: &MaximumProjection| {
            let lit = plane.intensity.iter().enumerate().filter(|(_, light)| **light > 0.0);
            lit.map(|(n, light)| (n, *light)).collect::<Vec<_>>()
        };
        assert_eq!(lit(xy), [(2 * 4 + 1, 3.0)]);
        assert_eq!(lit(xz), [(1, 3.0), (5, 2.5)]);
        assert_eq!(lit(yz), [(2, 3.0), (5, 2.5)]);
        assert_eq!(light.projection_bytes(), 4 * (12 + 8 + 6));
    }
}
