//! Grid calibration of synthetic images with known grids. The images are sampled at 81 points per pixel and share
//! no code with the models of the estimators.

use lfpiv_hw::RawImage;
use rand::{RngExt, SeedableRng};
use rand_pcg::Pcg64Mcg;

use super::*;
use crate::lightfield::MicroImageGrid;

/// Sampling points along each side of a pixel.
const POINTS: usize = 9;

const BLACK: f64 = 64.0;
const BRIGHT: f64 = 2400.0;

/// A synthetic white image with imperfections.
#[derive(Clone)]
struct Scene {
    size: [usize; 2],
    /// True grid; the image also shows lenses outside of its index range.
    grid: MicroImageGrid,
    radius_px: f64,
    /// Radius of a second disc, in pixels, and its outward displacement per pixel from the middle.
    second: Option<[f64; 2]>,
    /// Displacement of micro-images at the image's edge, in pixels; quadratic in the position.
    distortion_px: f64,
    /// Gradient of the light over a micro-image at the image's edge: relative increase from its centre to its outer
    /// rim.
    gradient: f64,
    /// Indices of lenses without light.
    dead: Vec<[i64; 2]>,
    /// Dark specks: column, row, radius, in pixels.
    dust: Vec<[f64; 3]>,
    noise: f64,
}

/// A square array of some 22 x 17 lenses, rotated, with a pitch that is not a whole number of pixels.
fn square(pitch: [f64; 2], turned_deg: f64) -> Scene {
    let (sine, cosine) = turned_deg.to_radians().sin_cos();
    Scene {
        size: [360, 280],
        grid: MicroImageGrid {
            microlenses: [22, 17],
            column_px: [181.3, pitch[0] * cosine, -pitch[1] * sine],
            row_px: [139.2, -pitch[0] * sine, -pitch[1] * cosine],
        },
        radius_px: 0.495 * pitch[0],
        second: None,
        distortion_px: 0.0,
        gradient: 0.0,
        dead: Vec::new(),
        dust: Vec::new(),
        noise: 20.0,
    }
}

fn hexagonal(pitch: f64, turned_deg: f64) -> Scene {
    let at = |angle: f64| {
        let (sine, cosine) = (turned_deg + angle).to_radians().sin_cos();
        [pitch * cosine, -pitch * sine]
    };
    let (a, b) = (at(0.0), at(60.0));
    let mut scene = square([pitch; 2], 0.0);
    scene.grid.column_px = [181.3, a[0], b[0]];
    scene.grid.row_px = [139.2, a[1], b[1]];
    scene
}

impl Scene {
    /// Centres of the stop's and of the second disc for all lenses near a pixel.
    fn discs_near(&self, column: f64, row: f64) -> Vec<[[f64; 2]; 2]> {
        let middle = self.size.map(|pixels| (pixels as f64 - 1.0) / 2.0);
        let [i, j] = self.grid.lens_at(column, row).map(|index| index.round() as i64);
        let slope = self.second.map_or(0.0, |[_, slope]| slope);
        (-2..=2)
            .flat_map(|dj| (-2..=2).map(move |di| [i + di, j + dj]))
            .filter(|lens| !self.dead.contains(lens))
            .map(|lens| {
                let mut stop = self.grid.centre_px(lens[0] as f64, lens[1] as f64);
                stop[0] += self.distortion_px * ((stop[0] - middle[0]) / middle[0]).powi(2);
                let cut = [0, 1].map(|axis| stop[axis] + slope * (stop[axis] - middle[axis]));
                [stop, cut]
            })
            .filter(|[stop, _]| (column - stop[0]).hypot(row - stop[1]) < self.radius_px + 1.0)
            .collect()
    }

    /// Light of a pixel: sum of its shares inside each disc.
    fn light(&self, column: f64, row: f64) -> f64 {
        let discs = self.discs_near(column, row);
        let cut_px = self.second.map_or(f64::INFINITY, |[radius, _]| radius);
        let mut inside = 0.0;
        for n in 0..POINTS * POINTS {
            let [x, y] = [column, row];
            let x = x + ((n % POINTS) as f64 + 0.5) / POINTS as f64 - 0.5;
            let y = y + ((n / POINTS) as f64 + 0.5) / POINTS as f64 - 0.5;
            let within = |[cx, cy]: [f64; 2], radius: f64| {
                (x - cx).powi(2) + (y - cy).powi(2) < radius * radius
            };
            let open =
                |disc: &&[[f64; 2]; 2]| within(disc[0], self.radius_px) && within(disc[1], cut_px);
            inside += discs.iter().filter(open).map(|disc| self.shade(disc[0], x)).sum::<f64>();
        }
        inside / (POINTS * POINTS) as f64
    }

    /// Light on a disc with a gradient along columns that is proportional to the field position.
    fn shade(&self, disc: [f64; 2], x: f64) -> f64 {
        let middle = (self.size[0] as f64 - 1.0) / 2.0;
        1.0 + self.gradient * (disc[0] - middle) / middle * (x - disc[0]) / self.radius_px
    }

    fn image(&self, seed: u64) -> WhiteImage {
        let mut random = Pcg64Mcg::seed_from_u64(seed);
        let [columns, rows] = self.size;
        let mut counts = Vec::with_capacity(columns * rows);
        for row in 0..rows {
            for column in 0..columns {
                let speck = |[x, y, r]: &[f64; 3]| (column as f64 - x).hypot(row as f64 - y) < *r;
                let open = if self.dust.iter().any(speck) { 0.3 } else { 1.0 };
                let noise: f64 = (0..12).map(|_| random.random::<f64>() - 0.5).sum();
                let light = BRIGHT * open * self.light(column as f64, row as f64);
                counts.push((BLACK + light + self.noise * noise).round().max(0.0) as u16);
            }
        }
        WhiteImage::average(&[RawImage::new(columns, rows, counts).unwrap()], &[]).unwrap()
    }

    /// Largest distance of a found centre from the nearest true one, in pixels.
    fn worst_px(&self, found: &MicroImageGrid) -> f64 {
        let [nx, ny] = found.microlenses;
        let mut worst = 0.0f64;
        let mut lenses = 0;
        for n in 0..nx * ny {
            let [x, y] = found.centre_px((n % nx) as f64, (n / nx) as f64);
            if x < 0.0 || y < 0.0 || x > self.size[0] as f64 || y > self.size[1] as f64 {
                continue;
            }
            let [i, j] = self.grid.lens_at(x, y).map(f64::round);
            let [u, v] = self.grid.centre_px(i, j);
            worst = worst.max((u - x).hypot(v - y));
            lenses += 1;
        }
        assert!(lenses > 100, "{lenses}");
        worst
    }

    fn calibrated(&self, seed: u64) -> GridCalibration {
        let mut steps = vec![0];
        let watch = |done| steps.push(done);
        let found = calibrate_grid_watched(&self.image(seed), None, watch).unwrap();
        assert!(steps.is_sorted() && steps.last() == Some(&GRID_STEPS), "{steps:?}");
        found
    }
}

/// Asserts that the grid is found within 0.02 px, without warnings, and that both estimators agree.
fn assert_found(scene: &Scene, seed: u64) -> GridCalibration {
    let found = scene.calibrated(seed);
    let worst = scene.worst_px(&found.grid);
    assert!(worst < 0.02, "{worst}: {:?}", found.grid);
    assert!(found.warnings.is_empty(), "{:?}", found.warnings);
    assert!(
        found.agreement.is_some_and(|agreement| agreement.worst_px < 0.1),
        "{:?}",
        found.agreement
    );
    found
}

#[test]
fn square_arrays_are_found_whatever_their_pitch_and_angle() {
    for (pitch, turned_deg, seed) in [
        ([17.31, 17.31], 1.0, 1),
        ([15.42, 15.37], -0.3, 2),
        ([24.0, 24.0], 0.0, 3),
        ([11.3, 11.3], 4.0, 4),
    ] {
        let found = assert_found(&square(pitch, turned_deg), seed);
        assert_eq!(found.array, ArrayKind::Square);
        for (found_px, pitch_px) in found.grid.pitch_px().into_iter().zip(pitch) {
            assert!((found_px - pitch_px).abs() < 0.002, "{:?}", found.grid);
        }
        let [along_i, along_j] = found.grid.turned_deg();
        assert!((along_i - turned_deg).abs() < 0.01 && (along_j - turned_deg).abs() < 0.01);
        assert!(found.heldout.rms_px.iter().all(|rms| *rms < 0.04), "{:?}", found.heldout);
    }
}

#[test]
fn hexagonal_arrays_are_found_and_oriented() {
    for (turned_deg, seed) in [(0.7, 5), (30.0, 6), (-14.0, 7)] {
        let found = assert_found(&hexagonal(18.6, turned_deg), seed);
        assert_eq!(found.array, ArrayKind::Hexagonal, "{:?}", found.grid);
        assert!(found.grid.column_px[1] > 0.0 && found.grid.row_px[2] < 0.0, "{:?}", found.grid);
    }
}

/// Small apertures, and large ones with overlapping micro-images.
#[test]
fn micro_images_of_any_size_are_found_with_the_f_number_advice() {
    for (share, seed, words) in [
        (0.35, 8, "open the main lens by 1.03 stops"),
        (0.57, 9, "close the main lens by 0.38 stops"),
    ] {
        let mut scene = square([18.31, 18.31], 0.4);
        scene.radius_px = share * 18.31;
        let found = assert_found(&scene, seed);
        assert!(found.f_number.to_string().ends_with(words), "{}", found.f_number);
    }
}

/// A cut of two pixels at the corner, from outside and from inside, which displaces centroids by one pixel.
#[test]
fn a_second_aperture_does_not_displace_the_grid() {
    for (slope, seed) in [(0.014, 10), (-0.012, 11)] {
        let mut scene = square([17.9, 17.9], 0.5);
        scene.second = Some([scene.radius_px + 0.8, slope]);
        let found = assert_found(&scene, seed);
        let second = found.second_aperture.unwrap();
        let at_corner = slope * 360f64.hypot(280.0) / 2.0;
        assert!((second.shift_at_corner_px - at_corner).abs() < 0.2, "{second:?}");
        assert!(found.least_open_share() < 0.92, "{}", found.least_open_share());
    }
}

/// A diffuser with a gradient of a tenth over a micro-image at the edge.
#[test]
fn uneven_light_hardly_displaces_the_grid() {
    let mut scene = square([17.31, 17.31], 0.5);
    scene.gradient = 0.05;
    assert_found(&scene, 16);
}

#[test]
fn dead_lenses_and_dust_are_detected_and_do_not_displace_the_grid() {
    let mut scene = square([17.31, 17.31], 0.5);
    scene.dead = vec![[3, 2], [-4, 1]];
    scene.dust = vec![[200.0, 100.0, 3.0], [85.0, 161.0, 2.0]];
    let found = assert_found(&scene, 12);
    assert_eq!(found.count(LensState::Dark), 2);
    assert!(
        (2..8).contains(&found.count(LensState::Disturbed)),
        "{}",
        found.count(LensState::Disturbed)
    );
    let [x, y] = scene.grid.centre_px(3.0, 2.0);
    let [i, j] = found.grid.lens_at(x, y).map(|index| index.round() as usize);
    assert_eq!(found.lenses[j * found.grid.microlenses[0] + i].state, LensState::Dark);
}

/// Displacements by the optics, which no affine grid fits, cause a warning.
#[test]
fn a_distorted_grid_causes_a_warning() {
    let mut scene = square([17.31, 17.31], 0.5);
    scene.distortion_px = 0.8;
    let found = scene.calibrated(13);
    let irregular =
        found.warnings.iter().find(|warning| matches!(warning, GridWarning::Irregular { .. }));
    let message = irregular.unwrap().to_string();
    assert!(message.contains("aberrations of the pupil"), "{message}");
    assert!(found.heldout.smooth_rms_px[0] < 0.3 * found.heldout.rms_px[0], "{:?}", found.heldout);
}

#[test]
fn an_image_that_does_not_repeat_has_no_grid() {
    let mut random = Pcg64Mcg::seed_from_u64(14);
    let counts = (0..200 * 200).map(|_| random.random_range(100..200)).collect();
    let noise = RawImage::new(200, 200, counts).unwrap();
    let flat = RawImage::new(200, 200, vec![500; 200 * 200]).unwrap();
    for image in [noise, flat] {
        let image = WhiteImage::average(&[image], &[]).unwrap();
        assert_eq!(calibrate_grid(&image, None).unwrap_err(), CalibrationError::NotPeriodic);
    }
    assert_eq!(WhiteImage::average(&[], &[]).unwrap_err(), CalibrationError::NoImage);
}

#[test]
fn micro_images_of_few_pixels_are_refused() {
    let mut scene = square([5.2, 5.2], 0.5);
    scene.size = [160, 160];
    let error = calibrate_grid(&scene.image(15), None).unwrap_err();
    assert!(matches!(error, CalibrationError::PitchTooSmall { .. }), "{error}");
}

#[test]
fn black_levels_are_subtracted_and_saturation_is_reported() {
    let white = |count| RawImage::new(2, 1, vec![count, 4095]).unwrap();
    let dark = RawImage::new(2, 1, vec![60, 64]).unwrap();
    let image = WhiteImage::average(&[white(100), white(200)], &[dark]).unwrap();
    assert_eq!(image.light(), [90.0, 4031.0]);
    assert_eq!(image.saturated_share(), 0.5);
    let other = RawImage::new(1, 1, vec![60]).unwrap();
    let error = WhiteImage::average(&[white(1)], &[other]).unwrap_err();
    assert!(error.to_string().starts_with("image 2 has 1 x 1 pixels"), "{error}");
}
