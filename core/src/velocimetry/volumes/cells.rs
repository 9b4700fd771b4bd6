//! What small cells of two volumes add to the correlation peaks of the windows about them.

use multiversion::multiversion;
use rayon::prelude::*;

use super::{
    light::CellLight,
    profile::{Rows, add_scaled},
};

/// Edge of a cell, in cells of the light.
pub const CELL: usize = 2;

/// Cells along an axis that are taken for one particle, in blocks that overlap: squares of their
/// sums, over the cells in a block, weigh two cells by how many blocks they share (Bartlett's
/// estimate of a sum's variance, never negative).
pub const BLOCK: usize = 3;

/// Values of the light that are multiplied at a time.
const LANES: usize = 8;

/// What a cell adds: asymmetry along x, y, z; then from [`SYMMETRIC`] the symmetric part along x, y,
/// z; from [`COMMON`] the light common to both frames; from [`ENERGY`] that of each frame, squared.
pub const SUMS: usize = 9;
pub const SYMMETRIC: usize = 3;
pub const COMMON: usize = 6;
pub const ENERGY: usize = 7;

/// The first of the [`SUMS`], of which blocks are made.
const BLOCKED: usize = ENERGY;

/// A cell's share of the squares over blocks: those of the asymmetry along x, y, z; from
/// [`MIXED`] its products with the symmetric part; from [`SYMMETRIC_SQUARES`] the squares of that;
/// from [`COMMON_SQUARES`] the common light times its block's, and times its own.
pub const SQUARES: usize = 11;
pub const MIXED: usize = 3;
pub const SYMMETRIC_SQUARES: usize = 6;
pub const COMMON_SQUARES: usize = 9;

/// `numbers` on every cell, stored as [`Rows`] has them.
#[derive(Debug)]
pub struct Cells {
    /// Cells along x, y, z.
    pub counts: [usize; 3],
    numbers: usize,
    values: Vec<f32>,
}

impl Cells {
    /// The [`SUMS`] of two frames that are alike in their cells and have a border.
    pub fn products([a, b]: [&CellLight; 2]) -> Self {
        let ([row, plane], origin) = (a.strides(), a.origin());
        let counts = a.cells.map(|n| n / CELL);
        Self::with(counts, SUMS, |z, rows| {
            for (y, sums) in rows.chunks_exact_mut((counts[0] * SUMS).max(1)).enumerate() {
                let start = origin + CELL * (y * row + z * plane);
                let frames = [a, b].map(|light| &light.stored()[start..]);
                multiply_row(frames, [1, row, plane], sums);
            }
        })
    }

    /// The [`SQUARES`] of a pair's [`SUMS`]; there is nothing beyond the faces.
    pub fn squares(&self) -> Self {
        let [nx, ny, nz] = self.counts;
        let around = |n: usize, count: usize| n.saturating_sub(1)..(n + 2).min(count);
        let length = nx * BLOCKED;
        Self::with(self.counts, SQUARES, |z, rows| {
            let mut along_z = vec![0.0; ny * length];
            for z in around(z, nz) {
                for (y, sums) in along_z.chunks_exact_mut(length).enumerate() {
                    add_scaled(sums, 1.0, self.row([y, z]));
                }
            }
            let (mut along_y, mut blocks) = (vec![0.0; length], vec![0.0; length]);
            for (y, squares) in rows.chunks_exact_mut(nx * SQUARES).enumerate() {
                along_y.fill(0.0);
                let beside = around(y, ny);
                for row in along_z[beside.start * length..beside.end * length].chunks_exact(length)
                {
                    add_scaled(&mut along_y, 1.0, row);
                }
                blocks.copy_from_slice(&along_y);
                for (blocks, beside) in blocks.chunks_exact_mut(nx).zip(along_y.chunks_exact(nx)) {
                    add_scaled(&mut blocks[1..], 1.0, beside);
                    add_scaled(blocks, 1.0, &beside[1..]);
                }
                square_row(self.row([y, z]), &blocks, nx, squares);
            }
        })
    }

    /// The numbers, to be summed.
    pub fn rows<'a>(&'a self) -> Rows<'a, impl Fn([usize; 2]) -> &'a [f32] + Sync> {
        let [nx, ny, _] = self.counts;
        Rows { cells: [nx, ny], numbers: self.numbers, at: |at| self.row(at) }
    }

    fn row(&self, [y, z]: [usize; 2]) -> &[f32] {
        let length = self.counts[0] * self.numbers;
        &self.values[(z * self.counts[1] + y) * length..][..length]
    }

    /// Cells whose planes of rows `fill` writes.
    fn with(counts: [usize; 3], numbers: usize, fill: impl Fn(usize, &mut [f32]) + Sync) -> Self {
        let [nx, ny, nz] = counts;
        let mut values = vec![0.0; nx * ny * nz * numbers];
        let planes = values.par_chunks_exact_mut((nx * ny * numbers).max(1));
        planes.enumerate().for_each(|(z, plane)| fill(z, plane));
        Self { counts, numbers, values }
    }
}

/// Sums for a row of cells whose light begins at the frames' first value.
#[multiversion(targets("x86_64+avx512f+avx512vl", "x86_64+avx2"))]
fn multiply_row([a, b]: [&[f32]; 2], strides: [usize; 3], sums: &mut [f32]) {
    const CELLS: usize = LANES / CELL;
    let count = sums.len() / SUMS;
    for cell in (0..count).step_by(CELLS) {
        let start = cell * CELL;
        let of_columns = multiply([&a[start..], &b[start..]], strides);
        for (to, of_columns) in sums.chunks_exact_mut(count).zip(&of_columns) {
            for (to, pair) in to[cell..].iter_mut().zip(of_columns.as_chunks::<CELL>().0) {
                *to = pair.iter().sum();
            }
        }
    }
}

/// Sums over the rows of a cell, for every column under [`LANES`] values.
#[inline(always)]
fn multiply([a, b]: [&[f32]; 2], strides: [usize; 3]) -> [[f32; LANES]; SUMS] {
    let [_, row, plane] = strides;
    let mut sums = [[0.0f32; LANES]; SUMS];
    for at in [0, row, plane, row + plane] {
        let (here_a, here_b) = (lanes(a, at), lanes(b, at));
        for (axis, stride) in strides.into_iter().enumerate() {
            let (next_a, next_b) = (lanes(a, at + stride), lanes(b, at + stride));
            for lane in 0..LANES {
                let forward = here_a[lane] * next_b[lane];
                let backward = next_a[lane] * here_b[lane];
                sums[axis][lane] += forward - backward;
                sums[SYMMETRIC + axis][lane] += forward + backward;
            }
        }
        for lane in 0..LANES {
            sums[COMMON][lane] += here_a[lane] * here_b[lane];
            sums[ENERGY][lane] += here_a[lane] * here_a[lane];
            sums[ENERGY + 1][lane] += here_b[lane] * here_b[lane];
        }
    }
    sums
}

#[inline(always)]
fn lanes(light: &[f32], at: usize) -> [f32; LANES] {
    let light = &light[at..][..LANES];
    std::array::from_fn(|lane| light[lane])
}

/// The [`SQUARES`] of a row of `count` cells, from their own [`SUMS`] and their blocks'.
fn square_row(own: &[f32], block: &[f32], count: usize, squares: &mut [f32]) {
    const PER_CELL: f32 = 1.0 / BLOCK.pow(3) as f32;
    for axis in 0..3 {
        let (asymmetry, symmetric) = (&block[axis * count..], &block[(SYMMETRIC + axis) * count..]);
        let mut to = |first: usize, a: &[f32], b: &[f32]| {
            multiply_scaled(PER_CELL, a, b, &mut squares[(first + axis) * count..][..count]);
        };
        to(0, asymmetry, asymmetry);
        to(MIXED, asymmetry, symmetric);
        to(SYMMETRIC_SQUARES, symmetric, symmetric);
    }
    let common = &own[COMMON * count..];
    let (by_block, by_itself) = squares[COMMON_SQUARES * count..].split_at_mut(count);
    multiply_scaled(1.0, common, &block[COMMON * count..], by_block);
    multiply_scaled(1.0, common, common, by_itself);
}

/// `to = factor · a · b`.
#[multiversion(targets("x86_64+avx512f+avx512vl", "x86_64+avx2"))]
fn multiply_scaled(factor: f32, a: &[f32], b: &[f32], to: &mut [f32]) {
    for ((to, a), b) in to.iter_mut().zip(a).zip(b) {
        *to = factor * a * b;
    }
}

#[cfg(test)]
mod tests {
    use super::{super::light::tests::random_light, *};

    /// The number of a cell.
    fn number(cells: &Cells, number: usize, [x, y, z]: [usize; 3]) -> f32 {
        cells.row([y, z])[number * cells.counts[0] + x]
    }

    /// The definition of [`SUMS`].
    fn sums_of([a, b]: [&CellLight; 2], cell: [usize; 3]) -> [f32; SUMS] {
        let ([row, plane], origin) = (a.strides(), a.origin());
        let mut sums = [0.0; SUMS];
        for part in 0..8 {
            let at = [part % 2, part / 2 % 2, part / 4];
            let place = |n: usize| CELL * cell[n] + at[n];
            let here = origin + place(0) + place(1) * row + place(2) * plane;
            let [a, b] = [a, b].map(CellLight::stored);
            for (axis, step) in [1, row, plane].into_iter().enumerate() {
                let (forward, backward) = (a[here] * b[here + step], a[here + step] * b[here]);
                sums[axis] += forward - backward;
                sums[SYMMETRIC + axis] += forward + backward;
            }
            sums[COMMON] += a[here] * b[here];
            sums[ENERGY] += a[here] * a[here];
            sums[ENERGY + 1] += b[here] * b[here];
        }
        sums
    }

    #[test]
    fn cells_are_the_sums_of_their_light_and_squares_those_of_blocks() {
        let [a, b] = [1, 2].map(|seed| random_light([13, 8, 11], 1, seed));
        let products = Cells::products([&a, &b]);
        let squares = products.squares();
        let counts = products.counts;
        assert_eq!(counts, [6, 4, 5]);
        let near = |a: f32, b: f32| assert!((a - b).abs() < 1e-3 * (1.0 + b.abs()), "{a} {b}");
        for n in 0..counts.iter().product() {
            let cell = [n % 6, n / 6 % 4, n / 24];
            let own = sums_of([&a, &b], cell);
            own.iter().enumerate().for_each(|(n, &sum)| near(number(&products, n, cell), sum));
            let mut block = [0.0; SUMS];
            let around = |c: usize| cell[c].saturating_sub(1)..(cell[c] + 2).min(counts[c]);
            for (z, y) in around(2).flat_map(|z| around(1).map(move |y| (z, y))) {
                for x in around(0) {
                    let other = sums_of([&a, &b], [x, y, z]);
                    block.iter_mut().zip(other).for_each(|(sum, part)| *sum += part);
                }
            }
            for axis in 0..3 {
                let (odd, even) = (block[axis], block[SYMMETRIC + axis]);
                near(number(&squares, axis, cell), odd * odd / 27.0);
                near(number(&squares, MIXED + axis, cell), odd * even / 27.0);
                near(number(&squares, SYMMETRIC_SQUARES + axis, cell), even * even / 27.0);
            }
            near(number(&squares, COMMON_SQUARES, cell), own[COMMON] * block[COMMON]);
            near(number(&squares, COMMON_SQUARES + 1, cell), own[COMMON].powi(2));
        }
    }
}
