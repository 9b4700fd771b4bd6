//! From images of a card to a map of the volume for each camera.

use lfpiv_hw::{
    CameraName, Optics, Pose,
    card::{CalibrationCard, Card, Pattern},
};
use nalgebra::{Point3, Vector3};
use rayon::prelude::*;
use serde::Serialize;

use super::{
    CardLight, ParameterEstimate, VolumeError, VolumeWarning,
    adjustment::{Adjusted, Bench, Sighting},
    coarse_shift::coarse_shift,
    mark_fit::{MarkSearch, SeenMark},
    parameters::{CameraParameters, DESCRIPTIONS},
};
use crate::model::{MapResidual, VolumeMap};

/// Least width of a mark, in microlenses.
const LEAST_MICROLENSES: f64 = 4.0;

/// Least number of positions: depths, and one to leave out.
const LEAST_POSITIONS: usize = 3;

/// Least number of marks of one camera.
const LEAST_MARKS: usize = 20;

/// A card whose image correlates less with what is expected is not there.
const LEAST_CORRELATION: f64 = 0.3;

/// A fiducial that is not seen leaves the next place within this of the best one.
const AMBIGUOUS_WITHIN: f64 = 0.002;

/// Most pixels for one mark, in the first and in the second pass.
const PIXELS: [usize; 2] = [2_000, 8_000];

/// Light this far about a rendered mark is not that mark's.
const MOST_MISFIT: f64 = 0.25;

/// Degree of the polynomials of a map: with it distortion is followed to a micrometre.
const MAP_DEGREE: usize = 4;

/// Held-out marks of a flat card on a good stage, in microlenses.
const USUAL_HELD_OUT: f64 = 0.05;

/// Passes that leave outliers out.
const OUTLIER_PASSES: usize = 3;

/// What a calibration is made from.
#[derive(Debug, Clone, Copy)]
pub struct VolumeInput<'a> {
    /// The optics as drawn, which all cameras share.
    pub optics: &'a Optics,
    /// Where the cameras should stand.
    pub poses: &'a [Pose],
    /// The card and its places.
    pub card: &'a CalibrationCard,
    /// The card's light, by position and then by camera.
    pub light: &'a [Vec<CardLight<'a>>],
    /// Standard deviation of the card's true places beside those told, along each axis, in mm; zero takes
    /// them as they are.
    pub stage_deviation_mm: f64,
    /// Middle and half the edges of the box that the maps must hold in, in mm.
    pub box_mm: [[f64; 3]; 2],
}

/// Both cameras, as the card shows them.
#[derive(Debug, Clone)]
pub struct VolumeCalibration {
    /// In the order of the poses.
    pub cameras: Vec<CalibratedCamera>,
    /// Marks of positions that were left out one by one.
    pub held_out: HeldOut,
    /// Of the normal matrix, with every parameter in prior standard deviations.
    pub condition_number: f64,
    /// How far the card was from each told place, in mm; zero where the stage is taken as it is.
    pub stage_mm: Vec<[f64; 3]>,
    /// What it cannot vouch for.
    pub warnings: Vec<VolumeWarning>,
}

/// One camera.
#[derive(Debug, Clone)]
pub struct CalibratedCamera {
    /// What an ideal camera as drawn would see in place of the volume's points.
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
    /// Place on the microlens plane, in mm along `right` and `up`.
    pub place_mm: [f64; 2],
    /// Seen less expected, in microlenses.
    pub residual_microlenses: [f64; 2],
}

/// How well marks are foretold at positions that the fit did not know: root mean squares of one
/// coordinate, in microlenses.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct HeldOut {
    /// Of a mark's mean over all views.
    pub mean_microlenses: f64,
    /// Of a mark in a single view.
    pub view_microlenses: f64,
    /// Marks that were foretold.
    pub marks: usize,
}

/// Fits both cameras to images of a card.
///
/// # Errors
/// [`VolumeError`]: numbers that do not belong together, a card that is not seen, or too little of it.
pub fn calibrate_volume(input: &VolumeInput<'_>) -> Result<VolumeCalibration, VolumeError> {
    check(input)?;
    let origins_mm: Vec<Point3<f64>> =
        input.card.position.iter().map(|position| Point3::from(position.origin_mm)).collect();
    let bench = Bench {
        optics: input.optics,
        poses: input.poses,
        walls: &input.card.wall,
        card: &input.card.card,
        origins_mm: &origins_mm,
        stage_deviation_mm: input.stage_deviation_mm,
    };
    let mut warnings = Vec::new();
    let mut sightings = first_pass(input, &bench, &mut warnings)?;
    let adjusted = fitted(&bench, &mut sightings, None)?;
    let mut sightings = second_pass(input, &bench, &adjusted);
    let adjusted = fitted(&bench, &mut sightings, Some(&adjusted))?;
    let held_out = held_out(&bench, &sightings, &adjusted)?;
    let cameras: Vec<CalibratedCamera> = (0..input.poses.len())
        .map(|camera| calibrated(input, &bench, &sightings, &adjusted, camera))
        .collect::<Result<_, _>>()?;
    warnings.extend(doubts(input, &sightings, &adjusted, &held_out));
    Ok(VolumeCalibration {
        cameras,
        held_out,
        condition_number: adjusted.condition_number,
        stage_mm: adjusted.stage_mm.iter().map(|&stage_mm| stage_mm.into()).collect(),
        warnings,
    })
}

fn check(input: &VolumeInput<'_>) -> Result<(), VolumeError> {
    let (cameras, positions) = (input.poses.len(), input.card.position.len());
    let numbers = |what, found, expected, each| {
        if found == expected {
            Ok(())
        } else {
            Err(VolumeError::Numbers { what, found, expected, each })
        }
    };
    numbers("images of positions", input.light.len(), positions, "position of the card")?;
    for lights in input.light {
        numbers("images of one position", lights.len(), cameras, "camera")?;
    }
    if !input.card.wall.is_empty() {
        numbers("[[wall]] tables", input.card.wall.len(), cameras, "camera")?;
    }
    if positions < LEAST_POSITIONS {
        return Err(VolumeError::FewPositions { found: positions });
    }
    let card = &input.card.card;
    let mark_mm = match card.pattern {
        Pattern::Dots => card.dot_diameter_mm,
        Pattern::Checkerboard => card.spacing_mm,
    };
    let microlenses = mark_mm / input.optics.object_pitch_mm();
    if microlenses < LEAST_MICROLENSES {
        return Err(VolumeError::SmallMarks { mark_mm, microlenses });
    }
    for (camera, pose) in input.poses.iter().enumerate() {
        let towards = card.normal().dot(&pose.axis);
        if towards.abs() < 0.1 || (towards < 0.0 && card.two_sided_mm.is_none()) {
            return Err(VolumeError::WrongSide { camera: CameraName(camera) });
        }
    }
    Ok(())
}

/// Looks for the card about where the drawing puts it, then for its marks.
fn first_pass(
    input: &VolumeInput<'_>,
    bench: &Bench<'_>,
    warnings: &mut Vec<VolumeWarning>,
) -> Result<Vec<Sighting>, VolumeError> {
    let mut sightings = Vec::new();
    for (position, lights) in input.light.iter().enumerate() {
        for (camera, light) in lights.iter().enumerate() {
            let model = bench.model(camera, CameraParameters::default());
            let origin_mm = &bench.origins_mm[position];
            let name = CameraName(camera);
            let found = coarse_shift(light, &model, bench.card, origin_mm);
            let correlation = found.map_or(0.0, |found| found.correlation);
            let Some(found) = found.filter(|found| found.correlation >= LEAST_CORRELATION) else {
                return Err(VolumeError::CardNotFound {
                    camera: name,
                    position: position + 1,
                    correlation,
                });
            };
            if found.correlation - found.next_correlation < AMBIGUOUS_WITHIN {
                warnings.push(VolumeWarning::Ambiguous { camera: name, position: position + 1 });
            }
            let search = MarkSearch {
                light,
                model: &model,
                card: bench.card,
                origin_mm,
                shift_mm: found.shift_mm,
                most_pixels: PIXELS[0],
            };
            sightings.push(Sighting { camera, position, marks: seen_marks(&search, bench.card) });
        }
    }
    Ok(sightings)
}

/// Looks for marks where the fitted cameras see them.
fn second_pass(input: &VolumeInput<'_>, bench: &Bench<'_>, adjusted: &Adjusted) -> Vec<Sighting> {
    let mut sightings = Vec::new();
    for (position, lights) in input.light.iter().enumerate() {
        for (camera, light) in lights.iter().enumerate() {
            let model = bench.model(camera, adjusted.cameras[camera]);
            let origin_mm = bench.origins_mm[position] + adjusted.stage_mm[position];
            let search = MarkSearch {
                light,
                model: &model,
                card: bench.card,
                origin_mm: &origin_mm,
                shift_mm: [0.0; 2],
                most_pixels: PIXELS[1],
            };
            sightings.push(Sighting { camera, position, marks: seen_marks(&search, bench.card) });
        }
    }
    sightings
}

fn seen_marks(search: &MarkSearch<'_>, card: &Card) -> Vec<SeenMark> {
    let numbers: Vec<[i32; 2]> = card.numbers().collect();
    numbers
        .into_par_iter()
        .filter_map(|number| search.fit(number))
        .filter(|mark| mark.misfit < MOST_MISFIT)
        .collect()
}

/// Adjusts, leaving outliers out.
fn fitted(
    bench: &Bench<'_>,
    sightings: &mut [Sighting],
    start: Option<&Adjusted>,
) -> Result<Adjusted, VolumeError> {
    for camera in 0..bench.poses.len() {
        let of_camera = sightings.iter().filter(|sighting| sighting.camera == camera);
        let found: usize = of_camera.map(|sighting| sighting.marks.len()).sum();
        if found < LEAST_MARKS {
            let camera = CameraName(camera);
            return Err(VolumeError::FewMarks { camera, found, needed: LEAST_MARKS });
        }
    }
    let mut adjusted = bench.adjust(sightings, start)?;
    for _ in 0..OUTLIER_PASSES {
        if !bench.drop_outliers(sightings, &adjusted) {
            break;
        }
        adjusted = bench.adjust(sightings, Some(&adjusted))?;
    }
    Ok(adjusted)
}

/// Leaves out one position after the other, but not the first and the last: nobody measures beyond the
/// card.
fn held_out(
    bench: &Bench<'_>,
    sightings: &[Sighting],
    all: &Adjusted,
) -> Result<HeldOut, VolumeError> {
    let inner: Vec<usize> = (1..bench.origins_mm.len() - 1).collect();
    let sums: Vec<[f64; 3]> = inner
        .into_par_iter()
        .map(|position| {
            let others: Vec<Sighting> = sightings
                .iter()
                .filter(|sighting| sighting.position != position)
                .cloned()
                .collect();
            let adjusted = bench.adjust(&others, Some(all))?;
            let mut sums = [0.0; 3];
            for sighting in sightings.iter().filter(|sighting| sighting.position == position) {
                for (mark, off) in residuals(bench, sighting, &adjusted, &Vector3::zeros()) {
                    // Over a disc of radius R the mean square of either coordinate is R²/4.
                    let radius_mm = bench.optics.pupil_diameter_mm() / 2.0;
                    let mean: f64 = off[0].iter().map(|mm| mm * mm).sum();
                    let leaning: f64 =
                        off[1].iter().map(|slope| (slope * radius_mm).powi(2) / 4.0).sum();
                    sums[0] += mean;
                    sums[1] += mean + leaning + 2.0 * mark.views_rms_mm * mark.views_rms_mm;
                    sums[2] += 1.0;
                }
            }
            Ok(sums)
        })
        .collect::<Result<_, VolumeError>>()?;
    let [mean, view, marks] =
        sums.iter().fold([0.0; 3], |sum, part| std::array::from_fn(|n| sum[n] + part[n]));
    let pitch_mm = bench.optics.microlens.pitch_mm;
    let rms = |squares: f64| (squares / (2.0 * marks.max(1.0))).sqrt() / pitch_mm;
    Ok(HeldOut { mean_microlenses: rms(mean), view_microlenses: rms(view), marks: marks as usize })
}

/// Seen less expected of every mark: places in mm and slopes.
fn residuals<'a>(
    bench: &'a Bench<'a>,
    sighting: &'a Sighting,
    adjusted: &Adjusted,
    stage_mm: &'a Vector3<f64>,
) -> impl Iterator<Item = (&'a SeenMark, [[f64; 2]; 2])> + use<'a> {
    let model = bench.model(sighting.camera, adjusted.cameras[sighting.camera]);
    sighting.marks.iter().filter_map(move |mark| {
        let [place_mm, slopes] =
            bench.expected(&model, sighting.position, stage_mm, mark.number)?;
        let off = [
            [mark.place_mm[0] - place_mm[0], mark.place_mm[1] - place_mm[1]],
            [mark.slopes[0] - slopes[0], mark.slopes[1] - slopes[1]],
        ];
        Some((mark, off))
    })
}

fn calibrated(
    input: &VolumeInput<'_>,
    bench: &Bench<'_>,
    sightings: &[Sighting],
    adjusted: &Adjusted,
    camera: usize,
) -> Result<CalibratedCamera, VolumeError> {
    let model = bench.model(camera, adjusted.cameras[camera]);
    let [centre_mm, half_mm] = input.box_mm;
    let seen = |world_mm: [f64; 3]| model.equivalent(&Point3::from(world_mm));
    let (map, map_residual) =
        VolumeMap::fit(centre_mm, half_mm, MAP_DEGREE, seen).ok_or(VolumeError::NoMap)?;
    let pitch_mm = input.optics.microlens.pitch_mm;
    let mut marks = Vec::new();
    for sighting in sightings.iter().filter(|sighting| sighting.camera == camera) {
        let stage_mm = &adjusted.stage_mm[sighting.position];
        for (mark, [place_mm, _]) in residuals(bench, sighting, adjusted, stage_mm) {
            marks.push(MarkResidual {
                position: sighting.position,
                number: mark.number,
                place_mm: mark.place_mm,
                residual_microlenses: place_mm.map(|mm| mm / pitch_mm),
            });
        }
    }
    let squares: f64 = marks.iter().flat_map(|mark| mark.residual_microlenses).map(|r| r * r).sum();
    Ok(CalibratedCamera {
        map,
        map_residual,
        parameters: estimates(adjusted, camera),
        rms_microlenses: (squares / (2.0 * marks.len() as f64)).sqrt(),
        marks,
    })
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

/// What the calibration cannot vouch for.
fn doubts(
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
