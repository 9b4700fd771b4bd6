//! Grids found in images whose grid is known. The images are counted together from hundreds of points per
//! pixel: no blurred rim, no rendered disc, nothing of what the estimators take micro-images to be.

use lfpiv_hw::RawImage;
use rand::{RngExt, SeedableRng};
use rand_pcg::Pcg64Mcg;

use super::*;
use crate::lightfield::MicroImageGrid;

/// Points along each side of a pixel.
const POINTS: usize = 9;

const BLACK: f64 = 64.0;
const BRIGHT: f64 = 2400.0;

/// An array and what is wrong with it.
#[derive(Clone)]
struct Scene {
    size: [usize; 2],
    /// True grid; lenses from −`lenses` to +`lenses` around it are there.
    grid: MicroImageGrid,
    radius_px: f64,
    /// Radius of a second disc, and how far it lies outwards per pixel from the middle.
    second: Option<[f64; 2]>,
    /// Displacement of micro-images in proportion to the square of the place, at the image's edge.
    bent_px: f64,
    /// Slope of the light over a micro-image at the image's edge: how much more there is on its outer rim.
    tilt: f64,
    /// Lenses without light.
    dead: Vec<[i64; 2]>,
    /// Dark specks: column, row, radius.
    dust: Vec<[f64; 3]>,
    noise: f64,
}

/// A square array of 22 x 17 lenses on its sensor, turned and of a pitch that fits no pixels.
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
        bent_px: 0.0,
        tilt: 0.0,
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
    /// The discs that may touch a pixel: centres of the stop's and of the second one.
    fn discs_near(&self, column: f64, row: f64) -> Vec<[[f64; 2]; 2]> {
        let middle = self.size.map(|pixels| (pixels as f64 - 1.0) / 2.0);
        let [i, j] = self.grid.lens_at(column, row).map(|index| index.round() as i64);
        let slope = self.second.map_or(0.0, |[_, slope]| slope);
        (-2..=2)
            .flat_map(|dj| (-2..=2).map(move |di| [i + di, j + dj]))
            .filter(|lens| !self.dead.contains(lens))
            .map(|lens| {
                let mut stop = self.grid.centre_px(lens[0] as f64, lens[1] as f64);
                stop[0] += self.bent_px * ((stop[0] - middle[0]) / middle[0]).powi(2);
                let cut = [0, 1].map(|axis| stop[axis] + slope * (stop[axis] - middle[axis]));
                [stop, cut]
            })
            .filter(|[stop, _]| (column - stop[0]).hypot(row - stop[1]) < self.radius_px + 1.0)
            .collect()
    }

    /// Light of a pixel: the share of it in each disc, added up.
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

    /// Light on a disc where it is tilted along the columns, in proportion to the field.
    fn shade(&self, disc: [f64; 2], x: f64) -> f64 {
        let middle = (self.size[0] as f64 - 1.0) / 2.0;
        1.0 + self.tilt * (disc[0] - middle) / middle * (x - disc[0]) / self.radius_px
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

    /// The largest distance of a found centre from the nearest true one, over the lenses that were found.
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

/// Found without warnings to 0.02 px, and both estimators say the same.
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
fn hexagonal_arrays_are_found_with_rows_level_and_upright() {
    for (turned_deg, seed) in [(0.7, 5), (30.0, 6), (-14.0, 7)] {
        let found = assert_found(&hexagonal(18.6, turned_deg), seed);
        assert_eq!(found.array, ArrayKind::Hexagonal, "{:?}", found.grid);
        assert!(found.grid.column_px[1] > 0.0 && found.grid.row_px[2] < 0.0, "{:?}", found.grid);
    }
}

/// Stopped down, and so far open that every micro-image overlaps its neighbours.
#[test]
fn micro_images_of_any_size_are_found_and_the_f_number_is_told() {
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

/// Two pixels cut off at the corner, from outside and from inside: centroids would be a pixel off.
#[test]
fn a_second_aperture_does_not_pull_the_grid() {
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

/// A diffuser whose light falls off by a tenth over a micro-image at the edge.
#[test]
fn uneven_light_hardly_pulls_the_grid() {
    let mut scene = square([17.31, 17.31], 0.5);
    scene.tilt = 0.05;
    assert_found(&scene, 16);
}

#[test]
fn dead_lenses_and_dust_are_named_and_do_not_pull() {
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

/// The optics displace micro-images: no affine grid fits, and that is said.
#[test]
fn a_bent_grid_is_called_so() {
    let mut scene = square([17.31, 17.31], 0.5);
    scene.bent_px = 0.8;
    let found = scene.calibrated(13);
    let bent =
        found.warnings.iter().find(|warning| matches!(warning, GridWarning::Irregular { .. }));
    let said = bent.unwrap().to_string();
    assert!(said.contains("aberrations of the pupil"), "{said}");
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
fn black_levels_are_taken_off_and_saturation_is_said() {
    let white = |count| RawImage::new(2, 1, vec![count, 4095]).unwrap();
    let dark = RawImage::new(2, 1, vec![60, 64]).unwrap();
    let image = WhiteImage::average(&[white(100), white(200)], &[dark]).unwrap();
    assert_eq!(image.light(), [90.0, 4031.0]);
    assert_eq!(image.saturated_share(), 0.5);
    let other = RawImage::new(1, 1, vec![60]).unwrap();
    let error = WhiteImage::average(&[white(1)], &[other]).unwrap_err();
    assert!(error.to_string().starts_with("image 2 has 1 x 1 pixels"), "{error}");
}
