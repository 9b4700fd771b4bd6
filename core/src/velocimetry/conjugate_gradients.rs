//! Iterative solution of symmetric positive definite equations.

/// Stopping criterion.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Until {
    /// Down to this part of the first residual, both divided by the root of the diagonal.
    pub tolerance: f64,
    /// At most so many steps.
    pub steps: usize,
}

/// Solves A x = `right` from `start` by conjugate gradients with A's diagonal as preconditioner
/// (Hestenes and Stiefel, J. Res. Natl. Bur. Stand. 49, 1952). `apply` gives A x.
///
/// A may be singular where `right` lies in its range: undetermined unknowns keep the values of
/// `start`. An unknown that is in no equation has 0 on the `diagonal`.
pub fn solve(
    apply: impl Fn(&[f64]) -> Vec<f64>,
    diagonal: &[f64],
    right: &[f64],
    start: Vec<f64>,
    until: Until,
) -> Vec<f64> {
    let mut value = start;
    let mut residual: Vec<f64> = right.iter().zip(apply(&value)).map(|(r, a)| r - a).collect();
    let scaled = |residual: &[f64]| -> Vec<f64> {
        let scale = |(r, d): (&f64, &f64)| if *d > 0.0 { r / d } else { 0.0 };
        residual.iter().zip(diagonal).map(scale).collect()
    };
    let mut step = scaled(&residual);
    let mut square = dot(&residual, &step);
    let enough = until.tolerance * until.tolerance * square;
    for _ in 0..until.steps {
        if square <= enough {
            break;
        }
        let applied = apply(&step);
        let length = square / dot(&step, &applied);
        add(&mut value, length, &step);
        add(&mut residual, -length, &applied);
        let next = scaled(&residual);
        let next_square = dot(&residual, &next);
        let keep = next_square / square;
        for (step, next) in step.iter_mut().zip(next) {
            *step = next + keep * *step;
        }
        square = next_square;
    }
    value
}

fn dot(a: &[f64], b: &[f64]) -> f64 {
    a.iter().zip(b).map(|(a, b)| a * b).sum()
}

fn add(to: &mut [f64], factor: f64, values: &[f64]) {
    for (to, value) in to.iter_mut().zip(values) {
        *to += factor * value;
    }
}
