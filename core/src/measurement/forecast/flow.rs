//! The flow of a trial: as smooth as windows can follow, and rough enough that particles which lie over each other in
//! one frame do so elsewhere in the other.
//!
//! Where a whole line of sight moves alike, particles hide each other alike in both frames, are misplaced alike, and
//! the displacement does not notice. A flow that is to be measured is not like that, so it has to be in the forecast.

use std::f64::consts::TAU;

use nalgebra::{UnitVector3, Vector3};
use rand::{Rng, RngExt};
use rand_distr::{Distribution, UnitSphere};

/// Waves of a flow: enough for a component to be distributed nearly normally over places.
const WAVES: usize = 6;

/// Length of the waves, in windows: vectors of true particles follow such waves to a thousandth of a voxel.
const WINDOWS_PER_WAVE: f64 = 6.0;

/// Least length of the waves, in largest displacements: a derivative of the displacement then has a standard
/// deviation of 0.13 at most, which correlation can follow.
const DISPLACEMENTS_PER_WAVE: f64 = 16.0;

/// Standard deviation of a component over its largest value: three of them are hardly ever passed.
const DEVIATION: f64 = 1.0 / 3.0;

/// Steps of the path from the middle of a pair to a frame.
const STEPS: usize = 2;

/// A transverse plane wave.
struct Wave {
    /// 2π over its length, per mm, along its direction.
    number: Vector3<f64>,
    /// Largest displacement, in mm per pair; across the direction.
    amplitude_mm: Vector3<f64>,
    phase: f64,
}

/// A steady flow free of divergence: a sum of transverse plane waves.
pub(super) struct WavyFlow(Vec<Wave>);

impl WavyFlow {
    /// Waves in all directions, for windows of edge `window_mm` and displacements up to `largest_mm` per component.
    pub fn random(window_mm: f64, largest_mm: f64, random: &mut impl Rng) -> Self {
        let length_mm = (WINDOWS_PER_WAVE * window_mm).max(DISPLACEMENTS_PER_WAVE * largest_mm);
        let number = TAU / length_mm;
        // N waves of amplitude A across random directions: a component has the variance N A²/6.
        let amplitude_mm = DEVIATION * largest_mm * (6.0 / WAVES as f64).sqrt();
        let wave = |_| {
            let [along, other] = [direction(random), direction(random)];
            let across = UnitVector3::new_normalize(along.cross(&other));
            Wave {
                number: along * number,
                amplitude_mm: across.into_inner() * amplitude_mm,
                phase: TAU * random.random::<f64>(),
            }
        };
        Self((0..WAVES).map(wave).collect())
    }

    /// Where what is at `middle_mm` in the middle of the pair is in frames a and b: classical Runge-Kutta.
    pub fn in_frames(&self, middle_mm: Vector3<f64>) -> [Vector3<f64>; 2] {
        [-0.5, 0.5].map(|share| {
            let step = share / STEPS as f64;
            (0..STEPS).fold(middle_mm, |at, _| {
                let first = self.velocity(at);
                let second = self.velocity(at + first * (step / 2.0));
                let third = self.velocity(at + second * (step / 2.0));
                let fourth = self.velocity(at + third * step);
                at + (first + (second + third) * 2.0 + fourth) * (step / 6.0)
            })
        })
    }

    /// In mm per pair.
    fn velocity(&self, at_mm: Vector3<f64>) -> Vector3<f64> {
        let of = |wave: &Wave| wave.amplitude_mm * (wave.number.dot(&at_mm) + wave.phase).cos();
        self.0.iter().map(of).sum()
    }
}

/// A direction that is as likely as any other.
fn direction(random: &mut impl Rng) -> Vector3<f64> {
    let direction: [f64; 3] = UnitSphere.sample(random);
    direction.into()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::measurement::forecast::generator;

    #[test]
    fn components_have_the_deviation_and_no_divergence() {
        let mut random = generator(3);
        let (mut square, mut divergence, mut slope) = (0.0, 0.0f64, 0.0f64);
        let (flows, step) = (400, 1e-4);
        for _ in 0..flows {
            let flow = WavyFlow::random(1.6, 0.6, &mut random);
            let at = direction(&mut random) * 3.0;
            square += flow.velocity(at).norm_squared() / 3.0;
            let along = |axis: usize| {
                let mut beside = at;
                beside[axis] += step;
                (flow.velocity(beside) - flow.velocity(at))[axis] / step
            };
            divergence = divergence.max((along(0) + along(1) + along(2)).abs());
            slope = slope.max(along(0).abs());
        }
        let deviation_mm = (square / f64::from(flows)).sqrt();
        assert!((deviation_mm / 0.2 - 1.0).abs() < 0.1, "{deviation_mm}");
        assert!(divergence < 1e-3 && slope > 0.1, "{divergence} {slope}");
    }

    #[test]
    fn the_middle_of_a_path_is_between_its_ends() {
        let flow = WavyFlow::random(1.6, 0.6, &mut generator(4));
        let middle_mm = Vector3::new(0.3, -1.2, 2.0);
        let [a_mm, b_mm] = flow.in_frames(middle_mm);
        assert!(((b_mm - a_mm) - flow.velocity(middle_mm)).norm() < 0.02);
        assert!(((a_mm + b_mm) / 2.0 - middle_mm).norm() < 0.03);
    }
}
