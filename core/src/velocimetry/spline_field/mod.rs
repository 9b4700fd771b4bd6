//! The displacement field through single particles: cubic B-splines on nodes as fine as the particles
//! allow (Gesemann et al., From noisy particle tracks to velocity, acceleration and pressure fields using
//! B-splines and penalties, 18th Int. Symp. Lisbon, 2016).
//!
//! Samples y with variance σ² at places x, third differences Δ³ of the coefficients c, where the flow is
//! incompressible its divergence, and, loosely, the coefficients b of the field before make the field that
//! minimises
//!
//! ```text
//! Σ ρ((y − B c)/σ)  +  Σ λ (Δ³c)²  +  Σ μ (∇·c)²  +  Σ κ (b − c)²
//! ```
//!
//! ρ is the negative logarithm of Student's distribution, minimised by reweighted least squares (`fit`). How
//! stiff the field is, λ, is chosen by how well samples that are left out are predicted (`stiffness`). What is
//! left open is known by draws: the same equations with random right-hand sides (`noise`), solved beside the
//! field itself (`lanes`). What left-out samples are missed by says how far the draws can be trusted
//! (`calibration`).

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
use stiffness::Ladder;

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
    /// Nodes are no further apart.
    pub coarsest_vox: f32,
}

/// What is known of a field before it is fitted.
#[derive(Clone, Copy)]
pub struct Guess<'a> {
    /// The field.
    pub at: &'a dyn Fn([f32; 3]) -> [f32; 3],
    /// What it errs by, in voxels.
    pub error_vox: f32,
    /// That of a field through about the same samples, where one was fitted.
    pub stiffness: Option<[f32; 3]>,
}

/// Distance of the nodes over that of the particles.
const NODES_PER_PARTICLE: f32 = 0.9;

/// Finest nodes, in voxels.
pub const FINEST_VOX: f32 = 2.0;

/// Largest third difference of neighbouring coefficients that is tried, in voxels.
const LARGEST_DIFFERENCE_VOX: f32 = 2.0;

/// From one third difference that is tried to the next: at first, and once samples are weighted by their real errors.
const RATIOS: [f32; 2] = [2.5, 1.7];

/// Slack of samples at first, over what the field before errs by, and in the second round.
const SLACK: [f32; 2] = [0.5, 0.1];

/// Rounds in which samples are weighted by their real errors.
const ROUNDS: usize = 3;

/// To try penalties, to follow samples, and to solve without the samples that are left out.
const TRYING: Until = Until { steps: 60, tolerance: 1e-3 };
const FOLLOWING: Until = Until { steps: 25, tolerance: 3e-3 };
const LEAVING_OUT: Until = Until { steps: 60, tolerance: 1e-3 };

/// The same for a field that is not the last.
const TRYING_QUICKLY: Until = Until { steps: 12, tolerance: 1e-3 };
const FOLLOWING_QUICKLY: Until = Until { steps: 10, tolerance: 3e-3 };

impl Extent {
    /// Nodes for so many particles: about one for each.
    fn nodes_for(&self, particles: usize) -> Nodes {
        let [low, high] = self.corners_vox;
        let volume: f32 = (0..3).map(|axis| (high[axis] - low[axis]).max(1.0)).product();
        let between = (volume / particles.max(1) as f32).cbrt();
        let step_vox = (NODES_PER_PARTICLE * between).min(self.coarsest_vox).max(FINEST_VOX);
        Nodes::covering(low, high, step_vox)
    }
}

/// The field through `samples`, and what it leaves of each sample when that is left out, in voxels. Samples
/// outside the extent count as if they were on its faces.
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
    // How uncertain the field is counts in the samples' weights from the first.
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

/// Numbers of the samples, those near to each other one after the other.
fn order_of(nodes: &Nodes, samples: &[Sample]) -> Vec<usize> {
    nodes.order(samples.iter().map(|sample| sample.middle_vox))
}

/// The field near `samples`, whose stated errors are not relied on.
pub fn near(extent: &Extent, samples: &[Sample], guess: &Guess<'_>) -> SplineField {
    let nodes = extent.nodes_for(samples.len());
    let samples: Vec<Sample> = order_of(&nodes, samples).into_iter().map(|n| samples[n]).collect();
    let mut fit = Fit::new(nodes, &samples, guess.at, false);
    follow(&mut fit, guess, TRYING_QUICKLY, |fit| fit.approach(FOLLOWING_QUICKLY));
    fit.field()
}

/// Moves the field from a guess towards samples, with less and less slack.
fn follow(fit: &mut Fit<'_>, guess: &Guess<'_>, trying: Until, towards: impl Fn(&mut Fit<'_>)) {
    fit.weigh(SLACK[0] * guess.error_vox);
    match guess.stiffness {
        Some(stiffness) => fit.stiffness = stiffness,
        None => {
            let ladder = Ladder::expecting(LARGEST_DIFFERENCE_VOX, RATIOS[0]);
            fit.choose_stiffness(&ladder, 0, trying);
        }
    }
    towards(fit);
    fit.weigh(SLACK[1] * guess.error_vox);
    towards(fit);
}

#[cfg(test)]
mod tests;
