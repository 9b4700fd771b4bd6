//! Detection of the fiducial on ray-traced images of small cards by a nominal camera.

use lfpiv_hw::RawImage;
use lfpiv_sim::{SensorSettings, imaging::PlacedCard};

use super::{images::small_optics, *};
use crate::{
    calibration::{
        CardLight, WhiteImage,
        volume::{
            camera_model::CameraModel,
            fiducial::{LEAST_SIGNIFICANCE, resolved_by_fiducial},
            parameters::CameraParameters,
        },
    },
    lightfield::MicroImageGrid,
};

/// Rays of each microlens: the images are noisy.
const RAYS: usize = 1 << 10;

/// Spacing of the marks in the image, in microlenses.
const LENSES_PER_SPACING: i64 = 8;

/// A card with many marks; the radius of fiducial dots is larger by 0.065 mm.
fn wide_card() -> Card {
    Card {
        spacing_mm: 0.8,
        dot_diameter_mm: 0.42,
        fiducial_diameter_mm: 0.55,
        marks: [61, 61],
        ..card()
    }
}

/// Shift in microlenses and its significance, for the initial shift `start` and a card at three depths whose mark
/// (0, 0) is `along_mm` along x from the middle.
fn found(card: &Card, along_mm: f64, start: [i64; 2]) -> ([i64; 2], f64) {
    let (optics, flaws) = (small_optics(), CameraFlaws::default());
    let settings = RaySettings { rays_per_particle: 1, diffraction_nm: None };
    let pose = &test_bench::poses()[0];
    let tracer = RayTracer::imperfect(&optics, pose, [0.0; 3], &flaws, &settings);
    let grid = MicroImageGrid::nominal(&optics);
    let pixels = optics.sensor.columns * optics.sensor.rows;
    let [columns, rows] = [optics.sensor.columns, optics.sensor.rows];
    let dark = RawImage::new(columns, rows, vec![64; pixels]).unwrap();
    let light =
        |image: RawImage| WhiteImage::average(&[image], std::slice::from_ref(&dark)).unwrap();
    let sensor = SensorSettings::default();
    let white = light(sensor.expose(&tracer.trace_white(RAYS, 3000.0, &[1]), &[1]));
    let origins =
        [-1.0, 0.0, 1.0].map(|n| Point3::from(card.normal() * n) + Vector3::x() * along_mm);
    let lights = [0, 1, 2].map(|n| {
        let placed = PlacedCard { card, origin_mm: origins[n], bend_mm: [0.0; 3] };
        let traced = tracer.trace_card(&placed, RAYS, 3000.0, &[n as u64]).unwrap();
        CardLight::new(&optics, &grid, &white, &light(sensor.expose(&traced, &[2, n as u64])))
    });
    let positions: Vec<_> = lights.iter().zip(origins).collect();
    let model = CameraModel::new(&optics, pose, None, CameraParameters::default());
    resolved_by_fiducial(&positions, &model, card, start)
}

#[test]
fn a_small_fiducial_resolves_the_ambiguity() {
    let (shift, significance) = found(&wide_card(), 0.0, [0, 0]);
    println!("significance {significance:.2}");
    assert_eq!(shift, [0, 0]);
    assert!(significance > LEAST_SIGNIFICANCE, "{significance}");
}

#[test]
fn a_card_that_fits_a_spacing_away_is_moved_to_its_fiducial() {
    for start in [[LENSES_PER_SPACING, 0], [-LENSES_PER_SPACING, 0]] {
        let (shift, significance) = found(&wide_card(), 0.0, start);
        println!("from {start:?} to {shift:?}, significance {significance:.2}");
        assert_eq!(shift, [0, 0]);
        assert!(significance > LEAST_SIGNIFICANCE, "{significance}");
    }
}

#[test]
fn without_a_fiducial_in_view_the_ambiguity_remains() {
    let (_, significance) = found(&wide_card(), 12.0 * 0.8, [0, 0]);
    println!("significance {significance:.2}");
    assert!(significance < LEAST_SIGNIFICANCE, "{significance}");
}
