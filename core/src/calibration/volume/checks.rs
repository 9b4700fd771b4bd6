//! Checks of a finished calibration: what its user should be warned of.

use lfpiv_hw::CameraName;
use nalgebra::Point3;

use super::{
    HeldOut, VolumeInput, VolumeWarning,
    adjustment::{Adjusted, Sighting},
    parameters::DESCRIPTIONS,
};

/// Held-out marks of a flat card on a good stage, in microlenses.
const USUAL_HELD_OUT: f64 = 0.05;

/// Warnings of a calibration whose residuals, parameters or covered volume are unusual.
pub(super) fn warnings(
    input: &VolumeInput<'_>,
    sightings: &[Sighting],
    adjusted: &Adjusted,
    held_out: &HeldOut,
) -> Vec<VolumeWarning> {
    let mut warnings = Vec::new();
    if held_out.mean_microlenses > USUAL_HELD_OUT {
        warnings.push(VolumeWarning::HeldOutFar {
            microlenses: held_out.mean_microlenses,
            usual: USUAL_HELD_OUT,
        });
    }
    for (camera, parameters) in adjusted.cameras.iter().enumerate() {
        for (value, (parameter, _, prior)) in parameters.0.iter().zip(DESCRIPTIONS) {
            let deviations = value.abs() / prior;
            if deviations > 3.0 {
                let camera = CameraName(camera);
                warnings.push(VolumeWarning::FarFromDrawing { camera, parameter, deviations });
            }
        }
    }
    warnings.extend(beyond_marks(input, sightings));
    warnings
}

/// Axes along which the box reaches farther than the marks.
fn beyond_marks(input: &VolumeInput<'_>, sightings: &[Sighting]) -> Vec<VolumeWarning> {
    let card = &input.card.card;
    let mut marks_mm = [[f64::INFINITY, f64::NEG_INFINITY]; 3];
    for sighting in sightings {
        let origin_mm = Point3::from(input.card.position[sighting.position].origin_mm);
        let axis = &input.poses[sighting.camera].axis;
        for mark in &sighting.marks {
            let along_mm = mark.number.map(|n| f64::from(n) * card.spacing_mm);
            let place_mm = card.place_mm(&origin_mm, along_mm, axis);
            for (range, place) in marks_mm.iter_mut().zip(place_mm.iter()) {
                *range = [range[0].min(*place), range[1].max(*place)];
            }
        }
    }
    let [centre_mm, half_mm] = input.box_mm;
    (0..3)
        .filter_map(|axis| {
            let below = marks_mm[axis][0] - (centre_mm[axis] - half_mm[axis]);
            let above = centre_mm[axis] + half_mm[axis] - marks_mm[axis][1];
            let by_mm = below.max(above);
            (by_mm > card.spacing_mm).then_some(VolumeWarning::BeyondMarks { axis, by_mm })
        })
        .collect()
}
