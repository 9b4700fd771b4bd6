use nalgebra::{DMatrix, DVector};
use rand::{Rng, RngExt, SeedableRng};
use rand_pcg::Pcg64Mcg;

use super::{
    super::{differences::Penalty, layout::Layout, nodes::Taps},
    pairs::Pair,
    particles::LightPeak,
    samples::{add_product, add_transposed, values_at},
    variance::{Waves, near_faces},
    *,
};
use crate::particles::Neighbours;

const NODES: [usize; 3] = [7, 6, 5];
const STEP: f32 = 8.0;

fn lattice(f: impl Fn([f32; 3]) -> [f32; 3]) -> Lattice {
    let values = vec![[0.0; 3]; NODES.iter().product()];
    Lattice { nodes: NODES, first_vox: [3.0; 3], step_vox: STEP, values }.sampling(f)
}

/// A smooth flow of some voxels, with curvature and rotation.
fn flow([x, y, z]: [f32; 3]) -> [f32; 3] {
    [3.0 + (0.06 * y).sin(), 0.02 * x - 1.0 + (0.05 * z).cos(), 0.03 * (x - y) + 0.5]
}

fn random() -> Pcg64Mcg {
    Pcg64Mcg::seed_from_u64(11)
}

/// Places between the lattice's nodes.
fn places(random: &mut impl Rng, count: usize) -> Vec<[f32; 3]> {
    let place = |random: &mut _, n: usize| 3.0 + STEP * (n - 1) as f32 * unit(random);
    (0..count).map(|_| NODES.map(|n| place(random, n))).collect()
}

fn unit(random: &mut impl Rng) -> f32 {
    random.random::<f32>()
}

/// Frames of points whose middle of the path is at `middles`, by the simulator's kind of rule:
/// many small steps.
fn frames(middles: &[[f32; 3]], flow: impl Fn([f32; 3]) -> [f32; 3]) -> [PointCloud; 2] {
    [-0.5f32, 0.5].map(|part| {
        const STEPS: usize = 50;
        let moved = |&at: &[f32; 3]| {
            (0..STEPS).fold(at, |at, _| {
                let by = flow(at);
                std::array::from_fn(|c| at[c] + part * by[c] / STEPS as f32)
            })
        };
        let position_vox: Vec<[f32; 3]> = middles.iter().map(moved).collect();
        PointCloud { light: vec![1.0; position_vox.len()], position_vox, grain_vox: 0.0 }
    })
}

/// What was found, on the nodes of a lattice.
fn on_nodes(found: &Refined, like: &Lattice) -> Lattice {
    let spline = &found.spline;
    like.clone().sampling(|at| spline.of(&spline.taps(at)).map(|value| value as f32))
}

fn largest_difference(a: &Lattice, b: &Lattice) -> f32 {
    let pairs = a.values.as_flattened().iter().zip(b.values.as_flattened());
    pairs.map(|(a, b)| (a - b).abs()).fold(0.0, f32::max)
}

/// The largest error against [`flow`] on nodes that are not on the lattice's faces.
fn largest_inner_error(found: &Lattice) -> f32 {
    let inner = |n: usize| {
        let place = Layout { nodes: NODES }.place(n);
        (0..3).all(|axis| place[axis] > 0 && place[axis] + 1 < NODES[axis])
    };
    let expected = lattice(flow).values;
    let nodes = (0..expected.len()).filter(|&n| inner(n));
    let errors = nodes.flat_map(|n| (0..3).map(move |c| (n, c)));
    errors.map(|(n, c)| (found.values[n][c] - expected[n][c]).abs()).fold(0.0, f32::max)
}

#[test]
fn a_spline_has_the_values_of_its_lattice_on_the_nodes_and_follows_it_between() {
    let field = lattice(flow);
    let spline = Spline::through(&field, None);
    assert!(largest_difference(&spline.on_nodes(&field), &field) < 1e-5);
    for at in places(&mut random(), 200) {
        let (found, expected) = (spline.of(&spline.taps(at)), flow(at));
        for c in 0..3 {
            assert!((found[c] as f32 - expected[c]).abs() < 0.01, "{at:?}: {found:?} {expected:?}");
        }
    }
}

#[test]
fn a_place_on_a_node_has_the_nodes_own_taps() {
    let spline = Spline::through(&lattice(flow), None);
    for n in 0..NODES.iter().product() {
        let place = Layout { nodes: NODES }.place(n).map(|i| 3.0 + STEP * i as f32);
        let [a, b] = [spline.taps(place), Taps::of_node(spline.nodes.layout, NODES, n)]
            .map(|taps| spline.of(&taps));
        assert!((0..3).all(|c| (a[c] - b[c]).abs() < 1e-6), "{n}: {a:?} {b:?}");
    }
}

/// ⟨B c, v⟩ = ⟨c, Bᵀ v⟩ for random c and v.
#[test]
fn scattering_is_the_transpose_of_gathering() {
    let mut random = random();
    let spline = Spline::through(&lattice(flow), None);
    let taps: Vec<Taps> = places(&mut random, 300).into_iter().map(|at| spline.taps(at)).collect();
    let mut numbers =
        |count: usize| -> Vec<f64> { (0..count).map(|_| f64::from(unit(&mut random))).collect() };
    let (coefficients, values) = (numbers(spline.nodes.layout.len()), numbers(taps.len()));
    let dot = |a: &[f64], b: &[f64]| a.iter().zip(b).map(|(a, b)| a * b).sum::<f64>();
    let mut transposed = vec![0.0; coefficients.len()];
    add_transposed(spline.nodes.layout, &taps, &values, &mut transposed);
    let on_taps = values_at(spline.nodes.layout, &taps, &coefficients);
    let gathered = dot(&on_taps, &values);
    let scattered = dot(&coefficients, &transposed);
    assert!((gathered / scattered - 1.0).abs() < 1e-9, "{gathered} {scattered}");
    // In one pass the product with BᵀWB is the same.
    let [mut separate, mut fused] = [(); 2].map(|()| vec![0.0; coefficients.len()]);
    let weighted: Vec<f64> = values.iter().zip(&on_taps).map(|(w, value)| w * value).collect();
    add_transposed(spline.nodes.layout, &taps, &weighted, &mut separate);
    add_product(spline.nodes.layout, &taps, &values, &coefficients, &mut fused);
    assert!(separate.iter().zip(&fused).all(|(a, b)| (a - b).abs() < 1e-9 * (1.0 + b.abs())));
}

#[test]
fn neighbours_are_those_that_a_search_through_all_finds() {
    let mut random = random();
    let points = places(&mut random, 500);
    let near = Neighbours::new(&points, 3.0);
    let square = |a: [f32; 3], b: [f32; 3]| (0..3).map(|c| (a[c] - b[c]).powi(2)).sum::<f32>();
    for at in places(&mut random, 100).into_iter().chain([[-40.0; 3], [1.5; 3], [90.0; 3]]) {
        let mut found = Vec::new();
        near.visit(at, |point, _| found.push(point));
        found.sort_unstable();
        let within = |&n: &usize| square(points[n], at) <= 9.0;
        let expected: Vec<usize> = (0..points.len()).filter(within).collect();
        assert_eq!(found, expected);
        let by_distance =
            |&a: &usize, &b: &usize| square(points[a], at).total_cmp(&square(points[b], at));
        assert_eq!(near.nearest(at, 3.0), expected.into_iter().min_by(by_distance));
    }
    assert_eq!(Neighbours::new(&[], 1.0).nearest([0.0; 3], 1.0), None);
}

/// Knots of points of different light about known centres, far enough apart, and a few dim points
/// between them.
#[test]
fn particles_are_the_centres_of_intensity_peaks() {
    let mut random = random();
    let centres: Vec<[f32; 3]> =
        (0..60).map(|n| [n % 4, n / 4 % 4, n / 16].map(|i| 4.0 * i as f32 + 0.3)).collect();
    let mut cloud = PointCloud { position_vox: Vec::new(), light: Vec::new(), grain_vox: 0.25 };
    let mut add = |at: [f32; 3], light: f32| {
        cloud.position_vox.push(at);
        cloud.light.push(light);
    };
    for &centre in &centres {
        for _ in 0..4 {
            let offset = [0; 3].map(|_| 0.5 * (unit(&mut random) - 0.5));
            // Two points opposite each other: their centre is that of the peak.
            let light = 1.0 + unit(&mut random);
            add(std::array::from_fn(|c| centre[c] + offset[c]), light);
            add(std::array::from_fn(|c| centre[c] - offset[c]), light);
        }
        add(centre.map(|c| c + 1.9), 0.05);
    }
    let found = particles(&cloud);
    assert_eq!(found.len(), centres.len());
    for centre in centres {
        let nearest = |p: &&LightPeak| (0..3).all(|c| (p.at_vox[c] - centre[c]).abs() < 1e-4);
        assert!(found.iter().find(nearest).is_some(), "{centre:?}");
    }
}

#[test]
fn no_light_leaves_the_correlations_field() {
    let field = lattice(flow);
    let dark = PointCloud { position_vox: vec![], light: vec![], grain_vox: 0.25 };
    let given_vox = [0.1, 0.2, 0.05];
    let uncertainty_vox = vec![Some(given_vox); field.values.len()];
    let settled = follow(&field, &uncertainty_vox, [&dark, &dark], false, None);
    for (settled, correlated) in on_nodes(&settled, &field).values.iter().zip(&field.values) {
        for c in 0..3 {
            assert!((settled[c] - correlated[c]).abs() < given_vox[c]);
        }
    }
    let good =
        |u: &Option<[f32; 3]>| u.is_some_and(|u| u.iter().all(|u| u.is_finite() && *u > 0.0));
    assert!(settled.uncertainty_vox.iter().all(good));
}

/// Particles in `frames` of [`flow`] lead from a field of that uncertainty to the true one.
fn assert_is_put_right(start: &Lattice, uncertainty_vox: f32, frames: [&PointCloud; 2]) {
    let settled =
        follow(start, &vec![Some([uncertainty_vox; 3]); start.values.len()], frames, false, None);
    let error = largest_inner_error(&on_nodes(&settled, start));
    assert!(error < 0.02, "{error}");
}

/// The correlation's field is off by several tenths of a voxel; particles at a realistic density put it
/// right.
#[test]
fn a_field_off_by_tenths_of_a_voxel_is_put_right_by_its_particles() {
    let middles = places(&mut random(), 900);
    let [a, b] = frames(&middles, flow);
    let off = lattice(|at| {
        let [u, v, w] = flow(at);
        [u + 0.2 * (0.1 * at[1]).sin(), v - 0.15, w + 0.1]
    });
    assert_is_put_right(&off, 0.1, [&a, &b]);
}

/// A third of the particles of frame b is somewhere else: lost, and new ones in their place.
#[test]
fn wrong_particles_do_not_draw_the_field_aside() {
    let mut random = random();
    let middles = places(&mut random, 1200);
    let [a, mut b] = frames(&middles, flow);
    for (n, at) in places(&mut random, 400).into_iter().enumerate() {
        b.position_vox[n] = at;
    }
    let start = lattice(|at| flow(at).map(|v| v + 0.05));
    assert_is_put_right(&start, 0.05, [&a, &b]);
}

/// Light along z that cameras too close to each other leave: it is where their lines of sight enclose
/// it, in both frames, wherever in it the particle is.
#[test]
fn light_that_is_wide_along_an_axis_is_not_followed_along_it() {
    let middles = places(&mut random(), 900);
    let sheared = |[_, _, z]: [f32; 3]| [0.3 + 0.01 * z, 0.0, 0.4];
    let [a, b] = frames(&middles, |at| [sheared(at)[0], 0.0, 0.0]).map(|cloud| {
        let lines = cloud
            .position_vox
            .into_iter()
            .flat_map(|[x, y, z]| (-3..=3).map(move |n| [x, y, z + 0.2 * n as f32]));
        let position_vox: Vec<[f32; 3]> = lines.collect();
        PointCloud { light: vec![1.0; position_vox.len()], position_vox, grain_vox: 0.2 }
    });
    let correlated = lattice(|at| {
        let [u, v, w] = sheared(at);
        [u + 0.1, v, w]
    });
    let uncertainty_vox = vec![Some([0.1; 3]); correlated.values.len()];
    let found =
        on_nodes(&follow(&correlated, &uncertainty_vox, [&a, &b], false, None), &correlated);
    let expected = lattice(sheared).values;
    let mean_error = |c: usize| {
        let errors = found.values.iter().zip(&expected).map(|(f, e)| f[c] - e[c]);
        errors.sum::<f32>() / found.values.len() as f32
    };
    assert!(mean_error(0).abs() < 0.02, "across: {}", mean_error(0));
    assert!(mean_error(2).abs() < 0.02, "along: {}", mean_error(2));
}

/// Frames of one flow, and frames that have nothing to do with each other.
#[test]
fn particles_measure_where_they_move_together_and_nowhere_else() {
    let mut random = random();
    let start = lattice(flow);
    let uncertainty_vox = vec![Some([0.1; 3]); start.values.len()];
    let middles = places(&mut random, 2000);
    let [a, b] = frames(&middles, flow);
    let together = follow(&start, &uncertainty_vox, [&a, &b], false, None).by_particles;
    assert!(together.iter().filter(|&&by| by).count() > together.len() / 2);
    let [_, other] = frames(&places(&mut random, 2000), flow);
    let apart = follow(&start, &uncertainty_vox, [&a, &other], false, None).by_particles;
    assert!(!apart.contains(&true));
}

/// The homogeneous formula against the inverse of the whole matrix, in the middle and near the faces of
/// a lattice with many samples at random places.
#[test]
fn the_variance_is_the_inverse_matrix_s() {
    let mut random = random();
    let spline = Spline::through(&lattice(flow), None);
    let (layout, count) = (spline.nodes.layout, spline.nodes.layout.len());
    for (per_cell, stiffness) in [(20.0, 2.0), (20.0, 0.1), (60.0, 0.5)] {
        let cells: usize = NODES.iter().map(|n| n - 1).product();
        let taps: Vec<Taps> = places(&mut random, per_cell as usize * cells)
            .into_iter()
            .chain(
                (0..NODES.iter().product())
                    .map(|n| Layout { nodes: NODES }.place(n).map(|i| 3.0 + STEP * i as f32)),
            )
            .map(|at| spline.taps(at))
            .collect();
        let mut samples = DMatrix::zeros(taps.len(), count);
        for (row, taps) in taps.iter().enumerate() {
            let mut of_row = vec![0.0; count];
            taps.scatter_component(layout, 1.0, &mut of_row);
            samples.set_row(row, &DVector::from_vec(of_row).transpose());
        }
        let mut matrix = samples.transpose() * &samples;
        for column in 0..count {
            let mut unit = vec![0.0; count];
            unit[column] = 1.0;
            let starts = |axis| {
                let stiff = move |n| if layout.starts(axis, n) { stiffness } else { 0.0 };
                (0..count).map(stiff).collect()
            };
            let penalty = Penalty { layout, stiffness: std::array::from_fn(starts) };
            let mut forces = vec![0.0; count];
            penalty.add_forces(&unit, &mut forces);
            for (row, force) in forces.into_iter().enumerate() {
                matrix[(row, column)] += force;
            }
        }
        let inverse = matrix.cholesky().unwrap();
        for place in [[3, 3, 2], [1, 3, 2], [3, 4, 2], [1, 1, 2], [0, 3, 2]] {
            let number = Layout { nodes: NODES }.number(place);
            let mut node = vec![0.0; count];
            Taps::of_node(layout, NODES, number).scatter_component(layout, 1.0, &mut node);
            let node = DVector::from_vec(node);
            let expected = node.dot(&inverse.solve(&node)).sqrt();
            let variance = Waves::new().variance(per_cell, 1.0, [stiffness; 3]);
            let found = (near_faces(NODES, place) * variance).sqrt();
            println!("{per_cell} {stiffness} {place:?}: {found:.3}, exactly {expected:.3}");
            assert!(
                (found / expected - 1.0).abs() < 0.15,
                "{per_cell} {stiffness} {place:?}: {found} {expected}"
            );
        }
    }
}

#[test]
fn pairs_are_each_others_nearest() {
    let spline = Spline::through(&lattice(|_| [1.0, 0.0, 0.0]), None);
    let a = [[10.0, 10.0, 10.0], [20.0, 20.0, 20.0], [20.3, 20.0, 20.0], [12.0, 30.0, 30.0]];
    let b = [[21.0, 20.0, 20.1], [11.1, 10.0, 10.0], [14.0, 30.0, 30.0]];
    let compact = |at_vox| LightPeak { at_vox, spread_vox2: [0.0; 3], light: 1.0 };
    let found = pairs(&spline, [&a.map(compact), &b.map(compact)], 0.7);
    let places: Vec<[f32; 3]> = found.iter().map(|Pair { middle_vox, .. }| *middle_vox).collect();
    assert_eq!(found.len(), 2, "{places:?}");
    assert!((found[0].displacement_vox[0] - 1.1).abs() < 1e-5);
    assert!((found[1].displacement_vox[2] - 0.1).abs() < 1e-5);
}
