//! Thresholds between bright and dark pixels in a camera's views.

use crate::lightfield::ViewStack;

/// A pixel is dark below this many standard deviations of the noise plus [`DARK_PARTICLE_SHARE`]
/// (docs/decisions.md, "Fitted constants").
const DARK_NOISE_WIDTHS: f64 = 3.0;

/// Part of the threshold that is proportional to a particle's light.
const DARK_PARTICLE_SHARE: f64 = 0.06;

/// Upper limit of the threshold, as a share of a particle's light: a particle at the corner of four
/// microlenses gives each of them a quarter of its light.
const LARGEST_DARK_SHARE: f64 = 0.15;

/// Particle light and noise in one camera's views.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ViewLevels {
    /// Light of a particle in a fully open view, in counts.
    pub particle_counts: f64,
    /// Standard deviation of a dark pixel, in counts.
    pub noise_counts: f64,
}

impl ViewLevels {
    /// Estimates a particle's light as the light-weighted mean of the views, Σ I² / Σ I, minus the
    /// contribution of noise. Exact for single particles, slightly high for overlapping ones.
    pub fn of(views: &ViewStack, noise_counts: f64) -> Self {
        let (mut sum, mut squares) = (0.0f64, 0.0f64);
        for &value in views.values() {
            sum += f64::from(value);
            squares += f64::from(value).powi(2);
        }
        let noise = views.values().len() as f64 * noise_counts.powi(2);
        let particle_counts = if sum > 0.0 { ((squares - noise) / sum).max(0.0) } else { 0.0 };
        Self { particle_counts, noise_counts }
    }

    /// The count below which a pixel contains no particle.
    pub fn dark_below(&self) -> f32 {
        let above_noise =
            DARK_NOISE_WIDTHS * self.noise_counts + DARK_PARTICLE_SHARE * self.particle_counts;
        // At least one standard deviation; otherwise a dark image would have no dark pixel.
        above_noise.min(LARGEST_DARK_SHARE * self.particle_counts).max(self.noise_counts) as f32
    }
}

/// Per camera, the count below which a pixel contains no particle.
pub(super) fn dark_below(levels: &[ViewLevels]) -> Vec<f32> {
    levels.iter().map(ViewLevels::dark_below).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn single_particles_give_their_own_light_despite_noise() {
        let mut values = vec![0.0f32; 10_000];
        for (n, value) in values.iter_mut().enumerate() {
            // Noise of ±4 counts, and a particle of 200 in every hundredth pixel.
            *value = if n % 2 == 0 { 4.0 } else { -4.0 };
            if n % 100 == 0 {
                *value += 200.0;
            }
        }
        let levels = ViewLevels::of(&ViewStack::new(10_000, values), 4.0);
        assert!((levels.particle_counts - 204.0).abs() < 6.0, "{levels:?}");
        assert!((levels.dark_below() - 24.2).abs() < 1.0);
    }

    #[test]
    fn dark_and_faint_views_have_finite_thresholds() {
        let dark = ViewLevels::of(&ViewStack::new(4, vec![0.0; 4]), 3.0);
        assert_eq!((dark.particle_counts, dark.dark_below()), (0.0, 3.0));
        let faint = ViewLevels { particle_counts: 50.0, noise_counts: 5.0 };
        assert_eq!(faint.dark_below(), 7.5);
    }
}
