//! Result of the calibration of one camera.

use nalgebra::Point3;
use serde::Serialize;

use super::{
    ParameterEstimate, VolumeError, VolumeInput,
    adjustment::{Adjusted, Bench, Observation},
    parameters::DESCRIPTIONS,
};
use crate::model::{MapResidual, VolumeMap};

/// Degree of the polynomials of a map: the residual with distortion is about a micrometre.
const MAP_DEGREE: usize = 4;

/// One camera.
#[derive(Debug, Clone)]
pub struct CalibratedCamera {
    /// Equivalent points of the nominal ideal camera for the volume's points.
    pub map: VolumeMap,
    /// Residual of the map relative to traced rays.
    pub map_residual: MapResidual,
    /// Estimated parameters.
    pub parameters: Vec<ParameterEstimate>,
    /// All marks that were used.
    pub marks: Vec<MarkResidual>,
    /// Root-mean-square residual of one coordinate of the marks, in microlenses.
    pub rms_microlenses: f64,
}

/// Measured location and residual of a mark.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct MarkResidual {
    /// Index of the card's position, from 0.
    pub position: usize,
    /// Indices of the mark on the card.
    pub number: [i32; 2],
    /// Measured location, in fractional microlens indices.
    pub lens: [f64; 2],
    /// Measured minus predicted location, in microlenses.
    pub residual_microlenses: [f64; 2],
}

impl CalibratedCamera {
    /// The camera with the adjusted parameters.
    ///
    /// # Errors
    /// [`VolumeError::NoMap`] if it does not see the whole box of its map.
    pub(super) fn of(
        input: &VolumeInput<'_>,
        bench: &Bench<'_>,
        observations: &[Observation],
        adjusted: &Adjusted,
        camera: usize,
    ) -> Result<Self, VolumeError> {
        let model = bench.model(camera, adjusted.cameras[camera]);
        let [centre_mm, half_mm] = input.box_mm;
        let seen = |world_mm: [f64; 3]| model.equivalent(&Point3::from(world_mm));
        let (map, map_residual) =
            VolumeMap::fit(centre_mm, half_mm, MAP_DEGREE, seen).ok_or(VolumeError::NoMap)?;
        let pitch_mm = input.optics.microlens.pitch_mm;
        let mut marks = Vec::new();
        for observation in observations.iter().filter(|observation| observation.camera == camera) {
            let stage_mm = &adjusted.stage_mm[observation.position];
            for (mark, [place_mm, _]) in bench.differences(observation, adjusted, stage_mm) {
                marks.push(MarkResidual {
                    position: observation.position,
                    number: mark.number,
                    lens: input.light[observation.position][camera].lens_at(mark.place_mm),
                    residual_microlenses: place_mm.map(|mm| mm / pitch_mm),
                });
            }
        }
        let squares: f64 =
            marks.iter().flat_map(|mark| mark.residual_microlenses).map(|r| r * r).sum();
        Ok(Self {
            map,
            map_residual,
            parameters: estimates(adjusted, camera),
            rms_microlenses: (squares / (2.0 * marks.len() as f64)).sqrt(),
            marks,
        })
    }
}

fn estimates(adjusted: &Adjusted, camera: usize) -> Vec<ParameterEstimate> {
    let values = adjusted.cameras[camera].0.iter().zip(&adjusted.deviations[camera]);
    values
        .zip(DESCRIPTIONS)
        .map(|((&value, &standard_deviation), (name, unit, prior_standard_deviation))| {
            ParameterEstimate { name, unit, value, standard_deviation, prior_standard_deviation }
        })
        .collect()
}
