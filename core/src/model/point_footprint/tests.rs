use lfpiv_hw::CameraName;

use super::*;
use crate::{lightfield::MicroImageGrid, test_bench};

fn volume() -> VolumeGrid {
    VolumeGrid { voxels: [40, 40, 60], voxel_mm: 0.1, centre_mm: [0.5, -0.5, 0.0] }
}

fn camera(calibration: &CameraCalibration, number: usize) -> PointCamera {
    let blur = PointBlur { plane_mm: 2e-3, sensor_px: 0.3 };
    let (optics, poses) = (test_bench::optics(), test_bench::poses());
    let name = CameraName(number);
    PointCamera::new(&optics, &poses[number], calibration, &volume(), name, blur).unwrap()
}

/// The image pixel by pixel: product of the shares of column and row and the open share.
fn rendered(camera: &PointCamera, footprint: &PointFootprint) -> Vec<f64> {
    let [width, height] = camera.sensor_px();
    let mut image = vec![0.0; width * height];
    for patch in &footprint.patches {
        for (r, row) in footprint.of(0, &patch.rows).iter().enumerate() {
            for (c, column) in footprint.of(0, &patch.columns).iter().enumerate() {
                let open = camera.open_shares()[patch.open + r * camera.open_stride() + c];
                image[(patch.rows.first_px + r) * width + patch.columns.first_px + c] +=
                    f64::from(row * column) * f64::from(open) / 255.0;
            }
        }
    }
    image
}

fn image_at(camera: &PointCamera, at_mm: [f64; 3]) -> Vec<f64> {
    let mut footprint = PointFootprint::default();
    camera.image(at_mm, &mut footprint);
    rendered(camera, &footprint)
}

#[test]
fn all_light_that_passes_the_pupil_is_in_the_image() {
    for number in 0..2 {
        let camera = camera(&CameraCalibration::default(), number);
        for at_mm in [[0.53, -0.31, 0.0], [0.5, 0.02, -1.3], [1.21, -1.17, 2.77]] {
            let light: f64 = image_at(&camera, at_mm).iter().sum();
            let share = light * camera.light_per_cell();
            assert!((share - 1.0).abs() < 0.01, "camera {number}, {at_mm:?}: {share}");
        }
    }
}

/// The code for arbitrarily oriented arrays agrees with that for aligned ones.
#[test]
fn a_negligible_rotation_of_the_array_does_not_change_the_image() {
    let mut grid = MicroImageGrid::nominal(&test_bench::optics());
    grid.column_px[2] = 1e-9;
    let turned = camera(&CameraCalibration { grid: Some(grid), map: None }, 0);
    let straight = camera(&CameraCalibration::default(), 0);
    assert!(straight.aligned && !turned.aligned);
    let at_mm = [0.53, -0.31, 1.7];
    let (one, other) = (image_at(&straight, at_mm), image_at(&turned, at_mm));
    let apart: f64 = one.iter().zip(&other).map(|(a, b)| (a - b).abs()).sum();
    assert!(apart < 1e-3 * one.iter().sum::<f64>(), "{apart}");
}

#[test]
fn a_small_step_changes_the_image_by_its_derivatives() {
    let camera = camera(&CameraCalibration::default(), 1);
    let at_mm = [0.533, 0.81, 1.72];
    let step = 1e-4;
    let mut footprint = PointFootprint::default();
    camera.image_and_derivatives(at_mm, &mut footprint);
    let width = camera.sensor_px()[0];
    for axis in 0..3 {
        let at = |step: f64| {
            let mut moved = at_mm;
            moved[axis] += step;
            image_at(&camera, moved)
        };
        let (low, high) = (at(-step), at(step));
        let mut expected = vec![0.0; low.len()];
        let [by_column, by_column_parallax, by_row, by_row_parallax] =
            footprint.by_place.map(|by| by[axis]);
        for patch in &footprint.patches {
            let [rows, columns] = [patch.rows, patch.columns]
                .map(|shares| [0, 1, 2].map(|kind| footprint.of(kind, &shares)));
            for r in 0..patch.rows.len {
                for c in 0..patch.columns.len {
                    let open = camera.open_shares()[patch.open + r * camera.open_stride() + c];
                    let [column, row] =
                        [columns.map(|of| f64::from(of[c])), rows.map(|of| f64::from(of[r]))];
                    let slope = (by_column * column[1] + by_column_parallax * column[2]) * row[0]
                        + (by_row * row[1] + by_row_parallax * row[2]) * column[0];
                    expected[(patch.rows.first_px + r) * width + patch.columns.first_px + c] +=
                        slope * f64::from(open) / 255.0;
                }
            }
        }
        let slopes = low.iter().zip(&high).map(|(low, high)| (high - low) / (2.0 * step));
        let apart: f64 = slopes.zip(&expected).map(|(a, b)| (a - b).abs()).sum();
        let all: f64 = expected.iter().map(|slope| slope.abs()).sum();
        assert!(all > 1.0 && apart < 5e-3 * all, "axis {axis}: {apart} of {all}");
    }
}

/// The circle of confusion of a thin lens, D |s_i − s'|/s'.
#[test]
fn the_light_of_a_point_is_as_wide_as_the_circle_of_confusion() {
    let camera = camera(&CameraCalibration::default(), 0);
    let optics = test_bench::optics();
    let (focal_mm, object_mm) = (optics.focal_length_mm, optics.object_distance_mm);
    let image_of = |distance_mm: f64| focal_mm * distance_mm / (distance_mm - focal_mm);
    for depth_mm in [-1.7, -0.4, 0.0, 0.8, 1.5] {
        let image_mm = image_of(object_mm - depth_mm);
        let apart_mm = (image_of(object_mm) - image_mm).abs();
        let expected = optics.pupil_diameter_mm() * apart_mm / image_mm / optics.microlens.pitch_mm;
        let found = camera.spread_pitches([0.3, -0.2, depth_mm]);
        assert!((found - expected).abs() < 0.01, "{depth_mm} mm: {found} {expected}");
    }
}
