//! Particles in water behind a glass wall.

use super::{flaws::with_camera, *};

/// Water behind 5 mm of glass, 40 mm from the centre.
fn tank(tilt_deg: [f64; 2]) -> CameraFlaws {
    let wall = WallSettings { distance_mm: 40.0, tilt_deg, ..WallSettings::default() };
    CameraFlaws { wall: Some(wall), ..CameraFlaws::default() }
}

fn meets_mm(flaws: &CameraFlaws, position_mm: [f64; 3], stop_mm: [f64; 2]) -> [f64; 2] {
    with_camera(0, flaws, |tracer| tracer.on_microlenses_mm(position_mm, stop_mm).unwrap())
}

/// Distance on the microlens plane of the rays through ±`u` along an axis of the stop, per distance
/// on the stop: zero in focus, and to first order s_i/s² times the equivalent depth.
fn parallax(flaws: &CameraFlaws, position_mm: [f64; 3], axis: usize, u: f64) -> f64 {
    let at = |u: f64| {
        let mut stop_mm = [0.0; 2];
        stop_mm[axis] = u;
        meets_mm(flaws, position_mm, stop_mm)[axis]
    };
    (at(u) - at(-u)) / (2.0 * u)
}

#[test]
fn a_wall_of_air_has_no_effect() {
    let mut flaws = tank([5.0, -3.0]);
    let wall = flaws.wall.as_mut().unwrap();
    (wall.glass_index, wall.medium_index) = (1.0, 1.0);
    let position_mm = [3.0, -2.0, 4.0];
    for stop_mm in [[0.0, 0.0], [12.0, 1.0], [-4.0, 9.0]] {
        let with = meets_mm(&flaws, position_mm, stop_mm);
        let without = meets_mm(&CameraFlaws::default(), position_mm, stop_mm);
        assert!((with[0] - without[0]).abs() < 1e-10 && (with[1] - without[1]).abs() < 1e-10);
    }
}

#[test]
fn a_perpendicular_wall_divides_depth_by_the_index() {
    let (air, water) = (CameraFlaws::default(), tank([0.0; 2]));
    for depth in [-4.0, -1.0, 2.0, 4.0] {
        let seen = parallax(&water, [0.0, 0.0, depth], 0, 1.0);
        let expected = parallax(&air, [0.0, 0.0, depth / 1.333], 0, 1.0);
        assert!((seen - expected).abs() < 2e-6, "{seen} instead of {expected}");
        // The equivalent depth z/n also determines the magnification, −200/(200 − z/n).
        let place_mm = meets_mm(&water, [1.0, 0.0, depth], [0.0; 2]);
        let expected_mm = -200.0 / (200.0 - depth / 1.333);
        assert!((place_mm[0] - expected_mm).abs() < 2e-5, "{place_mm:?}, not {expected_mm}");
    }
}

/// The camera is set up through the wall: for any tilt the centre is on the axis and in focus.
#[test]
fn the_centre_of_the_volume_is_on_the_axis_and_in_focus() {
    for tilt_deg in [[0.0, 0.0], [5.0, 0.0], [0.0, -5.0], [10.0, 7.0]] {
        let flaws = tank(tilt_deg);
        let centre_mm = meets_mm(&flaws, [0.0; 3], [0.0; 2]);
        assert!(centre_mm.iter().all(|mm| mm.abs() < 1e-9), "{centre_mm:?}");
        let of_both = parallax(&flaws, [0.0; 3], 0, 0.5) + parallax(&flaws, [0.0; 3], 1, 0.5);
        // 1 µm of parallax at the edge of the stop.
        assert!(of_both.abs() < 1e-4, "tilt {tilt_deg:?}: {of_both}");
    }
}

/// In the plane of incidence a point appears nearer than perpendicular to it. For 40 mm of water
/// and 5 mm of glass the difference is 40 (1 − cos² 5°/cos² 3.749°)/1.333 + 5 (1 − cos² 5°/cos²
/// 3.331°)/1.5 = 0.113 mm, which on the microlenses is 0.07 voxels between the axes at the edge of
/// the stop.
#[test]
fn a_tilted_wall_gives_columns_and_rows_different_depths() {
    for (tilt_deg, in_plane) in [([5.0, 0.0], 1), ([0.0, 5.0], 0)] {
        let flaws = tank(tilt_deg);
        let depth = |axis: usize| parallax(&flaws, [0.0; 3], axis, 1.0) * 200.0;
        let apart_mm = depth(in_plane) - depth(1 - in_plane);
        assert!((apart_mm - 0.113).abs() < 0.002, "{apart_mm} mm");
        let at_edge_vox = 12.5 * apart_mm / 200.0 / 0.1;
        assert!((0.06..0.09).contains(&at_edge_vox), "{at_edge_vox}");
    }
}

/// The wall belongs to the tank: after moving the camera by δ along its axis, the plane in focus
/// moves by nδ.
#[test]
fn the_wall_does_not_move_with_the_camera() {
    let (optics, flaws) = (optics(), tank([0.0; 2]));
    let tracer = RayTracer::imperfect(&optics, &poses()[0], [0.0, 0.0, 0.6], &flaws, &settings(1));
    let at = |depth: f64, u: f64| tracer.on_microlenses_mm([0.0, 0.0, depth], [u, 0.0]).unwrap()[0];
    for (depth, in_focus) in [(0.6, false), (0.6 * 1.333, true)] {
        let parallax = (at(depth, 1.0) - at(depth, -1.0)) / 2.0;
        assert_eq!(parallax.abs() < 2e-6, in_focus, "{depth}: {parallax}");
    }
}

#[test]
fn points_that_are_not_behind_the_wall_are_not_seen() {
    with_camera(0, &tank([5.0, 0.0]), |tracer| {
        assert_eq!(tracer.on_microlenses_mm([0.0, 0.0, 41.0], [0.0; 2]), None);
        assert_eq!(tracer.on_microlenses_mm([0.0, f64::NAN, 0.0], [0.0; 2]), None);
        assert_eq!(tracer.trace(&[source([0.0, 0.0, 60.0])], &[1]).total(), 0.0);
        assert!((tracer.trace(&[source([1.0, 0.5, 3.0])], &[1]).total() - 1000.0).abs() < 0.01);
    });
}
