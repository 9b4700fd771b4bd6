//! Light rendered onto cells: the arrays that are correlated.

use multiversion::multiversion;

use super::{b_spline, cloud::PointCloud, lattice::Lattice};
use crate::model::VolumeGrid;

/// A box of cubic cells in space. Rows along x are contiguous, z is slowest.
#[derive(Debug, Clone, PartialEq)]
pub struct Raster {
    /// Cells along x, y, z.
    pub cells: [usize; 3],
    /// Centre of cell (0, 0, 0), in voxels.
    pub first_vox: [f32; 3],
    /// Edge of a cell, in voxels.
    pub cell_vox: f32,
}

impl Raster {
    /// Number of cells.
    pub fn len(&self) -> usize {
        self.cells.iter().product()
    }

    /// The cells along `axis` whose centres lie in `low_vox..high_vox`.
    pub fn within(&self, axis: usize, low_vox: f32, high_vox: f32) -> [i64; 2] {
        [low_vox, high_vox].map(|at| ((at - self.first_vox[axis]) / self.cell_vox).ceil() as i64)
    }

    /// Renders a cloud, each point moved by `shift_vox` where it is given, as a cubic B-spline
    /// four cells wide: close to a Gaussian of 0.58 cells standard deviation, summing to the
    /// point's light wherever it lies, so that correlation peaks suit the three-point Gaussian
    /// fit. Points within two cells of the raster's faces, or outside, are left out.
    pub fn render(&self, cloud: &PointCloud, shift_vox: Option<&Lattice>) -> Vec<f32> {
        let mut image = vec![0.0f32; self.len()];
        splat(self, cloud, shift_vox, &mut image);
        image
    }
}

impl PointCloud {
    /// The cloud on the voxels of `grid` (z, y, x), whose voxels its positions count: see
    /// [`Raster::render`].
    pub fn render(&self, grid: &VolumeGrid) -> Vec<f32> {
        let raster = Raster { cells: grid.voxels, first_vox: [0.0; 3], cell_vox: 1.0 };
        raster.render(self, None)
    }
}

/// A cloud as rendered on a raster.
#[derive(Debug, Clone, Copy)]
pub struct Image<'a> {
    /// The light of every cell.
    pub light: &'a [f32],
    /// Cells along x, y, z.
    pub cells: [usize; 3],
    /// First cell with known light along each axis, and the one after the last.
    pub lit: [[i64; 2]; 3],
}

impl Image<'_> {
    /// The part of a cube of edge `edge` at `corner` whose light is known, as first cell and end
    /// along each axis.
    pub fn inside(&self, corner: [i64; 3], edge: usize) -> [[i64; 2]; 3] {
        std::array::from_fn(|axis| {
            let first = self.lit[axis][0].max(0);
            let end = self.lit[axis][1].min(self.cells[axis] as i64).max(first);
            let low = corner[axis].clamp(first, end);
            [low, (corner[axis] + edge as i64).clamp(low, end)]
        })
    }

    /// The cells `[from, to)` of the row along x at `y`, `z`, all of them inside.
    pub fn row(&self, [from, to]: [i64; 2], y: i64, z: i64) -> &[f32] {
        let start = (z as usize * self.cells[1] + y as usize) * self.cells[0];
        &self.light[start + from as usize..start + to as usize]
    }
}

#[multiversion(targets("x86_64+avx512f+avx512vl", "x86_64+avx2"))]
fn splat(raster: &Raster, cloud: &PointCloud, shift_vox: Option<&Lattice>, image: &mut [f32]) {
    let [nx, ny, _] = raster.cells;
    let per_cell = 1.0 / raster.cell_vox;
    for (at, &light) in cloud.position_vox.iter().zip(&cloud.light) {
        let shift = shift_vox.map_or([0.0; 3], |field| field.at(*at));
        let place: [f32; 3] =
            std::array::from_fn(|a| (at[a] + shift[a] - raster.first_vox[a]) * per_cell);
        if !(0..3).all(|a| place[a] >= 1.0 && place[a] < raster.cells[a] as f32 - 2.0) {
            continue;
        }
        let [(i, wx), (j, wy), (k, wz)] = place.map(spline_taps);
        for (c, wz) in wz.iter().enumerate() {
            for (b, wy) in wy.iter().enumerate() {
                let start = ((k + c) * ny + j + b) * nx + i;
                let scaled = light * wz * wy;
                for (cell, wx) in image[start..start + 4].iter_mut().zip(wx) {
                    *cell += scaled * wx;
                }
            }
        }
    }
}

/// First of the four cells under a cubic B-spline at `at` (at least 1), and its weights on them.
#[inline(always)]
fn spline_taps(at: f32) -> (usize, [f32; 4]) {
    let cell = at as usize;
    (cell - 1, b_spline::weights(at - cell as f32))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_point_keeps_its_light_and_its_place() {
        let raster = Raster { cells: [9, 8, 7], first_vox: [2.0, 0.0, -4.0], cell_vox: 2.0 };
        let cloud =
            PointCloud { position_vox: vec![[10.3, 7.9, 2.6]], light: vec![3.0], grain_vox: 0.0 };
        let drift = Lattice {
            nodes: [1; 3],
            first_vox: [0.0; 3],
            step_vox: 8.0,
            values: vec![[0.0, 0.0, 0.4]],
        };
        let image = raster.render(&cloud, Some(&drift));
        let sum: f32 = image.iter().sum();
        assert!((sum - 3.0).abs() < 1e-5);
        for (axis, expected) in [10.3, 7.9, 3.0].into_iter().enumerate() {
            let stride: usize = raster.cells[..axis].iter().product();
            let moment: f32 = (image.iter().enumerate())
                .map(|(n, v)| v * (n / stride % raster.cells[axis]) as f32)
                .sum();
            let at = raster.first_vox[axis] + raster.cell_vox * moment / sum;
            assert!((at - expected).abs() < 1e-4, "{at} {expected}");
        }
    }
}
