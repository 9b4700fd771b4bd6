//! Several starts for one particle: where its image fits best with all others as they are.
//!
//! Near a camera's focal plane the image of a particle is flat: all views show the same microlens, and
//! no gradient of this camera moves a misplaced particle along what the other camera sees as
//! depth. The residual still tells which of several starting positions is better.

use super::{
    fit::FrameFit,
    normal::{CAMERAS, LightPrior, Particle, StepRule},
};
use crate::model::{PointCamera, PointFootprint};

/// Steps from a start.
const STEPS: usize = 4;

/// Starts that are followed.
const FOLLOWED: usize = 2;

/// A start has converged when a step is shorter than this, in mm.
const CONVERGED_MM: f64 = 1e-4;

/// Weight of a mismatch between the cameras' lights when places are compared.
const LIGHT_MISMATCH_WEIGHT: f64 = 0.02;

/// How much of the residual a particle at a place would explain.
#[derive(Debug, Clone, Copy)]
struct Gain {
    particle: Particle,
    /// Decrease of the weighted sum of squared residuals, reduced where the cameras' lights do not match.
    value: f64,
}

impl FrameFit {
    /// Moves a particle to where it explains most of the residual. `starts` and its own position are tried,
    /// and the best of them are followed by a few steps.
    pub fn restart(
        &mut self,
        cameras: &[PointCamera],
        n: usize,
        starts: &[[f64; 3]],
        (prior, rule): (&LightPrior, &StepRule),
        footprint: &mut PointFootprint,
    ) {
        let own = self.particles[n];
        self.put(cameras, &own, -1.0, footprint);
        let mut tried: Vec<Gain> = starts
            .iter()
            .chain([&own.at_mm])
            .map(|&at_mm| self.gain(cameras, at_mm, prior, footprint))
            .collect();
        let stays = Gain { particle: own, ..tried[tried.len() - 1] };
        tried.sort_by(|a, b| b.value.total_cmp(&a.value));
        let followed: Vec<Gain> = tried
            .iter()
            .take(FOLLOWED)
            .map(|start| {
                let mut particle = start.particle;
                for _ in 0..STEPS {
                    let normal = self.equations_of_new(cameras, &particle, footprint);
                    let (moved, step_mm) = normal.stepped(&particle, cameras.len(), prior, rule);
                    particle = moved;
                    if step_mm < CONVERGED_MM {
                        break;
                    }
                }
                self.gain(cameras, particle.at_mm, prior, footprint)
            })
            .collect();
        let best = followed.iter().fold(
            stays,
            |best, gain| {
                if gain.value > best.value { *gain } else { best }
            },
        );
        self.particles[n] = best.particle;
        self.put(cameras, &best.particle, 1.0, footprint);
    }

    /// Takes a particle out of the model (`sign` −1) or puts it in.
    fn put(
        &mut self,
        cameras: &[PointCamera],
        particle: &Particle,
        sign: f64,
        footprint: &mut PointFootprint,
    ) {
        for (c, camera) in cameras.iter().enumerate() {
            camera.image(particle.at_mm, footprint);
            self.images[c].add(camera, footprint, (sign * particle.light[c]) as f32);
        }
    }

    /// The lights that the residual has for a new particle at a place, and what that explains of it.
    pub fn light_at(
        &self,
        cameras: &[PointCamera],
        at_mm: [f64; 3],
        footprint: &mut PointFootprint,
    ) -> (Particle, f64) {
        let mut particle = Particle { at_mm, light: [0.0; CAMERAS] };
        let mut value = 0.0;
        for (c, camera) in cameras.iter().enumerate() {
            camera.image(at_mm, footprint);
            let [pull, weight] = self.images[c].light_equation(camera, footprint);
            particle.light[c] = (pull / weight.max(1e-12)).max(0.0);
            value += particle.light[c] * pull;
        }
        (particle, value)
    }

    /// What a new particle at a place explains of the residual.
    fn gain(
        &self,
        cameras: &[PointCamera],
        at_mm: [f64; 3],
        prior: &LightPrior,
        footprint: &mut PointFootprint,
    ) -> Gain {
        let (particle, mut value) = self.light_at(cameras, at_mm, footprint);
        if cameras.len() == CAMERAS {
            let [a, b] = prior.relative(&particle);
            let apart = 2.0 * (a - b) / (prior.spread * (a + b).max(0.1));
            value /= 1.0 + LIGHT_MISMATCH_WEIGHT * apart * apart;
        }
        Gain { particle, value }
    }
}
