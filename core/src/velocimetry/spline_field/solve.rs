//! Several right-hand sides solved at once by preconditioned conjugate gradients.

use super::{
    super::conjugate_gradients::Until,
    equations::Equations,
    lanes::{Lane, Vectors, add, dot, scale_and_add, zeros},
    preconditioner::Preconditioner,
};

/// Improves `field`, whose equations have the residual `residual`: at most `steps` steps of conjugate
/// gradients (Hestenes and Stiefel, J. Res. Natl. Bur. Stand. 49, 1952), each lane with its own step
/// lengths, or fewer once every lane's residual, in the preconditioner's norm, is `tolerance` of its first.
pub fn improve(
    equations: &Equations,
    preconditioner: &Preconditioner,
    mut residual: Vectors,
    field: &mut Vectors,
    Until { steps, tolerance }: Until,
) {
    let count = equations.nodes.layout.len();
    let [mut step, mut next, mut scratch] = [(); 3].map(|()| zeros(field.len(), count));
    preconditioner.apply(&residual, &mut step, &mut scratch);
    let mut square = dot(&residual, &step);
    let enough = square.map(|square| square * tolerance * tolerance);
    for _ in 0..steps {
        if square.iter().zip(enough).all(|(square, enough)| *square <= enough) {
            return;
        }
        let applied = equations.applied(&step);
        let curvature = dot(&step, &applied);
        let length: Lane = std::array::from_fn(|l| ratio(square[l], curvature[l]));
        add(field, length, &step);
        add(&mut residual, length.map(|length| -length), &applied);
        preconditioner.apply(&residual, &mut next, &mut scratch);
        let next_square = dot(&residual, &next);
        let keep: Lane = std::array::from_fn(|l| ratio(next_square[l], square[l]));
        scale_and_add(&mut step, keep, &next);
        square = next_square;
    }
}

/// The ratio; 0 for a lane that has converged.
fn ratio(above: f64, below: f64) -> f32 {
    if below > 0.0 && above > 0.0 { (above / below) as f32 } else { 0.0 }
}
