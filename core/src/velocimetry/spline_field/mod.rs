//! The displacement field through single particles: cubic B-splines on nodes as fine as the particles
//! allow (Gesemann et al., From noisy particle tracks to velocity, acceleration and pressure fields using
//! B-splines and penalties, 18th Int. Symp. Lisbon, 2016).
//!
//! The field minimises a sum over the samples y with variance σ² at positions x, the third differences Δ³ of
//! the coefficients c, the divergence if the flow is incompressible, and, with a small weight, the deviation
//! from the coefficients b of the previous field:
//!
//! ```text
//! Σ ρ((y − B c)/σ)  +  Σ λ (Δ³c)²  +  Σ μ (∇·c)²  +  Σ κ (b − c)²
//! ```
//!
//! ρ is the negative logarithm of Student's distribution, minimised by reweighted least squares (`fit`). How
//! stiff the field is, λ, is chosen by cross-validation (`stiffness`). The posterior spread is sampled: the
//! same equations with random right-hand sides (`noise`) are solved together with the field (`lanes`).
//! Cross-validation residuals calibrate the spread (`calibration`).

mod calibration;
mod divergence;
mod equations;
mod field;
mod fit;
mod lanes;
mod modes;
mod noise;
mod nugget;
mod preconditioner;
mod scatter;
mod solve;
mod stiffness;

use super::{conjugate_gradients::Until, nodes::Nodes};
pub use field::SplineField;
use fit::Fit;
use stiffness::{Ladder, Search};

/// The displacement of a particle, or of anything else that is known at a place.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Sample {
    /// Its place in the middle of the pair, in voxels.
    pub middle_vox: [f32; 3],
    /// From frame a to frame b, in voxels.
    pub displacement_vox: [f32; 3],
    /// Variance of the displacement along x, y, z, in voxel²; greater than zero.
    pub variance_vox2: [f32; 3],
}

/// Where a field is fitted, in voxels.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Extent {
    /// Least and largest corner.
    pub corners_vox: [[f32; 3]; 2],
    /// Largest node spacing.
    pub coarsest_vox: f32,
}

/// Prior estimate of a field.
#[derive(Clone, Copy)]
pub struct Guess<'a> {
    /// The field.
    pub at: &'a dyn Fn([f32; 3]) -> [f32; 3],
    /// Its typical error, in voxels.
    pub error_vox: f32,
    /// Stiffness of an earlier fit to nearly the same samples, if there is one.
    pub stiffness: Option<[f32; 3]>,
}

/// Node spacing, in mean particle spacings.
const NODE_SPACING: f32 = 0.9;

/// Least node spacing, in voxels.
pub const FINEST_VOX: f32 = 2.0;

/// Largest third difference of neighbouring coefficients that is tried, in voxels.
const LARGEST_DIFFERENCE_VOX: f32 = 2.0;

/// Ratio of successive third differences in the search: at first, and after samples are weighted by their
/// estimated errors.
const RATIOS: [f32; 2] = [2.5, 1.7];

/// Additional standard deviation of samples in the first and second round, relative to the error of the
/// previous field.
const EXTRA_SIGMA: [f32; 2] = [0.5, 0.1];

/// Rounds in which samples are weighted by their estimated errors.
const ROUNDS: usize = 3;

/// The search of penalties. With 50 residuals the choice depends on chance (docs/decisions.md).
const TRYING: Search = Search { until: Until { steps: 60, tolerance: 1e-3 }, residuals: 500 };

/// Stopping criteria for the fit to samples, and cross-validation.
const FOLLOWING: Until = Until { steps: 25, tolerance: 3e-3 };
const LEAVING_OUT: Until = Until { steps: 60, tolerance: 1e-3 };

/// The same for an intermediate field.
const TRYING_QUICKLY: Search = Search { until: Until { steps: 12, tolerance: 1e-3 }, residuals: 1 };
const FOLLOWING_QUICKLY: Until = Until { steps: 10, tolerance: 3e-3 };

impl Extent {
    /// Nodes for this number of particles: about one per particle.
    fn nodes_for(&self, particles: usize) -> Nodes {
        let [low, high] = self.corners_vox;
        let volume: f32 = (0..3).map(|axis| (high[axis] - low[axis]).max(1.0)).product();
        let between = (volume / particles.max(1) as f32).cbrt();
        let step_vox = (NODE_SPACING * between).min(self.coarsest_vox).max(FINEST_VOX);
        Nodes::covering(low, high, step_vox)
    }
}

/// The field fitted to `samples`, and the cross-validation residual of each sample, in voxels. Samples outside
/// the extent are moved to its faces.
pub fn through(
    extent: &Extent,
    samples: &[Sample],
    guess: &Guess<'_>,
    incompressible: bool,
) -> (SplineField, Vec<[f32; 3]>) {
    let nodes = extent.nodes_for(samples.len());
    let order = order_of(&nodes, samples);
    let samples: Vec<Sample> = order.iter().map(|&n| samples[n]).collect();
    let mut fit = Fit::new(nodes, &samples, guess.at, incompressible);
    // The field's uncertainty is part of the samples' weights from the first round.
    follow(&mut fit, guess, TRYING, |fit| fit.improve(FOLLOWING));
    for round in 0..ROUNDS {
        fit.weigh(0.0);
        if round == 0 {
            fit.choose_stiffness(&Ladder::about(RATIOS[1]), 1, TRYING);
        }
        fit.improve(FOLLOWING);
    }
    let missed = fit.left_out(LEAVING_OUT);
    let mut in_order = vec![[0.0; 3]; missed.len()];
    order.into_iter().zip(&missed).for_each(|(n, missed)| in_order[n] = *missed);
    (fit.calibrated(&missed), in_order)
}

/// Indices of the samples, sorted by position so that neighbours are adjacent.
fn order_of(nodes: &Nodes, samples: &[Sample]) -> Vec<usize> {
    nodes.order(samples.iter().map(|sample| sample.middle_vox))
}

/// The field fitted to `samples` without use of their stated errors.
pub fn near(extent: &Extent, samples: &[Sample], guess: &Guess<'_>) -> SplineField {
    let nodes = extent.nodes_for(samples.len());
    let samples: Vec<Sample> = order_of(&nodes, samples).into_iter().map(|n| samples[n]).collect();
    let mut fit = Fit::new(nodes, &samples, guess.at, false);
    follow(&mut fit, guess, TRYING_QUICKLY, |fit| fit.approach(FOLLOWING_QUICKLY));
    fit.field()
}

/// Moves the field from a guess towards the samples, with decreasing additional standard deviation.
fn follow(fit: &mut Fit<'_>, guess: &Guess<'_>, trying: Search, towards: impl Fn(&mut Fit<'_>)) {
    fit.weigh(EXTRA_SIGMA[0] * guess.error_vox);
    match guess.stiffness {
        Some(stiffness) => fit.stiffness = stiffness,
        None => {
            let ladder = Ladder::expecting(LARGEST_DIFFERENCE_VOX, RATIOS[0]);
            fit.choose_stiffness(&ladder, 0, trying);
        }
    }
    towards(fit);
    fit.weigh(EXTRA_SIGMA[1] * guess.error_vox);
    towards(fit);
}

#[cfg(test)]
mod tests;
