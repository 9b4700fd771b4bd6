mod flaws;
mod wall;
mod white;

use proptest::prelude::*;
use rayon::ThreadPoolBuilder;

use super::*;
use crate::test_bench::{optics, poses};

fn settings(rays_per_particle: usize) -> RaySettings {
    RaySettings { rays_per_particle, diffraction_nm: None }
}

fn source(position_mm: [f64; 3]) -> PointSource {
    PointSource { id: 0, position_mm, electrons: 1000.0 }
}

fn image_of(position_mm: [f64; 3], camera: usize) -> ElectronImage {
    let (optics, poses) = (optics(), poses());
    RayTracer::new(&optics, &poses[camera], &settings(4096)).trace(&[source(position_mm)], &[1])
}

/// Centre of light on the sensor along `right` and `up`, in mm.
fn centroid_mm(image: &ElectronImage) -> [f64; 2] {
    let optics = optics();
    let mut sums = [0.0; 2];
    for (index, &electrons) in image.electrons().iter().enumerate() {
        let (row, column) = (index / image.columns(), index % image.columns());
        sums[0] += f64::from(electrons) * optics.sensor.column_centre_mm(column);
        sums[1] += f64::from(electrons) * optics.sensor.row_centre_mm(row);
    }
    sums.map(|sum| sum / image.total())
}

/// First and last microlens column with light, from the pixels' own micro-images. Pixels farther
/// than 0.45 pitches from the centre are ignored, because rays may cross the border between
/// micro-images; the others see |U| < 0.45 s_i p_m (1 + f_m/s_i) / f_m = 11.3 mm of the pupil.
fn lit_microlens_columns(image: &ElectronImage) -> (usize, usize) {
    let optics = optics();
    let lit = image.electrons().iter().enumerate().filter(|(_, electrons)| **electrons > 0.0);
    let columns = lit.filter_map(|(index, _)| {
        let x_mm = optics.sensor.column_centre_mm(index % image.columns());
        let place = x_mm / optics.micro_image_pitch_mm() + 64.0;
        ((place - place.round()).abs() < 0.45).then_some(place.round() as usize)
    });
    columns.fold((usize::MAX, 0), |(low, high), column| (low.min(column), high.max(column)))
}

#[test]
fn a_point_in_focus_on_the_axis_fills_the_central_micro_image() {
    let image = image_of([0.0; 3], 0);
    // All light is behind microlens (64, 48): a disc of diameter D f_m / s_i = 0.1 mm on the axis.
    let radius_px = 25.0 * 0.8 / 200.0 / 2.0 / 0.0055;
    for (index, &electrons) in image.electrons().iter().enumerate() {
        let x = (index % 2352) as f64 - 1175.5;
        let y = (index / 2352) as f64 - 883.5;
        let inside = x.hypot(y) < radius_px - 0.75;
        assert!(electrons == 0.0 || x.hypot(y) < radius_px + 0.75);
        assert!(!inside || electrons > 0.0, "no light at {x}, {y}");
    }
    let centroid = centroid_mm(&image);
    assert!(centroid[0].abs() < 1e-4 && centroid[1].abs() < 1e-4, "{centroid:?}");
}

#[test]
fn magnification_inverts_the_picture() {
    // In focus at (1, 0.5): microlens at (−1, −0.5), centre of its micro-image 1.004 further.
    let centroid = centroid_mm(&image_of([1.0, 0.5, 0.0], 0));
    assert!((centroid[0] + 1.004).abs() < 1e-3, "{centroid:?}");
    assert!((centroid[1] + 0.502).abs() < 1e-3, "{centroid:?}");
    // Camera 2 sees x along right and −z along up.
    let centroid = centroid_mm(&image_of([1.0, 0.0, 0.5], 1));
    assert!((centroid[0] + 1.004).abs() < 1e-3, "{centroid:?}");
    assert!((centroid[1] - 0.502).abs() < 1e-3, "{centroid:?}");
}

#[test]
fn one_ray_agrees_with_the_formulas_of_the_theory() {
    let (optics, poses) = (optics(), poses());
    let tracer = RayTracer::new(&optics, &poses[0], &settings(1));
    let (xi, depth, pupil) = (0.73_f64, 2.0_f64, 5.0_f64);
    // Computed with the intermediate image: s = 198, s' = F s/(s − F), ξ' = −ξ s'/s.
    let s = 200.0 - depth;
    let conjugate = 100.0 * s / (s - 100.0);
    let image_point = -xi * conjugate / s;
    let x = pupil + (image_point - pupil) * 200.0 / conjugate;
    let lens_centre: f64 = (x / 0.1_f64).round() * 0.1;
    let on_sensor = lens_centre + 0.8 * (x - pupil) / 200.0;
    let column = (on_sensor / 0.0055 + 1175.5).round() as u32;
    let mut rng = random_stream(Purpose::Rays, &[0]);
    let plane_mm = tracer.on_microlenses_mm([xi, 0.0, depth], [pupil, 0.0]).unwrap();
    let pixel = tracer.detector.pixel(plane_mm, [pupil, 0.0], &mut rng).unwrap();
    assert_eq!(pixel % 2352, column);
}

#[test]
fn disparity_with_depth_has_the_closed_form() {
    // x = a U + b ξ: the spot on the microlens plane extends to |a U| on both sides. For a point
    // nearer than the plane in focus, a ray through the right edge of the pupil (U > 0) hits the
    // sensor right of the axis.
    for depth in [-5.0, -4.0, -2.0, 2.0, 4.0, 5.0] {
        let s: f64 = 200.0 - depth;
        let a = 1.0 - 200.0 * (1.0 / 100.0 - 1.0 / s);
        let (low, high) = lit_microlens_columns(&image_of([0.0, 0.0, depth], 0));
        let half_width = (a.abs() * 11.3 / 0.1).round() as usize;
        assert_eq!((low, high), (64 - half_width, 64 + half_width), "depth {depth}");
        let (optics, poses) = (optics(), poses());
        let tracer = RayTracer::new(&optics, &poses[0], &settings(1));
        let mut rng = random_stream(Purpose::Rays, &[0]);
        let plane_mm = tracer.on_microlenses_mm([0.0, 0.0, depth], [12.0, 0.0]).unwrap();
        let pixel = tracer.detector.pixel(plane_mm, [12.0, 0.0], &mut rng).unwrap() % 2352;
        assert_eq!(pixel > 1176, depth > 0.0, "depth {depth}: pixel {pixel}");
    }
}

#[test]
fn rays_beyond_the_array_are_lost() {
    assert_eq!(image_of([7.0, 0.0, 0.0], 0).total(), 0.0);
    assert_eq!(image_of([0.0, 0.0, 200.0], 0).total(), 0.0);
    assert_eq!(image_of([0.0, f64::NAN, 0.0], 0).total(), 0.0);
    // On the border of the last microlens column (64.5 × 0.1 mm), out of focus: part is lost.
    let part = image_of([6.4, 0.0, 2.0], 0).total();
    assert!((100.0..900.0).contains(&part), "{part}");
}

#[test]
fn diffraction_widens_a_micro_image_and_keeps_its_energy() {
    let (optics, poses) = (optics(), poses());
    let spread = |diffraction_nm| {
        let settings = RaySettings { rays_per_particle: 1_000_000, diffraction_nm };
        let image = RayTracer::new(&optics, &poses[0], &settings).trace(&[source([0.0; 3])], &[1]);
        assert!((image.total() - 1000.0).abs() < 0.01);
        let moment = image.electrons().iter().enumerate().map(|(index, &electrons)| {
            let y_mm = optics.sensor.row_centre_mm(index / 2352);
            f64::from(electrons) * y_mm * y_mm
        });
        moment.sum::<f64>() / image.total()
    };
    // σ = 0.42 × 532 nm × 8 behind the microlens; the main lens' blur stays inside the microlens.
    // Pixels widen the sharp disc less than the blurred one: 1.21 σ² by numerical integration.
    let added = spread(Some(532.0)) - spread(None);
    let expected = 1.21 * (0.42 * 532e-6 * 8.0_f64).powi(2);
    assert!((added / expected - 1.0).abs() < 0.1, "{added} instead of {expected}");
}

/// Images of a perfect camera are fixed bit for bit, so that recorded runs and references stay
/// valid.
#[test]
fn images_of_a_perfect_camera_are_reproduced() {
    let (optics, poses) = (optics(), poses());
    let sources: Vec<PointSource> = (0..40)
        .map(|id| {
            let at = |step: f64| (id as f64 * step).fract() - 0.5;
            let position_mm = [11.0 * at(0.618), 8.0 * at(0.755), 8.0 * at(0.570)];
            PointSource { id, position_mm, electrons: 1000.0 + id as f64 }
        })
        .collect();
    let cases = [
        (0, None, 0x8847_f8d9_62e6_3d25),
        (1, None, 0x0714_07d4_2546_2925),
        (1, Some(532.0), 0x5e9f_e407_9db7_7525),
    ];
    for (camera, diffraction_nm, expected) in cases {
        let settings = RaySettings { rays_per_particle: 1000, diffraction_nm };
        let image = RayTracer::new(&optics, &poses[camera], &settings).trace(&sources, &[3, 1]);
        // Fowler-Noll-Vo hash of the pixels' bits.
        let digest = image.electrons().iter().fold(0xcbf2_9ce4_8422_2325_u64, |hash, electrons| {
            (hash ^ u64::from(electrons.to_bits())).wrapping_mul(0x0100_0000_01b3)
        });
        assert_eq!(digest, expected, "camera {camera}, diffraction {diffraction_nm:?}");
    }
}

#[test]
fn threads_do_not_change_a_traced_box() {
    let (optics, poses) = (optics(), poses());
    let tracer = RayTracer::new(&optics, &poses[0], &settings(1));
    let with_threads = |threads| {
        let pool = ThreadPoolBuilder::new().num_threads(threads).build().unwrap();
        pool.install(|| tracer.trace_box([0.3, 0.2, 1.0], 0.1, 500.0, 300_000, 9))
    };
    let image = with_threads(1);
    assert_eq!(image, with_threads(2));
    assert!((image.total() - 500.0).abs() < 0.01);
}

#[test]
fn a_box_gives_the_image_of_the_points_in_it() {
    let (optics, poses) = (optics(), poses());
    let tracer = RayTracer::new(&optics, &poses[1], &settings(256));
    let (centre, edge) = ([1.05, 2.0, -0.33], 0.1);
    let glow = tracer.trace_box(centre, edge, 8000.0, 1 << 20, 5);
    let lattice = |i: usize| edge * ((i as f64 + 0.5) / 20.0 - 0.5);
    let sources: Vec<PointSource> = (0..8000)
        .map(|id| {
            let offset = [lattice(id % 20), lattice(id / 20 % 20), lattice(id / 400)];
            let position_mm = std::array::from_fn(|axis| centre[axis] + offset[axis]);
            PointSource { id: id as u64, position_mm, electrons: 1.0 }
        })
        .collect();
    let points = tracer.trace(&sources, &[2]);
    let difference: f64 = glow
        .electrons()
        .iter()
        .zip(points.electrons())
        .map(|(a, b)| f64::from((a - b).abs()))
        .sum();
    assert!(difference / 8000.0 < 0.05, "L1 {}", difference / 8000.0);
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(32))]
    #[test]
    fn light_of_points_well_inside_the_field_is_conserved(
        x in -4.0..4.0_f64, y in -3.0..3.0_f64, z in -4.0..4.0_f64, camera in 0..2_usize,
    ) {
        let total = image_of([x, y, z], camera).total();
        prop_assert!((total - 1000.0).abs() < 0.01, "{}", total);
    }
}
