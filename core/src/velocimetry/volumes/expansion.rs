//! A lattice's values on rows of cells.

use multiversion::multiversion;

use crate::velocimetry::lattice::{AxisTaps, Lattice, axis_taps};

/// One component of a lattice on the cells of a box, as [`Lattice::at`] has it.
///
/// Along x and y once, on the lattice's own planes; along z row by row, where four rows are added as
/// they lie in memory.
#[derive(Debug)]
pub struct Expansion {
    cells: [usize; 2],
    planes: Vec<f32>,
    along_z: Vec<AxisTaps>,
}

/// Cells along an axis.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Axis {
    /// Centre of the first, in voxels.
    pub first_vox: f32,
    /// Distance of their centres, in voxels.
    pub step_vox: f32,
    /// How many there are.
    pub count: usize,
}

impl Expansion {
    /// Component `component` of `field` on the cells of `axes`.
    pub fn new(field: &Lattice, component: usize, axes: [Axis; 3]) -> Self {
        let [xs, ys, along_z]: [Vec<AxisTaps>; 3] = std::array::from_fn(|axis| {
            let Axis { first_vox, step_vox, count } = axes[axis];
            (0..count)
                .map(|n| {
                    let from_node = first_vox + n as f32 * step_vox - field.first_vox[axis];
                    axis_taps(from_node / field.step_vox, field.nodes[axis])
                })
                .collect()
        });
        let cells = [xs.len(), ys.len()];
        let along_x: Vec<f32> = field
            .values
            .chunks_exact(field.nodes[0])
            .flat_map(|row| {
                xs.iter().map(|(at, weight)| {
                    at.iter().zip(weight).map(|(&n, w)| w * row[n][component]).sum::<f32>()
                })
            })
            .collect();
        let mut planes = vec![0.0; cells[0] * cells[1] * field.nodes[2]];
        let from = along_x.chunks_exact(cells[0] * field.nodes[1]);
        for (plane, from) in planes.chunks_exact_mut(cells[0] * cells[1]).zip(from) {
            for (row, taps) in plane.chunks_exact_mut(cells[0]).zip(&ys) {
                weighted(taps, cells[0], from, 1.0, row);
            }
        }
        Self { cells, planes, along_z }
    }

    /// Writes `scale` times the values at y, z to `row`.
    pub fn write_row(&self, [y, z]: [usize; 2], scale: f32, row: &mut [f32]) {
        let plane = self.cells[0] * self.cells[1];
        weighted(&self.along_z[z], plane, &self.planes[y * self.cells[0]..], scale, row);
    }
}

/// Writes `scale` times the weighted sum of four rows that lie `stride` apart.
#[multiversion(targets("x86_64+avx512f+avx512vl", "x86_64+avx2"))]
fn weighted(taps: &AxisTaps, stride: usize, from: &[f32], scale: f32, row: &mut [f32]) {
    let (at, weights) = taps;
    let length = row.len();
    let [a, b, c, d] = at.map(|n| &from[n * stride..][..length]);
    let [wa, wb, wc, wd] = weights.map(|weight| weight * scale);
    for ((((value, a), b), c), d) in row.iter_mut().zip(a).zip(b).zip(c).zip(d) {
        *value = wa * a + wb * b + wc * c + wd * d;
    }
}

#[cfg(test)]
mod tests {
    use rand::{RngExt, SeedableRng};
    use rand_pcg::Pcg64Mcg;

    use super::*;

    #[test]
    fn every_cell_has_the_lattices_value() {
        let mut random = Pcg64Mcg::seed_from_u64(8);
        let field = Lattice {
            nodes: [4, 1, 6],
            first_vox: [3.5, 1.0, -2.0],
            step_vox: 8.0,
            values: (0..24).map(|_| std::array::from_fn(|_| random.random())).collect(),
        };
        let axis = |first_vox, count| Axis { first_vox, step_vox: 2.0, count };
        let axes = [axis(-6.0, 20), axis(0.0, 3), axis(-9.0, 30)];
        let mut row = vec![0.0; 20];
        for component in 0..3 {
            let expansion = Expansion::new(&field, component, axes);
            for (y, z) in (0..30).flat_map(|z| (0..3).map(move |y| (y, z))) {
                expansion.write_row([y, z], 0.5, &mut row);
                for (x, value) in row.iter().enumerate() {
                    let cell = [x, y, z];
                    let at = std::array::from_fn(|c| axes[c].first_vox + 2.0 * cell[c] as f32);
                    let expected = 0.5 * field.at(at)[component];
                    assert!((value - expected).abs() < 1e-5, "{value} {expected}");
                }
            }
        }
    }
}
