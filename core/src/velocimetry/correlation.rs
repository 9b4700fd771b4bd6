//! Cross-correlation of overlapping windows, by sums that they share.
//!
//! For windows W about their places and a lag s along each axis,
//!
//! ```text
//! C(s) = Σ_{m ∈ W} a(m − ⌊s/2⌋) b(m + ⌈s/2⌉) − Σ a(m − ⌊s/2⌋) Σ b(m + ⌈s/2⌉) / N
//! ```
//!
//! The window stands at the middle of each pair of cells, not at one end: C(s) of (a, b) is then
//! C(−s) of (b, a), so that equal frames give a symmetric peak, and light that crosses a window's
//! face causes no bias. No cell is compared with zeros outside a window, so there is no bias
//! towards lag zero. With deformation the lags are few, and direct sums are faster than Fourier
//! transforms: every product is summed once over a brick, and windows add bricks.

use rayon::prelude::*;

use super::{
    kernel::{box_sums, product_columns, window_sums},
    lags::Lags,
    layout::Layout,
    raster::Raster,
    windows::{LANES, Windows},
};

/// Two frames on the raster of some windows, ready to be correlated at some lags.
pub struct Frames<'a> {
    windows: &'a Windows,
    lags: Lags,
    raster: &'a Raster,
    a: &'a [f32],
    b: &'a [f32],
    sums: [Vec<f32>; 2],
    /// First cell with known light along each axis, and the one after the last.
    lit: [[i64; 2]; 3],
    /// Share of each window in the flow; all of it if absent.
    flow_shares: Option<&'a [f32]>,
    bricks: Bricks,
}

/// How windows are put together along y and z: window n is bricks `first(n)..first(n) + parts`.
#[derive(Debug, Clone, Copy)]
struct Bricks {
    edge: usize,
    pitch: usize,
    parts: usize,
}

/// Least size of a shared brick.
const LEAST_BRICK: usize = 4;

impl Bricks {
    /// The largest bricks that windows share; bricks as large as a window where those are small.
    fn of(windows: &Windows) -> Self {
        let shared = greatest_common_divisor(windows.edge, windows.step);
        if shared >= LEAST_BRICK {
            Self { edge: shared, pitch: shared, parts: windows.edge / shared }
        } else {
            Self { edge: windows.edge, pitch: windows.step, parts: 1 }
        }
    }

    fn count(self, windows: &Windows, axis: usize) -> usize {
        (windows.span(axis) - self.edge) / self.pitch + 1
    }
}

impl<'a> Frames<'a> {
    /// Frames a and b, rendered on `raster`, which is that of `windows` with the border of `lags`;
    /// light is known in the cells `lit` along each axis.
    pub fn new(
        windows: &'a Windows,
        lags: Lags,
        raster: &'a Raster,
        [a, b]: [&'a [f32]; 2],
        lit: [[i64; 2]; 3],
    ) -> Self {
        let sum = |image| box_sums(image, raster.cells, windows.edge);
        let (sum_a, sum_b) = rayon::join(|| sum(a), || sum(b));
        let bricks = Bricks::of(windows);
        Self { windows, lags, raster, a, b, sums: [sum_a, sum_b], lit, flow_shares: None, bricks }
    }

    /// The same with these shares of the windows in the flow: there is light in no other cell, so that fewer
    /// pairs of cells agree by chance.
    pub fn with_flow_shares(self, flow_shares: Option<&'a [f32]>) -> Self {
        Self { flow_shares, ..self }
    }

    /// What `visit` makes of every window's correlation, C(s) for all lags, in the windows' order.
    pub fn correlate<T: Send>(&self, visit: impl Fn(&[f32]) -> T + Sync) -> Vec<T> {
        let [nx, ny, nz] = self.windows.nodes;
        let across = self.bricks.count(self.windows, 1);
        let down = self.bricks.count(self.windows, 2);
        let brick_rows: Vec<Vec<f32>> = (0..across * down)
            .into_par_iter()
            .map(|brick| self.brick_row(brick % across, brick / across))
            .collect();
        let each = self.bricks.step_between(self.windows);
        (0..ny * nz)
            .into_par_iter()
            .flat_map_iter(|row| {
                let (j, k) = (row % ny, row / ny);
                let mut sums = vec![0.0f32; self.lags.count() * nx];
                for c in 0..self.bricks.parts {
                    for b in 0..self.bricks.parts {
                        let brick = (k * each + c) * across + j * each + b;
                        for (sum, part) in sums.iter_mut().zip(&brick_rows[brick]) {
                            *sum += part;
                        }
                    }
                }
                let mut correlation = vec![0.0f32; self.lags.count()];
                (0..nx)
                    .map(|i| {
                        self.subtract_chance([i, j, k], &sums[i..], &mut correlation);
                        visit(&correlation)
                    })
                    .collect::<Vec<T>>()
            })
            .collect()
    }

    /// Sums of products over a row of bricks along x: for every lag, over the x extent of every
    /// window.
    fn brick_row(&self, y: usize, z: usize) -> Vec<f32> {
        let [nx, ny, _] = self.raster.cells;
        let nodes = self.windows.nodes[0];
        let border = self.lags.border() as i64;
        let corner = [0, y * self.bricks.pitch, z * self.bricks.pitch].map(|c| c as i64 + border);
        let offset = |at: [i64; 3]| ((at[2] * ny as i64 + at[1]) * nx as i64 + at[0]) as usize;
        let per_line = self.lags.edge();
        let width = self.windows.span(0).next_multiple_of(LANES);
        let mut sums = vec![0.0f32; self.lags.count() * nodes];
        let mut columns = vec![0.0f32; per_line * width];
        let lines = sums.chunks_exact_mut(per_line * nodes);
        for (line, sums) in lines.enumerate() {
            // The lags of a line differ along x only.
            let s = self.lags.components(line * per_line);
            let back = std::array::from_fn(|axis| match axis {
                0 => 0,
                _ => corner[axis] - s[axis].div_euclid(2),
            });
            let forth = std::array::from_fn(|axis| match axis {
                0 => 0,
                _ => back[axis] + s[axis],
            });
            let frames = [&self.a[offset(back)..], &self.b[offset(forth)..]];
            let strides = [nx, nx * ny];
            product_columns(self.lags, frames, strides, self.bricks.edge, &mut columns);
            for (columns, sums) in columns.chunks_exact(width).zip(sums.chunks_exact_mut(nodes)) {
                window_sums(columns, self.windows.edge, self.windows.step, sums);
            }
        }
        sums
    }

    /// A window's correlation: its sums of products, `sums[lag · nodes along x]`, less what the
    /// mean light of both frames gives by chance.
    fn subtract_chance(&self, node: [usize; 3], sums: &[f32], correlation: &mut [f32]) {
        let [nx, ny, _] = self.raster.cells;
        let strides = [1, nx, nx * ny];
        let [xs, ys, zs]: [Vec<AxisPairs>; 3] =
            std::array::from_fn(|axis| self.axis_pairs(axis, node[axis], strides[axis]));
        let window = Layout { nodes: self.windows.nodes }.number(node);
        let share = self.flow_shares.map_or(1.0, |shares| shares[window]);
        let mut products = sums.iter().step_by(self.windows.nodes[0]);
        let mut correlation = correlation.iter_mut();
        for z in &zs {
            for y in &ys {
                let pairs = share * y.pairs * z.pairs;
                let (back, forth) = (y.back + z.back, y.forth + z.forth);
                let (a, b) = (&self.sums[0][back..], &self.sums[1][forth..]);
                for ((x, value), product) in xs.iter().zip(&mut correlation).zip(&mut products) {
                    *value = product - a[x.back] * b[x.forth] / (pairs * x.pairs).max(1.0);
                }
            }
        }
    }

    /// For every lag along `axis`, what a window takes part in.
    fn axis_pairs(&self, axis: usize, node: usize, stride: usize) -> Vec<AxisPairs> {
        let start = (node * self.windows.step + self.lags.border()) as i64;
        let [low, high] = self.lit[axis];
        let reach = self.lags.reach as i64;
        (-reach..=reach)
            .map(|s| {
                let back = start - s.div_euclid(2);
                let first = back.max(low).max(low - s);
                let end = (back + self.windows.edge as i64).min(high).min(high - s);
                AxisPairs {
                    pairs: (end - first).max(0) as f32,
                    back: back as usize * stride,
                    forth: (back + s) as usize * stride,
                }
            })
            .collect()
    }
}

/// A window at one lag, along one axis.
struct AxisPairs {
    /// Pairs of cells with known light.
    pairs: f32,
    /// Where the window begins in frame a.
    back: usize,
    /// Where it begins in frame b.
    forth: usize,
}

impl Bricks {
    /// Bricks from one window to the next.
    fn step_between(self, windows: &Windows) -> usize {
        windows.step / self.pitch
    }
}

fn greatest_common_divisor(a: usize, b: usize) -> usize {
    if b == 0 { a } else { greatest_common_divisor(b, a % b) }
}

#[cfg(test)]
mod tests {
    use rand::{RngExt, SeedableRng};
    use rand_pcg::Pcg64Mcg;

    use super::*;

    /// The formula, a pair of cells at a time.
    fn naive(frames: &Frames, node: [usize; 3], s: [i64; 3]) -> f64 {
        let (windows, border) = (frames.windows, frames.lags.border() as i64);
        let [nx, ny, _] = frames.raster.cells;
        let edge = windows.edge as i64;
        let (mut products, mut sum_a, mut sum_b, mut pairs) = (0.0, 0.0, 0.0, 0);
        for m in 0..edge.pow(3) {
            let m = [m % edge, m / edge % edge, m / (edge * edge)];
            let middle: [i64; 3] =
                std::array::from_fn(|c| (node[c] * windows.step) as i64 + border + m[c]);
            let from: [i64; 3] = std::array::from_fn(|c| middle[c] - s[c].div_euclid(2));
            let to: [i64; 3] = std::array::from_fn(|c| from[c] + s[c]);
            let value = |image: &[f32], [x, y, z]: [i64; 3]| {
                f64::from(image[(z as usize * ny + y as usize) * nx + x as usize])
            };
            let (a, b) = (value(frames.a, from), value(frames.b, to));
            products += a * b;
            sum_a += a;
            sum_b += b;
            let known = |at: [i64; 3]| {
                (0..3).all(|c| (frames.lit[c][0]..frames.lit[c][1]).contains(&at[c]))
            };
            pairs += i32::from(known(from) && known(to));
        }
        products - sum_a * sum_b / f64::from(pairs.max(1))
    }

    #[test]
    fn shared_and_single_bricks_agree_with_the_formula() {
        let mut random = Pcg64Mcg::seed_from_u64(5);
        for (edge, step, reach) in [(8, 4, 4), (8, 8, 2), (6, 5, 3), (9, 6, 1), (4, 2, 6)] {
            let windows =
                Windows { nodes: [3, 2, 4], edge, step, cell_vox: 1.0, first_vox: [0.0; 3] };
            let lags = Lags { reach };
            let raster = windows.raster(lags.border());
            let lit = raster.cells.map(|n| [2, n as i64 - 3]);
            let mut image = || -> Vec<f32> { (0..raster.len()).map(|_| random.random()).collect() };
            let (a, b) = (image(), image());
            let frames = Frames::new(&windows, lags, &raster, [&a, &b], lit);
            let all = frames.correlate(<[f32]>::to_vec);
            for (index, correlation) in all.iter().enumerate() {
                let node = [index % 3, index / 3 % 2, index / 6];
                for (lag, &fast) in correlation.iter().enumerate().step_by(7) {
                    let slow = naive(&frames, node, lags.components(lag));
                    let scale = (edge as f64).powi(3);
                    assert!((f64::from(fast) - slow).abs() < 1e-5 * scale, "{fast} {slow}");
                }
            }
        }
    }

    #[test]
    fn swapped_frames_give_the_mirrored_correlation() {
        let mut random = Pcg64Mcg::seed_from_u64(6);
        let windows =
            Windows { nodes: [2; 3], edge: 8, step: 4, cell_vox: 1.0, first_vox: [0.0; 3] };
        let lags = Lags { reach: 2 };
        let raster = windows.raster(lags.border());
        let lit = raster.cells.map(|n| [0, n as i64]);
        let mut image = || -> Vec<f32> { (0..raster.len()).map(|_| random.random()).collect() };
        let (a, b) = (image(), image());
        let forth = Frames::new(&windows, lags, &raster, [&a, &b], lit).correlate(<[f32]>::to_vec);
        let back = Frames::new(&windows, lags, &raster, [&b, &a], lit).correlate(<[f32]>::to_vec);
        for (forth, back) in forth.iter().flatten().zip(back.iter().flat_map(|c| c.iter().rev())) {
            assert!((forth - back).abs() < 1e-3);
        }
    }
}
