//! The likeliest field behind displacements of single particles, and what they leave open.

use rayon::prelude::*;

use super::{
    super::conjugate_gradients::Until,
    Sample, calibration,
    divergence::Divergence,
    equations::{Equations, Targets, values_at},
    field::SplineField,
    lanes::{LANES, Lane, Vectors, zeros},
    nodes::{Nodes, Taps},
    noise::Noise,
    nugget,
    preconditioner::{Modes, Preconditioner},
    scatter::inflation,
    solve::improve,
    stiffness::Ladder,
};
use crate::statistics::{NORMAL_OF_MEDIAN, median};

/// Degrees of freedom of Student's distribution, which particles' errors are taken to have: one that was
/// taken for another is wrong by more than a normal distribution allows (Lange, Little and Taylor, J. Am.
/// Stat. Assoc. 84, 1989).
const DEGREES_OF_FREEDOM: f32 = 3.0;

/// Divergence that an incompressible flow may show, in voxel per voxel: the displacement over a pair is that of
/// a curved path.
const DIVERGENCE: f32 = 0.01;

/// What it may show beside that while samples have slack, per voxel of slack: were it held to zero at once,
/// conjugate gradients would follow samples too slowly.
const DIVERGENCE_OF_SLACK: f32 = 0.1;

/// Standard deviation of a coefficient about that of the field before, in voxels. Samples say far more wherever
/// there are any; without it the equations leave fields open that are quadratic along every axis.
const ANCHOR_VOX: f32 = 3.0;

/// Standard deviation that is added to every sample's own, over the typical error of the field at left-out samples.
/// Samples that are known far better than the field between them do not improve it, but weights that differ by a
/// hundred thousand make conjugate gradients slow (docs/decisions.md).
const ADDED_DEVIATION: f32 = 0.2;

/// A field that is being fitted to samples.
pub struct Fit<'a> {
    nodes: Nodes,
    modes: Modes,
    samples: &'a [Sample],
    taps: Vec<Taps>,
    /// Lane 0 is the field, the others are draws from its error.
    coefficients: Vectors,
    /// Per component: coefficients of the field that the fit began with.
    before: [Vec<f32>; 3],
    /// Per component and sample: inverse variance, less for one that is far off the field.
    weights: [Vec<f32>; 3],
    /// Penalty of third differences, per component.
    pub stiffness: [f32; 3],
    /// Variance of the samples over what they state, per component.
    excess: [f32; 3],
    /// Factor on the variance of each sample beside that, per component.
    inflation: [Vec<f32>; 3],
    /// Standard deviation that every sample is given beside its own, in voxels.
    slack_vox: f32,
    /// Typical error of the field at left-out samples, in voxels, per component; 0 before that is known.
    missed_vox: [f32; 3],
    incompressible: bool,
}

impl<'a> Fit<'a> {
    /// Begins with the field `start` on `nodes`.
    pub fn new(
        nodes: Nodes,
        samples: &'a [Sample],
        start: impl Fn([f32; 3]) -> [f32; 3],
        incompressible: bool,
    ) -> Self {
        let (layout, count) = (nodes.layout, nodes.layout.len());
        let mut coefficients = zeros(count);
        for n in 0..count {
            let value = start(nodes.place_vox(n));
            for (lanes, value) in coefficients.iter_mut().zip(value) {
                lanes[n][0] = value;
            }
        }
        let before =
            std::array::from_fn(|c| coefficients[c].iter().map(|lanes| lanes[0]).collect());
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
            slack_vox: 0.0,
            missed_vox: [0.0; 3],
            incompressible,
        }
    }

    /// Weighs samples by what the field leaves of them. Without slack, what their errors really are is asked
    /// of those that are close together, and of those that the field misses.
    pub fn weigh(&mut self, slack_vox: f32) {
        self.slack_vox = slack_vox;
        if slack_vox == 0.0 {
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

    /// Chooses the stiffness by which the samples that are left out, one in eight from number `first` on, are
    /// predicted best.
    pub fn choose_stiffness(&mut self, ladder: &Ladder, first: usize, until: Until) {
        let is_left_out = |n: usize| n % LANES == first;
        let weights =
            self.lanes_of_weights(
                |n, weight| {
                    if is_left_out(n) { [0.0; LANES] } else { [weight; LANES] }
                },
            );
        let mut equations = self.equations(weights);
        equations.factors = ladder.factors();
        let mut field: Vectors =
            std::array::from_fn(|c| self.before[c].iter().map(|&b| [b; LANES]).collect());
        self.solve(&equations, self.values_of_samples(), &mut field, until);
        for (c, field) in field.iter().enumerate() {
            let values = self.values(field);
            let mut scores = [0.0f64; LANES];
            let mut missed: [Vec<f64>; LANES] = Default::default();
            for n in (first..self.samples.len()).step_by(LANES) {
                let variance = f64::from(DEGREES_OF_FREEDOM * self.variance(c, n));
                for l in 0..LANES {
                    let left = f64::from(self.samples[n].displacement_vox[c] - values[n][l]);
                    // Minus the logarithm of Student's density.
                    scores[l] += (left * left / variance).ln_1p();
                    missed[l].push(left.abs());
                }
            }
            let (factor, rung) = ladder.best(&scores);
            self.stiffness[c] *= factor;
            let typical = median(std::mem::take(&mut missed[rung])).unwrap_or_default();
            self.missed_vox[c] = (NORMAL_OF_MEDIAN * typical) as f32;
        }
    }

    /// Moves the field towards the samples, and draws from its error.
    pub fn improve(&mut self, until: Until) {
        let weights = self.lanes_of_weights(|_, weight| [weight; LANES]);
        let equations = self.equations(weights);
        let targets = std::array::from_fn(|c| {
            let target = |(n, (sample, weight)): (usize, (&Sample, &f32))| {
                let mut target = Noise.of_sample(c, n).map(|sign| sign / weight.sqrt());
                target[0] = sample.displacement_vox[c];
                target
            };
            self.samples.iter().zip(&self.weights[c]).enumerate().map(target).collect()
        });
        let targets = Targets { samples: &targets, before: &self.before, noise: Some(&Noise) };
        let mut field = self.coefficients.clone();
        let residual = equations.residual(&field, &targets);
        let preconditioner = Preconditioner::new(&self.modes, &equations);
        improve(&equations, &preconditioner, residual, &mut field, until);
        self.coefficients = field;
    }

    /// What each sample is off the field that all but an eighth of the samples, it among them, make.
    pub fn left_out(&self, until: Until) -> Vec<[f32; 3]> {
        let weights = self.lanes_of_weights(|n, weight| {
            let mut weights = [weight; LANES];
            weights[n % LANES] = 0.0;
            weights
        });
        let mut field: Vectors = std::array::from_fn(|c| {
            self.coefficients[c].iter().map(|lanes| [lanes[0]; LANES]).collect()
        });
        self.solve(&self.equations(weights), self.values_of_samples(), &mut field, until);
        let values: [Vec<Lane>; 3] = std::array::from_fn(|c| self.values(&field[c]));
        let missed = |(n, sample): (usize, &Sample)| {
            std::array::from_fn(|c| sample.displacement_vox[c] - values[c][n][n % LANES])
        };
        self.samples.iter().enumerate().map(missed).collect()
    }

    /// The field as it is now, as uncertain as its draws say.
    pub fn field(&self) -> SplineField {
        SplineField::new(self.nodes, &self.coefficients, self.stiffness)
    }

    /// The field as it is now, as uncertain as samples that were left out say, which `missed` it by so much.
    pub fn calibrated(&self, missed: &[[f32; 3]]) -> SplineField {
        let field = self.field();
        let variance = |c: usize, n: usize| self.variance(c, n);
        let widening = calibration::widening(&self.nodes, &field, self.samples, missed, variance);
        field.widened(&widening)
    }

    /// Inflation of every sample's variance by what the field leaves of those about it.
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

    /// Solves for the fields of all lanes, none of which is a draw.
    fn solve(
        &self,
        equations: &Equations,
        samples: [Vec<Lane>; 3],
        field: &mut Vectors,
        until: Until,
    ) {
        let targets = Targets { samples: &samples, before: &self.before, noise: None };
        let residual = equations.residual(field, &targets);
        let preconditioner = Preconditioner::new(&self.modes, equations);
        improve(equations, &preconditioner, residual, field, until);
    }

    fn values(&self, field: &[Lane]) -> Vec<Lane> {
        values_at(self.nodes.layout, &self.taps, field)
    }

    fn values_of_samples(&self) -> [Vec<Lane>; 3] {
        let of = |c: usize| self.samples.iter().map(|s| [s.displacement_vox[c]; LANES]).collect();
        [of(0), of(1), of(2)]
    }

    fn lanes_of_weights(&self, lanes: impl Fn(usize, f32) -> Lane) -> [Vec<Lane>; 3] {
        let of = |weights: &Vec<f32>| {
            weights.iter().enumerate().map(|(n, &weight)| lanes(n, weight)).collect()
        };
        self.weights.each_ref().map(of)
    }

    /// Variance of sample `n` in component `c`, in voxel².
    fn variance(&self, c: usize, n: usize) -> f32 {
        let own = self.excess[c] * self.inflation[c][n] * self.samples[n].variance_vox2[c];
        let added = ADDED_DEVIATION * self.missed_vox[c];
        own + self.slack_vox * self.slack_vox + added * added
    }

    fn equations(&self, weights: [Vec<Lane>; 3]) -> Equations<'_> {
        let divergence = DIVERGENCE.hypot(DIVERGENCE_OF_SLACK * self.slack_vox);
        let divergence = Divergence {
            step_vox: self.nodes.step_vox,
            stiffness: 1.0 / (divergence * divergence),
        };
        Equations {
            nodes: &self.nodes,
            taps: &self.taps,
            weights,
            stiffness: self.stiffness,
            factors: [1.0; LANES],
            divergence: self.incompressible.then_some(divergence),
            anchor: 1.0 / (ANCHOR_VOX * ANCHOR_VOX),
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
