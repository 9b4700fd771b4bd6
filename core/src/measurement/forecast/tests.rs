use lfpiv_hw::Pose;
use nalgebra::Vector3;

use super::*;
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

const CONDITIONS: Conditions = Conditions {
    ppm: 0.3,
    intensity_spread: 0.2,
    photoelectrons: 100_000.0,
    background_electrons: 10.0,
    read_noise_electrons: 5.0,
};

fn median(places: &[ForecastPlace], component: usize) -> f64 {
    let mut all: Vec<f64> = places.iter().map(|p| p.uncertainty_vox[component]).collect();
    all.sort_by(f64::total_cmp);
    all[all.len() / 2]
}

#[test]
fn one_camera_knows_depth_badly_and_two_know_all_three() {
    let both = forecast(&bench(test_bench::poses()), &CONDITIONS).unwrap();
    let one = forecast(&bench(test_bench::poses()[..1].to_vec()), &CONDITIONS).unwrap();
    assert_eq!(both.len(), PLACES.pow(3));
    for component in 0..3 {
        assert!(median(&both, component) < median(&one, component));
    }
    assert!(median(&one, 2) > 5.0 * median(&one, 0), "{}", median(&one, 2));
    assert!(median(&both, 2) < 2.0 * median(&both, 0));
}

#[test]
fn less_light_and_fewer_particles_cost_accuracy() {
    let of =
        |seeding: &Conditions| median(&forecast(&bench(test_bench::poses()), seeding).unwrap(), 0);
    let dim = Conditions { photoelectrons: 500.0, ..CONDITIONS };
    assert!(of(&dim) > 3.0 * of(&CONDITIONS), "{} {}", of(&dim), of(&CONDITIONS));
    // Where particles lie over each other more of them do not help: each is known worse.
    let dense = Conditions { ppm: 1.0, ..CONDITIONS };
    let ratio = of(&dense) / of(&CONDITIONS);
    assert!((0.9..1.1).contains(&ratio), "{ratio}");
}

#[test]
fn places_at_the_faces_are_worse_than_inside() {
    let places = forecast(&bench(test_bench::poses()), &CONDITIONS).unwrap();
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
    assert!(forecast(&far, &CONDITIONS).is_err());
    assert_eq!(uncertainty_mm(&Matrix3::zeros()), [f64::INFINITY; 3]);
    let known = Matrix3::from_diagonal(&Vector3::new(4.0, 1.0, 0.25));
    assert_eq!(uncertainty_mm(&known), [0.5, 1.0, 2.0].map(|v: f64| v * 2f64.sqrt()));
}
