//! One camera as the card shows it.

use nalgebra::Point3;
use serde::Serialize;

use super::{
    ParameterEstimate, VolumeError, VolumeInput,
    adjustment::{Adjusted, Bench, Sighting},
    parameters::DESCRIPTIONS,
};
use crate::model::{MapResidual, VolumeMap};

/// Degree of the polynomials of a map: with it distortion is followed to a micrometre.
const MAP_DEGREE: usize = 4;

/// One camera.
#[derive(Debug, Clone)]
pub struct CalibratedCamera {
    /// Equivalent points of the nominal ideal camera for the volume's points.
    pub map: VolumeMap,
    /// How well the map follows the rays.
    pub map_residual: MapResidual,
    /// What the rays depend on.
    pub parameters: Vec<ParameterEstimate>,
    /// Every mark that was used.
    pub marks: Vec<MarkResidual>,
    /// Root mean square of one coordinate of the marks' places, in microlenses.
    pub rms_microlenses: f64,
}

/// Where a mark was seen, and how far from where the model sees it.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct MarkResidual {
    /// Position of the card, from 0.
    pub position: usize,
    /// Number on the card.
    pub number: [i32; 2],
    /// The microlens, in fractions, where it was seen.
    pub lens: [f64; 2],
    /// Seen less expected, in microlenses.
    pub residual_microlenses: [f64; 2],
}

impl CalibratedCamera {
    /// The camera with the parameters that were found.
    ///
    /// # Errors
    /// It does not see all of the box that its map should hold in.
    pub(super) fn of(
        input: &VolumeInput<'_>,
        bench: &Bench<'_>,
        sightings: &[Sighting],
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
        for sighting in sightings.iter().filter(|sighting| sighting.camera == camera) {
            let stage_mm = &adjusted.stage_mm[sighting.position];
            for (mark, [place_mm, _]) in bench.differences(sighting, adjusted, stage_mm) {
                marks.push(MarkResidual {
                    position: sighting.position,
                    number: mark.number,
                    lens: input.light[sighting.position][camera].lens_at(mark.place_mm),
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
