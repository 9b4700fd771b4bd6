//! The likeliest field behind displacements of single particles, and what they leave open.

use rayon::prelude::*;

use super::{
    Sample, calibration,
    divergence::Divergence,
    equations::{Equations, Targets, values_at},
    field::SplineField,
    lanes::{LANES, Lane, Vectors, zeros},
    nodes::{Nodes, Taps},
    noise::Noise,
    nugget,
    preconditioner::{Modes, Preconditioner},
    roughness::{Stiffness, even, updated},
    scatter::inflation,
    solve::improve,
};

/// Degrees of freedom of Student's distribution, which particles' errors are taken to have: one that was
/// taken for another is wrong by more than a normal distribution allows (Lange, Little and Taylor, J. Am.
/// Stat. Assoc. 84, 1989).
const DEGREES_OF_FREEDOM: f32 = 3.0;

/// Third differences that the first round expects, in voxels.
const FIRST_DIFFERENCE_VOX: f32 = 0.1;

/// Divergence that an incompressible flow may show, in voxel per voxel: the displacement over a pair is that of
/// a curved path.
const DIVERGENCE: f32 = 0.003;

/// Below this part of their first residual equations are solved well enough.
const TOLERANCE: f64 = 0.02;

/// Steps in which the fields of left-out samples are solved for, from the field of all.
const LEFT_OUT_STEPS: usize = 60;

/// A field that is being fitted.
pub struct Fit {
    nodes: Nodes,
    modes: Modes,
    /// Lane 0 is the field, the others are draws from its error.
    coefficients: Vectors,
    stiffness: [Stiffness; 3],
    /// Variance of the samples over what they state, per component.
    excess: [f32; 3],
    /// Factor on the variance of each sample beside that, per component.
    inflation: [Vec<f32>; 3],
    incompressible: bool,
}

/// How the field is moved towards samples.
#[derive(Debug, Clone, Copy)]
pub struct Round {
    /// Standard deviation that every sample is given beside its own, in voxels: what the field cannot follow
    /// yet.
    pub slack_vox: f32,
    /// Whether samples that are far off count less.
    pub robust: bool,
    /// Steps of conjugate gradients.
    pub steps: usize,
}

impl Fit {
    /// Begins with the field `start` on `nodes`.
    pub fn new(nodes: Nodes, start: impl Fn([f32; 3]) -> [f32; 3], incompressible: bool) -> Self {
        let (layout, count) = (nodes.layout, nodes.layout.len());
        let mut coefficients = zeros(count);
        for n in 0..count {
            let value = start(nodes.place_vox(n));
            for (lanes, value) in coefficients.iter_mut().zip(value) {
                lanes[n][0] = value;
            }
        }
        let stiffness = std::array::from_fn(|_| even(layout, FIRST_DIFFERENCE_VOX));
        let modes = Modes::new(layout);
        Self {
            nodes,
            modes,
            coefficients,
            stiffness,
            excess: [1.0; 3],
            inflation: Default::default(),
            incompressible,
        }
    }

    /// Moves the field towards `samples`. Without slack, what their errors really are is asked of those that
    /// are close together.
    pub fn adjust(&mut self, samples: &[Sample], round: Round) {
        let taps = self.taps(samples);
        if round.slack_vox == 0.0 {
            self.excess = nugget::excess(samples, &self.field());
            self.inflation = self.scatter(samples, &taps);
        } else {
            self.inflation = [(); 3].map(|()| vec![1.0; samples.len()]);
        }
        let slack = round.slack_vox * round.slack_vox;
        let (mut weights, mut targets): ([Vec<Lane>; 3], [Vec<Lane>; 3]) = Default::default();
        for c in 0..3 {
            let values = values_at(self.nodes.layout, &taps, &self.coefficients[c]);
            let of_sample = |(n, (sample, value)): (usize, (&Sample, &Lane))| {
                let variance = self.variance(samples, c, n) + slack;
                let weight = if round.robust {
                    weight(square_left(sample, value, c), variance)
                } else {
                    1.0 / variance
                };
                let mut target = Noise.of_sample(c, n).map(|sign| sign / weight.sqrt());
                target[0] = sample.displacement_vox[c];
                ([weight; LANES], target)
            };
            (weights[c], targets[c]) =
                samples.iter().zip(&values).enumerate().map(of_sample).unzip();
        }
        let mut field = std::mem::replace(&mut self.coefficients, zeros(0));
        let equations = self.equations(&taps, weights);
        let targets = Targets { samples: &targets, noise: Some(&Noise) };
        let residual = equations.residual(&field, &targets);
        let preconditioner = Preconditioner::new(&self.modes, &equations);
        improve(&equations, &preconditioner, residual, &mut field, round.steps, TOLERANCE);
        self.coefficients = field;
    }

    /// Inflation of every sample's variance by what the field leaves of those about it.
    fn scatter(&self, samples: &[Sample], taps: &[Taps]) -> [Vec<f32>; 3] {
        std::array::from_fn(|c| {
            let values = values_at(self.nodes.layout, taps, &self.coefficients[c]);
            let left = |(sample, value): (&Sample, &Lane)| {
                square_left(sample, value, c) / (self.excess[c] * sample.variance_vox2[c])
            };
            let left: Vec<f32> = samples.iter().zip(&values).map(left).collect();
            inflation(&self.nodes, samples, &left)
        })
    }

    /// Takes the penalties anew from the field and its error.
    pub fn learn_roughness(&mut self) {
        let layout = self.nodes.layout;
        let learned: Vec<Stiffness> = (0..3usize)
            .into_par_iter()
            .map(|c| updated(layout, &self.stiffness[c], &self.coefficients[c]))
            .collect();
        for (stiffness, learned) in self.stiffness.iter_mut().zip(learned) {
            *stiffness = learned;
        }
    }

    /// What each sample is off the field that all but an eighth of the samples, it among them, make.
    pub fn left_out(&self, samples: &[Sample]) -> Vec<[f32; 3]> {
        let taps = self.taps(samples);
        let layout = self.nodes.layout;
        let (mut weights, mut targets): ([Vec<Lane>; 3], [Vec<Lane>; 3]) = Default::default();
        for c in 0..3 {
            let values = values_at(layout, &taps, &self.coefficients[c]);
            let of_sample = |(n, (sample, value)): (usize, (&Sample, &Lane))| {
                let variance = self.variance(samples, c, n);
                let mut weights = [weight(square_left(sample, value, c), variance); LANES];
                weights[n % LANES] = 0.0;
                (weights, [sample.displacement_vox[c]; LANES])
            };
            (weights[c], targets[c]) =
                samples.iter().zip(&values).enumerate().map(of_sample).unzip();
        }
        let equations = self.equations(&taps, weights);
        let mut field: Vectors = std::array::from_fn(|c| {
            self.coefficients[c].iter().map(|lanes| [lanes[0]; LANES]).collect()
        });
        let residual = equations.residual(&field, &Targets { samples: &targets, noise: None });
        let preconditioner = Preconditioner::new(&self.modes, &equations);
        improve(
            &equations,
            &preconditioner,
            residual,
            &mut field,
            LEFT_OUT_STEPS,
            TOLERANCE / 10.0,
        );
        let values: [Vec<Lane>; 3] = std::array::from_fn(|c| values_at(layout, &taps, &field[c]));
        let missed = |(n, sample): (usize, &Sample)| {
            std::array::from_fn(|c| sample.displacement_vox[c] - values[c][n][n % LANES])
        };
        samples.iter().enumerate().map(missed).collect()
    }

    /// The field as it is now, as uncertain as its draws say.
    pub fn field(&self) -> SplineField {
        SplineField::new(self.nodes, &self.coefficients)
    }

    /// The field as it is now, as uncertain as samples that were left out say, which `missed` it by so much.
    pub fn calibrated(&self, samples: &[Sample], missed: &[[f32; 3]]) -> SplineField {
        let field = self.field();
        let variance = |c: usize, n: usize| self.variance(samples, c, n);
        let widening = calibration::widening(&self.nodes, &field, samples, missed, variance);
        field.widened(&widening)
    }

    /// Variance of sample `n` in component `c`, in voxel².
    fn variance(&self, samples: &[Sample], c: usize, n: usize) -> f32 {
        self.excess[c] * self.inflation[c][n] * samples[n].variance_vox2[c]
    }

    fn taps(&self, samples: &[Sample]) -> Vec<Taps> {
        samples.par_iter().map(|sample| self.nodes.taps(sample.middle_vox)).collect()
    }

    fn equations<'a>(&'a self, taps: &'a [Taps], weights: [Vec<Lane>; 3]) -> Equations<'a> {
        let divergence = Divergence {
            step_vox: self.nodes.step_vox,
            stiffness: 1.0 / (DIVERGENCE * DIVERGENCE),
        };
        Equations {
            nodes: &self.nodes,
            taps,
            weights,
            stiffness: &self.stiffness,
            divergence: self.incompressible.then_some(divergence),
        }
    }
}

/// Square of what the field leaves of a sample, its own error's variance included, from the field's and the
/// draws' values there.
fn square_left(sample: &Sample, value: &Lane, c: usize) -> f32 {
    let [field, errors @ ..] = value;
    let left = sample.displacement_vox[c] - field;
    left * left + errors.iter().map(|e| e * e).sum::<f32>() / (LANES - 1) as f32
}

/// Weight of a sample under Student's distribution, from the square of what is left of it.
fn weight(square: f32, variance: f32) -> f32 {
    (DEGREES_OF_FREEDOM + 1.0) / (DEGREES_OF_FREEDOM * variance + square)
}
