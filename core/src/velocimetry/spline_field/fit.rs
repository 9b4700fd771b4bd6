//! The most probable field, given displacements of single particles, and samples of its error.

use rayon::prelude::*;

use super::{
    super::{
        cell_divergence::DIVERGENCE_DEVIATION,
        conjugate_gradients::Until,
        nodes::{Nodes, Taps},
    },
    Sample, calibration,
    divergence::Divergence,
    equations::{Equations, Targets, values_at},
    field::SplineField,
    lanes::{LANES, Lane, Vectors, packed, zeros},
    modes::Modes,
    noise::Noise,
    nugget,
    preconditioner::Preconditioner,
    scatter::inflation,
    solve::improve,
    stiffness::{Ladder, Scores, Search},
};
use crate::statistics::{NORMAL_OF_MEDIAN, median};

/// Degrees of freedom of Student's distribution for particles' errors: mismatched particles have larger
/// errors than a normal distribution allows (Lange, Little and Taylor, J. Am.
/// Stat. Assoc. 84, 1989).
const DEGREES_OF_FREEDOM: f32 = 3.0;

/// Additional standard deviation of the divergence, per voxel of the samples' additional one: with a strict
/// constraint from the start, conjugate gradients would converge slowly.
const DIVERGENCE_PER_EXTRA_SIGMA: f32 = 0.1;

/// Standard deviation of a coefficient about that of the previous field, in voxels. Without it, fields that are quadratic
/// along every axis would be undetermined. The previous field knows the samples that cross-validation leaves out: with a
/// small deviation their residuals would be too small where samples are few (docs/decisions.md).
const ANCHOR_VOX: f32 = 10.0;

/// Standard deviation added to that of every sample, relative to the typical cross-validation residual. Samples
/// that are much more accurate than the field between them do not improve it, but weights that differ by a factor
/// of 100,000 make conjugate gradients slow (docs/decisions.md).
const ADDED_DEVIATION: f32 = 0.2;

/// A field and its fit to samples.
pub struct Fit<'a> {
    nodes: Nodes,
    modes: Modes,
    samples: &'a [Sample],
    taps: Vec<Taps>,
    /// Per component: lane 0 is the field, the others are random samples of its error.
    coefficients: Vectors,
    /// Per component, in all lanes: coefficients of the initial field.
    before: Vectors,
    /// Per component and sample: inverse variance, reduced for large residuals.
    weights: [Vec<f32>; 3],
    /// Penalty of third differences, per component.
    pub stiffness: [f32; 3],
    /// Ratio of the samples' variance to the stated one, per component.
    excess: [f32; 3],
    /// Additional factor on the variance of each sample, per component.
    inflation: [Vec<f32>; 3],
    /// Standard deviation added to that of every sample, in voxels.
    extra_sigma_vox: f32,
    /// Typical cross-validation residual, in voxels, per component; 0 before it is known.
    missed_vox: [f32; 3],
    incompressible: bool,
}

impl<'a> Fit<'a> {
    /// Initialises the field `start` on `nodes`. Samples are in the order of [`Nodes::order`].
    pub fn new(
        nodes: Nodes,
        samples: &'a [Sample],
        start: impl Fn([f32; 3]) -> [f32; 3],
        incompressible: bool,
    ) -> Self {
        let (layout, count) = (nodes.layout, nodes.layout.len());
        let mut coefficients = zeros(3, count);
        for n in 0..count {
            let value = start(nodes.place_vox(n));
            for (lanes, value) in coefficients.iter_mut().zip(value) {
                lanes[n][0] = value;
            }
        }
        let before = first_in_all_lanes(&coefficients);
        let taps = samples.par_iter().map(|sample| nodes.taps(sample.middle_vox)).collect();
        Self {
            nodes,
            modes: Modes::new(layout),
            samples,
            taps,
            coefficients,
            before,
            weights: Default::default(),
            stiffness: [1.0; 3],
            excess: [1.0; 3],
            inflation: [(); 3].map(|()| vec![1.0; samples.len()]),
            extra_sigma_vox: 0.0,
            missed_vox: [0.0; 3],
            incompressible,
        }
    }

    /// Updates the samples' weights from their residuals. If `extra_sigma_vox` is 0, their variance is estimated
    /// from close pairs of samples and from local residuals.
    pub fn weigh(&mut self, extra_sigma_vox: f32) {
        self.extra_sigma_vox = extra_sigma_vox;
        if extra_sigma_vox == 0.0 {
            self.excess = nugget::excess(self.samples, &self.field());
            self.inflation = self.scatter();
        }
        for c in 0..3 {
            let values = self.values(&self.coefficients[c]);
            self.weights[c] = self
                .samples
                .iter()
                .zip(&values)
                .enumerate()
                .map(|(n, (sample, value))| {
                    let variance = self.variance(c, n);
                    (DEGREES_OF_FREEDOM + 1.0)
                        / (DEGREES_OF_FREEDOM * variance + square_left(sample, value, c))
                })
                .collect();
        }
    }

    /// Chooses the stiffness with the least cross-validation error. Every eighth sample is left out, beginning with
    /// index `first`, then others, until there are enough residuals.
    pub fn choose_stiffness(&mut self, ladder: &Ladder, first: usize, search: Search) {
        let folds = (LANES * search.residuals).div_ceil(self.samples.len().max(1)).clamp(1, LANES);
        let mut scores: [Scores; 3] = Default::default();
        for first in (first..first + folds).map(|first| first % LANES) {
            self.leave_out(first, ladder, search.until, &mut scores);
        }
        for (c, scores) in scores.into_iter().enumerate() {
            let (factor, rung) = ladder.best(&scores.sums);
            self.stiffness[c] *= factor;
            let typical = median(scores.missed[rung].iter().copied()).unwrap_or_default();
            self.missed_vox[c] = (NORMAL_OF_MEDIAN * typical) as f32;
        }
    }

    /// Adds the cross-validation residuals of every eighth sample, beginning with index `first`, to the scores of the
    /// components.
    fn leave_out(&self, first: usize, ladder: &Ladder, until: Until, scores: &mut [Scores; 3]) {
        let is_left_out = |n: usize| n % LANES == first;
        let weights =
            self.lanes_of_weights(
                |n, weight| {
                    if is_left_out(n) { [0.0; LANES] } else { [weight; LANES] }
                },
            );
        let mut equations = self.equations(weights);
        for stiffness in &mut equations.stiffness {
            stiffness.iter_mut().zip(ladder.factors()).for_each(|(s, factor)| *s *= factor);
        }
        let mut field = self.before.clone();
        self.solve_for_samples(&equations, &mut field, until);
        for (c, (field, scores)) in field.iter().zip(scores).enumerate() {
            let values = self.values(field);
            for n in (first..self.samples.len()).step_by(LANES) {
                let variance = f64::from(DEGREES_OF_FREEDOM * self.variance(c, n));
                let missed = values[n].map(|value| self.samples[n].displacement_vox[c] - value);
                scores.add(missed.map(f64::from), variance);
            }
        }
    }

    /// Fits the field to the samples without the divergence constraint. Samples of its error are unchanged.
    pub fn approach(&mut self, until: Until) {
        let samples = |of: &dyn Fn(usize, usize) -> f32| {
            vec![(0..self.samples.len()).map(|n| packed(|c| of(c, n))).collect::<Vec<Lane>>()]
        };
        let coefficients = |of: &Vectors| -> Vectors {
            let count = self.nodes.layout.len();
            vec![(0..count).map(|n| packed(|c| of[c][n][0])).collect()]
        };
        let equations = Equations {
            weights: samples(&|c, n| self.weights[c][n]),
            stiffness: vec![packed(|c| self.stiffness[c])],
            ..self.equations(Vec::new())
        };
        let mut field = coefficients(&self.coefficients);
        let targets = Targets {
            samples: &samples(&|c, n| self.samples[n].displacement_vox[c]),
            before: &coefficients(&self.before),
            noise: None,
        };
        self.solve(&equations, &targets, &mut field, until);
        for (c, coefficients) in self.coefficients.iter_mut().enumerate() {
            for (lanes, found) in coefficients.iter_mut().zip(&field[0]) {
                lanes[0] = found[c];
            }
        }
    }

    /// Fits the field to the samples, and updates the samples of its error.
    pub fn improve(&mut self, until: Until) {
        let weights = self.lanes_of_weights(|_, weight| [weight; LANES]);
        let equations = self.equations(weights);
        let of_component = |c: usize| -> Vec<Lane> {
            let target = |(n, (sample, weight)): (usize, (&Sample, &f32))| {
                let mut target = Noise.of_sample(c, n).map(|sign| sign / weight.sqrt());
                target[0] = sample.displacement_vox[c];
                target
            };
            self.samples.iter().zip(&self.weights[c]).enumerate().map(target).collect()
        };
        let samples: Vec<Vec<Lane>> = (0..3).map(of_component).collect();
        let targets = Targets { samples: &samples, before: &self.before, noise: Some(&Noise) };
        let mut field = self.coefficients.clone();
        self.solve(&equations, &targets, &mut field, until);
        self.coefficients = field;
    }

    /// Cross-validation residual of each sample (eight folds).
    pub fn left_out(&self, until: Until) -> Vec<[f32; 3]> {
        let weights = self.lanes_of_weights(|n, weight| {
            let mut weights = [weight; LANES];
            weights[n % LANES] = 0.0;
            weights
        });
        let mut field = first_in_all_lanes(&self.coefficients);
        self.solve_for_samples(&self.equations(weights), &mut field, until);
        let values: [Vec<Lane>; 3] = std::array::from_fn(|c| self.values(&field[c]));
        let missed = |(n, sample): (usize, &Sample)| {
            std::array::from_fn(|c| sample.displacement_vox[c] - values[c][n][n % LANES])
        };
        self.samples.iter().enumerate().map(missed).collect()
    }

    /// The current field, with the uncertainty from the samples of its error.
    pub fn field(&self) -> SplineField {
        SplineField::new(self.nodes, &self.coefficients, self.stiffness)
    }

    /// The current field, with its uncertainty calibrated by the cross-validation residuals `missed`.
    pub fn calibrated(&self, missed: &[[f32; 3]]) -> SplineField {
        let field = self.field();
        let variance = |c: usize, n: usize| self.variance(c, n);
        let widening = calibration::widening(&self.nodes, &field, self.samples, missed, variance);
        field.widened(&widening)
    }

    /// Factor on every sample's variance, from the residuals of its neighbours.
    fn scatter(&self) -> [Vec<f32>; 3] {
        std::array::from_fn(|c| {
            let values = self.values(&self.coefficients[c]);
            let left = |(sample, value): (&Sample, &Lane)| {
                square_left(sample, value, c) / (self.excess[c] * sample.variance_vox2[c])
            };
            let left: Vec<f32> = self.samples.iter().zip(&values).map(left).collect();
            inflation(&self.nodes, self.samples, &left)
        })
    }

    /// Solves for the fields of all lanes, with the samples' displacements as targets in each.
    fn solve_for_samples(&self, equations: &Equations, field: &mut Vectors, until: Until) {
        let of = |c: usize| self.samples.iter().map(|s| [s.displacement_vox[c]; LANES]).collect();
        let samples: Vec<Vec<Lane>> = (0..3).map(of).collect();
        let targets = Targets { samples: &samples, before: &self.before, noise: None };
        self.solve(equations, &targets, field, until);
    }

    fn solve(&self, equations: &Equations, targets: &Targets, field: &mut Vectors, until: Until) {
        let residual = equations.residual(field, targets);
        let preconditioner = Preconditioner::new(&self.modes, equations);
        improve(equations, &preconditioner, residual, field, until);
    }

    fn values(&self, field: &[Lane]) -> Vec<Lane> {
        values_at(self.nodes.layout, &self.taps, field)
    }

    fn lanes_of_weights(&self, lanes: impl Fn(usize, f32) -> Lane) -> Vec<Vec<Lane>> {
        let of = |weights: &Vec<f32>| -> Vec<Lane> {
            weights.iter().enumerate().map(|(n, &weight)| lanes(n, weight)).collect()
        };
        self.weights.iter().map(of).collect()
    }

    /// Variance of sample `n` in component `c`, in voxel².
    fn variance(&self, c: usize, n: usize) -> f32 {
        let own = self.excess[c] * self.inflation[c][n] * self.samples[n].variance_vox2[c];
        let added = ADDED_DEVIATION * self.missed_vox[c];
        own + self.extra_sigma_vox * self.extra_sigma_vox + added * added
    }

    /// Equations with a vector for each component.
    fn equations(&self, weights: Vec<Vec<Lane>>) -> Equations<'_> {
        let divergence =
            (DIVERGENCE_DEVIATION as f32).hypot(DIVERGENCE_PER_EXTRA_SIGMA * self.extra_sigma_vox);
        let divergence = Divergence {
            step_vox: self.nodes.step_vox,
            stiffness: 1.0 / (divergence * divergence),
        };
        Equations {
            nodes: &self.nodes,
            taps: &self.taps,
            weights,
            stiffness: self.stiffness.map(|stiffness| [stiffness; LANES]).to_vec(),
            divergence: self.incompressible.then_some(divergence),
            anchor: 1.0 / (ANCHOR_VOX * ANCHOR_VOX),
        }
    }
}

/// The field of lane 0 in all lanes.
fn first_in_all_lanes(field: &Vectors) -> Vectors {
    let of_vector =
        |of: &Vec<Lane>| -> Vec<Lane> { of.iter().map(|lanes| [lanes[0]; LANES]).collect() };
    field.iter().map(of_vector).collect()
}

/// Squared residual of a sample plus the variance of the field there, from lane 0 and the other lanes of `value`.
fn square_left(sample: &Sample, value: &Lane, c: usize) -> f32 {
    let [field, errors @ ..] = value;
    let left = sample.displacement_vox[c] - field;
    left * left + errors.iter().map(|e| e * e).sum::<f32>() / (LANES - 1) as f32
}
