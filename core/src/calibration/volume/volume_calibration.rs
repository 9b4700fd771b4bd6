//! Calibration of all cameras: from images of a card to a map of the volume for each camera.

use lfpiv_hw::{CameraName, card::Card};
use nalgebra::Point3;
use rayon::prelude::*;

use super::{
    CalibratedCamera, HeldOut, VolumeError, VolumeInput, VolumeWarning,
    adjustment::{Adjusted, Bench, Observation, initial_deviations},
    checks,
    coarse_shift::coarse_shifts,
    fiducial::LEAST_SIGNIFICANCE,
    held_out::held_out,
    mark_fit::{MarkSearch, ObservedMark},
    parameters::CameraParameters,
};

/// Least number of marks of one camera.
const LEAST_MARKS: usize = 20;

/// Least correlation coefficient of an image with the predicted card.
const LEAST_CORRELATION: f64 = 0.3;

/// Largest number of pixels for one mark in the first and second pass.
const PIXELS: [usize; 2] = [2_000, 20_000];

/// Largest relative residual of a rendered mark.
const MOST_MISFIT: f64 = 0.25;

/// Largest number of iterations of outlier rejection and reweighting.
const OUTLIER_PASSES: usize = 4;

/// Relative change of the standard deviations at convergence.
const CONVERGED: f64 = 0.2;

/// Result of a volume calibration.
#[derive(Debug, Clone)]
pub struct VolumeCalibration {
    /// The cameras in the order of the poses.
    pub cameras: Vec<CalibratedCamera>,
    /// Prediction errors by leave-one-out cross-validation over positions.
    pub held_out: HeldOut,
    /// Condition number of the normal matrix, with parameters in prior standard deviations.
    pub condition_number: f64,
    /// Fitted minus stated positions of the card, in mm; 0 for an exact stage.
    pub stage_mm: Vec<[f64; 3]>,
    /// Reasons to doubt the result.
    pub warnings: Vec<VolumeWarning>,
}

/// Fits all cameras to images of a card. Calls `step_ended` after each of the [`VolumeInput::steps`].
///
/// # Errors
/// [`VolumeError`]: numbers do not match, the card or too few of its marks are found, or no camera fits them.
pub fn calibrate_volume(
    input: &VolumeInput<'_>,
    mut step_ended: impl FnMut(),
) -> Result<VolumeCalibration, VolumeError> {
    input.check()?;
    let origins_mm: Vec<Point3<f64>> =
        input.card.position.iter().map(|position| Point3::from(position.origin_mm)).collect();
    let mut bench = Bench {
        optics: input.optics,
        poses: input.poses,
        walls: &input.card.wall,
        card: &input.card.card,
        origins_mm: &origins_mm,
        stage_deviation_mm: input.stage_deviation_mm,
        deviations: initial_deviations(input.optics),
    };
    let mut warnings = Vec::new();
    let mut observations = first_pass(input, &bench, &mut warnings, &mut step_ended)?;
    let adjusted = fitted(&mut bench, &mut observations, None)?;
    step_ended();
    let mut observations = second_pass(input, &bench, &adjusted, &mut step_ended);
    let adjusted = fitted(&mut bench, &mut observations, Some(&adjusted))?;
    step_ended();
    let held_out = held_out(&bench, &observations, &adjusted)?;
    step_ended();
    let cameras: Vec<CalibratedCamera> = (0..input.poses.len())
        .map(|camera| CalibratedCamera::of(input, &bench, &observations, &adjusted, camera))
        .collect::<Result<_, _>>()?;
    step_ended();
    warnings.extend(checks::warnings(input, &observations, &adjusted, &held_out));
    Ok(VolumeCalibration {
        cameras,
        held_out,
        condition_number: adjusted.condition_number,
        stage_mm: adjusted.stage_mm.iter().map(|&stage_mm| stage_mm.into()).collect(),
        warnings,
    })
}

/// Locates the card near its nominal location in the images, and measures its marks.
fn first_pass(
    input: &VolumeInput<'_>,
    bench: &Bench<'_>,
    warnings: &mut Vec<VolumeWarning>,
    step_ended: &mut impl FnMut(),
) -> Result<Vec<Observation>, VolumeError> {
    let mut observations = Vec::new();
    for camera in 0..input.poses.len() {
        let name = CameraName(camera);
        let model = bench.model(camera, CameraParameters::default());
        let images: Vec<_> = input
            .light
            .iter()
            .zip(bench.origins_mm)
            .map(|(lights, origin_mm)| (&lights[camera], *origin_mm))
            .collect();
        let found = coarse_shifts(&images, &model, bench.card)
            .ok_or(VolumeError::FewPositions { found: 0 })?;
        let worst = (0..images.len())
            .min_by(|&a, &b| found.correlations[a].total_cmp(&found.correlations[b]));
        if let Some(worst) = worst
            && found.correlations[worst] < LEAST_CORRELATION
        {
            return Err(VolumeError::CardNotFound {
                camera: name,
                position: worst + 1,
                correlation: found.correlations[worst],
            });
        }
        if found.significance < LEAST_SIGNIFICANCE {
            warnings.push(VolumeWarning::Ambiguous { camera: name });
        }
        for (position, (light, origin_mm)) in images.iter().enumerate() {
            let search = MarkSearch {
                light,
                model: &model,
                card: bench.card,
                origin_mm,
                shift_mm: found.shifts_mm[position],
                most_pixels: PIXELS[0],
            };
            observations.push(Observation {
                camera,
                position,
                marks: observed_marks(&search, bench.card),
            });
            step_ended();
        }
    }
    Ok(observations)
}

/// Measures the marks near the locations predicted by the fitted cameras.
fn second_pass(
    input: &VolumeInput<'_>,
    bench: &Bench<'_>,
    adjusted: &Adjusted,
    step_ended: &mut impl FnMut(),
) -> Vec<Observation> {
    let mut observations = Vec::new();
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
            observations.push(Observation {
                camera,
                position,
                marks: observed_marks(&search, bench.card),
            });
            step_ended();
        }
    }
    observations
}

/// Measures all marks of the card in one image.
fn observed_marks(search: &MarkSearch<'_>, card: &Card) -> Vec<ObservedMark> {
    let numbers: Vec<[i32; 2]> = card.numbers().collect();
    numbers
        .into_par_iter()
        .filter_map(|number| search.fit(number))
        .filter(|mark| mark.misfit < MOST_MISFIT)
        .collect()
}

/// Fits the cameras, with iterated outlier rejection and weights from the scatter of the marks.
fn fitted(
    bench: &mut Bench<'_>,
    observations: &mut [Observation],
    start: Option<&Adjusted>,
) -> Result<Adjusted, VolumeError> {
    for camera in 0..bench.poses.len() {
        let of_camera = observations.iter().filter(|observation| observation.camera == camera);
        let found: usize = of_camera.map(|observation| observation.marks.len()).sum();
        if found < LEAST_MARKS {
            let camera = CameraName(camera);
            return Err(VolumeError::FewMarks { camera, found, needed: LEAST_MARKS });
        }
    }
    let mut adjusted = bench.adjust(observations, start)?;
    for _ in 0..OUTLIER_PASSES {
        let dropped = bench.drop_outliers(observations, &adjusted);
        let before = bench.deviations;
        bench.update_deviations(observations, &adjusted);
        let converged = (0..2).all(|n| (bench.deviations[n] / before[n] - 1.0).abs() < CONVERGED);
        if converged && !dropped {
            break;
        }
        adjusted = bench.adjust(observations, Some(&adjusted))?;
    }
    Ok(adjusted)
}
