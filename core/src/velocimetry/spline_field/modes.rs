//! Transformation of coefficients to modes of the penalty along each axis, and back.
//!
//! P = Δ³ᵀΔ³ is symmetric about the middle of an axis, so each of its eigenvectors is even or odd: coefficients are
//! folded at the middle and transformed by two matrices of half the size.

use multiversion::multiversion;
use nalgebra::{DMatrix, SymmetricEigen};
use rayon::prelude::*;

use super::{
    super::{
        b_spline::{self, HALFWAY, HALFWAY_SLOPES},
        layout::Layout,
    },
    lanes::{LANES, Lane},
};

/// An axis in the penalty's eigenvectors: the even ones first, then the odd ones.
pub struct AxisModes {
    /// Even modes, and odd ones.
    blocks: [Block; 2],
    /// Eigenvalues of P.
    pub penalty: Vec<f64>,
    /// Diagonal of M, the products of B-splines at places spread evenly over the cells.
    pub data: Vec<f64>,
    /// Diagonal of the product of slopes, at steps of 1, and of values half way between nodes.
    pub slope: Vec<f64>,
    pub halfway: Vec<f64>,
}

/// Modes of one parity on the folded coefficients.
struct Block {
    size: usize,
    /// A row for each mode.
    to_modes: Vec<f32>,
    /// Its transpose.
    from_modes: Vec<f32>,
}

/// Transformation between coefficients and modes. It does not depend on the weights.
pub struct Modes {
    layout: Layout,
    /// Along x, y, z.
    pub axes: [AxisModes; 3],
}

/// Direction of a transformation.
#[derive(Clone, Copy, PartialEq)]
enum Direction {
    ToModes,
    FromModes,
}

impl AxisModes {
    fn new(count: usize) -> Self {
        // The B-spline at places spread evenly over the cells.
        let mut data = DMatrix::<f64>::zeros(count, count);
        const PLACES: usize = 4;
        for n in 0..PLACES {
            let t = (n as f32 + 0.5) / PLACES as f32;
            let weights = b_spline::weights(t).map(f64::from);
            data += banded(count, &weights) / PLACES as f64;
        }
        let penalty = banded(count, &[-1.0, 3.0, -3.0, 1.0]);
        let folds = folds(count);
        // A little of M tells quadratic fields, which P does not know, from each other.
        let folded =
            matrix_product(&matrix_product(&folds.transpose(), &(&penalty + 1e-4 * &data)), &folds);
        let even = count.div_ceil(2);
        let sizes = [even, count - even];
        let mut vectors = DMatrix::<f64>::zeros(count, count);
        for (first, size) in [0, even].into_iter().zip(sizes) {
            let block = folded.view((first, first), (size, size)).into_owned();
            let SymmetricEigen { eigenvectors, .. } = block.symmetric_eigen();
            let unfolded = matrix_product(&folds.columns(first, size).into_owned(), &eigenvectors);
            vectors.columns_mut(first, size).copy_from(&unfolded);
        }
        let diagonal = |matrix: &DMatrix<f64>| -> Vec<f64> {
            let transformed =
                matrix_product(&matrix_product(&vectors.transpose(), matrix), &vectors);
            (0..count).map(|k| transformed[(k, k)].max(0.0)).collect()
        };
        let block = |first: usize, size: usize| {
            // An odd mode's folded coefficient stands where the second of the two was.
            let entry = |k: usize, at: usize| {
                let place = if first == 0 { at } else { count - 1 - (first + at) };
                vectors[(place, first + k)] as f32
            };
            let square = |entry: &dyn Fn(usize, usize) -> f32| {
                (0..size * size).map(|n| entry(n / size, n % size)).collect()
            };
            Block { size, to_modes: square(&entry), from_modes: square(&|at, k| entry(k, at)) }
        };
        Self {
            blocks: [block(0, sizes[0]), block(even, sizes[1])],
            penalty: diagonal(&penalty),
            data: diagonal(&data),
            slope: diagonal(&banded(count, &HALFWAY_SLOPES)),
            halfway: diagonal(&banded(count, &HALFWAY)),
        }
    }
}

/// The product of a banded matrix's transpose with it, whose rows all hold `weights`, each a place further.
fn banded(count: usize, weights: &[f64]) -> DMatrix<f64> {
    let rows = count + 1 - weights.len();
    let mut matrix = DMatrix::<f64>::zeros(rows, count);
    for row in 0..rows {
        for (place, weight) in weights.iter().enumerate() {
            matrix[(row, row + place)] = *weight;
        }
    }
    matrix_product(&matrix.transpose(), &matrix)
}

/// The product a b, each sum in order. nalgebra's own product uses fused multiply-add where the processor has it, so
/// that its last bits depend on the processor.
fn matrix_product(a: &DMatrix<f64>, b: &DMatrix<f64>) -> DMatrix<f64> {
    let entry = |row, column| (0..a.ncols()).map(|n| a[(row, n)] * b[(n, column)]).sum();
    DMatrix::from_fn(a.nrows(), b.ncols(), entry)
}

/// Columns that are even about the middle, then odd ones: an orthonormal basis.
fn folds(count: usize) -> DMatrix<f64> {
    let mut folds = DMatrix::<f64>::zeros(count, count);
    for low in 0..count.div_ceil(2) {
        let high = count - 1 - low;
        if low == high {
            folds[(low, low)] = 1.0;
            continue;
        }
        let root = std::f64::consts::FRAC_1_SQRT_2;
        (folds[(low, low)], folds[(high, low)]) = (root, root);
        (folds[(low, high)], folds[(high, high)]) = (root, -root);
    }
    folds
}

/// Number of neighbouring columns along z that are transformed together.
const STRIP: usize = 64;

impl Modes {
    /// Modes of a lattice of coefficients.
    pub fn new(layout: Layout) -> Self {
        Self { layout, axes: layout.nodes.map(AxisModes::new) }
    }

    /// Scales a field, multiplies each of its modes by a factor, and scales the result. `result` and `strips` have as
    /// many coefficients as the field; `strips` is scratch memory.
    ///
    /// Planes are transformed along x and y, columns along z, each while it is in the processor's cache.
    pub fn filter(
        &self,
        field: &[Lane],
        (scales, factors): (&[Lane], &[Lane]),
        result: &mut [Lane],
        strips: &mut [Lane],
    ) {
        let [nx, ny, nz] = self.layout.nodes;
        let plane = nx * ny;
        let [x, y, z] = &self.axes;
        let planes = result.par_chunks_mut(plane).zip(field.par_chunks(plane));
        let scratch = || vec![[0.0; LANES]; plane];
        planes.zip(scales.par_chunks(plane)).for_each_init(
            scratch,
            |scratch, ((to, from), scales)| {
                for ((to, from), scale) in to.iter_mut().zip(from).zip(scales) {
                    *to = product(from, scale);
                }
                to.chunks_exact_mut(nx).zip(scratch.chunks_exact_mut(nx)).for_each(
                    |(row, transformed)| {
                        x.transform(Direction::ToModes, 1, row, transformed);
                    },
                );
                y.transform(Direction::ToModes, nx, scratch, to);
            },
        );
        let transformed = &*result;
        let scratch = || vec![[0.0; LANES]; nz * STRIP];
        strips.par_chunks_mut(nz * STRIP).enumerate().for_each_init(
            scratch,
            |scratch, (n, strip)| {
                let width = strip.len() / nz;
                let scratch = &mut scratch[..strip.len()];
                let row = |z: usize| z * plane + n * STRIP..z * plane + n * STRIP + width;
                for (z, to) in strip.chunks_exact_mut(width).enumerate() {
                    to.copy_from_slice(&transformed[row(z)]);
                }
                z.transform(Direction::ToModes, width, strip, scratch);
                for (z, modes) in scratch.chunks_exact_mut(width).enumerate() {
                    let factors = &factors[row(z)];
                    modes.iter_mut().zip(factors).for_each(|(mode, by)| *mode = product(mode, by));
                }
                z.transform(Direction::FromModes, width, scratch, strip);
            },
        );
        let planes = result.par_chunks_mut(plane).zip(scales.par_chunks(plane)).enumerate();
        let scratch = || vec![[0.0; LANES]; plane];
        planes.for_each_init(scratch, |scratch, (z, (to, scales))| {
            let strips = strips.chunks(nz * STRIP);
            for (to, strip) in to.chunks_mut(STRIP).zip(strips) {
                let width = to.len();
                to.copy_from_slice(&strip[z * width..][..width]);
            }
            y.transform(Direction::FromModes, nx, to, scratch);
            scratch.chunks_exact_mut(nx).zip(to.chunks_exact_mut(nx)).for_each(
                |(row, transformed)| {
                    x.transform(Direction::FromModes, 1, row, transformed);
                },
            );
            to.iter_mut().zip(scales).for_each(|(to, scale)| *to = product(to, scale));
        });
    }
}

fn product(one: &Lane, other: &Lane) -> Lane {
    std::array::from_fn(|l| one[l] * other[l])
}

impl AxisModes {
    /// Transforms `s` adjacent rows, whose coefficients are `s` apart. `from` is overwritten.
    fn transform(&self, direction: Direction, s: usize, from: &mut [Lane], to: &mut [Lane]) {
        if direction == Direction::ToModes {
            fold(s, from);
        }
        let mut first = 0;
        for block in &self.blocks {
            let matrix = match direction {
                Direction::ToModes => &block.to_modes,
                Direction::FromModes => &block.from_modes,
            };
            let places = first..first + block.size * s;
            multiply(matrix, block.size, &from[places.clone()], &mut to[places.clone()]);
            first = places.end;
        }
        if direction == Direction::FromModes {
            fold(s, to);
        }
    }
}

/// Replaces each pair of coefficients at equal distance from the middle by their sum (first) and their difference
/// (second).
fn fold(s: usize, values: &mut [Lane]) {
    let half = values.len() / s / 2 * s;
    let (low, rest) = values.split_at_mut(half);
    let middle = rest.len() - half;
    let high = &mut rest[middle..];
    for (low, high) in low.chunks_exact_mut(s).zip(high.chunks_exact_mut(s).rev()) {
        for (low, high) in low.iter_mut().zip(high) {
            for l in 0..LANES {
                (low[l], high[l]) = (low[l] + high[l], low[l] - high[l]);
            }
        }
    }
}

/// A square matrix of `count` rows times as many rows of values.
///
/// Several rows are multiplied at once: each value is read once for all of them, and their sums do not wait for each
/// other.
#[multiversion(targets("x86_64+avx512f+avx512vl", "x86_64+avx2"))]
fn multiply(matrix: &[f32], count: usize, from: &[Lane], to: &mut [Lane]) {
    let mut first = 0;
    while first < count {
        let multiplied = match count - first {
            8.. => multiply_rows::<8>(matrix, (count, first), from, to),
            4.. => multiply_rows::<4>(matrix, (count, first), from, to),
            _ => multiply_rows::<1>(matrix, (count, first), from, to),
        };
        first += multiplied;
    }
}

/// `ROWS` rows of [`multiply`], from row `first` on; returns their number.
#[inline(always)]
fn multiply_rows<const ROWS: usize>(
    matrix: &[f32],
    (count, first): (usize, usize),
    from: &[Lane],
    to: &mut [Lane],
) -> usize {
    let s = from.len() / count;
    let rows: [&[f32]; ROWS] = std::array::from_fn(|r| &matrix[(first + r) * count..][..count]);
    for o in 0..s {
        let mut sums = [[0.0; LANES]; ROWS];
        for j in 0..count {
            let value = &from[j * s + o];
            let factors = rows.map(|row| row[j]);
            for (sum, factor) in sums.iter_mut().zip(factors) {
                for l in 0..LANES {
                    sum[l] += factor * value[l];
                }
            }
        }
        for (r, sum) in sums.into_iter().enumerate() {
            to[(first + r) * s + o] = sum;
        }
    }
    ROWS
}

#[cfg(test)]
mod tests {
    use rand::{RngExt, SeedableRng};
    use rand_pcg::Pcg64Mcg;

    use super::*;

    /// A filter by the eigenvalues of the penalty is the penalty itself, third differences one by one.
    #[test]
    fn the_penalty_in_its_modes_is_the_penalty() {
        for nodes in [[4, 7, 9], [30, 31, 8]] {
            let mut random = Pcg64Mcg::seed_from_u64(5);
            let layout = Layout { nodes };
            let mut lanes = |low: f32| -> Vec<Lane> {
                let mut lane = || [(); LANES].map(|()| random.random_range(low..1.0));
                (0..layout.len()).map(|_| lane()).collect()
            };
            let (field, scales, modes) = (lanes(-1.0), lanes(0.5), Modes::new(layout));
            let factors: Vec<Lane> = (0..layout.len())
                .map(|n| {
                    let place = layout.place(n);
                    let sum: f64 = (0..3).map(|axis| modes.axes[axis].penalty[place[axis]]).sum();
                    [sum as f32; LANES]
                })
                .collect();
            let [mut found, mut scratch] = [(); 2].map(|()| vec![[0.0; LANES]; layout.len()]);
            modes.filter(&field, (&scales, &factors), &mut found, &mut scratch);
            for l in [0, 5] {
                let scaled = |n: usize| f64::from(field[n][l] * scales[n][l]);
                let mut expected = vec![0.0; layout.len()];
                for axis in 0..3 {
                    let s = layout.stride(axis);
                    for n in (0..layout.len()).filter(|&n| layout.starts(axis, n)) {
                        let weights = [-1.0, 3.0, -3.0, 1.0];
                        let third: f64 = (0..4).map(|k| weights[k] * scaled(n + k * s)).sum();
                        (0..4).for_each(|k| expected[n + k * s] += weights[k] * third);
                    }
                }
                for (n, expected) in expected.iter().enumerate() {
                    let expected = expected * f64::from(scales[n][l]);
                    assert!((f64::from(found[n][l]) - expected).abs() < 2e-4, "{n} {l}");
                }
            }
        }
    }
}
