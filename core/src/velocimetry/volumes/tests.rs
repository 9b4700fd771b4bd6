mod plane;

use rand::{RngExt, SeedableRng};
use rand_pcg::Pcg64Mcg;

use super::*;
use crate::velocimetry::{
    PointCloud, VectorStatus,
    test_data::{DarkThird, Particles, error_vox, frames, waves},
};

const GRID: VolumeGrid = VolumeGrid { voxels: [80, 64, 56], voxel_mm: 0.1, centre_mm: [0.0; 3] };

/// Particles rendered before and after `flow` (voxels, of the place in the middle) has moved them.
fn pair(seed: u64, flow: impl Fn([f64; 3]) -> [f64; 3]) -> [DenseVolume; 2] {
    rendered(&GRID, &frames(seed, &GRID, 3500, flow))
}

fn rendered(grid: &VolumeGrid, frames: &[Particles; 2]) -> [DenseVolume; 2] {
    frames.each_ref().map(|particles| {
        let intensity = PointCloud::from_particles(particles, grid).render(grid);
        DenseVolume { grid: grid.clone(), intensity }
    })
}

fn settings() -> VelocimetrySettings {
    VelocimetrySettings { passes: 4, ..VelocimetrySettings::default() }
}

fn measured(pair: &[DenseVolume; 2]) -> VelocityField {
    VolumeInterrogation::new(&GRID, &settings()).measure(&pair[0], &pair[1], 1e-4)
}

/// Errors of all components, with their standard uncertainty.
fn errors(field: &VelocityField, flow: impl Fn([f64; 3]) -> [f64; 3]) -> Vec<[f64; 2]> {
    (0..field.grid.len())
        .flat_map(|n| {
            let (error, sigma) = (error_vox(field, &GRID, &flow, n), field.uncertainty_vox[n]);
            (0..3).map(move |c| [error[c].abs(), f64::from(sigma[c])])
        })
        .collect()
}

fn mean_error(errors: &[[f64; 2]]) -> f64 {
    errors.iter().map(|[error, _]| error).sum::<f64>() / errors.len() as f64
}

#[test]
fn even_displacements_are_found_to_some_hundredths_of_a_voxel() {
    for shift in [[0.0; 3], [0.5, -0.5, 0.25], [5.7, -3.2, 1.4]] {
        let field = measured(&pair(1, |_| shift));
        let errors = errors(&field, |_| shift);
        let valid = field.status.iter().filter(|status| **status == VectorStatus::Valid).count();
        // Next to a face much of what moves by six voxels is seen once.
        assert!(valid as f64 > 0.97 * field.grid.len() as f64, "{shift:?}: {valid} valid");
        assert!(mean_error(&errors) < 0.03, "{shift:?}: {}", mean_error(&errors));
    }
}

#[test]
fn a_smooth_flow_is_found_in_the_middle_of_the_pair() {
    let errors = errors(&measured(&pair(2, waves)), waves);
    assert!(mean_error(&errors) < 0.05, "{}", mean_error(&errors));
}

#[test]
fn frames_that_change_places_turn_the_field_round() {
    let [a, b] = pair(3, waves);
    let [there, back] = [measured(&[a.clone(), b.clone()]), measured(&[b, a])];
    let apart = there.displacement_vox.iter().flatten().zip(back.displacement_vox.iter().flatten());
    let mean = apart.map(|(there, back)| (there + back).abs()).sum::<f32>()
        / (3 * there.grid.len()) as f32;
    assert!(mean < 0.06, "{mean}");
}

#[test]
fn intervals_hold_what_they_say() {
    let mut all = Vec::new();
    for seed in 4..8 {
        all.extend(errors(&measured(&pair(seed, waves)), waves));
    }
    let within = |k: f64| {
        all.iter().filter(|[error, sigma]| *error <= k * sigma).count() as f64 / all.len() as f64
    };
    println!("{:.3} within one, {:.3} within two", within(1.0), within(1.96));
    assert!((within(1.0) - 0.68).abs() < 0.08 && (within(1.96) - 0.95).abs() < 0.08);
}

#[test]
fn threads_change_nothing() {
    let pair = pair(9, waves);
    let with = |threads: usize| {
        let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().unwrap();
        pool.install(|| measured(&pair))
    };
    assert_eq!(with(1), with(3));
}

#[test]
fn noise_alone_gives_no_valid_vector_and_darkness_none_at_all() {
    let mut random = Pcg64Mcg::seed_from_u64(10);
    let mut noise = || DenseVolume {
        grid: GRID,
        intensity: (0..GRID.len()).map(|_| random.random()).collect(),
    };
    let field = measured(&[noise(), noise()]);
    let valid = field.status.iter().filter(|status| **status == VectorStatus::Valid).count();
    assert_eq!(valid, 0, "of {}", field.grid.len());
    assert!(field.displacement_vox.as_flattened().iter().all(|v| v.is_finite()));
    let dark = DenseVolume { grid: GRID, intensity: vec![0.0; GRID.len()] };
    for light in [0.0, 3.0] {
        let even = DenseVolume { grid: GRID, intensity: vec![light; GRID.len()] };
        let field = measured(&[dark.clone(), even]);
        assert!(field.status.iter().all(|status| *status == VectorStatus::Invalid));
        assert!(field.displacement_vox.iter().all(|v| *v == [0.0; 3]));
    }
}

#[test]
fn windows_of_any_size_and_overlap_find_a_smooth_flow() {
    let pair = pair(11, waves);
    for (window_mm, overlap, most) in
        [(1.0, 0.5, 0.15), (1.3, 0.0, 0.1), (1.7, 0.75, 0.05), (2.4, 0.5, 0.1)]
    {
        let settings = VelocimetrySettings { window_mm, overlap, ..settings() };
        let field = VolumeInterrogation::new(&GRID, &settings).measure(&pair[0], &pair[1], 1e-4);
        let error = mean_error(&errors(&field, waves));
        assert!(error < most, "{window_mm} mm, overlap {overlap}: {error}");
    }
}

#[test]
fn any_volume_is_measured_in_windows_that_fit() {
    for voxels in [[12, 9, 10], [30, 20, 1], [1, 1, 1], [2, 40, 3]] {
        let grid = VolumeGrid { voxels, voxel_mm: 0.1, centre_mm: [0.0; 3] };
        let mut random = Pcg64Mcg::seed_from_u64(12);
        let mut volume = || DenseVolume {
            grid: grid.clone(),
            intensity: (0..grid.len()).map(|_| random.random::<f32>().powi(8)).collect(),
        };
        let (a, b) = (volume(), volume());
        let field = VolumeInterrogation::new(&grid, &settings()).measure(&a, &b, 1e-4);
        assert_eq!(field.status.len(), field.grid.len());
        assert!(!field.grid.is_empty());
        assert!(field.displacement_vox.as_flattened().iter().all(|v| v.is_finite()));
        assert!(field.uncertainty_vox.as_flattened().iter().all(|v| v.is_finite()));
    }
}

#[test]
fn a_dark_third_costs_the_vectors_in_the_light_nothing() {
    let volume = DarkThird::new();
    let frames = volume.frames(1);
    let [whole, ended] = [&volume.whole, &volume.ended].map(|grid| {
        let [a, b] = rendered(grid, &frames);
        VolumeInterrogation::new(grid, &settings()).measure(&a, &b, 1e-4)
    });
    volume.assert_same_error(&whole, &ended);
}

#[test]
fn a_peak_that_is_hardly_the_highest_is_not_trusted() {
    let volumes = pair(13, waves);
    let valid = |least_peak_ratio: f64| {
        let settings = VelocimetrySettings { least_peak_ratio, ..settings() };
        VolumeInterrogation::new(&GRID, &settings).measure(&volumes[0], &volumes[1], 1e-4)
    };
    let field = valid(1.0);
    let mut ratios = field.peak_ratio.clone();
    assert!(ratios.iter().all(|ratio| (0.0..100.0).contains(ratio)), "{ratios:?}");
    ratios.sort_by(f32::total_cmp);
    let typical = f64::from(ratios[ratios.len() / 2]);
    let asked = valid(typical);
    for (n, status) in asked.status.iter().enumerate() {
        let below = f64::from(asked.peak_ratio[n]) < typical;
        assert!(!below || *status != VectorStatus::Valid, "{n}: {}", asked.peak_ratio[n]);
    }
    let share = [field.valid_share(), asked.valid_share()];
    assert!(share[0] > 0.97 && (0.3..0.7).contains(&share[1]), "{share:?}");
}

/// Light in what is masked moves against the flow, and is brighter.
#[test]
fn what_is_masked_is_not_measured_and_does_not_disturb() {
    let flow = [1.5, -0.75, 0.5];
    let edge = 28;
    let masked = |n: usize| GRID.indices(n as u32)[0] < edge;
    let mask = VolumeMask { grid: GRID, flow: (0..GRID.len()).map(|n| !masked(n)).collect() };
    let (mut inside, outside) = (pair(5, |_| flow.map(|d| -d)), pair(6, |_| flow));
    for (inside, outside) in inside.iter_mut().zip(&outside) {
        let light = inside.intensity.iter_mut().zip(&outside.intensity).enumerate();
        light.for_each(|(n, (inside, outside))| {
            *inside = if masked(n) { 3.0 * *inside } else { *outside };
        });
    }
    let worst = |field: &VelocityField| {
        let valid = (0..field.grid.len()).filter(|&n| field.status[n] == VectorStatus::Valid);
        let in_flow = valid.filter(|&n| mask.is_flow(field.grid.position_mm(n)));
        in_flow
            .flat_map(|n| error_vox(field, &GRID, |_| flow, n))
            .fold(0.0f64, |worst, error| worst.max(error.abs()))
    };
    let [a, b] = &inside;
    let windows = VolumeInterrogation::new(&GRID, &settings());
    let whole = windows.measure(a, b, 1e-4);
    let field = windows.with_mask(Some(Arc::new(mask.clone()))).measure(a, b, 1e-4);
    for (n, status) in field.status.iter().enumerate() {
        let is_flow = mask.is_flow(field.grid.position_mm(n));
        assert_eq!(*status == VectorStatus::Masked, !is_flow);
    }
    assert!(field.valid_share() > 0.95, "{}", field.valid_share());
    println!("largest error beside it: {:.3}, unmasked {:.3} voxels", worst(&field), worst(&whole));
    assert!(worst(&field) < 0.25 && worst(&whole) > 0.5);
}
