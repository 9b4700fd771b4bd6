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
mod nodes;
mod noise;
mod nugget;
mod preconditioner;
mod scatter;
mod solve;
mod stiffness;

use super::conjugate_gradients::Until;
pub use field::SplineField;
use fit::Fit;
use nodes::Nodes;
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

/// Distance of the nodes over that of the particles.
const NODES_PER_PARTICLE: f32 = 0.9;

/// Finest and coarsest nodes, in voxels.
const STEPS_VOX: [f32; 2] = [2.0, 12.0];

/// Largest third difference of neighbouring coefficients that is tried, in voxels.
const LARGEST_DIFFERENCE_VOX: f32 = 1.0;

/// From one third difference that is tried to the next: at first, and once samples are weighted by their real errors.
const RATIOS: [f32; 2] = [2.5, 1.5];

/// Slack of samples at first, over what the field before errs by, and in the second round.
const SLACK: [f32; 2] = [0.5, 0.1];

/// Rounds in which samples are weighted by their real errors.
const ROUNDS: usize = 3;

/// To try penalties, to follow samples, and to solve without the samples that are left out.
const TRYING: Until = Until { steps: 40, tolerance: 1e-3 };
const FOLLOWING: Until = Until { steps: 30, tolerance: 3e-3 };
const LEAVING_OUT: Until = Until { steps: 60, tolerance: 2e-3 };

/// Nodes over a box from `low_vox` to `high_vox` that holds so many particles: about one for each.
fn nodes_for(low_vox: [f32; 3], high_vox: [f32; 3], particles: usize) -> Nodes {
    let volume: f32 = (0..3).map(|axis| (high_vox[axis] - low_vox[axis]).max(1.0)).product();
    let between = (volume / particles.max(1) as f32).cbrt();
    let step_vox = (NODES_PER_PARTICLE * between).clamp(STEPS_VOX[0], STEPS_VOX[1]);
    Nodes::covering(low_vox, high_vox, step_vox)
}

/// The field through `samples` in a box from its least to its largest corner, near the field `start`, which errs
/// by some `error_vox`, and what it leaves of each sample when that is left out, in voxels. Samples outside the
/// box count as if they were on its faces.
pub fn through(
    [low_vox, high_vox]: [[f32; 3]; 2],
    samples: &[Sample],
    start: impl Fn([f32; 3]) -> [f32; 3],
    error_vox: f32,
    incompressible: bool,
) -> (SplineField, Vec<[f32; 3]>) {
    let nodes = nodes_for(low_vox, high_vox, samples.len());
    let mut fit = Fit::new(nodes, samples, start, incompressible);
    fit.weigh(SLACK[0] * error_vox);
    fit.choose_stiffness(&Ladder::expecting(LARGEST_DIFFERENCE_VOX, RATIOS[0]), 0, TRYING);
    fit.improve(FOLLOWING);
    fit.weigh(SLACK[1] * error_vox);
    fit.improve(FOLLOWING);
    for round in 0..ROUNDS {
        fit.weigh(0.0);
        if round == 0 {
            fit.choose_stiffness(&Ladder::about(RATIOS[1]), 1, TRYING);
        }
        fit.improve(FOLLOWING);
    }
    let missed = fit.left_out(LEAVING_OUT);
    (fit.calibrated(&missed), missed)
}

#[cfg(test)]
mod tests;
