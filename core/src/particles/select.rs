//! Convergence, removal and merging of a frame's particles, and the prior of their light.

use super::{
    fit::FrameFit,
    neighbours::Neighbours,
    normal::{CAMERAS, LightPrior, Particle, StepRule},
};
use crate::{
    model::PointCamera,
    statistics::{NORMAL_OF_MEDIAN, median, weighted_median},
};

/// A candidate position of a particle.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Candidate {
    /// In mm.
    pub at_mm: [f64; 3],
    /// Its light, in counts if all of it reached one open pixel.
    pub light: f64,
}

/// Assumed relative spread of a particle's light between cameras before the first fit.
const SPREAD_BEFORE: f64 = 0.5;

/// Bounds of the estimated spread.
const SPREADS: [f64; 2] = [0.05, 1.0];

impl LightPrior {
    /// The prior before the first fit. Faint candidates are many and mostly false, so each counts by its light.
    pub fn of_candidates(candidates: &[Candidate]) -> Self {
        let lights = candidates.iter().map(|candidate| (candidate.light, candidate.light));
        let typical = weighted_median(lights.collect()).filter(|&light| light > 0.0);
        Self { typical: [typical.unwrap_or(1.0); CAMERAS], spread: SPREAD_BEFORE }
    }

    /// The prior from paired particles; unchanged without any.
    pub fn of_particles(self, particles: &[Particle], cameras: usize) -> Self {
        let mut prior = self;
        for camera in 0..cameras {
            let lights = particles.iter().map(|particle| particle.light[camera]);
            if let Some(typical) = median(lights).filter(|&light| light > 0.0) {
                prior.typical[camera] = typical;
            }
        }
        if cameras == CAMERAS {
            let apart = |particle: &Particle| {
                let [a, b] = prior.relative(particle);
                2.0 * (a - b).abs() / (a + b).max(0.1)
            };
            let spread = median(particles.iter().map(apart)).map(|m| NORMAL_OF_MEDIAN * m);
            prior.spread = spread.unwrap_or(self.spread).clamp(SPREADS[0], SPREADS[1]);
        }
        prior
    }

    /// A particle's lights relative to the typical ones.
    pub fn relative(&self, particle: &Particle) -> [f64; CAMERAS] {
        std::array::from_fn(|camera| particle.light[camera] / self.typical[camera])
    }

    /// Mean over the cameras of a particle's light over the typical one.
    pub fn mean_relative(&self, particle: &Particle, cameras: usize) -> f64 {
        self.relative(particle)[..cameras].iter().sum::<f64>() / cameras as f64
    }
}

impl FrameFit {
    /// Adds the candidates; the model does not hold them before [`Self::render`].
    pub fn propose(&mut self, candidates: &[Candidate]) {
        let particle = |c: &Candidate| Particle { at_mm: c.at_mm, light: [c.light; CAMERAS] };
        self.extend(candidates.iter().map(particle));
    }

    /// Steps the particles that have not converged: their last step was longer than `converged_mm`.
    pub fn iterate(
        &mut self,
        cameras: &[PointCamera],
        prior: &LightPrior,
        rule: &StepRule,
        (converged_mm, rounds): (f64, usize),
    ) {
        for _ in 0..rounds {
            let of: Vec<usize> =
                (0..self.particles.len()).filter(|&n| self.steps_mm[n] > converged_mm).collect();
            if of.is_empty() {
                break;
            }
            self.step(cameras, &of, prior, rule);
        }
    }

    /// Reactivates all particles, including converged ones.
    pub fn reactivate(&mut self) {
        self.steps_mm.fill(f64::INFINITY);
    }

    /// Removes particles with less than `least_light` of the typical light, and merges those within `one_mm`.
    pub fn prune(
        &mut self,
        cameras: &[PointCamera],
        prior: &LightPrior,
        (least_light, one_mm): (f64, f64),
    ) {
        let count = self.particles.len();
        let lights: Vec<f64> =
            self.particles.iter().map(|p| prior.mean_relative(p, cameras.len())).collect();
        let places: Vec<[f32; 3]> =
            self.particles.iter().map(|p| p.at_mm.map(|mm| mm as f32)).collect();
        let near = Neighbours::new(&places, one_mm as f32);
        let mut brightest_first: Vec<usize> = (0..count).collect();
        brightest_first.sort_by(|&a, &b| lights[b].total_cmp(&lights[a]));
        let mut gone = vec![false; count];
        for &n in &brightest_first {
            if gone[n] {
                continue;
            }
            let mut others = Vec::new();
            near.visit(places[n], |other, _| {
                if other != n && !gone[other] && lights[other] <= lights[n] {
                    others.push(other);
                }
            });
            others.sort_unstable();
            for other in others {
                gone[other] = true;
                self.merge(n, other, lights[other] / (lights[n] + lights[other]).max(1e-9));
            }
            gone[n] = lights[n] < least_light;
        }
        self.remove(&gone);
        if self.particles.len() < count {
            self.render(cameras);
        }
    }

    /// Adds the light of particle `other`, a share of both's, to particle `n`.
    fn merge(&mut self, n: usize, other: usize, share: f64) {
        let two = self.particles[other];
        let one = &mut self.particles[n];
        for axis in 0..3 {
            one.at_mm[axis] += share * (two.at_mm[axis] - one.at_mm[axis]);
        }
        for camera in 0..CAMERAS {
            one.light[camera] += two.light[camera];
        }
        self.steps_mm[n] = f64::INFINITY;
    }
}
