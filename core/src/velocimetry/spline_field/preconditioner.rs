//! The equations as if everywhere were the same, solved exactly: a preconditioner.
//!
//! With constant weights the data's matrix is w M ⊗ M ⊗ M, M the products of B-splines along an axis, and the
//! penalty's the sum over the axes of λ P, P = Δ³ᵀΔ³. In the eigenvectors of P, in which M is nearly diagonal,
//! the equations fall apart (fast diagonalisation: Lynch, Rice and Thomas, Numer. Math. 6, 1964).

use multiversion::multiversion;
use nalgebra::{DMatrix, SymmetricEigen};
use rayon::prelude::*;

use super::{
    super::{
        b_spline::{self, HALFWAY, HALFWAY_SLOPES},
        differences::Layout,
    },
    equations::Equations,
    lanes::{LANES, Lane, Vectors, zeros},
};

/// An axis in the penalty's eigenvectors.
struct AxisModes {
    /// Row k is eigenvector k.
    vectors: Vec<f32>,
    /// Its transpose.
    transposed: Vec<f32>,
    /// Eigenvalues of P.
    penalty: Vec<f64>,
    /// Diagonal of M.
    data: Vec<f64>,
    /// Diagonal of the product of slopes, at steps of 1, and of values half way between nodes.
    slope: Vec<f64>,
    halfway: Vec<f64>,
}

/// What does not change as weights do.
pub struct Modes {
    layout: Layout,
    axes: [AxisModes; 3],
}

/// See the head of this file.
pub struct Preconditioner<'a> {
    modes: &'a Modes,
    /// 1 over the equations' diagonal in the modes, per component.
    inverse: [Vec<Lane>; 3],
    /// Root of the mean diagonal over each coefficient's own, per component: where there is more data
    /// than elsewhere.
    scale: [Vec<f32>; 3],
}

impl AxisModes {
    fn new(count: usize) -> Self {
        let banded = |weights: &[f64]| {
            let rows = count + 1 - weights.len();
            let mut matrix = DMatrix::<f64>::zeros(rows, count);
            for row in 0..rows {
                for (place, weight) in weights.iter().enumerate() {
                    matrix[(row, row + place)] = *weight;
                }
            }
            matrix.transpose() * matrix
        };
        // The B-spline at places spread evenly over the cells.
        let mut data = DMatrix::<f64>::zeros(count, count);
        const PLACES: usize = 4;
        for n in 0..PLACES {
            let t = (n as f32 + 0.5) / PLACES as f32;
            let weights = b_spline::weights(t).map(f64::from);
            data += banded(&weights) / PLACES as f64;
        }
        let penalty = banded(&[-1.0, 3.0, -3.0, 1.0]);
        // A little of M tells straight fields, which P does not know, from each other.
        let SymmetricEigen { eigenvectors, .. } = (&penalty + 1e-4 * &data).symmetric_eigen();
        let diagonal = |matrix: &DMatrix<f64>| -> Vec<f64> {
            let product = eigenvectors.transpose() * matrix * &eigenvectors;
            (0..count).map(|k| product[(k, k)].max(0.0)).collect()
        };
        let (mut vectors, mut transposed) = (vec![0.0; count * count], vec![0.0; count * count]);
        for k in 0..count {
            for n in 0..count {
                let entry = eigenvectors[(n, k)] as f32;
                vectors[k * count + n] = entry;
                transposed[n * count + k] = entry;
            }
        }
        Self {
            vectors,
            transposed,
            penalty: diagonal(&penalty),
            data: diagonal(&data),
            slope: diagonal(&banded(&HALFWAY_SLOPES)),
            halfway: diagonal(&banded(&HALFWAY)),
        }
    }
}

impl Modes {
    /// Modes of a lattice of coefficients.
    pub fn new(layout: Layout) -> Self {
        Self { layout, axes: layout.nodes.map(AxisModes::new) }
    }
}

impl<'a> Preconditioner<'a> {
    /// For equations on the lattice of `modes`.
    pub fn new(modes: &'a Modes, equations: &Equations) -> Self {
        let parts: Vec<(Vec<Lane>, Vec<f32>)> =
            (0..3usize).into_par_iter().map(|c| of_component(modes, equations, c)).collect();
        let mut preconditioner =
            Self { modes, inverse: Default::default(), scale: Default::default() };
        for (c, (inverse, scale)) in parts.into_iter().enumerate() {
            (preconditioner.inverse[c], preconditioner.scale[c]) = (inverse, scale);
        }
        preconditioner
    }

    /// What `residual` asks of a field, nearly.
    pub fn applied(&self, residual: &Vectors) -> Vectors {
        let Layout { nodes } = self.modes.layout;
        let mut result = zeros(0);
        result.par_iter_mut().enumerate().for_each(|(c, result)| {
            let scaled = |field: &mut [Lane], by: &[f32]| {
                for (value, by) in field.iter_mut().zip(by) {
                    value.iter_mut().for_each(|v| *v *= by);
                }
            };
            let mut field = residual[c].clone();
            let mut other = vec![[0.0; LANES]; field.len()];
            scaled(&mut field, &self.scale[c]);
            for (axis, modes) in self.modes.axes.iter().enumerate() {
                turn(
                    &modes.vectors,
                    self.modes.layout.stride(axis),
                    nodes[axis],
                    &field,
                    &mut other,
                );
                std::mem::swap(&mut field, &mut other);
            }
            for (value, inverse) in field.iter_mut().zip(&self.inverse[c]) {
                for l in 0..LANES {
                    value[l] *= inverse[l];
                }
            }
            for (axis, modes) in self.modes.axes.iter().enumerate() {
                turn(
                    &modes.transposed,
                    self.modes.layout.stride(axis),
                    nodes[axis],
                    &field,
                    &mut other,
                );
                std::mem::swap(&mut field, &mut other);
            }
            scaled(&mut field, &self.scale[c]);
            *result = field;
        });
        result
    }
}

/// 1 over the diagonal in the modes, and the scales, of component `c`.
fn of_component(modes: &Modes, equations: &Equations, c: usize) -> (Vec<Lane>, Vec<f32>) {
    let (layout, count) = (modes.layout, modes.layout.len());
    let cells: f64 = (0..3).map(|axis| equations.nodes.cells(axis) as f64).product();
    // Lane 0 stands for all: lanes differ little in what counts.
    let weight = equations.weights[c].iter().map(|w| f64::from(w[0])).sum::<f64>() / cells;
    let stiffness = equations.lanes_of_stiffness(c).map(f64::from);
    let divergence = equations.divergence.map_or((0.0, 1.0), |divergence| {
        (f64::from(divergence.stiffness), f64::from(divergence.step_vox))
    });
    let [x, y, z] = &modes.axes;
    let mut inverse = Vec::with_capacity(count);
    for n in 0..count {
        let [i, j, k] = layout.place(n);
        let data = weight * x.data[i] * y.data[j] * z.data[k];
        let rough = x.penalty[i] + y.penalty[j] + z.penalty[k];
        let along = |axis: usize, of: usize| {
            let modes = &modes.axes[axis];
            if axis == c { modes.slope[of] / divergence.1.powi(2) } else { modes.halfway[of] }
        };
        let divergence = divergence.0 * along(0, i) * along(1, j) * along(2, k);
        let even = data + divergence + f64::from(equations.anchor);
        inverse.push(stiffness.map(|stiffness| (1.0 / (even + stiffness * rough)) as f32));
    }
    (inverse, scales(equations, c, weight))
}

/// Root of the diagonal that constant weights would give over the coefficients' own.
fn scales(equations: &Equations, c: usize, weight: f64) -> Vec<f32> {
    let layout = equations.nodes.layout;
    let mut rough = vec![equations.anchor; layout.len()];
    for axis in 0..3 {
        let s = layout.stride(axis);
        for n in (0..layout.len()).filter(|&n| layout.starts(axis, n)) {
            for (place, square) in [1.0, 9.0, 9.0, 1.0].into_iter().enumerate() {
                rough[n + place * s] += square * equations.stiffness[c];
            }
        }
    }
    let mut own = rough.clone();
    for (taps, weight) in equations.taps.iter().zip(&equations.weights[c]) {
        taps.scatter_squares(layout, weight[0], &mut own);
    }
    // Mean square of a B-spline over its four cells, along three axes.
    let mean = (weight * (151.0f64 / 315.0).powi(3)) as f32;
    let scale = |(rough, own): (&f32, &f32)| ((rough + mean) / own).sqrt().clamp(0.1, 10.0);
    rough.iter().zip(&own).map(scale).collect()
}

/// Rows of the matrix that are multiplied at once, so that each value is read once for all of them.
const ROWS: usize = 4;

/// Multiplies every row along the axis of `count` nodes `s` apart by a matrix, stored row by row.
#[multiversion(targets("x86_64+avx512f+avx512vl", "x86_64+avx2"))]
fn turn(matrix: &[f32], s: usize, count: usize, from: &[Lane], to: &mut [Lane]) {
    for block in 0..from.len() / (s * count) {
        let start = block * s * count;
        for i in (0..count).step_by(ROWS) {
            // Where fewer rows are left, the last one is computed several times.
            let numbers: [usize; ROWS] = std::array::from_fn(|r| (i + r).min(count - 1));
            let rows = numbers.map(|i| &matrix[i * count..][..count]);
            for o in 0..s {
                let mut sums = [[0.0; LANES]; ROWS];
                for j in 0..count {
                    let value = &from[start + j * s + o];
                    for (sum, row) in sums.iter_mut().zip(rows) {
                        for l in 0..LANES {
                            sum[l] += row[j] * value[l];
                        }
                    }
                }
                for (i, sum) in numbers.into_iter().zip(sums) {
                    to[start + i * s + o] = sum;
                }
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use rand::{RngExt, SeedableRng};
    use rand_pcg::Pcg64Mcg;

    use super::*;

    #[test]
    fn rows_are_multiplied_as_one_by_one() {
        let mut random = Pcg64Mcg::seed_from_u64(5);
        let nodes = [3, 6, 9];
        let layout = Layout { nodes };
        let field: Vec<Lane> = (0..layout.len())
            .map(|_| std::array::from_fn(|_| random.random_range(-1.0..1.0)))
            .collect();
        for (axis, &count) in nodes.iter().enumerate() {
            let s = layout.stride(axis);
            let matrix: Vec<f32> =
                (0..count * count).map(|_| random.random_range(-1.0..1.0)).collect();
            let mut found = vec![[0.0; LANES]; field.len()];
            turn(&matrix, s, count, &field, &mut found);
            for (n, found) in found.iter().enumerate() {
                let i = n / s % count;
                for l in 0..LANES {
                    let entry = |j: usize| {
                        f64::from(matrix[i * count + j]) * f64::from(field[n - i * s + j * s][l])
                    };
                    let expected: f64 = (0..count).map(entry).sum();
                    assert!((f64::from(found[l]) - expected).abs() < 1e-5, "{axis} {n} {l}");
                }
            }
        }
    }
}
