//! What a bench can be expected to measure, before it is built: the uncertainty of vectors over the volume, from
//! optics, light and seeding alone (docs/theory.md, section 10).
//!
//! A particle is known as exactly as its image changes when it moves: the bound of Cramér and Rao, from the
//! derivatives of its footprint in each camera. Noise is that of the sensor and of the light, and the light of
//! the other particles, which lies over it everywhere: a solver that told them apart perfectly would do better.
//! A vector has what the particles of its part of the lattice know together.

mod footprint;

use nalgebra::{Matrix3, Vector3};
use rand::{RngExt, SeedableRng};
use rand_pcg::Pcg64Mcg;
use rayon::prelude::*;

use self::footprint::Cameras;
use super::Measurement;
use crate::model::ModelError;

/// Places along each axis at which the uncertainty is found.
const PLACES: usize = 7;
/// Particles in each place's part of the lattice.
const PARTICLES: usize = 12;
/// The same numbers every time: a forecast does not scatter.
const SEED: u64 = 1;

/// What is in front of the cameras.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Conditions {
    /// Particles per microlens: their number over that of the microlens pitches on the volume's face along x
    /// and y.
    pub ppm: f64,
    /// Half-width of the uniform distribution of relative brightness about 1.
    pub intensity_spread: f64,
    /// Photo-electrons that the mean particle releases in each camera and exposure, of all its light that
    /// passes the pupil.
    pub photoelectrons: f64,
    /// Photo-electrons of stationary light in a pixel.
    pub background_electrons: f64,
    /// Standard deviation of a pixel's read-out, in electrons.
    pub read_noise_electrons: f64,
}

/// The uncertainty to expect at a place.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ForecastPlace {
    /// Where, in mm.
    pub position_mm: [f64; 3],
    /// Standard uncertainty of the displacement along x, y, z, in voxels; infinite where no camera sees it.
    pub uncertainty_vox: [f64; 3],
}

/// Forecasts the uncertainty of vectors at places all over the volume, faces included.
///
/// That of the flow between the vectors, of outliers and of a bench that is not as drawn comes on top. Fields
/// without particle tracking are those of correlation, whose windows cost more
/// ([`correlation_error_vox`](crate::velocimetry::correlation_error_vox)).
///
/// # Errors
/// A camera does not see the volume, or it reaches too deep for the lens.
pub fn forecast(
    measurement: &Measurement,
    conditions: &Conditions,
) -> Result<Vec<ForecastPlace>, ModelError> {
    let Measurement { optics, volume, velocimetry, .. } = measurement;
    let size_mm = volume.voxels.map(|voxels| voxels as f64 * volume.voxel_mm);
    let face = size_mm[0] * size_mm[1] / optics.object_pitch_mm().powi(2);
    let per_mm3 = conditions.ppm * face / size_mm.iter().product::<f64>();
    let cameras = Cameras::new(measurement, conditions, per_mm3)?;
    let imagers = cameras.imagers()?;
    let spacing_mm = velocimetry.window_mm * (1.0 - velocimetry.overlap);
    let in_cell = per_mm3 * spacing_mm.powi(3);
    let half_mm = size_mm.map(|size| size / 2.0);
    let at = |index: usize| -> [f64; 3] {
        let step = [index % PLACES, index / PLACES % PLACES, index / PLACES.pow(2)];
        std::array::from_fn(|axis| {
            let share = 2.0 * step[axis] as f64 / (PLACES - 1) as f64 - 1.0;
            // The outermost vectors are on the faces, or nearly so.
            volume.centre_mm[axis] + share * (half_mm[axis] - spacing_mm / 4.0).max(0.0)
        })
    };
    let place = |index: usize| {
        let position_mm = at(index);
        let mut random = generator(index as u64 + (1 << 16));
        let mut information = Matrix3::zeros();
        for _ in 0..PARTICLES {
            let particle: [f64; 3] = std::array::from_fn(|axis| {
                position_mm[axis] + spacing_mm * (random.random::<f64>() - 0.5)
            });
            let inside =
                (0..3).all(|axis| (particle[axis] - volume.centre_mm[axis]).abs() <= half_mm[axis]);
            // Beyond the faces there is no light.
            if inside {
                information += cameras.information(&imagers, &Vector3::from(particle));
            }
        }
        let uncertainty_mm = uncertainty_mm(&(information * (in_cell / PARTICLES as f64)));
        ForecastPlace {
            position_mm,
            uncertainty_vox: uncertainty_mm.map(|mm| mm / volume.voxel_mm),
        }
    };
    Ok((0..PLACES.pow(3)).into_par_iter().map(place).collect())
}

/// Of the difference of two positions that are known so well.
fn uncertainty_mm(information: &Matrix3<f64>) -> [f64; 3] {
    match information.try_inverse() {
        Some(covariance) => std::array::from_fn(|axis| {
            let variance = covariance[(axis, axis)];
            if variance > 0.0 { (2.0 * variance).sqrt() } else { f64::INFINITY }
        }),
        None => [f64::INFINITY; 3],
    }
}

/// A seeded generator, so that a forecast is the same every time.
fn generator(stream: u64) -> Pcg64Mcg {
    Pcg64Mcg::seed_from_u64(SEED.wrapping_mul(1 << 32) + stream)
}

#[cfg(test)]
mod tests;
