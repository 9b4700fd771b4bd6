use nalgebra::{DMatrix, DVector};
use proptest::{prelude::*, test_runner::RngSeed};

use super::*;

const NODES: [usize; 3] = [5, 4, 6];

fn lattice(values: Vec<[f32; 3]>) -> Lattice {
    Lattice { nodes: NODES, first_vox: [7.5; 3], step_vox: 8.0, values }
}

fn places() -> impl Iterator<Item = [f32; 3]> {
    let [nx, ny, nz] = NODES;
    (0..nx * ny * nz).map(move |n| [n % nx, n / nx % ny, n / (nx * ny)].map(|i| i as f32))
}

/// The same equations as a dense matrix, solved directly.
fn solved_directly(equations: &Equations, measured: &[f64]) -> Vec<f64> {
    let count = measured.len();
    let mut matrix = DMatrix::from_diagonal(&DVector::from_column_slice(&equations.certainty));
    let right = &matrix * DVector::from_column_slice(measured);
    for axis in 0..3 {
        let layout = equations.penalty.layout;
        let s = layout.stride(axis);
        for n in (0..count).filter(|&n| layout.starts(axis, n)) {
            let mut difference = DVector::zeros(count);
            for (k, factor) in [-1.0, 3.0, -3.0, 1.0].into_iter().enumerate() {
                difference[n + k * s] = factor;
            }
            matrix += equations.penalty.stiffness[axis][n] * &difference * difference.transpose();
        }
    }
    matrix.lu().solve(&right).expect("certainties are positive").as_slice().to_vec()
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 24, rng_seed: RngSeed::Fixed(7), ..Default::default() })]

    #[test]
    fn conjugate_gradients_agree_with_a_direct_solution(
        noise in proptest::collection::vec((-1f64..1.0, 0.01f64..0.5), 120),
    ) {
        let layout = Layout { nodes: NODES };
        let (value, deviation): (Vec<f64>, Vec<f64>) = noise.into_iter().unzip();
        let variance: Vec<f64> = deviation.iter().map(|d| d * d).collect();
        let equations = Equations::new(layout, &value, &variance);
        let expected = solved_directly(&equations, &value);
        for (n, found) in equations.solve(value).into_iter().enumerate() {
            let allowed = 0.02 * variance[n].sqrt();
            prop_assert!((found - expected[n]).abs() < allowed, "{n}: {found} {}", expected[n]);
        }
    }
}

#[test]
fn a_field_of_second_order_is_its_own_likeliest() {
    let field = lattice(
        places()
            .map(|[x, y, z]| [0.3 * x * x - y, 0.1 * y * y + x * z, 2.0 - z * z / 4.0])
            .collect(),
    );
    let found = field.likeliest(&vec![[0.1; 3]; field.values.len()]);
    for (found, value) in found.values.iter().zip(&field.values) {
        for c in 0..3 {
            assert!((found[c] - value[c]).abs() < 1e-4, "{found:?} {value:?}");
        }
    }
}

#[test]
fn an_uncertain_vector_follows_its_neighbours() {
    let mut field = lattice(places().map(|[x, _, z]| [0.2 * x, 0.0, 0.1 * z]).collect());
    let wrong = 2 * 20 + 2 * 5 + 2;
    let right = field.values[wrong];
    field.values[wrong] = [2.0, -1.0, 1.0];
    let mut uncertainty_vox = vec![[0.01; 3]; field.values.len()];
    uncertainty_vox[wrong] = [2.0; 3];
    let found = field.likeliest(&uncertainty_vox).values[wrong];
    for c in 0..3 {
        assert!((found[c] - right[c]).abs() < 0.1, "{found:?} {right:?}");
    }
}

#[test]
fn lattices_too_small_for_a_third_difference_stay_as_they_are() {
    let values = vec![[1.0, -2.0, 0.5], [0.0, 3.0, 1.0]];
    let field = Lattice { nodes: [2, 1, 1], first_vox: [0.0; 3], step_vox: 8.0, values };
    let found = field.likeliest(&[[0.1; 3]; 2]);
    for (found, value) in found.values.iter().flatten().zip(field.values.iter().flatten()) {
        assert!((found - value).abs() < 1e-6);
    }
}
