//! Light on cubic cells, with a border as wide as the lags.

use rayon::prelude::*;

use super::{
    expansion::{Axis, Expansion},
    profile::{Profile, Rows, add_scaled},
};
use crate::{
    reconstruction::DenseVolume,
    velocimetry::{b_spline::ON_NODES, windows::Windows},
};

/// Light on cells of whole voxels, from voxel (0, 0, 0) on; there is none outside.
#[derive(Debug, Clone, PartialEq)]
pub struct CellLight {
    /// Cells along x, y, z, stored z, y, x.
    pub cells: [usize; 3],
    /// Edge of a cell, in voxels.
    pub cell_vox: usize,
    /// Cells stored around these on every side.
    pub border: usize,
    values: Vec<f32>,
}

impl CellLight {
    /// Padding after the last value, for kernels that read whole lanes.
    const SPARE: usize = 32;

    /// No light.
    pub fn dark(cells: [usize; 3], cell_vox: usize, border: usize) -> Self {
        let mut light = Self { cells, cell_vox, border, values: Vec::new() };
        let [_, plane] = light.strides();
        light.values = vec![0.0; plane * (cells[2] + 2 * border) + Self::SPARE];
        light
    }

    /// A volume's light less its local mean, that of `windows` of a `profile`, between whose centres it
    /// is interpolated.
    ///
    /// Random products of such light have zero mean. Cells outside contain the mean, which is zero, so windows need
    /// no correction for the part outside the volume.
    pub fn without_mean(
        volume: &DenseVolume,
        windows: &Windows,
        profile: &Profile,
        border: usize,
    ) -> Self {
        let [nx, ny, nz] = volume.grid.voxels;
        let row = |[y, z]: [usize; 2]| &volume.intensity[(z * ny + y) * nx..][..nx];
        let sums = Rows { cells: [nx, ny], numbers: 1, at: row }.box_sums(&profile.spans(windows));
        let mut means = windows.at_rest();
        for (mean, sum) in means.values.iter_mut().zip(sums) {
            mean[0] = sum / profile.sum();
        }
        let mut light = Self::dark([nx, ny, nz], 1, border);
        let means = Expansion::new(&means, 0, light.axes(0));
        light.each_row(|to, at| {
            means.write_row(at, -1.0, to);
            add_scaled(to, 1.0, row(at));
        });
        light
    }

    /// The same light summed over cells of `cell_vox` voxels; the last ones may be partly outside.
    pub fn binned(&self, cell_vox: usize, border: usize) -> Self {
        let bin = cell_vox / self.cell_vox;
        let mut binned = Self::dark(self.cells.map(|n| n.div_ceil(bin)), cell_vox, border);
        binned.each_row(|row, [y, z]| {
            let within = |n: usize, count: usize| n * bin..((n + 1) * bin).min(count);
            let mut sums = vec![0.0; self.cells[0]];
            for z in within(z, self.cells[2]) {
                for y in within(y, self.cells[1]) {
                    add_scaled(&mut sums, 1.0, self.row([y, z]));
                }
            }
            for (sum, cells) in row.iter_mut().zip(sums.chunks(bin)) {
                *sum = cells.iter().sum();
            }
        });
        binned
    }

    /// The light as a sum of cubic B-splines with nodes one cell apart, sampled in the cells: equal to warping by zero
    /// displacement.
    pub fn splined(&self) -> Self {
        let [nx, ny, nz] = self.cells;
        let mut splined = Self::dark(self.cells, self.cell_vox, self.border);
        let taps = |n: usize, count: usize| {
            let beside = n.saturating_sub(1)..(n + 2).min(count);
            beside.map(move |other| (other, ON_NODES[n.abs_diff(other)]))
        };
        let border = self.border;
        let [row, _] = self.strides();
        splined.each_stored_plane(|to, stored| {
            let Some(z) = stored.checked_sub(border).filter(|&z| z < nz) else { return };
            let mut along_z = vec![0.0; nx * ny];
            for (z, weight) in taps(z, nz) {
                for (y, sums) in along_z.chunks_exact_mut(nx).enumerate() {
                    add_scaled(sums, weight, self.row([y, z]));
                }
            }
            let mut along_y = vec![0.0; nx];
            for y in 0..ny {
                along_y.fill(0.0);
                for (y, weight) in taps(y, ny) {
                    add_scaled(&mut along_y, weight, &along_z[y * nx..]);
                }
                let to = &mut to[(y + border) * row + border..][..nx];
                add_scaled(to, ON_NODES[0], &along_y);
                add_scaled(&mut to[1..], ON_NODES[1], &along_y);
                add_scaled(to, ON_NODES[1], &along_y[1..]);
            }
        });
        splined
    }

    /// A layer of cells, and the same once more beside it along z.
    pub fn doubled_layer(&self) -> Self {
        let [nx, ny, _] = self.cells;
        let mut doubled = Self::dark([nx, ny, 2], self.cell_vox, self.border);
        doubled.each_row(|row, [y, _]| row.copy_from_slice(self.row([y, 0])));
        doubled
    }

    /// Values from one row, and from one plane, to the next.
    pub fn strides(&self) -> [usize; 2] {
        let row = self.cells[0] + 2 * self.border;
        [row, row * (self.cells[1] + 2 * self.border)]
    }

    /// Place of cell (0, 0, 0) among the stored values.
    pub fn origin(&self) -> usize {
        let [row, plane] = self.strides();
        self.border * (1 + row + plane)
    }

    /// All that is stored, the border included.
    pub fn stored(&self) -> &[f32] {
        &self.values
    }

    /// The cells at y, z, without the border.
    pub fn row(&self, [y, z]: [usize; 2]) -> &[f32] {
        let [row, plane] = self.strides();
        &self.values[self.origin() + z * plane + y * row..][..self.cells[0]]
    }

    /// The cells along every axis and `border` more on each side, in voxels.
    pub fn axes(&self, border: usize) -> [Axis; 3] {
        let step_vox = self.cell_vox as f32;
        let first_vox = (step_vox - 1.0) / 2.0 - border as f32 * step_vox;
        self.cells.map(|n| Axis { first_vox, step_vox, count: n + 2 * border })
    }

    /// Lets `fill` change every row of cells, whose y and z it is told; planes in parallel.
    pub fn each_row(&mut self, fill: impl Fn(&mut [f32], [usize; 2]) + Sync) {
        let ([row, plane], [nx, ny, nz], border) = (self.strides(), self.cells, self.border);
        let planes = self.values.par_chunks_exact_mut(plane).skip(border).take(nz);
        planes.enumerate().for_each(|(z, plane)| {
            let rows = plane.chunks_exact_mut(row).skip(border).take(ny);
            for (y, row) in rows.enumerate() {
                fill(&mut row[border..border + nx], [y, z]);
            }
        });
    }

    /// Lets `fill` change every plane that is stored, counted from the border's first.
    pub fn each_stored_plane(&mut self, fill: impl Fn(&mut [f32], usize) + Sync) {
        let ([_, plane], planes) = (self.strides(), self.cells[2] + 2 * self.border);
        let planes = self.values.par_chunks_exact_mut(plane).take(planes);
        planes.enumerate().for_each(|(z, plane)| fill(plane, z));
    }
}

#[cfg(test)]
pub mod tests {
    use rand::{RngExt, SeedableRng};
    use rand_pcg::Pcg64Mcg;

    use super::{super::warp::warped, *};
    use crate::model::VolumeGrid;

    /// Random light, the border included.
    pub fn random_light(cells: [usize; 3], border: usize, seed: u64) -> CellLight {
        let mut light = CellLight::dark(cells, 1, border);
        light.each_stored_plane(|plane, z| {
            let mut random = Pcg64Mcg::seed_from_u64(seed * 1000 + z as u64);
            plane.fill_with(|| random.random_range(-0.5..1.0));
        });
        light
    }

    #[test]
    fn bins_hold_the_light_of_their_cells() {
        let light = random_light([9, 7, 8], 1, 3);
        let binned = light.binned(3, 2);
        assert_eq!((binned.cells, binned.cell_vox), ([3, 3, 3], 3));
        let mut expected = [0.0; 27];
        for (z, y) in (0..8).flat_map(|z| (0..7).map(move |y| (z, y))) {
            for (x, value) in light.row([y, z]).iter().enumerate() {
                expected[(z / 3 * 3 + y / 3) * 3 + x / 3] += value;
            }
        }
        for (n, expected) in expected.iter().enumerate() {
            assert!((binned.row([n / 3 % 3, n / 9])[n % 3] - expected).abs() < 1e-4);
        }
        let sum = |light: &CellLight| light.stored().iter().sum::<f32>();
        assert!((sum(&binned) - expected.iter().sum::<f32>()).abs() < 1e-3, "a dark border");
    }

    #[test]
    fn splined_light_equals_warping_by_zero_displacement() {
        let light = random_light([9, 7, 8], 1, 5);
        let windows =
            Windows { nodes: [2; 3], edge: 4, step: 3, cell_vox: 1.0, first_vox: [1.5; 3] };
        let (splined, found) = (light.splined(), warped(&light, &windows.at_rest(), 1));
        for (z, y) in (0..8).flat_map(|z| (0..7).map(move |y| (z, y))) {
            for (a, b) in splined.row([y, z]).iter().zip(found.row([y, z])) {
                assert!((a - b).abs() < 1e-5, "{a} {b}");
            }
        }
    }

    #[test]
    fn light_that_rises_evenly_has_nothing_over_its_mean() {
        let grid = VolumeGrid { voxels: [32, 24, 24], voxel_mm: 0.1, centre_mm: [0.0; 3] };
        let intensity =
            (0..grid.len()).map(|n| 5.0 + 0.1 * (n % 32) as f32 + 0.2 * (n / 768) as f32).collect();
        let volume = DenseVolume { grid, intensity };
        let windows =
            Windows { nodes: [3, 2, 2], edge: 16, step: 8, cell_vox: 1.0, first_vox: [7.5; 3] };
        let light = CellLight::without_mean(&volume, &windows, &Profile::peaked(16), 1);
        assert!(light.stored().iter().all(|value| value.abs() < 1e-3));
    }
}
