//! The displacement field through single particles: cubic B-splines on nodes as fine as the particles
//! allow (Gesemann et al., From noisy particle tracks to velocity, acceleration and pressure fields using
//! B-splines and penalties, 18th Int. Symp. Lisbon, 2016).
//!
//! Samples y with variance σ² at places x, third differences Δ³ of the coefficients c and, where the flow is
//! incompressible, its divergence make the field that minimises
//!
//! ```text
//! Σ ρ((y − B c)/σ)  +  Σ λ (Δ³c)²  +  Σ μ (∇·c)²
//! ```
//!
//! ρ is the negative logarithm of Student's distribution, minimised by reweighted least squares (`fit`). How
//! rough the field may be, λ, is estimated about each place from the field and what is left open of it
//! (`roughness`), never from the field alone. What is left open is known by draws: the same equations with
//! random right-hand sides (`noise`), solved beside the field itself (`lanes`). What samples that were left
//! out are missed by says how far the draws can be trusted (`calibration`).

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
mod roughness;
mod scatter;
mod solve;

pub use field::SplineField;
use fit::{Fit, Round};
use nodes::Nodes;

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

/// Slack of the rounds, in voxels, down from what a first field may miss.
const SLACK_VOX: [f32; 10] = [1.0, 0.5, 0.3, 0.15, 0.07, 0.03, 0.0, 0.0, 0.0, 0.0];

/// Rounds begin with no more slack than so many times the first field's error.
const FIRST_SLACK: f32 = 4.0;

/// Slack below which particles that are far off are taken for wrong.
const ROBUST_BELOW_VOX: f32 = 0.05;

/// Steps of conjugate gradients in a round.
const STEPS: usize = 12;

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
    let mut fit = Fit::new(nodes, start, incompressible);
    let slacks = SLACK_VOX.into_iter().filter(|slack| *slack <= FIRST_SLACK * error_vox);
    for (n, slack_vox) in slacks.enumerate() {
        if n > 0 {
            fit.learn_roughness();
        }
        let robust = slack_vox < ROBUST_BELOW_VOX;
        fit.adjust(samples, Round { slack_vox, robust, steps: STEPS });
    }
    let missed = fit.left_out(samples);
    (fit.calibrated(samples, &missed), missed)
}

#[cfg(test)]
mod tests;
