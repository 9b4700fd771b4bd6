//! Warnings of a finished calibration.

use lfpiv_hw::CameraName;
use nalgebra::Point3;

use super::{
    HeldOut, VolumeInput, VolumeWarning,
    adjustment::{Adjusted, Observation},
    parameters::DESCRIPTIONS,
};

/// Largest residual of held-out marks for a flat card on an accurate stage, in microlenses.
const MOST_HELD_OUT: f64 = 0.05;

/// Warnings about large residuals, parameters far from their priors, and a volume beyond the marks.
pub(super) fn warnings(
    input: &VolumeInput<'_>,
    observations: &[Observation],
    adjusted: &Adjusted,
    held_out: &HeldOut,
) -> Vec<VolumeWarning> {
    let mut warnings = Vec::new();
    if held_out.mean_microlenses > MOST_HELD_OUT {
        warnings.push(VolumeWarning::HeldOutFar {
            microlenses: held_out.mean_microlenses,
            usual: MOST_HELD_OUT,
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
    warnings.extend(beyond_marks(input, observations));
    warnings
}

/// Warnings for axes along which the box extends more than a spacing beyond the marks.
fn beyond_marks(input: &VolumeInput<'_>, observations: &[Observation]) -> Vec<VolumeWarning> {
    let card = &input.card.card;
    let mut marks_mm = [[f64::INFINITY, f64::NEG_INFINITY]; 3];
    for observation in observations {
        let origin_mm = Point3::from(input.card.position[observation.position].origin_mm);
        let axis = &input.poses[observation.camera].axis;
        for mark in &observation.marks {
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
