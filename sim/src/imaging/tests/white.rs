//! White images: positions and sizes of micro-images, and effects that darken them.

use super::*;
use crate::test_bench;

const RAYS: usize = 1 << 14;

fn small_optics() -> Optics {
    test_bench::small().optics
}

fn white(flaws: &CameraFlaws) -> (ElectronImage, TrueMicroImageGrid) {
    let optics = small_optics();
    let tracer = RayTracer::imperfect(&optics, &poses()[0], [0.0; 3], flaws, &settings(1));
    (tracer.trace_white(RAYS, 1000.0, &[1]), tracer.micro_image_grid())
}

/// Light of a micro-image, its centroid, and its mean square distance from that, in pixels, within
/// half a pitch of the centre; `None` if cut by the sensor's edge.
fn micro_image(
    image: &ElectronImage,
    grid: &TrueMicroImageGrid,
    [i, j]: [usize; 2],
) -> Option<(f64, [f64; 2], f64)> {
    let centre = grid.centre_px(i, j);
    let half = grid.column_px[1].hypot(grid.row_px[1]) / 2.0;
    let inside = |place: f64, count: usize| place - half > 0.0 && place + half < count as f64 - 1.0;
    if !inside(centre[0], image.columns()) || !inside(centre[1], image.rows()) {
        return None;
    }
    let (mut light, mut first, mut second) = (0.0, [0.0; 2], 0.0);
    for (index, &electrons) in image.electrons().iter().enumerate() {
        let place = [index % image.columns(), index / image.columns()].map(|pixel| pixel as f64);
        let from = [place[0] - centre[0], place[1] - centre[1]];
        if from[0].abs() <= half && from[1].abs() <= half {
            let electrons = f64::from(electrons);
            light += electrons;
            (0..2).for_each(|axis| first[axis] += electrons * from[axis]);
            second += electrons * (from[0].powi(2) + from[1].powi(2));
        }
    }
    let mean = first.map(|sum| sum / light);
    let square = second / light - mean[0].powi(2) - mean[1].powi(2);
    Some((light, [centre[0] + mean[0], centre[1] + mean[1]], square))
}

/// Every third microlens along both axes whose micro-image is not cut by the sensor's edge.
fn some_microlenses(
    image: &ElectronImage,
    grid: &TrueMicroImageGrid,
) -> Vec<([usize; 2], f64, [f64; 2], f64)> {
    let lenses = (0..17).step_by(3).flat_map(|j| (0..21).step_by(3).map(move |i| [i, j]));
    let found: Vec<_> = lenses
        .filter_map(|lens| {
            let (light, centre, square) = micro_image(image, grid, lens)?;
            Some((lens, light, centre, square))
        })
        .collect();
    assert!(found.len() > 20);
    found
}

/// An array with all deviations. Its stop is smaller than nominal, so that micro-images do not
/// touch and each pixel sees one microlens.
fn displaced() -> CameraFlaws {
    CameraFlaws {
        array_rotation_deg: 0.7,
        array_shift_mm: [0.031, -0.017],
        array_pitch_scale: [1.004, 0.996],
        exit_pupil_mm: 40.0,
        f_number_scale: 1.2,
        ..CameraFlaws::default()
    }
}

#[test]
fn micro_images_of_a_perfect_array_agree_with_the_theory() {
    let (_, grid) = white(&CameraFlaws::default());
    let pitch_px = 0.1004 / 0.0055;
    for (i, j) in [(0, 0), (20, 0), (5, 16)] {
        let expected = [191.5 + (i as f64 - 10.0) * pitch_px, 155.5 - (j as f64 - 8.0) * pitch_px];
        let got = grid.centre_px(i, j);
        assert!((got[0] - expected[0]).abs() < 1e-9 && (got[1] - expected[1]).abs() < 1e-9);
    }
}

#[test]
fn micro_images_are_centred_on_the_true_grid() {
    for flaws in [CameraFlaws { f_number_scale: 1.2, ..CameraFlaws::default() }, displaced()] {
        let (image, grid) = white(&flaws);
        for ([i, j], _, centre, _) in some_microlenses(&image, &grid) {
            let expected = grid.centre_px(i, j);
            let missed = [centre[0] - expected[0], centre[1] - expected[1]];
            assert!(missed.iter().all(|px| px.abs() < 0.02), "{i}, {j}: {missed:?} px");
        }
    }
}

/// The grid computed directly: rotation from `right` towards `up`, rows counted downwards.
#[test]
fn the_true_grid_follows_rotation_and_pitch_of_the_array() {
    let (_, grid) = white(&displaced());
    let pixel_mm = 0.0055;
    let grown = 1.0 + 0.8 / (200.0 - 40.0);
    let (sine, cosine) = 0.7_f64.to_radians().sin_cos();
    let along_i = 0.1004 / 1.0 * grown / pixel_mm;
    let along_j = 0.0996 / 1.0 * grown / pixel_mm;
    for (got, expected) in [
        (grid.column_px[1], along_i * cosine),
        (grid.row_px[1], -along_i * sine),
        (grid.column_px[2], -along_j * sine),
        (grid.row_px[2], -along_j * cosine),
    ] {
        assert!((got - expected).abs() < 1e-9, "{got} instead of {expected}");
    }
    let middle = grid.centre_px(10, 8);
    assert!((middle[0] - (191.5 + 0.031 * grown / pixel_mm)).abs() < 1e-9);
    assert!((middle[1] - (155.5 + 0.017 * grown / pixel_mm)).abs() < 1e-9);
}

/// A second aperture whose projection on the stop is as large as the stop gives the overlap of two
/// equal discs; the centroid of the light is half-way between their centres.
#[test]
fn vignetting_moves_the_light_but_not_the_grid() {
    for (behind_lens_mm, towards_axis) in [(-30.0, true), (30.0, false)] {
        // For d = 0, the ray through u on the stop and x on the microlenses passes the aperture at
        // u κ + x v/s_i, with κ = 1 − v/s_i behind the lens and κ = 1 + v/s_o in front of it.
        let kept = 1.0 - f64::abs(behind_lens_mm) / 200.0;
        let vignetting = SecondAperture { radius_mm: 12.5 / 1.2 * kept, behind_lens_mm };
        let flaws = CameraFlaws {
            vignetting: Some(vignetting),
            f_number_scale: 1.2,
            ..CameraFlaws::default()
        };
        let (image, grid) = white(&flaws);
        for ([i, j], _, centre, _) in some_microlenses(&image, &grid) {
            let expected = grid.centre_px(i, j);
            for (axis, from_axis_mm) in [(0, (i as f64 - 10.0) * 0.1), (1, (8.0 - j as f64) * 0.1)]
            {
                let half_way_mm = -from_axis_mm * behind_lens_mm / 200.0 / kept / 2.0;
                let moved = -half_way_mm * 0.8 / 200.0 / 0.0055;
                let got = centre[axis] - expected[axis];
                assert!((got - moved).abs() < 0.02, "{i}, {j}: {got} instead of {moved} px");
                assert_eq!(moved * from_axis_mm < 0.0, towards_axis && from_axis_mm != 0.0);
            }
        }
    }
}

/// A uniform disc of radius R has a mean square distance of R²/2 from its centre; the pixel width
/// adds 1/6, the microlens' aperture almost nothing.
#[test]
fn the_f_number_sets_the_size_of_micro_images() {
    for f_number_scale in [1.1, 1.3, 1.6] {
        let (image, grid) = white(&CameraFlaws { f_number_scale, ..CameraFlaws::default() });
        let radius_px: f64 = 12.5 / f_number_scale * 0.8 / 200.0 / 0.0055;
        for (lens, _, _, square) in some_microlenses(&image, &grid) {
            let expected = radius_px.powi(2) / 2.0 + 1.0 / 6.0;
            assert!((square / expected - 1.0).abs() < 0.01, "{lens:?}: {square}, not {expected}");
        }
    }
}

/// With a stop wider than the microlenses' f-number, neighbouring micro-images overlap, and the
/// area between them gets the light of both.
#[test]
fn micro_images_of_too_wide_a_stop_overlap() {
    let between_and_middle = |f_number_scale| {
        let (image, grid) = white(&CameraFlaws { f_number_scale, ..CameraFlaws::default() });
        let [column, row] = grid.centre_px(10, 8);
        [column + grid.column_px[1] / 2.0, column]
            .map(|column| image.electrons()[row.round() as usize * 384 + column.round() as usize])
    };
    let [between, middle] = between_and_middle(0.8);
    assert!((between / middle - 2.0).abs() < 0.2, "{between} and {middle}");
    let [between, middle] = between_and_middle(1.2);
    assert!(between == 0.0 && middle > 800.0, "{between} and {middle}");
}

#[test]
fn dead_microlenses_are_dark_and_the_others_are_not() {
    let flaws = CameraFlaws { dead_microlenses: 40, f_number_scale: 1.2, ..CameraFlaws::default() };
    let (image, grid) = white(&flaws);
    let lenses = (1..16).flat_map(|j| (1..20).map(move |i| [i, j]));
    let lights: Vec<f64> =
        lenses.filter_map(|lens| Some(micro_image(&image, &grid, lens)?.0)).collect();
    let brightest = lights.iter().copied().fold(0.0, f64::max);
    let dark = lights.iter().filter(|&&light| light == 0.0).count();
    assert!((20..=40).contains(&dark), "{dark} of {}", lights.len());
    assert!(lights.iter().all(|&light| light == 0.0 || light > 0.99 * brightest));
}

#[test]
fn light_is_uniform_and_as_bright_as_requested() {
    let (image, grid) = white(&CameraFlaws { f_number_scale: 1.2, ..CameraFlaws::default() });
    let brightest = image.electrons().iter().copied().fold(0.0, f32::max);
    assert!((brightest - 1000.0).abs() < 1e-3, "{brightest}");
    // Pixels completely inside their micro-image, whose radius is 7.6 pixels.
    let mut open = Vec::new();
    for (index, &electrons) in image.electrons().iter().enumerate() {
        let place = [(index % 384) as f64, (index / 384) as f64];
        let [i, j] = [
            (place[0] - grid.column_px[0]) / grid.column_px[1],
            (place[1] - grid.row_px[0]) / grid.row_px[2],
        ]
        .map(|lens| lens.round().max(0.0) as usize);
        let centre = grid.centre_px(i, j);
        let inside = (place[0] - centre[0]).hypot(place[1] - centre[1]) < 6.5;
        if inside && i < 21 && j < 17 {
            open.push(f64::from(electrons));
        }
    }
    let mean = open.iter().sum::<f64>() / open.len() as f64;
    let variance = open.iter().map(|light| (light - mean).powi(2)).sum::<f64>() / open.len() as f64;
    assert!(variance.sqrt() / mean < 0.04, "{} of {mean}", variance.sqrt());
    assert!(mean > 800.0, "{mean}");
}

#[test]
fn threads_do_not_change_a_white_image() {
    let flaws = CameraFlaws {
        blur_px: 0.4,
        dust: Dust { specks: 20, ..Dust::default() },
        dead_microlenses: 3,
        vignetting: Some(SecondAperture { radius_mm: 12.0, behind_lens_mm: -50.0 }),
        ..displaced()
    };
    let optics = small_optics();
    let lit = RaySettings { rays_per_particle: 1, diffraction_nm: Some(532.0) };
    let tracer = RayTracer::imperfect(&optics, &poses()[1], [0.0; 3], &flaws, &lit);
    let with_threads = |threads| {
        let pool = ThreadPoolBuilder::new().num_threads(threads).build().unwrap();
        pool.install(|| tracer.trace_white(500, 1000.0, &[4]))
    };
    let image = with_threads(1);
    assert_eq!(image, with_threads(2));
    assert_ne!(image, tracer.trace_white(500, 1000.0, &[5]));
}
