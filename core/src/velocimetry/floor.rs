//! Error of the correlation itself, as measured with true particles.

/// Edge of the windows for which the constants below hold, in voxels.
const WINDOW_VOX: f64 = 16.0;

/// Error of a window with many particles in the reference flow, in voxels: the unresolved part of the flow.
const FULL_WINDOW_ERROR_VOX: f64 = 0.009;

/// Power of the window's edge in this error: smoothing reduces third differences.
const FULL_WINDOW_ERROR_POWER: f64 = 3.0;

/// Error due to a single particle, in voxels, and its power of the window's edge: the particle measures the flow
/// at its own position, not at the window's centre. All of these: docs/decisions.md, "Fitted constants".
const PER_PARTICLE_VOX: f64 = 0.041;
const PER_PARTICLE_POWER: f64 = 1.4;

/// Expected mean |error| of a displacement component, in voxels, by correlation alone, of windows with this edge
/// and this mean number of particles.
///
/// √(r² + q²/N) with r ∝ W³ and q ∝ W^1.4, fitted to the error of true particles in the flow of the
/// shipped bench (10 mm wavelength, 2 voxels amplitude, five passes, windows of 8 to 24 voxels
/// with 5 to 400 particles; `tests/model_parts.rs` prints the table). The error is
/// smaller in smoother flows and larger in rougher ones.
pub fn correlation_error_vox(window_vox: f64, particles_per_window: f64) -> f64 {
    let edge = window_vox / WINDOW_VOX;
    let resolution = FULL_WINDOW_ERROR_VOX * edge.powf(FULL_WINDOW_ERROR_POWER);
    let particle = PER_PARTICLE_VOX * edge.powf(PER_PARTICLE_POWER);
    resolution.hypot(particle / particles_per_window.max(1.0).sqrt())
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Window in voxels, particles in it, measured error of the true particles in voxels.
    const MEASURED: [(f64, f64, f64); 10] = [
        (8.0, 6.4, 0.0058),
        (8.0, 15.4, 0.0047),
        (16.0, 5.1, 0.0248),
        (16.0, 15.4, 0.0114),
        (16.0, 51.2, 0.0094),
        (16.0, 122.9, 0.0096),
        (24.0, 17.3, 0.0365),
        (24.0, 51.8, 0.0309),
        (24.0, 172.8, 0.0322),
        (24.0, 414.7, 0.0313),
    ];

    #[test]
    fn the_fit_is_within_a_quarter_of_what_was_measured() {
        for (window, particles, measured) in MEASURED {
            let fitted = correlation_error_vox(window, particles);
            assert!((fitted / measured - 1.0).abs() < 0.25, "{window}, {particles}: {fitted}");
        }
    }

    #[test]
    fn empty_windows_have_a_finite_error() {
        assert_eq!(correlation_error_vox(16.0, 0.0), correlation_error_vox(16.0, 1.0));
    }
}
