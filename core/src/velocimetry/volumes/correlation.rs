//! Cross-correlation of all windows of two volumes.
//!
//! ```text
//! C(s) = Σ_{m ∈ W} w(m) a(m − ⌊s/2⌋) b(m + ⌈s/2⌉)
//! ```
//!
//! for windows W of weights w and light without its mean. The window stands at the middle of each pair
//! of cells, not at one end: C(s) of (a, b) is C(−s) of (b, a), and light that crosses a window's face
//! causes no bias. Every product is summed once, over a brick; windows add bricks.
//!
//! A single layer has no lags across it. Its correlation there is assumed: at a lag of one cell it is
//! [`BESIDE_LAYER`] times that at lag zero.

use std::{borrow::Cow, ops::Range};

use multiversion::multiversion;
use rayon::prelude::*;

use super::{
    bricks::Bricks,
    light::CellLight,
    profile::{Profile, Span, add_scaled, sum_columns},
};
use crate::velocimetry::{lags::Lags, windows::Windows};

/// Cells multiplied at a time.
const LANES: usize = 32;

/// Assumed correlation at a lag of one cell across a single layer, relative to that at lag zero across it.
const BESIDE_LAYER: f32 = 0.5;

/// Two volumes ready to be correlated.
pub struct Correlation<'a> {
    lags: Lags,
    flat: bool,
    frames: [&'a CellLight; 2],
    spans: [Vec<Span>; 3],
    bricks: [Bricks; 2],
}

impl<'a> Correlation<'a> {
    /// Frames a and b, alike in their cells, with at least the border of `lags` around them.
    pub fn new(
        windows: &Windows,
        profile: &Profile,
        lags: Lags,
        frames: [&'a CellLight; 2],
    ) -> Self {
        let spans = profile.spans(windows);
        let bricks = [1, 2].map(|axis| Bricks::of(&spans[axis]));
        Self { lags, flat: profile.is_flat(), frames, spans, bricks }
    }

    /// What `visit` makes of every window's correlation, C(s) for all lags, in the windows' order.
    pub fn of_windows<T: Send>(&self, visit: impl Fn(&[f32]) -> T + Sync) -> Vec<T> {
        let [across, down] = self.bricks.each_ref().map(Bricks::count);
        let offsets = self.offsets();
        let brick_rows: Vec<Vec<f32>> = (0..across * down)
            .into_par_iter()
            .map_init(Vec::new, |columns, brick| {
                self.brick_row([brick % across, brick / across], &offsets, columns)
            })
            .collect();
        let (nodes, count) = (self.spans[0].len(), offsets.len());
        let [of_y, of_z] = self.bricks.each_ref().map(Bricks::windows);
        (0..of_y.len() * of_z.len())
            .into_par_iter()
            .flat_map_iter(|row| {
                let mut sums = vec![0.0; count * nodes];
                for z in &of_z[row / of_y.len()] {
                    for y in &of_y[row % of_y.len()] {
                        let bricks = &brick_rows[z.brick * across + y.brick];
                        add_scaled(&mut sums, z.weight * y.weight, bricks);
                    }
                }
                let visited = |sums: &[f32]| visit(&self.of_all_lags(sums));
                sums.chunks_exact(count).map(visited).collect::<Vec<T>>()
            })
            .collect()
    }

    /// The lags that are tried.
    fn tried(&self) -> Range<usize> {
        let (plane, reach) = (self.lags.edge().pow(2), self.lags.reach);
        if self.flat { reach * plane..(reach + 1) * plane } else { 0..self.lags.count() }
    }

    /// A window's correlation at all lags from that at those that were tried.
    fn of_all_lags<'c>(&self, tried: &'c [f32]) -> Cow<'c, [f32]> {
        if !self.flat {
            return Cow::Borrowed(tried);
        }
        let mut all = vec![0.0; self.lags.count()];
        let (range, plane) = (self.tried(), tried.len());
        for (first, share) in
            [(range.start - plane, BESIDE_LAYER), (range.start, 1.0), (range.end, BESIDE_LAYER)]
        {
            add_scaled(&mut all[first..first + plane], share, tried);
        }
        Cow::Owned(all)
    }

    /// For every lag that is tried, where frames a and b are multiplied, counted from the first plane and
    /// row that are stored.
    fn offsets(&self) -> Vec<[usize; 2]> {
        let (strides, origin) = (self.frames[0].strides(), self.frames[0].origin() as i64);
        let [row, plane] = strides.map(|stride| stride as i64);
        let offset = |[x, y, z]: [i64; 3]| (origin + x + y * row + z * plane) as usize;
        self.tried()
            .map(|lag| {
                let s = self.lags.components(lag);
                let back = s.map(|s| -s.div_euclid(2));
                [offset(back), offset(std::array::from_fn(|c| back[c] + s[c]))]
            })
            .collect()
    }

    /// The row of bricks at y, z summed over the windows along x: of every window, every lag.
    fn brick_row(
        &self,
        [y, z]: [usize; 2],
        offsets: &[[usize; 2]],
        columns: &mut Vec<f32>,
    ) -> Vec<f32> {
        let [row, plane] = self.frames[0].strides();
        let ([y, rows], [z, planes]) = (self.bricks[0].cells(y), self.bricks[1].cells(z));
        let frames = self.frames.map(|light| &light.stored()[y * row + z * plane..]);
        let end = self.spans[0].last().map_or(0, |span| span.first + span.weights.len());
        let width = end.next_multiple_of(LANES);
        columns.resize(offsets.len() * width, 0.0);
        multiply_columns(frames, [row, plane], [rows, planes], offsets, columns);
        let mut sums = Vec::with_capacity(self.spans[0].len() * offsets.len());
        sum_columns(columns, width, &self.spans[0], &mut sums);
        sums
    }
}

/// For every pair of offsets: `columns[lag][x] = Σ a(offset_a + x) b(offset_b + x)` over `rows` that lie
/// `row` apart, in `planes` that lie `plane` apart.
#[multiversion(targets("x86_64+avx512f+avx512vl", "x86_64+avx2"))]
fn multiply_columns(
    [a, b]: [&[f32]; 2],
    [row, plane]: [usize; 2],
    [rows, planes]: [usize; 2],
    offsets: &[[usize; 2]],
    columns: &mut [f32],
) {
    let width = columns.len() / offsets.len();
    for tile in (0..width).step_by(LANES) {
        for (&[of_a, of_b], columns) in offsets.iter().zip(columns.chunks_exact_mut(width)) {
            let (a, b) = (&a[of_a + tile..], &b[of_b + tile..]);
            let mut sum = [0.0; LANES];
            for z in 0..planes {
                for y in 0..rows {
                    let at = z * plane + y * row;
                    let pairs = a[at..][..LANES].iter().zip(&b[at..][..LANES]);
                    for (sum, (a, b)) in sum.iter_mut().zip(pairs) {
                        *sum += a * b;
                    }
                }
            }
            columns[tile..tile + LANES].copy_from_slice(&sum);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::{super::light::tests::random_light, *};

    /// The formula, a pair of cells at a time.
    fn naive(
        windows: &Windows,
        profile: &Profile,
        [a, b]: [&CellLight; 2],
        node: [usize; 3],
        s: [i64; 3],
    ) -> f64 {
        let value = |light: &CellLight, at: [i64; 3]| {
            let [row, plane] = light.strides().map(|stride| stride as i64);
            let place = light.origin() as i64 + at[0] + at[1] * row + at[2] * plane;
            f64::from(light.stored()[place as usize])
        };
        let edge = windows.edge;
        let mut sum = 0.0;
        for m in 0..edge.pow(3) {
            let m = [m % edge, m / edge % edge, m / (edge * edge)];
            let weight: f64 = m.iter().map(|&m| f64::from(profile.weights(0)[m])).product();
            let from: [i64; 3] = std::array::from_fn(|c| {
                (node[c] * windows.step + m[c]) as i64 - s[c].div_euclid(2)
            });
            sum += weight * value(a, from) * value(b, std::array::from_fn(|c| from[c] + s[c]));
        }
        sum
    }

    #[test]
    fn windows_correlate_as_the_formula_says() {
        for (edge, step, reach) in [(8, 4, 4), (8, 8, 2), (6, 5, 3), (9, 6, 1), (4, 2, 1)] {
            let nodes = [3, 2, 4];
            let windows = Windows { nodes, edge, step, cell_vox: 1.0, first_vox: [0.0; 3] };
            let lags = Lags { reach };
            let cells = [0, 1, 2].map(|axis| windows.span(axis) + axis);
            let [a, b] = [1, 2].map(|seed| random_light(cells, lags.border(), seed));
            for profile in [Profile::uniform(edge), Profile::peaked(edge)] {
                let all = Correlation::new(&windows, &profile, lags, [&a, &b])
                    .of_windows(<[f32]>::to_vec);
                for (n, correlation) in all.iter().enumerate() {
                    let node = [n % 3, n / 3 % 2, n / 6];
                    for (lag, fast) in correlation.iter().enumerate().step_by(5) {
                        let slow = naive(&windows, &profile, [&a, &b], node, lags.components(lag));
                        assert!((f64::from(*fast) - slow).abs() < 1e-2, "{fast} {slow}");
                    }
                }
            }
        }
    }
}
