//! Lower bound of the uncertainty of vectors (docs/theory.md, section 10).
//!
//! Cramér–Rao bound of a particle's position, from the derivatives of its footprint in each camera. The noise
//! consists of sensor noise, shot noise and the overlapping light of other particles; a solver that separates
//! particles perfectly would have a lower bound. A vector has the combined information of the particles in its
//! cell of the lattice.

use nalgebra::{Matrix3, Vector3};
use rand::RngExt;
use rayon::prelude::*;

use super::{ForecastPlace, SceneConditions, footprint::Cameras, generator};
use crate::{measurement::Measurement, model::ModelError};

/// Positions along each axis at which the uncertainty is computed.
pub(super) const PLACES: usize = 7;
/// Particles in the cell of each position.
const PARTICLES: usize = 12;

/// Least uncertainty of the vectors of an unbiased measurement at positions throughout the volume, faces included.
///
/// Errors due to unresolved flow between the vectors, to outliers and to deviations of the bench from its nominal
/// geometry are not included. Fields without particle tracking have the larger error of correlation windows
/// ([`correlation_error_vox`](crate::velocimetry::correlation_error_vox)).
///
/// # Errors
/// A camera does not see the volume, or it reaches too deep for the lens.
pub fn bound(
    measurement: &Measurement,
    conditions: &SceneConditions,
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
            // The outermost vectors are on or near the faces.
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
            // There is no light outside the volume.
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

/// Standard uncertainty of the difference of two positions with this information.
pub(super) fn uncertainty_mm(information: &Matrix3<f64>) -> [f64; 3] {
    match information.try_inverse() {
        Some(covariance) => std::array::from_fn(|axis| {
            let variance = covariance[(axis, axis)];
            if variance > 0.0 { (2.0 * variance).sqrt() } else { f64::INFINITY }
        }),
        None => [f64::INFINITY; 3],
    }
}
