//! Images of a plane: grids of a single layer.

use rand::{RngExt, SeedableRng};
use rand_pcg::Pcg64Mcg;

use super::*;

/// Standard deviation of a particle's image, in pixels.
const SPREAD_PX: f64 = 0.8;

fn plane(voxels: [usize; 2]) -> VolumeGrid {
    VolumeGrid { voxels: [voxels[0], voxels[1], 1], voxel_mm: 0.02, centre_mm: [0.0; 3] }
}

/// Images of 0.03 particles per pixel before and after `flow` (pixels, of the place in the middle).
fn images(
    seed: u64,
    grid: &VolumeGrid,
    flow: impl Fn([f64; 2]) -> [f64; 2],
    reach_px: f64,
) -> [DenseVolume; 2] {
    let [nx, ny, _] = grid.voxels;
    let mut random = Pcg64Mcg::seed_from_u64(seed);
    let mut images =
        [(); 2].map(|()| DenseVolume { grid: grid.clone(), intensity: vec![0.0; nx * ny] });
    let [width, height] = [nx, ny].map(|n| n as f64 + 2.0 * reach_px);
    for _ in 0..(0.03 * width * height) as usize {
        let middle = [width, height].map(|length| random.random_range(0.0..length) - reach_px);
        let light = random.random_range(0.5..1.5);
        for (image, half) in images.iter_mut().zip([-0.5, 0.5]) {
            let start = flow(middle);
            let on_path = [0, 1].map(|c| middle[c] + half * start[c] / 2.0);
            let whole = flow(on_path);
            let at = [0, 1].map(|c| middle[c] + half * whole[c]);
            draw(&mut image.intensity, [nx, ny], at, light);
        }
    }
    images
}

fn draw(image: &mut [f32], [nx, ny]: [usize; 2], at: [f64; 2], light: f64) {
    let around = |at: f64, count: usize| {
        (at - 4.0).ceil().max(0.0) as usize
            ..((at + 4.0).floor() + 1.0).clamp(0.0, count as f64) as usize
    };
    for y in around(at[1], ny) {
        for x in around(at[0], nx) {
            let square = (x as f64 - at[0]).powi(2) + (y as f64 - at[1]).powi(2);
            image[y * nx + x] += (light * (-square / (2.0 * SPREAD_PX.powi(2))).exp()) as f32;
        }
    }
}

/// Differences of valid vectors along x and y from `flow`, with their standard uncertainties, in pixels.
fn plane_errors(
    field: &VelocityField,
    grid: &VolumeGrid,
    flow: impl Fn([f64; 2]) -> [f64; 2],
) -> Vec<[f64; 2]> {
    let valid = |n: &usize| field.status[*n] == VectorStatus::Valid;
    (0..field.grid.len())
        .filter(valid)
        .flat_map(|n| {
            let at = field.grid.position_mm(n);
            let truth = flow([0, 1].map(|c| grid.index_of(c, at[c])));
            let (d, sigma) = (field.displacement_vox[n], field.uncertainty_vox[n]);
            [0, 1].map(|c| [(f64::from(d[c]) - truth[c]).abs(), f64::from(sigma[c])])
        })
        .collect()
}

fn plane_settings() -> VelocimetrySettings {
    VelocimetrySettings {
        window_mm: 32.0 * 0.02,
        max_displacement_vox: 8.0,
        passes: 4,
        ..VelocimetrySettings::default()
    }
}

fn plane_waves([x, y]: [f64; 2]) -> [f64; 2] {
    let wave = |t: f64| 3.0 * (t * std::f64::consts::TAU / 320.0).sin();
    [wave(y) + 2.0, wave(x + 80.0)]
}

#[test]
fn a_plane_is_measured_in_squares_with_intervals_that_hold() {
    let grid = plane([320, 256]);
    let interrogation = VolumeInterrogation::new(&grid, &plane_settings());
    assert_eq!(interrogation.vector_grid().vectors, [19, 15, 1]);
    assert_eq!(interrogation.vector_grid().first_mm[2], 0.0);
    let mut all = Vec::new();
    for seed in 1..5 {
        let [a, b] = images(seed, &grid, plane_waves, 8.0);
        let field = interrogation.measure(&a, &b, 1e-4);
        assert!(field.valid_share() > 0.97, "{}", field.valid_share());
        assert!(field.displacement_vox.iter().all(|d| d[2] == 0.0), "nothing across the plane");
        all.extend(plane_errors(&field, &grid, plane_waves));
    }
    let within = |k: f64| {
        all.iter().filter(|[error, sigma]| *error <= k * sigma).count() as f64 / all.len() as f64
    };
    let mean = mean_error(&all);
    println!("mean {mean:.4} px; {:.3} within one, {:.3} within two", within(1.0), within(1.96));
    assert!(mean < 0.08, "{mean}");
    assert!((within(1.0) - 0.68).abs() < 0.1 && (within(1.96) - 0.95).abs() < 0.08);
}

#[test]
fn large_displacements_are_followed_from_coarse_images_to_fine_ones() {
    // A shear layer: 24 px of difference within two windows.
    let flow = |[_, y]: [f64; 2]| [12.0 * ((y - 128.0) / 24.0).tanh() + 12.0, 0.0];
    let fine = plane([320, 256]);
    let [a, b] = images(7, &fine, flow, 30.0);
    let coarse = VolumeGrid { voxels: [80, 64, 1], voxel_mm: 0.08, centre_mm: [0.0; 3] };
    let binned = |image: &DenseVolume| {
        let mut intensity = vec![0.0; 80 * 64];
        for (n, value) in image.intensity.iter().enumerate() {
            intensity[n / 320 / 4 * 80 + n % 320 / 4] += value;
        }
        DenseVolume { grid: coarse.clone(), intensity }
    };
    let at_first = VelocimetrySettings {
        window_mm: 16.0 * 0.08,
        max_displacement_vox: 8.0,
        ..plane_settings()
    };
    let first =
        VolumeInterrogation::new(&coarse, &at_first).measure(&binned(&a), &binned(&b), 1e-4);
    let at_last = VelocimetrySettings { max_displacement_vox: 30.0, ..plane_settings() };
    let interrogation = VolumeInterrogation::new(&fine, &at_last);
    let field = interrogation.measure_from(&first, &a, &b, 1e-4);
    let errors = plane_errors(&field, &fine, flow);
    println!("{:.3} valid, mean {:.3} px", field.valid_share(), mean_error(&errors));
    assert!(field.valid_share() > 0.9, "{}", field.valid_share());
    assert!(mean_error(&errors) < 0.25, "{}", mean_error(&errors));
}
