//! From images of a card to a map of the volume for each camera.

use lfpiv_hw::{CameraName, card::Card};
use nalgebra::Point3;
use rayon::prelude::*;

use super::{
    CalibratedCamera, HeldOut, VolumeError, VolumeInput, VolumeWarning,
    adjustment::{Adjusted, Bench, Sighting, first_deviations},
    checks,
    coarse_shift::coarse_shifts,
    fiducial::LEAST_CLARITY,
    held_out::held_out,
    mark_fit::{MarkSearch, SeenMark},
    parameters::CameraParameters,
};

/// Least number of marks of one camera.
const LEAST_MARKS: usize = 20;

/// A card whose image correlates less with what is expected is not there.
const LEAST_CORRELATION: f64 = 0.3;

/// Most pixels for one mark, in the first and in the second pass.
const PIXELS: [usize; 2] = [2_000, 20_000];

/// Light this far about a rendered mark is not that mark's.
const MOST_MISFIT: f64 = 0.25;

/// Passes that leave outliers out and weigh the rest anew.
const OUTLIER_PASSES: usize = 4;

/// Weights that change by less than this share are the last.
const SETTLED: f64 = 0.2;

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

/// Fits both cameras to images of a card; calls `step_ended` after each of the [`VolumeInput::steps`].
///
/// # Errors
/// [`VolumeError`]: numbers that do not belong together, a card that is not seen, or too little of it.
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
        deviations: first_deviations(input.optics),
    };
    let mut warnings = Vec::new();
    let mut sightings = first_pass(input, &bench, &mut warnings, &mut step_ended)?;
    let adjusted = fitted(&mut bench, &mut sightings, None)?;
    step_ended();
    let mut sightings = second_pass(input, &bench, &adjusted, &mut step_ended);
    let adjusted = fitted(&mut bench, &mut sightings, Some(&adjusted))?;
    step_ended();
    let held_out = held_out(&bench, &sightings, &adjusted)?;
    step_ended();
    let cameras: Vec<CalibratedCamera> = (0..input.poses.len())
        .map(|camera| CalibratedCamera::of(input, &bench, &sightings, &adjusted, camera))
        .collect::<Result<_, _>>()?;
    step_ended();
    warnings.extend(checks::warnings(input, &sightings, &adjusted, &held_out));
    Ok(VolumeCalibration {
        cameras,
        held_out,
        condition_number: adjusted.condition_number,
        stage_mm: adjusted.stage_mm.iter().map(|&stage_mm| stage_mm.into()).collect(),
        warnings,
    })
}

/// Looks for the card about where the drawing puts it, then for its marks.
fn first_pass(
    input: &VolumeInput<'_>,
    bench: &Bench<'_>,
    warnings: &mut Vec<VolumeWarning>,
    step_ended: &mut impl FnMut(),
) -> Result<Vec<Sighting>, VolumeError> {
    let mut sightings = Vec::new();
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
        if found.clarity < LEAST_CLARITY {
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
            sightings.push(Sighting { camera, position, marks: seen_marks(&search, bench.card) });
            step_ended();
        }
    }
    Ok(sightings)
}

/// Looks for marks where the fitted cameras see them.
fn second_pass(
    input: &VolumeInput<'_>,
    bench: &Bench<'_>,
    adjusted: &Adjusted,
    step_ended: &mut impl FnMut(),
) -> Vec<Sighting> {
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
            step_ended();
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

/// Adjusts, leaving outliers out, and weighs marks as they scatter.
fn fitted(
    bench: &mut Bench<'_>,
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
        let dropped = bench.drop_outliers(sightings, &adjusted);
        let before = bench.deviations;
        bench.weigh(sightings, &adjusted);
        let settled = (0..2).all(|n| (bench.deviations[n] / before[n] - 1.0).abs() < SETTLED);
        if settled && !dropped {
            break;
        }
        adjusted = bench.adjust(sightings, Some(&adjusted))?;
    }
    Ok(adjusted)
}
