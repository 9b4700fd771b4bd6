//! Error due to the omission of a part of the forward model, and computing time with it.
//!
//! The figures are fitted to what `tests/model_parts.rs` prints: the bench's flow in 4 x 4 x 4 mm,
//! in focus and beside it, 0.16 and 0.54 particles per microlens, with and without noise and
//! diffraction; the error of a part is √(e² − e₀²), from the mean |error| without and with it. Values
//! of a few thousandths of a voxel are accurate to about 50 %.

use super::combination::Combination;
use crate::model::{Part, SceneMeasure};

/// Position error of one particle due to unmodelled blur of the pupil, relative to the standard deviation of that
/// blur. A window of N particles averages it in both frames: √(2/N).
const PUPIL_BLUR_ERROR: f64 = 0.5;

/// The same for diffraction. Scattering of rays by 1.8 µm on microlenses and sensor changed errors by at most this.
const DIFFRACTION_ERROR: f64 = 0.15;

/// Position error of one particle with the complete model, in voxels, times the parallax across the aperture in
/// voxels, divided by the root of the seeding in particles per microlens: overlapping particles are separated by
/// parallax.
const OVERLAP_ERROR: f64 = 0.37;

/// Error due to omission of the views at the edge of the aperture, in voxels, divided by the noise per particle: their
/// light is lost. It is not measurable at low noise.
const EDGE_VIEWS_ERROR: f64 = 0.07;

/// Error without noise weighting, in voxels, divided by the root of the noise per particle. It is the same in all
/// windows and is not averaged.
const NOISE_WEIGHTING_ERROR: f64 = 0.036;

/// Error due to voxels of the volume's own size, in voxels, and the power of the refinement with which it decreases.
/// Both frames are rounded to the same grid, so it is not averaged either.
const COARSE_VOXEL_ERROR: f64 = 0.09;
const COARSE_VOXEL_POWER: f64 = 1.8;

/// Relative time of a reconstruction for each refinement. A refinement of two is not faster than of four, which starts
/// with a single pass on voxels twice as large.
const TIME_OF_REFINEMENT: [(usize, f64); 3] = [(1, 1.0), (2, 2.0), (4, 2.0)];

/// Errors due to the omission of single parts, in voxels of displacement.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Errors([f64; 5]);

impl Errors {
    /// The error of one part.
    pub fn of(&self, part: Part) -> f64 {
        self.0[part as usize]
    }
}

/// Errors without each part, on grids of `refinement`, relative to the `finest` one.
pub(super) fn errors_without(scene: &SceneMeasure, refinement: usize, finest: usize) -> Errors {
    let averaged = |one_vox: f64| (2.0 / scene.particles_per_window.max(1.0)).sqrt() * one_vox;
    // A uniform distribution's standard deviation is its width over √12.
    let blur = |width_vox: f64| averaged(width_vox / 12f64.sqrt());
    // If a share f of the light is lost, the information decreases by the factor 1 − f: the squared error
    // increases by the share f/(1 − f).
    let gone = scene.partly_open_light;
    let overlap_vox = OVERLAP_ERROR * scene.seeding_ppm.sqrt() / scene.parallax_vox.max(1e-3);
    let rounding = |n: usize| (COARSE_VOXEL_ERROR * (n as f64).powf(-COARSE_VOXEL_POWER)).powi(2);
    let mut errors = [0.0; 5];
    errors[Part::PupilBlur as usize] = PUPIL_BLUR_ERROR * blur(scene.pupil_blur_vox);
    errors[Part::ApertureCoverage as usize] =
        averaged(overlap_vox * (gone / (1.0 - gone).max(1e-6)).sqrt())
            .hypot(EDGE_VIEWS_ERROR * scene.noise_per_particle);
    errors[Part::Diffraction as usize] =
        DIFFRACTION_ERROR * blur(scene.diffraction_vox.unwrap_or(0.0));
    errors[Part::NoiseWeighting as usize] = NOISE_WEIGHTING_ERROR * scene.noise_per_particle.sqrt();
    errors[Part::FineVoxels as usize] = (rounding(refinement) - rounding(finest)).max(0.0).sqrt();
    Errors(errors)
}

/// Time of a reconstruction, in units of one on the volume's own voxels with all views and without
/// blur.
///
/// Work is proportional to the number of voxels, views and microlenses under a voxel's projection: 1 + w/p along an
/// axis for a width w and the pitch p. The voxel's own width is accounted for by [`TIME_OF_REFINEMENT`].
pub(super) fn cost(scene: &SceneMeasure, combination: &Combination) -> f64 {
    let of = |on: bool, width: f64| if on { width } else { 0.0 };
    let blur = of(combination.pupil_blur, scene.pupil_blur_vox)
        .hypot(of(combination.diffraction, scene.diffraction_vox.unwrap_or(0.0)));
    let voxel = 1.0 / combination.refinement as f64;
    let microlenses = |width: f64| 1.0 + width / scene.pitch_vox;
    let left_out = if combination.aperture_coverage { 0.0 } else { scene.partly_open_views };
    time_of(combination.refinement) * (1.0 - left_out) * microlenses(blur.hypot(voxel))
        / microlenses(voxel)
}

/// [`TIME_OF_REFINEMENT`], interpolated between its entries.
fn time_of(refinement: usize) -> f64 {
    let [low, middle, high] = TIME_OF_REFINEMENT;
    let (a, b) = if refinement <= middle.0 { (low, middle) } else { (middle, high) };
    a.1 + (b.1 - a.1) * (refinement as f64 - a.0 as f64) / (b.0 - a.0) as f64
}
