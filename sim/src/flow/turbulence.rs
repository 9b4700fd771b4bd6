//! Synthetic turbulence: many random solenoidal waves between two wavelengths.

use std::f64::consts::{PI, TAU};

use garde::Validate;
use lfpiv_hw::check::finite;
use rand::{Rng, RngExt};
use serde::{Deserialize, Serialize};

use super::drawn::DrawnWaves;
use crate::stream::{Purpose, random_stream};

/// Number of waves: enough to have no preferred direction, few enough to advect particles quickly.
const WAVES: usize = 96;

/// Random solenoidal Fourier modes with Kolmogorov's spectrum between two wavelengths (Kraichnan, Phys.
/// Fluids 13, 1970):
///
/// u(x) = Σ a e cos(k·x + φ), e ⟂ k, with directions of k and e and phases φ drawn at random.
///
/// Wave numbers k are spaced evenly in log k, so E(k) ∝ k^(−5/3) requires a² ∝ k^(−2/3). Equal
/// settings give equal fields.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, Validate)]
#[serde(deny_unknown_fields, default)]
pub struct Turbulence {
    /// Shortest and longest wavelength, in mm.
    #[garde(inner(custom(finite), range(min = 0.01, max = 10_000.0)), custom(ascend))]
    pub wavelengths_mm: [f64; 2],
    /// Expected root mean square of each velocity component, in m/s; a single field deviates by
    /// some 10 %.
    #[garde(custom(finite), range(min = 0.0, max = 1000.0))]
    pub rms_m_s: f64,
    /// Seed of directions and phases, independent of the run's seed for particles.
    #[garde(skip)]
    pub seed: u64,
    #[serde(skip)]
    #[garde(skip)]
    waves: DrawnWaves<Wave>,
}

#[derive(Debug, Clone, Copy)]
struct Wave {
    /// k, in rad/mm.
    number_per_mm: [f64; 3],
    /// a e, in m/s.
    amplitude_m_s: [f64; 3],
    /// φ.
    phase: f64,
}

impl Default for Turbulence {
    /// 1.6 to 10 mm and 1.4 m/s: on the bench 16 to 100 voxels, and 1.4 voxels in 100 µs.
    fn default() -> Self {
        Self::new([1.6, 10.0], 1.4, 1)
    }
}

impl Turbulence {
    /// A field between two wavelengths (shorter one first), in mm.
    pub fn new(wavelengths_mm: [f64; 2], rms_m_s: f64, seed: u64) -> Self {
        Self { wavelengths_mm, rms_m_s, seed, waves: DrawnWaves::default() }
    }

    pub(super) fn velocity_m_s(&self, position_mm: [f64; 3]) -> [f64; 3] {
        let mut velocity = [0.0; 3];
        for wave in self.waves.get_or_draw(|| self.draw()) {
            let angle: f64 = (0..3).map(|c| wave.number_per_mm[c] * position_mm[c]).sum();
            let cosine = (angle + wave.phase).cos();
            for (velocity, amplitude) in velocity.iter_mut().zip(wave.amplitude_m_s) {
                *velocity += amplitude * cosine;
            }
        }
        velocity
    }

    fn draw(&self) -> Vec<Wave> {
        let mut rng = random_stream(Purpose::Turbulence, &[self.seed]);
        let [longest, shortest] = [1, 0].map(|n| TAU / self.wavelengths_mm[n]);
        let number =
            |n: usize| longest * (shortest / longest).powf((n as f64 + 0.5) / WAVES as f64);
        let squares: f64 = (0..WAVES).map(|n| number(n).powf(-2.0 / 3.0)).sum();
        // The mean of cos² is 1/2, and the squared amplitude includes three components.
        let scale = self.rms_m_s * (6.0 / squares).sqrt();
        (0..WAVES)
            .map(|n| {
                let along = direction(&mut rng);
                let across = perpendicular(&mut rng, along);
                let amplitude_m_s = scale * number(n).powf(-1.0 / 3.0);
                Wave {
                    number_per_mm: along.map(|c| number(n) * c),
                    amplitude_m_s: across.map(|c| amplitude_m_s * c),
                    phase: rng.random_range(0.0..TAU),
                }
            })
            .collect()
    }
}

/// A uniformly distributed unit vector.
pub(super) fn direction(rng: &mut impl Rng) -> [f64; 3] {
    let z: f64 = rng.random_range(-1.0..=1.0);
    let (sin, cos) = rng.random_range(-PI..PI).sin_cos();
    let across = (1.0 - z * z).sqrt();
    [across * cos, across * sin, z]
}

/// A uniformly distributed unit vector perpendicular to `along`.
pub(super) fn perpendicular(rng: &mut impl Rng, along: [f64; 3]) -> [f64; 3] {
    loop {
        let drawn = direction(rng);
        let common: f64 = (0..3).map(|c| drawn[c] * along[c]).sum();
        let left: [f64; 3] = std::array::from_fn(|c| drawn[c] - common * along[c]);
        let length = left.iter().map(|c| c * c).sum::<f64>().sqrt();
        if length > 0.1 {
            return left.map(|c| c / length);
        }
    }
}

fn ascend(wavelengths_mm: &[f64; 2], (): &()) -> garde::Result {
    if wavelengths_mm[0] <= wavelengths_mm[1] {
        Ok(())
    } else {
        Err(garde::Error::new("allowed: the shorter wavelength first"))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Root mean square of a component over many points and fields.
    #[test]
    fn the_fields_have_their_rms() {
        let mut rng = random_stream(Purpose::Seeding, &[9]);
        let (mut sum, mut count) = (0.0, 0.0_f64);
        for seed in 0..40 {
            let flow = Turbulence::new([1.6, 10.0], 1.4, seed);
            for _ in 0..200 {
                let at = std::array::from_fn(|_| rng.random_range(-50.0..50.0));
                sum += flow.velocity_m_s(at).iter().map(|c| c * c).sum::<f64>();
                count += 3.0;
            }
        }
        let rms = (sum / count).sqrt();
        assert!((rms / 1.4 - 1.0).abs() < 0.03, "{rms}");
    }

    #[test]
    fn waves_lie_between_the_wavelengths_and_are_transverse() {
        let flow = Turbulence::default();
        let dot = |a: [f64; 3], b: [f64; 3]| (0..3).map(|c| a[c] * b[c]).sum::<f64>();
        let waves = flow.draw();
        for wave in &waves {
            let number = dot(wave.number_per_mm, wave.number_per_mm).sqrt();
            assert!((1.6..=10.0).contains(&(TAU / number)), "{number}");
            assert!(dot(wave.number_per_mm, wave.amplitude_m_s).abs() < 1e-9);
        }
        // E(k) ∝ k^(−5/3): the energy up to k grows as K − k^(−2/3).
        let square = |wave: &Wave| dot(wave.amplitude_m_s, wave.amplitude_m_s);
        let half: f64 = waves[..WAVES / 2].iter().map(square).sum();
        let all: f64 = waves.iter().map(square).sum();
        let [low, middle, high] = [10.0, 4.0, 1.6f64].map(|mm| mm.powf(2.0 / 3.0));
        assert!((half / all - (low - middle) / (low - high)).abs() < 0.01, "{}", half / all);
    }

    #[test]
    fn equal_seeds_give_equal_fields() {
        let at = [1.0, -2.0, 0.5];
        let velocity = |seed| Turbulence::new([1.6, 10.0], 1.4, seed).velocity_m_s(at);
        assert_eq!(velocity(3), velocity(3));
        assert_ne!(velocity(3), velocity(4));
        assert!(Turbulence::new([10.0, 1.6], 1.4, 1).validate().is_err());
    }
}
