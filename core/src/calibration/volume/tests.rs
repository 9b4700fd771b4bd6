//! Calibration with marks traced by the simulator, without images, and with images (`fiducial`, `images`).

mod fiducial;
mod images;

use lfpiv_hw::{
    Pose,
    card::{Card, Pattern, Wall},
};
use lfpiv_sim::imaging::{CameraFlaws, Distortion, RaySettings, RayTracer, WallSettings};
use nalgebra::{Point3, Vector3};

use super::{
    adjustment::{Adjusted, Bench, Observation, initial_deviations},
    mark_fit::ObservedMark,
};
use crate::{model::EquivalentPoint, test_bench};

/// A camera with all kinds of deviations, behind a tilted wall.
fn flaws() -> CameraFlaws {
    CameraFlaws {
        turn_deg: [0.15, -0.1, 0.2],
        distortion: Distortion { radial: 0.005, tangential: [3e-4, -2e-4] },
        exit_pupil_mm: 20.0,
        wall: Some(WallSettings { tilt_deg: [5.0, 0.0], ..WallSettings::default() }),
        ..CameraFlaws::default()
    }
}

fn walls() -> Vec<Wall> {
    let WallSettings { distance_mm, thickness_mm, glass_index, medium_index, .. } =
        WallSettings::default();
    vec![Wall { distance_mm, thickness_mm, glass_index, medium_index }; 2]
}

fn card() -> Card {
    let half = 0.5f64.sqrt();
    Card {
        pattern: Pattern::Dots,
        spacing_mm: 1.0,
        dot_diameter_mm: 0.5,
        fiducial_diameter_mm: 0.7,
        marks: [9, 9],
        right: Vector3::x(),
        up: Vector3::new(0.0, half, -half),
        two_sided_mm: None,
    }
}

/// Place of a ray of the true camera, for `pupil_mm` on the nominal pupil.
fn place_mm(tracer: &RayTracer<'_>, point_mm: &Point3<f64>, pupil_mm: [f64; 2]) -> [f64; 2] {
    let optics = test_bench::optics();
    let image_mm = optics.image_distance_mm();
    let behind_mm = image_mm - flaws().exit_pupil_mm;
    let magnified =
        (1.0 + optics.microlens.focal_length_mm / behind_mm) / optics.micro_image_magnification();
    let stop_mm = pupil_mm.map(|u| u * behind_mm / image_mm);
    tracer.on_microlenses_mm((*point_mm).into(), stop_mm).unwrap().map(|x| x * magnified)
}

fn place_and_slopes(tracer: &RayTracer<'_>, point_mm: &Point3<f64>) -> [[f64; 2]; 2] {
    let off_mm = test_bench::optics().pupil_diameter_mm() / 4.0;
    let slope = |axis: usize| {
        let through = |sign: f64| {
            let mut pupil_mm = [0.0; 2];
            pupil_mm[axis] = sign * off_mm;
            place_mm(tracer, point_mm, pupil_mm)[axis]
        };
        (through(1.0) - through(-1.0)) / (2.0 * off_mm)
    };
    [place_mm(tracer, point_mm, [0.0; 2]), [slope(0), slope(1)]]
}

/// Traced observations of all marks by both cameras.
fn observations(
    tracers: &[RayTracer<'_>],
    poses: &[Pose],
    origins_mm: &[Point3<f64>],
) -> Vec<Observation> {
    let card = card();
    let mut observations = Vec::new();
    for (camera, tracer) in tracers.iter().enumerate() {
        for (position, origin_mm) in origins_mm.iter().enumerate() {
            let marks = card.numbers().map(|number| {
                let along_mm = number.map(f64::from);
                let point_mm = card.place_mm(origin_mm, along_mm, &poses[camera].axis);
                let [place_mm, slopes] = place_and_slopes(tracer, &point_mm);
                ObservedMark { number, place_mm, slopes, misfit: 0.0, views_rms_mm: 0.0 }
            });
            observations.push(Observation { camera, position, marks: marks.collect() });
        }
    }
    observations
}

/// Largest lateral and depth error of equivalent points, in mm.
fn worst(bench: &Bench<'_>, adjusted: &Adjusted, tracers: &[RayTracer<'_>]) -> [f64; 2] {
    let mut worst = [0.0f64; 2];
    for (camera, tracer) in tracers.iter().enumerate() {
        let model = bench.model(camera, adjusted.cameras[camera]);
        for n in 0..27 {
            let point_mm = Point3::from([n % 3, n / 3 % 3, n / 9].map(|n| f64::from(n - 1) * 3.0));
            let fitted = model.equivalent(&point_mm).unwrap();
            let [place_mm, slopes] = place_and_slopes(tracer, &point_mm);
            let traced = EquivalentPoint::of_rays(bench.optics, place_mm, slopes);
            for axis in 0..2 {
                worst[0] = worst[0].max((fitted.lateral_mm[axis] - traced.lateral_mm[axis]).abs());
                worst[1] = worst[1].max((fitted.depth_mm[axis] - traced.depth_mm[axis]).abs());
            }
        }
    }
    worst
}

#[test]
fn a_tilted_wall_and_all_other_deviations_are_fitted_to_a_micrometre() {
    let (optics, poses, walls, card) = (test_bench::optics(), test_bench::poses(), walls(), card());
    let settings = RaySettings { rays_per_particle: 16, diffraction_nm: None };
    let shifts = [[0.0; 3], [0.2, 0.1, -0.15]];
    let tracers: Vec<RayTracer<'_>> = (0..2)
        .map(|n| RayTracer::imperfect(&optics, &poses[n], shifts[n], &flaws(), &settings))
        .collect();
    let along = card.normal();
    let origins_mm: Vec<Point3<f64>> =
        (-3..=3).map(|step| Point3::from(along * f64::from(step))).collect();
    let observations = observations(&tracers, &poses, &origins_mm);
    let mut bench = Bench {
        optics: &optics,
        poses: &poses,
        walls: &walls,
        card: &card,
        origins_mm: &origins_mm,
        stage_deviation_mm: 0.0,
        deviations: initial_deviations(&optics),
    };
    bench.deviations = bench.deviations.map(|deviation| deviation / 10.0);
    let adjusted = bench.adjust(&observations, None).unwrap();
    let [lateral_mm, depth_mm] = worst(&bench, &adjusted, &tracers);
    assert!(lateral_mm < 1e-3 && depth_mm < 1e-2, "{lateral_mm} {depth_mm}");
    assert!(adjusted.condition_number.is_finite());
    for parameters in &adjusted.cameras {
        let [tilt, across] = parameters.wall_tilt_rad().map(f64::to_degrees);
        assert!((tilt - 5.0).abs() < 0.3 && across.abs() < 0.3, "{tilt} {across}");
    }
}
