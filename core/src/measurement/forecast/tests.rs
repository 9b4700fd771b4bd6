use lfpiv_hw::Pose;
use nalgebra::{Matrix3, Vector3};

use super::{
    bound::{PLACES, uncertainty_mm},
    *,
};
use crate::{
    lightfield::ImageSettings,
    model::{ModelSettings, VolumeGrid},
    reconstruction::ReconstructionSettings,
    test_bench,
    velocimetry::VelocimetrySettings,
};

fn bench(cameras: Vec<Pose>) -> Measurement {
    Measurement {
        optics: test_bench::optics(),
        cameras,
        calibrations: Vec::new(),
        volume: VolumeGrid { voxels: [60, 50, 50], voxel_mm: 0.1, centre_mm: [0.0; 3] },
        mask: None,
        image: ImageSettings::default(),
        model: ModelSettings::default(),
        reconstruction: ReconstructionSettings::default(),
        velocimetry: VelocimetrySettings::default(),
        spacing_mm: None,
        dt_s: 1e-4,
    }
}

const CONDITIONS: SceneConditions = SceneConditions {
    ppm: 0.3,
    intensity_spread: 0.2,
    photoelectrons: 100_000.0,
    background_electrons: 10.0,
    read_noise_electrons: 5.0,
    counts_per_electron: 1.0,
    offset_counts: 64.0,
    saturation_counts: 4095,
    diffraction_nm: None,
};

fn median(places: &[ForecastPlace], component: usize) -> f64 {
    let mut all: Vec<f64> = places.iter().map(|p| p.uncertainty_vox[component]).collect();
    all.sort_by(f64::total_cmp);
    all[all.len() / 2]
}

#[test]
fn one_camera_knows_depth_badly_and_two_know_all_three() {
    let both = bound(&bench(test_bench::poses()), &CONDITIONS).unwrap();
    let one = bound(&bench(test_bench::poses()[..1].to_vec()), &CONDITIONS).unwrap();
    assert_eq!(both.len(), PLACES.pow(3));
    for component in 0..3 {
        assert!(median(&both, component) < median(&one, component));
    }
    assert!(median(&one, 2) > 5.0 * median(&one, 0), "{}", median(&one, 2));
    assert!(median(&both, 2) < 2.0 * median(&both, 0));
}

#[test]
fn less_light_and_fewer_particles_cost_accuracy() {
    let of = |seeding: &SceneConditions| {
        median(&bound(&bench(test_bench::poses()), seeding).unwrap(), 0)
    };
    let dim = SceneConditions { photoelectrons: 500.0, ..CONDITIONS };
    assert!(of(&dim) > 3.0 * of(&CONDITIONS), "{} {}", of(&dim), of(&CONDITIONS));
    // Where particles lie over each other more of them do not help: each is known worse.
    let dense = SceneConditions { ppm: 1.0, ..CONDITIONS };
    let ratio = of(&dense) / of(&CONDITIONS);
    assert!((0.9..1.1).contains(&ratio), "{ratio}");
}

#[test]
fn places_at_the_faces_are_worse_than_inside() {
    let places = bound(&bench(test_bench::poses()), &CONDITIONS).unwrap();
    let mean = |is_edge: bool| {
        let chosen: Vec<f64> = places
            .iter()
            .filter(|place| (place.position_mm[0].abs() > 2.5) == is_edge)
            .map(|place| place.uncertainty_vox[0])
            .collect();
        chosen.iter().sum::<f64>() / chosen.len() as f64
    };
    assert!(mean(true) > 1.1 * mean(false), "{} {}", mean(true), mean(false));
}

/// A camera that looks away has no say, and a volume that nobody sees is refused.
#[test]
fn a_volume_out_of_view_is_refused() {
    let mut far = bench(test_bench::poses());
    far.volume.centre_mm = [100.0, 0.0, 0.0];
    assert!(bound(&far, &CONDITIONS).is_err());
    assert_eq!(uncertainty_mm(&Matrix3::zeros()), [f64::INFINITY; 3]);
    let known = Matrix3::from_diagonal(&Vector3::new(4.0, 1.0, 0.25));
    assert_eq!(uncertainty_mm(&known), [0.5, 1.0, 2.0].map(|v: f64| v * 2f64.sqrt()));
}

/// A bench whose pairs are quick to image and to measure.
fn small() -> Measurement {
    let volume = VolumeGrid { voxels: [40, 32, 40], ..bench(Vec::new()).volume };
    Measurement { volume, ..bench(test_bench::poses()) }
}

fn root_mean_square(forecast: &Forecast, component: usize) -> f64 {
    let squares = forecast.places.iter().map(|place| place.uncertainty_vox[component].powi(2));
    (squares.sum::<f64>() / forecast.places.len() as f64).sqrt()
}

/// The forecast of the small bench from two pairs.
fn of_two_pairs(conditions: &SceneConditions) -> Forecast {
    after_pairs(&SimulatedBench::new(&small(), conditions).unwrap(), 2).unwrap()
}

#[test]
fn trials_are_worse_than_the_bound_and_the_same_every_time() {
    let trials = of_two_pairs(&CONDITIONS);
    assert_eq!(trials, of_two_pairs(&CONDITIONS));
    assert!(trials.valid_share > 0.9 && trials.pairs == 2, "{trials:?}");
    let held = bound(&small(), &CONDITIONS).unwrap();
    for component in 0..3 {
        let (expected, least) = (root_mean_square(&trials, component), median(&held, component));
        assert!(expected > least && expected < 0.1, "{expected} {least}");
    }
    // A few electrons in a pixel are below the noise: hardly a vector is valid.
    let dark = SceneConditions { photoelectrons: 3000.0, counts_per_electron: 4.0, ..CONDITIONS };
    let dark = of_two_pairs(&dark);
    assert!(dark.valid_share < 0.1, "{dark:?}");
}

/// What is lit in a pixel, summed over the image, is the light of its particles.
#[test]
fn exposures_have_the_light_of_their_sources() {
    let (bench, dark) = (small(), SceneConditions { read_noise_electrons: 0.0, ..CONDITIONS });
    let exposures = exposure::Exposures::new(&bench, &dark).unwrap();
    let sum = |sources: &[exposure::PointSource]| -> f64 {
        let image = exposures.image(1, sources, 7);
        image.counts().iter().map(|&count| f64::from(count)).sum()
    };
    let source =
        |x: f64, brightness: f64| exposure::PointSource { at_mm: [x, 0.4, -0.7], brightness };
    let light = sum(&[source(0.3, 1.0), source(-0.9, 0.5)]) - sum(&[]);
    // Both images have the same stationary light and, where there is no particle, the same noise.
    assert!((light / (1.5 * dark.photoelectrons) - 1.0).abs() < 0.02, "{light}");
}
