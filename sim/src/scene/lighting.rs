//! Differences of light between exposures: the `[simulation.lighting]` table.

use garde::Validate;
use lfpiv_hw::check::finite;
use rand::RngExt;
use serde::{Deserialize, Serialize};

use crate::stream::{Purpose, random_stream};

/// Brightness factors of a particle by exposure. By default the light is the same in every frame
/// and camera.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, Validate)]
#[serde(deny_unknown_fields, default)]
pub struct Lighting {
    /// Relative pulse energy in exposures 1 and 2: two laser heads are not equal.
    #[garde(inner(custom(finite), range(min = 0.0, max = 1000.0)))]
    pub pulse_energy: [f64; 2],
    /// Relative light of each camera, in the order of the cameras; 1 for cameras that are not
    /// listed. Particles scatter more light forwards than sideways.
    #[garde(inner(custom(finite), range(min = 0.0, max = 1000.0)))]
    pub camera_light: Vec<f64>,
    /// Half-width s of the uniform distribution on [1 − s, 1 + s] of each particle's light in each
    /// frame: the sheets of two laser heads have different profiles.
    #[garde(custom(finite), range(min = 0.0, max = 1.0))]
    pub frame_spread: f64,
    /// Half-width of the same distribution for each camera, equal in both frames: Mie scattering
    /// changes within degrees.
    #[garde(custom(finite), range(min = 0.0, max = 1.0))]
    pub camera_spread: f64,
}

impl Default for Lighting {
    fn default() -> Self {
        Self {
            pulse_energy: [1.0; 2],
            camera_light: Vec::new(),
            frame_spread: 0.0,
            camera_spread: 0.0,
        }
    }
}

impl Lighting {
    /// Brightness factor of a particle in the exposure `[seed, shot, camera, frame]`.
    pub(super) fn factor(&self, [seed, shot, camera, frame]: [u64; 4], particle: u64) -> f64 {
        let of = |shares: &[f64], index: u64| shares.get(index as usize).copied().unwrap_or(1.0);
        let drawn = |spread: f64, purpose: Purpose, of: u64| {
            if spread == 0.0 {
                return 1.0;
            }
            let mut rng = random_stream(purpose, &[seed, shot, of, particle]);
            1.0 + spread * rng.random_range(-1.0..=1.0)
        };
        of(&self.pulse_energy, frame)
            * of(&self.camera_light, camera)
            * drawn(self.frame_spread, Purpose::FrameLight, frame)
            * drawn(self.camera_spread, Purpose::CameraLight, camera)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const PARTICLES: u64 = 4000;

    fn mean(values: impl Iterator<Item = f64>) -> f64 {
        let values: Vec<f64> = values.collect();
        values.iter().sum::<f64>() / values.len() as f64
    }

    #[test]
    fn by_default_every_exposure_has_the_same_light() {
        let lighting = Lighting::default();
        for exposure in [[1, 0, 0, 0], [7, 3, 1, 1], [1, 0, 9, 1]] {
            assert_eq!(lighting.factor(exposure, 5), 1.0);
        }
    }

    #[test]
    fn frames_and_cameras_have_their_shares() {
        let lighting = Lighting {
            pulse_energy: [1.0, 0.8],
            camera_light: vec![1.0, 0.5],
            ..Lighting::default()
        };
        assert_eq!(lighting.factor([1, 0, 0, 1], 2), 0.8);
        assert_eq!(lighting.factor([1, 0, 1, 1], 2), 0.4);
        // A camera that is not listed.
        assert_eq!(lighting.factor([1, 0, 2, 0], 2), 1.0);
    }

    /// A uniform distribution of half-width s has variance s²/3. Frame factors are equal in both
    /// cameras, camera factors are equal in both frames.
    #[test]
    fn spreads_are_drawn_for_frames_and_for_cameras() {
        let (frames, cameras) = (
            Lighting { frame_spread: 0.3, ..Lighting::default() },
            Lighting { camera_spread: 0.3, ..Lighting::default() },
        );
        for (lighting, same, other) in
            [(frames, [1, 0, 1, 0], [1, 0, 0, 1]), (cameras, [1, 0, 0, 1], [1, 0, 1, 0])]
        {
            let light = |exposure, particle| lighting.factor(exposure, particle) - 1.0;
            let first = [1, 0, 0, 0];
            let variance = mean((0..PARTICLES).map(|n| light(first, n).powi(2)));
            assert!((variance / 0.03 - 1.0).abs() < 0.06, "{variance}");
            assert!((0..PARTICLES).all(|n| light(first, n) == light(same, n)));
            let shared = mean((0..PARTICLES).map(|n| light(first, n) * light(other, n)));
            assert!(shared.abs() < 0.1 * variance, "{shared}");
        }
    }
}
