//! Preconditioner: exact solution of the equations with uniform weights.
//!
//! With constant weights the data's matrix is w M ⊗ M ⊗ M, M the products of B-splines along an axis, and the
//! penalty's the sum over the axes of λ P, P = Δ³ᵀΔ³. In the eigenvectors of P, in which M is nearly diagonal,
//! the equations decouple (fast diagonalisation: Lynch, Rice and Thomas, Numer. Math. 6, 1964).

use rayon::prelude::*;

use super::{
    equations::Equations,
    lanes::{LANES, Lane, Vectors},
    modes::Modes,
};

/// The preconditioner; see the head of this file.
pub struct Preconditioner<'a> {
    modes: &'a Modes,
    /// Per vector.
    parts: Vec<Factors>,
}

/// Factors for one vector of coefficients.
struct Factors {
    /// Inverse of the equations' diagonal in the modes.
    inverse: Vec<Lane>,
    /// Root of the ratio of the mean diagonal to each coefficient's own: accounts for non-uniform data.
    scale: Vec<Lane>,
}

impl<'a> Preconditioner<'a> {
    /// For equations on the lattice of `modes`.
    pub fn new(modes: &'a Modes, equations: &Equations) -> Self {
        let vectors = 0..equations.weights.len();
        let parts = vectors.into_par_iter().map(|c| Factors::new(modes, equations, c)).collect();
        Self { modes, parts }
    }

    /// Writes the approximate solution for the right-hand side `residual` to `result`. `scratch` has the same size.
    pub fn apply(&self, residual: &Vectors, result: &mut Vectors, scratch: &mut Vectors) {
        let vectors = residual.par_iter().zip(&self.parts).zip(result).zip(scratch);
        vectors.for_each(|(((residual, part), result), scratch)| {
            self.modes.filter(residual, (&part.scale, &part.inverse), result, scratch);
        });
    }
}

impl Factors {
    fn new(modes: &Modes, equations: &Equations, c: usize) -> Self {
        let layout = equations.nodes.layout;
        let cells = equations.nodes.all_cells() as f64;
        let typical = typical(&equations.weights[c]).map(|weight| weight / cells);
        let stiffness = equations.stiffness[c].map(f64::from);
        let [x, y, z] = &modes.axes;
        let diagonal = |n: usize| -> Lane {
            let [i, j, k] = layout.place(n);
            let data = x.data[i] * y.data[j] * z.data[k];
            let rough = x.penalty[i] + y.penalty[j] + z.penalty[k];
            let divergence = equations.divergence.map_or(0.0, |divergence| {
                let along = |axis: usize, of: usize| {
                    let modes = &modes.axes[axis];
                    let step_vox = f64::from(divergence.step_vox);
                    if axis == c { modes.slope[of] / step_vox.powi(2) } else { modes.halfway[of] }
                };
                f64::from(divergence.stiffness) * along(0, i) * along(1, j) * along(2, k)
            });
            let even = divergence + f64::from(equations.anchor);
            std::array::from_fn(|l| {
                (1.0 / (typical[l] * data + stiffness[l] * rough + even)) as f32
            })
        };
        let inverse = (0..layout.len()).map(diagonal).collect();
        Self { inverse, scale: scales(equations, c) }
    }
}

/// Number of positive weights of each lane times their geometric mean. Weights differ by a factor of 1000, and the
/// few largest determine only a few modes, so the geometric mean is more suitable than the arithmetic one
/// (docs/decisions.md).
fn typical(weights: &[Lane]) -> [f64; LANES] {
    let (mut counts, mut logarithms) = ([0.0f64; LANES], [0.0f64; LANES]);
    for weights in weights {
        for l in (0..LANES).filter(|&l| weights[l] > 0.0) {
            counts[l] += 1.0;
            logarithms[l] += f64::from(libm::logf(weights[l]));
        }
    }
    std::array::from_fn(|l| counts[l] * libm::exp(logarithms[l] / counts[l].max(1.0)))
}

/// Root of the ratio of the diagonal with uniform weights to the coefficients' own.
fn scales(equations: &Equations, c: usize) -> Vec<Lane> {
    let (layout, stiffness) = (equations.nodes.layout, equations.stiffness[c]);
    // Contribution of third differences, divided by λ.
    let mut rough = vec![0.0f32; layout.len()];
    for axis in 0..3 {
        let s = layout.stride(axis);
        for n in (0..layout.len()).filter(|&n| layout.starts(axis, n)) {
            for (place, square) in [1.0, 9.0, 9.0, 1.0].into_iter().enumerate() {
                rough[n + place * s] += square;
            }
        }
    }
    let mut own = vec![[0.0; LANES]; layout.len()];
    let mut sums = [0.0f64; LANES];
    for (taps, weights) in equations.taps.iter().zip(&equations.weights[c]) {
        taps.squared().scatter(layout, *weights, &mut own[taps.first..]);
        (0..LANES).for_each(|l| sums[l] += f64::from(weights[l]));
    }
    // Mean square of a B-spline over its four cells, along three axes.
    let cells = equations.nodes.all_cells() as f64;
    let mean = sums.map(|sum| (sum / cells * (151.0f64 / 315.0).powi(3)) as f32);
    let scale = |(own, rough): (&Lane, &f32)| {
        std::array::from_fn(|l| {
            let rough = stiffness[l] * rough + equations.anchor;
            ((rough + mean[l]) / (rough + own[l])).sqrt().clamp(0.1, 10.0)
        })
    };
    own.iter().zip(&rough).map(scale).collect()
}
