//! Light rendered onto cells: the arrays that are correlated.

use multiversion::multiversion;

use super::{cloud::PointCloud, lattice::Lattice};

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
    let t = at - cell as f32;
    let s = 1.0 - t;
    let weights = [
        s * s * s / 6.0,
        2.0 / 3.0 - t * t * (2.0 - t) / 2.0,
        2.0 / 3.0 - s * s * (2.0 - s) / 2.0,
        t * t * t / 6.0,
    ];
    (cell - 1, weights)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_point_keeps_its_light_and_its_place() {
        let raster = Raster { cells: [9, 8, 7], first_vox: [2.0, 0.0, -4.0], cell_vox: 2.0 };
        let cloud = PointCloud { position_vox: vec![[10.3, 7.9, 2.6]], light: vec![3.0] };
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
