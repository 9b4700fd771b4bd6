use nalgebra::{DMatrix, DVector};
use rand::{Rng, RngExt, SeedableRng};
use rand_pcg::Pcg64Mcg;

use super::{
    super::{layout::Layout, nodes::Taps},
    divergence::Divergence,
    equations::{Equations, Targets},
    lanes::{LANES, Lane, Vectors, zeros},
    modes::Modes,
    noise::Noise,
    preconditioner::Preconditioner,
    solve::improve,
    *,
};

const LOW: [f32; 3] = [0.0; 3];
const HIGH: [f32; 3] = [40.0, 36.0, 32.0];

fn random() -> Pcg64Mcg {
    Pcg64Mcg::seed_from_u64(5)
}

fn place(random: &mut impl Rng) -> [f32; 3] {
    HIGH.map(|high| high * random.random::<f32>())
}

fn normal(random: &mut impl Rng) -> f32 {
    // The sum of twelve uniform variables has variance 1.
    (0..12).map(|_| random.random::<f32>()).sum::<f32>() - 6.0
}

/// `count` samples of a flow with independent errors.
fn samples(flow: impl Fn([f32; 3]) -> [f32; 3], count: usize, deviation_vox: f32) -> Vec<Sample> {
    samples_by(random(), flow, count, deviation_vox)
}

fn samples_by(
    mut random: impl Rng,
    flow: impl Fn([f32; 3]) -> [f32; 3],
    count: usize,
    deviation_vox: f32,
) -> Vec<Sample> {
    let sample = |_| {
        let middle_vox = place(&mut random);
        let mut displacement_vox = flow(middle_vox);
        displacement_vox.iter_mut().for_each(|d| *d += deviation_vox * normal(&mut random));
        Sample { middle_vox, displacement_vox, variance_vox2: [deviation_vox * deviation_vox; 3] }
    };
    (0..count).map(sample).collect()
}

/// A solenoidal wave of `wavelength` voxels.
fn wave(wavelength: f32, [x, y, z]: [f32; 3]) -> [f32; 3] {
    let k = std::f32::consts::TAU / wavelength;
    [(k * z).sin() + (k * y).cos(), (k * x).sin() + (k * z).cos(), (k * y).sin() + (k * x).cos()]
}

/// Lanes differ in how stiff they are.
const FACTORS: Lane = [1.0, 2.0, 0.5, 3.0, 1.0, 0.3, 1.0, 1.0];

/// A small problem with all its parts, of random weights.
struct Problem {
    nodes: Nodes,
    taps: Vec<Taps>,
    weights: Vec<Vec<Lane>>,
    stiffness: [f32; 3],
    values: Vec<Vec<Lane>>,
    before: Vectors,
}

impl Problem {
    fn new() -> Self {
        let mut random = random();
        let nodes = Nodes::covering([0.0; 3], [12.0, 12.0, 8.0], 4.0);
        let mut taps: Vec<_> = (0..60)
            .map(|_| nodes.taps([12.0, 12.0, 8.0].map(|high| high * random.random::<f32>())))
            .collect();
        taps.sort_by_key(|taps| taps.first);
        let mut lanes = |low: f32, high: f32| -> Vec<Vec<Lane>> {
            let mut lane = || [(); LANES].map(|()| random.random_range(low..high));
            (0..3).map(|_| (0..60).map(|_| lane()).collect()).collect()
        };
        let (weights, values) = (lanes(0.5, 2.0), lanes(-1.0, 1.0));
        let stiffness = [3.7, 2.1, 1.3];
        let coefficient = |c: usize, n: usize| [0.01 * ((c + n) % 7) as f32; LANES];
        let before: Vectors =
            (0..3).map(|c| (0..nodes.layout.len()).map(|n| coefficient(c, n)).collect()).collect();
        Self { nodes, taps, weights, stiffness, values, before }
    }

    fn equations(&self) -> Equations<'_> {
        Equations {
            nodes: &self.nodes,
            taps: &self.taps,
            weights: self.weights.clone(),
            stiffness: self.stiffness.map(|s| FACTORS.map(|factor| factor * s)).to_vec(),
            divergence: Some(Divergence { step_vox: 4.0, stiffness: 5.0 }),
            anchor: 0.1,
        }
    }

    /// The equations of lane `l` row by row: samples, third differences, anchors, divergence; with what each row is
    /// to be, and its weight.
    fn rows(&self, l: usize) -> (DMatrix<f64>, DVector<f64>) {
        let layout = self.nodes.layout;
        let count = layout.len();
        let mut rows: Vec<(Vec<f64>, f64)> = Vec::new();
        for c in 0..3 {
            for (n, taps) in self.taps.iter().enumerate() {
                let mut row = vec![[0.0f32]; count];
                taps.scatter(layout, [1.0], &mut row[taps.first..]);
                let root = f64::from(self.weights[c][n][l]).sqrt();
                let mut whole = vec![0.0; 3 * count];
                for (to, from) in whole[c * count..].iter_mut().zip(&row) {
                    *to = root * f64::from(from[0]);
                }
                rows.push((whole, root * f64::from(self.values[c][n][l])));
            }
            for axis in 0..3 {
                let s = layout.stride(axis);
                for n in (0..count).filter(|&n| layout.starts(axis, n)) {
                    let root = f64::from(self.stiffness[c] * FACTORS[l]).sqrt();
                    let mut whole = vec![0.0; 3 * count];
                    for (place, factor) in [-1.0, 3.0, -3.0, 1.0].into_iter().enumerate() {
                        whole[c * count + n + place * s] = root * factor;
                    }
                    rows.push((whole, f64::from(Noise.of_difference(c, axis, n)[l])));
                }
            }
            for n in 0..count {
                let root = 0.1f64.sqrt();
                let mut whole = vec![0.0; 3 * count];
                whole[c * count + n] = root;
                let drawn = f64::from(Noise.of_anchor(c, n)[l]);
                rows.push((
                    whole,
                    if l == 0 { root * f64::from(self.before[c][n][0]) } else { drawn },
                ));
            }
        }
        for n in (0..count).filter(|&n| (0..3).all(|axis| layout.starts(axis, n))) {
            let place = layout.place(n);
            let middle = std::array::from_fn(|axis| {
                self.nodes.first_vox[axis] + 4.0 * (place[axis] as f32 + 0.5)
            });
            let root = 5f64.sqrt();
            let mut whole = vec![0.0; 3 * count];
            for c in 0..3 {
                let mut row = vec![[0.0f32]; count];
                let taps = self.nodes.derivative_taps(middle, c);
                taps.scatter(layout, [1.0], &mut row[taps.first..]);
                for (to, from) in whole[c * count..].iter_mut().zip(&row) {
                    *to = root * f64::from(from[0]);
                }
            }
            rows.push((whole, f64::from(Noise.of_divergence(n)[l])));
        }
        let matrix = DMatrix::from_fn(rows.len(), 3 * count, |row, column| rows[row].0[column]);
        let right = DVector::from_iterator(rows.len(), rows.iter().map(|(_, right)| *right));
        (matrix, right)
    }
}

fn of_lane(field: &Vectors, l: usize) -> DVector<f64> {
    let values: Vec<f64> = field.iter().flatten().map(|lanes| f64::from(lanes[l])).collect();
    DVector::from_vec(values)
}

/// The matrix that is never written down is that of the rows, for the field and for a draw.
#[test]
fn the_equations_are_those_of_a_dense_matrix() {
    let problem = Problem::new();
    let equations = problem.equations();
    let mut random = random();
    let mut field = zeros(3, problem.nodes.layout.len());
    field.iter_mut().flatten().for_each(|lanes| *lanes = [(); LANES].map(|()| random.random()));
    let applied = equations.applied(&field);
    let targets =
        Targets { samples: &problem.values, before: &problem.before, noise: Some(&Noise) };
    let residual = equations.residual(&field, &targets);
    for l in [0, 3] {
        let (rows, right) = problem.rows(l);
        let expected = rows.transpose() * &rows * of_lane(&field, l);
        assert!((of_lane(&applied, l) - &expected).amax() < 1e-4 * expected.amax());
        let expected = rows.transpose() * (right - rows * of_lane(&field, l));
        assert!((of_lane(&residual, l) - &expected).amax() < 1e-4 * expected.amax());
    }
}

#[test]
fn conjugate_gradients_come_to_the_solution_of_the_dense_matrix() {
    let problem = Problem::new();
    let equations = problem.equations();
    let mut field = zeros(3, problem.nodes.layout.len());
    let targets =
        Targets { samples: &problem.values, before: &problem.before, noise: Some(&Noise) };
    let residual = equations.residual(&field, &targets);
    let modes = Modes::new(problem.nodes.layout);
    let preconditioner = Preconditioner::new(&modes, &equations);
    improve(
        &equations,
        &preconditioner,
        residual,
        &mut field,
        Until { steps: 60, tolerance: 1e-6 },
    );
    for l in [0, 5] {
        let (rows, right) = problem.rows(l);
        let normal = rows.transpose() * &rows;
        let expected = normal.cholesky().unwrap().solve(&(rows.transpose() * right));
        let off = (of_lane(&field, l) - &expected).amax();
        assert!(off < 1e-3 * expected.amax(), "{off} of {}", expected.amax());
    }
}

#[test]
fn a_fields_derivatives_are_its_slopes() {
    let start = |[x, y, z]: [f32; 3]| [0.1 * x - 0.2 * z, 0.3 * y, 0.05 * x * z];
    let nodes = Nodes::covering(LOW, HIGH, 5.0);
    let field = Fit::new(nodes, &[], start, false).field();
    let mut random = random();
    for _ in 0..50 {
        let at = place(&mut random).map(|v| v.clamp(1.0, 31.0));
        let gradient = field.gradient(at);
        for (along, slopes) in gradient.into_iter().enumerate() {
            let [mut low, mut high] = [at; 2];
            (low[along], high[along]) = (at[along] - 0.1, at[along] + 0.1);
            let (low, high) = (field.value(low), field.value(high));
            for c in 0..3 {
                assert!((slopes[c] - (high[c] - low[c]) / 0.2).abs() < 2e-4, "{along} {c}");
            }
        }
    }
}

/// Error and coverage at places of no sample.
fn unseen(field: &SplineField, flow: impl Fn([f32; 3]) -> [f32; 3]) -> (f32, [f32; 2]) {
    let mut random = Pcg64Mcg::seed_from_u64(77);
    let (mut sum, mut held, mut all) = (0.0, [0.0f32; 2], 0.0);
    for _ in 0..600 {
        let at = place(&mut random);
        let (found, expected, u) = (field.value(at), flow(at), field.uncertainty_vox(at));
        for c in 0..3 {
            let error = (found[c] - expected[c]).abs();
            sum += error;
            for (held, widths) in held.iter_mut().zip([1.0, 1.96]) {
                *held += f32::from(u8::from(error <= widths * u[c]));
            }
            all += 1.0;
        }
    }
    (sum / all, held.map(|held| held / all))
}

/// The field through samples of which nothing is known before.
fn fitted(samples: &[Sample], incompressible: bool) -> SplineField {
    let extent = Extent { corners_vox: [LOW, HIGH], coarsest_vox: 12.0 };
    let guess = Guess { at: &|_| [0.0; 3], error_vox: 0.5, stiffness: None };
    through(&extent, samples, &guess, incompressible).0
}

/// 600 particles 4.2 voxels apart see waves of 24 voxels; intervals hold what they say, near enough for a
/// volume of a few independent pieces.
#[test]
fn waves_are_resolved_and_intervals_hold() {
    let flow = |at| wave(24.0, at);
    for deviation_vox in [0.002, 0.05] {
        let samples = samples(flow, 600, deviation_vox);
        let field = fitted(&samples, false);
        let (error, [one, two]) = unseen(&field, flow);
        println!("{deviation_vox}: {error:.4}, {one:.2} {two:.2}");
        assert!(error < 0.04 + 0.6 * deviation_vox, "{error}");
        assert!((0.55..0.9).contains(&one) && two > 0.85, "{one} {two}");
    }
}

/// The components of this wave are alike, so their penalties should be. With few residuals they differ by chance.
#[test]
fn few_particles_choose_like_penalties_for_like_components() {
    let nodes = Nodes::covering(LOW, HIGH, 8.0);
    let spread = |residuals: usize| -> f32 {
        let of_seed = |seed: u64| {
            let random = Pcg64Mcg::seed_from_u64(seed);
            let mut samples = samples_by(random, |at| wave(64.0, at), 120, 0.02);
            samples.sort_by_key(|sample| nodes.taps(sample.middle_vox).first);
            let mut fit = Fit::new(nodes, &samples, |_| [0.0; 3], false);
            fit.weigh(0.0);
            let search = Search { residuals, ..TRYING };
            fit.choose_stiffness(&Ladder::expecting(LARGEST_DIFFERENCE_VOX, RATIOS[0]), 0, search);
            let logarithms = fit.stiffness.map(f32::ln);
            logarithms.iter().copied().fold(f32::MIN, f32::max)
                - logarithms.iter().copied().fold(f32::MAX, f32::min)
        };
        (0..12).map(of_seed).sum::<f32>() / 12.0
    };
    let [one, all] = [1, 120].map(spread);
    println!("{one:.2} {all:.2}");
    assert!(all < 0.6 * one, "{one} {all}");
}

/// Again from the field that was found, with its stiffness: what most particles follow, not what few do.
#[test]
fn a_field_that_is_not_the_last_is_near_the_flow() {
    let flow = |at| wave(24.0, at);
    let extent = Extent { corners_vox: [LOW, HIGH], coarsest_vox: 12.0 };
    let mut samples = samples(flow, 600, 0.02);
    for sample in samples.iter_mut().step_by(33) {
        sample.displacement_vox[1] += 0.8;
    }
    let guess = Guess { at: &|_| [0.0; 3], error_vox: 0.5, stiffness: None };
    let first = near(&extent, &samples, &guess);
    let at = |at_vox| first.value(at_vox);
    let guess = Guess { at: &at, error_vox: 0.5, stiffness: Some(first.stiffness) };
    let again = near(&extent, &samples, &guess);
    let [first, again] = [&first, &again].map(|field| unseen(field, flow).0);
    println!("{first:.4} {again:.4}");
    assert!(first < 0.15 && again < 0.8 * first, "{first} {again}");
}

#[test]
fn particles_taken_for_others_hardly_move_the_field() {
    let flow = |at| wave(40.0, at);
    let mut samples = samples(flow, 600, 0.01);
    let clean = unseen(&fitted(&samples, false), flow).0;
    for sample in samples.iter_mut().step_by(33) {
        sample.displacement_vox[0] += 0.8;
        sample.displacement_vox[2] -= 0.5;
    }
    let soiled = unseen(&fitted(&samples, false), flow).0;
    println!("{clean:.4} {soiled:.4}");
    assert!(soiled < 2.0 * clean + 0.003, "{clean} {soiled}");
}

/// What few particles leave open is narrowed by knowing that the flow has no divergence.
#[test]
fn incompressible_fields_are_nearer_to_an_incompressible_flow() {
    let flow = |at| wave(24.0, at);
    let samples = samples(flow, 250, 0.01);
    let [free, bound] = [false, true].map(|incompressible| {
        let field = fitted(&samples, incompressible);
        let divergence = |at| (0..3).map(|c| field.gradient(at)[c][c]).sum::<f32>().abs();
        let mut random = random();
        let mean = (0..200).map(|_| divergence(place(&mut random))).sum::<f32>() / 200.0;
        (unseen(&field, flow).0, mean)
    });
    println!("{free:?} {bound:?}");
    assert!(bound.0 < free.0 && bound.1 < 0.3 * free.1, "{free:?} {bound:?}");
}

#[test]
fn the_layout_has_a_coefficient_beyond_each_end() {
    let nodes = Nodes::covering([1.0; 3], [21.0, 11.0, 6.0], 5.0);
    assert_eq!(nodes.layout, Layout { nodes: [7, 5, 5] });
}
