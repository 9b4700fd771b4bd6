//! Windows with larger weights in the middle, and sums over them.

use multiversion::multiversion;
use rayon::prelude::*;

use crate::velocimetry::windows::Windows;

/// Weight of the outer quarters of a window along each axis; its middle half has 1.
///
/// The response of a uniform window to a wave as long as itself is sin(π)/π = 0: noise at that wavelength is never
/// corrected (Astarita, Exp. Fluids 43, 2007). The response of this one is 0.27, and light at its faces, which a lag
/// moves across them, has a smaller weight.
const OUTER_WEIGHT: f32 = 0.4;

/// A window's weights along an axis.
#[derive(Debug, Clone, PartialEq)]
pub struct Profile {
    weights: Vec<f32>,
    /// Whether windows are one cell thick along z, as the one layer is that they are on.
    flat: bool,
}

/// Cells along an axis that are summed, and their weights.
#[derive(Debug, Clone, PartialEq)]
pub struct Span {
    /// First cell.
    pub first: usize,
    /// Weight of it and those after it.
    pub weights: Vec<f32>,
}

impl Span {
    /// The span with its weights squared.
    pub fn squared(&self) -> Self {
        Self { first: self.first, weights: self.weights.iter().map(|w| w * w).collect() }
    }
}

impl Profile {
    /// Equal weights of all `edge` cells.
    pub fn uniform(edge: usize) -> Self {
        Self { weights: vec![1.0; edge], flat: false }
    }

    /// Larger weights of the middle half of `edge` cells.
    pub fn peaked(edge: usize) -> Self {
        let outer = edge / 4;
        let middle = outer..edge - outer;
        let weight = |m| if middle.contains(&m) { 1.0 } else { OUTER_WEIGHT };
        Self { weights: (0..edge).map(weight).collect(), flat: false }
    }

    /// The same, one cell thick along z if `flat`.
    pub fn on_layer(self, flat: bool) -> Self {
        Self { flat, ..self }
    }

    /// Whether windows are one cell thick along z.
    pub fn is_flat(&self) -> bool {
        self.flat
    }

    /// One weight per cell along an axis (0 is x).
    pub fn weights(&self, axis: usize) -> &[f32] {
        if self.flat && axis == 2 { &[1.0] } else { &self.weights }
    }

    /// Sum of the weights of all cells of a window.
    pub fn sum(&self) -> f32 {
        (0..3).map(|axis| self.weights(axis).iter().sum::<f32>()).product()
    }

    /// The windows along every axis.
    pub fn spans(&self, windows: &Windows) -> [Vec<Span>; 3] {
        std::array::from_fn(|axis| {
            let weights = self.weights(axis);
            let span = |n| Span { first: n * windows.step, weights: weights.to_vec() };
            (0..windows.nodes[axis]).map(span).collect()
        })
    }
}

/// Numbers on the cells of a box, several per cell: a row holds all cells' first number, then all their
/// second one, and so on.
pub struct Rows<'a, F: Fn([usize; 2]) -> &'a [f32] + Sync> {
    /// Cells along x and y.
    pub cells: [usize; 2],
    /// Numbers per cell.
    pub numbers: usize,
    /// The row at y, z.
    pub at: F,
}

impl<'a, F: Fn([usize; 2]) -> &'a [f32] + Sync> Rows<'a, F> {
    /// Σ w_x w_y w_z value over every box of spans along x, y, z; in the spans' order, x fastest, the
    /// numbers of a box beside each other.
    ///
    /// Along z and y first, where rows are added as they lie in memory.
    pub fn box_sums(&self, [xs, ys, zs]: &[Vec<Span>; 3]) -> Vec<f32> {
        let ([nx, ny], length) = (self.cells, self.cells[0] * self.numbers);
        zs.par_iter()
            .flat_map_iter(|z| {
                let mut plane = vec![0.0; length * ny];
                for (n, &weight) in z.weights.iter().enumerate() {
                    for (y, to) in plane.chunks_exact_mut(length).enumerate() {
                        add_scaled(to, weight, (self.at)([y, z.first + n]));
                    }
                }
                let mut row = vec![0.0; length];
                let mut sums = Vec::with_capacity(xs.len() * ys.len() * self.numbers);
                for y in ys {
                    row.fill(0.0);
                    let rows = plane[y.first * length..].chunks_exact(length);
                    for (from, &weight) in rows.zip(&y.weights) {
                        add_scaled(&mut row, weight, from);
                    }
                    sum_columns(&row, nx, xs, &mut sums);
                }
                sums
            })
            .collect()
    }
}

/// `to += factor · from`.
#[multiversion(targets("x86_64+avx512f+avx512vl", "x86_64+avx2"))]
pub fn add_scaled(to: &mut [f32], factor: f32, from: &[f32]) {
    for (to, from) in to.iter_mut().zip(from) {
        *to += factor * from;
    }
}

/// Adds to `sums`, for every span, the weighted sum of its cells in each of the rows of `length` cells.
#[multiversion(targets("x86_64+avx512f+avx512vl", "x86_64+avx2"))]
pub fn sum_columns(rows: &[f32], length: usize, spans: &[Span], sums: &mut Vec<f32>) {
    for span in spans {
        for row in rows.chunks_exact(length) {
            sums.push(dot(&row[span.first..], &span.weights));
        }
    }
}

/// Σ weight · value, in lanes.
#[inline(always)]
fn dot(values: &[f32], weights: &[f32]) -> f32 {
    const LANES: usize = 8;
    let (groups, rest) = weights.as_chunks::<LANES>();
    let (value_groups, value_rest) = values[..weights.len()].as_chunks::<LANES>();
    let mut lanes = [0.0f32; LANES];
    for (values, weights) in value_groups.iter().zip(groups) {
        for lane in 0..LANES {
            lanes[lane] += weights[lane] * values[lane];
        }
    }
    let mut sum = 0.0;
    for (value, weight) in value_rest.iter().zip(rest) {
        sum += weight * value;
    }
    for lane in lanes {
        sum += lane;
    }
    sum
}

#[cfg(test)]
mod tests {
    use rand::{RngExt, SeedableRng};
    use rand_pcg::Pcg64Mcg;

    use super::*;

    #[test]
    fn sums_are_those_of_the_definition() {
        let ([nx, ny, nz], numbers) = ([21, 7, 9], 2);
        let mut random = Pcg64Mcg::seed_from_u64(4);
        let values: Vec<f32> = (0..nx * ny * nz * numbers).map(|_| random.random()).collect();
        let mut spans = |count: usize, within: usize| -> Vec<Span> {
            (0..count)
                .map(|_| {
                    let first = random.random_range(0..within);
                    let length = random.random_range(0..=within - first);
                    Span { first, weights: (0..length).map(|_| random.random()).collect() }
                })
                .collect()
        };
        let spans = [spans(4, nx), spans(3, ny), spans(5, nz)];
        let length = nx * numbers;
        let at = |[y, z]: [usize; 2]| &values[(z * ny + y) * length..][..length];
        let sums = Rows { cells: [nx, ny], numbers, at }.box_sums(&spans);
        assert_eq!(sums.len(), 60 * numbers);
        for (n, sum) in sums.iter().enumerate() {
            let (number, n) = (n % numbers, n / numbers);
            let [x, y, z] = [&spans[0][n % 4], &spans[1][n / 4 % 3], &spans[2][n / 12]];
            let mut expected = 0.0f64;
            for (c, wz) in z.weights.iter().enumerate() {
                for (b, wy) in y.weights.iter().enumerate() {
                    for (a, wx) in x.weights.iter().enumerate() {
                        let row = at([y.first + b, z.first + c]);
                        expected += f64::from(wx * wy * wz * row[number * nx + x.first + a]);
                    }
                }
            }
            assert!((f64::from(*sum) - expected).abs() < 1e-3, "{sum} {expected}");
        }
    }
}
