use nalgebra::{DMatrix, DVector};
use proptest::{prelude::*, test_runner::RngSeed};
use rand::{RngExt, SeedableRng};
use rand_pcg::Pcg64Mcg;

use super::*;

const NODES: [usize; 3] = [5, 4, 6];

fn lattice(values: Vec<[f32; 3]>) -> Lattice {
    Lattice { nodes: NODES, first_vox: [7.5; 3], step_vox: 8.0, values }
}

fn places() -> impl Iterator<Item = [f32; 3]> {
    let [nx, ny, nz] = NODES;
    (0..nx * ny * nz).map(move |n| [n % nx, n / nx % ny, n / (nx * ny)].map(|i| i as f32))
}

/// The likeliest field behind vectors all of which were measured.
fn likeliest(field: &Lattice, uncertainty_vox: &[Option<[f32; 3]>]) -> Lattice {
    let measured: Vec<bool> = uncertainty_vox.iter().map(Option::is_some).collect();
    field.likeliest(uncertainty_vox, &measured, None)
}

/// The same equations as a dense matrix, solved directly.
fn solved_directly(equations: &SmoothingEquations, measured: &[f64]) -> Vec<f64> {
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
        let variance: Vec<Option<f64>> = deviation.iter().map(|d| Some(d * d)).collect();
        let equations = SmoothingEquations::new(
            layout,
            &value,
            &variance,
            Known { measured: &vec![true; value.len()], flow: None },
        );
        let expected = solved_directly(&equations, &value);
        for (n, found) in equations.solve(value).into_iter().enumerate() {
            let allowed = 0.02 * deviation[n];
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
    let found = likeliest(&field, &vec![Some([0.1; 3]); field.values.len()]);
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
    let mut uncertainty_vox = vec![Some([0.01; 3]); field.values.len()];
    uncertainty_vox[wrong] = Some([2.0; 3]);
    let found = likeliest(&field, &uncertainty_vox).values[wrong];
    for c in 0..3 {
        assert!((found[c] - right[c]).abs() < 0.1, "{found:?} {right:?}");
    }
}

#[test]
fn lattices_too_small_for_a_third_difference_stay_as_they_are() {
    let values = vec![[1.0, -2.0, 0.5], [0.0, 3.0, 1.0]];
    let field = Lattice { nodes: [2, 1, 1], first_vox: [0.0; 3], step_vox: 8.0, values };
    let found = likeliest(&field, &[Some([0.1; 3]); 2]);
    for (found, value) in found.values.iter().flatten().zip(field.values.iter().flatten()) {
        assert!((found - value).abs() < 1e-6);
    }
}

/// Vectors with some noise that curve more than any field of second order.
fn noisy_curves() -> Lattice {
    let mut random = Pcg64Mcg::seed_from_u64(3);
    lattice(
        places()
            .map(|at| {
                let noise = [(); 3].map(|()| random.random_range(-0.03..0.03));
                std::array::from_fn(|c| noise[c] + 3.0 * (0.4 * (at[0] + at[1] + at[2])).sin())
            })
            .collect(),
    )
}

/// The field without its last layers along z is a lattice of its own: it comes out alike whether they are
/// without vectors or do not exist.
#[test]
fn what_has_no_vector_changes_none_of_the_others() {
    let field = noisy_curves();
    let lit = 20 * 4;
    let ended = Lattice { nodes: [5, 4, 4], values: field.values[..lit].to_vec(), ..field };
    let alone = likeliest(&ended, &vec![Some([0.02; 3]); lit]);
    let mut whole = field.clone();
    whole.values[lit..].fill([0.0; 3]);
    let known: Vec<bool> = (0..120).map(|n| n < lit).collect();
    let uncertainty_vox: Vec<Option<[f32; 3]>> =
        known.iter().map(|known| known.then_some([0.02; 3])).collect();
    for whole in [whole.clone(), whole.filled(&known, None)] {
        let found = likeliest(&whole, &uncertainty_vox);
        for (found, alone) in found.values.iter().zip(&alone.values) {
            // Both are solved as far as a fraction of the uncertainty.
            assert!((0..3).all(|c| (found[c] - alone[c]).abs() < 0.002), "{found:?} {alone:?}");
        }
        assert!(found.values.as_flattened().iter().all(|v| v.is_finite()));
    }
}

#[test]
fn a_hole_is_filled_by_the_field_about_it() {
    let curved = |[x, y, z]: [f32; 3]| [0.3 * x * x - y, 0.1 * y * y + x * z, 2.0 - z * z / 4.0];
    let mut field = lattice(places().map(curved).collect());
    let hole = 2 * 20 + 2 * 5 + 2;
    let right = field.values[hole];
    field.values[hole] = [0.0; 3];
    let mut uncertainty_vox = vec![Some([0.01; 3]); field.values.len()];
    uncertainty_vox[hole] = None;
    let found = likeliest(&field, &uncertainty_vox).values[hole];
    assert!((0..3).all(|c| (found[c] - right[c]).abs() < 0.01), "{found:?} {right:?}");
}

#[test]
fn a_field_without_any_vector_stays_as_it_is() {
    let field = noisy_curves();
    assert_eq!(likeliest(&field, &vec![None; field.values.len()]), field);
}
