//! What correlation alone costs: the error that true particles would give.

/// Edge of the windows that the figures below belong to, in voxels.
const WINDOW_VOX: f64 = 16.0;

/// Error of a full window in the reference flow, in voxels: what it cannot resolve.
const FULL_WINDOW_ERROR_VOX: f64 = 0.009;

/// How that grows with the window's edge: the vectors are drawn towards fields without third
/// differences.
const FULL_WINDOW_ERROR_POWER: f64 = 3.0;

/// What one particle adds, in voxels, and how that grows with the window's edge: it stands for the
/// flow at its own place, off the window's centre. As all of these: docs/decisions.md, "Constants
/// that were fitted".
const PER_PARTICLE_VOX: f64 = 0.041;
const PER_PARTICLE_POWER: f64 = 1.4;

/// Mean |error| of a displacement component that is to be expected of windows of this edge which
/// hold this many particles on average, in voxels, by correlation alone.
///
/// √(r² + q²/N) with r ∝ W³ and q ∝ W^1.4, fitted to the error of true particles in the flow of the
/// shipped bench (10 mm wavelength, 2 voxels amplitude, five passes, windows of 8 to 24 voxels
/// with 5 to 400 particles; `tests/model_parts.rs` prints the table). The flow of a run is not known
/// before it is measured: a smoother one has a smaller error, a rougher one a larger.
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
