//! What the images hold: the bound of the uncertainty of vectors (docs/theory.md, section 10).
//!
//! A particle is known as exactly as its image changes when it moves: the bound of Cramér and Rao, from the
//! derivatives of its footprint in each camera. Noise is that of the sensor and of the light, and the light of
//! the other particles, which lies over it everywhere: a solver that told them apart perfectly would do better.
//! A vector has what the particles of its part of the lattice know together.

use nalgebra::{Matrix3, Vector3};
use rand::RngExt;
use rayon::prelude::*;

use super::{Conditions, ForecastPlace, footprint::Cameras, generator};
use crate::{measurement::Measurement, model::ModelError};

/// Places along each axis at which the uncertainty is found.
pub(super) const PLACES: usize = 7;
/// Particles in each place's part of the lattice.
const PARTICLES: usize = 12;

/// The least uncertainty of vectors that an unbiased measurement may have at places all over the volume, faces included.
///
/// That of the flow between the vectors, of outliers and of a bench that is not as drawn comes on top. Fields
/// without particle tracking are those of correlation, whose windows cost more
/// ([`correlation_error_vox`](crate::velocimetry::correlation_error_vox)).
///
/// # Errors
/// A camera does not see the volume, or it reaches too deep for the lens.
pub fn bound(
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
pub(super) fn uncertainty_mm(information: &Matrix3<f64>) -> [f64; 3] {
    match information.try_inverse() {
        Some(covariance) => std::array::from_fn(|axis| {
            let variance = covariance[(axis, axis)];
            if variance > 0.0 { (2.0 * variance).sqrt() } else { f64::INFINITY }
        }),
        None => [f64::INFINITY; 3],
    }
}
