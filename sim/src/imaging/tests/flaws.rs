//! Deviations of main lens, stop and pose.

use super::*;

/// Calls `look` with the tracer of camera `number` with `flaws`.
pub(super) fn with_camera<T>(
    number: usize,
    flaws: &CameraFlaws,
    look: impl FnOnce(&RayTracer<'_>) -> T,
) -> T {
    let optics = optics();
    look(&RayTracer::imperfect(&optics, &poses()[number], [0.0; 3], flaws, &settings(4096)))
}

/// Position of one ray of camera 1 on the microlens plane.
fn meets_mm(flaws: &CameraFlaws, position_mm: [f64; 3], stop_mm: [f64; 2]) -> [f64; 2] {
    with_camera(0, flaws, |tracer| tracer.on_microlenses_mm(position_mm, stop_mm).unwrap())
}

fn close(a: [f64; 2], b: [f64; 2], tolerance: f64) -> bool {
    (a[0] - b[0]).abs() < tolerance && (a[1] - b[1]).abs() < tolerance
}

/// Follows a ray from an object point through a position on the lens, using straight lines and
/// thin-lens refraction only. Returns its positions on the stop and on the microlens plane.
fn follow_ray(object: [f64; 2], depth: f64, on_lens: [f64; 2], stop: f64) -> [[f64; 2]; 2] {
    let at = |distance: f64| {
        std::array::from_fn(|axis| {
            let slope = (on_lens[axis] - object[axis]) / (200.0 - depth) - on_lens[axis] / 100.0;
            on_lens[axis] + slope * distance
        })
    };
    [at(stop), at(200.0)]
}

#[test]
fn rays_through_a_stop_away_from_the_lens_are_correct() {
    for exit_pupil_mm in [-60.0, 0.0, 35.0, 120.0] {
        let flaws = CameraFlaws { exit_pupil_mm, ..CameraFlaws::default() };
        for (object, depth, on_lens) in
            [([0.0, 0.0], 3.0, [8.0, -2.0]), ([4.0, -3.0], -4.0, [-5.0, 6.0])]
        {
            let [stop_mm, plane_mm] = follow_ray(object, depth, on_lens, exit_pupil_mm);
            let met_mm = meets_mm(&flaws, [object[0], object[1], depth], stop_mm);
            assert!(close(met_mm, plane_mm, 1e-10), "{met_mm:?} instead of {plane_mm:?}");
        }
    }
}

/// x = u + (ξ' − u)(s_i − d)/(s' − d). To first order, parallax per stop radius is that of a stop
/// in the lens, because the stop keeps the working f-number; only the chief ray differs.
#[test]
fn the_exit_pupil_changes_parallax_by_its_formula() {
    let (depth, object_mm, stop_mm) = (4.0_f64, 5.0_f64, 40.0_f64);
    let flaws = CameraFlaws { exit_pupil_mm: stop_mm, ..CameraFlaws::default() };
    let s = 200.0 - depth;
    let conjugate = 100.0 * s / (s - 100.0);
    let image_mm = -object_mm * conjugate / s;
    let radius_mm = with_camera(0, &flaws, |tracer| tracer.lens.stop_radius_mm);
    assert!((radius_mm - 12.5 * 160.0 / 200.0).abs() < 1e-12, "{radius_mm}");
    for u in [-radius_mm, 0.0, radius_mm] {
        let expected = u + (image_mm - u) * (200.0 - stop_mm) / (conjugate - stop_mm);
        let met_mm = meets_mm(&flaws, [object_mm, 0.0, depth], [u, 0.0]);
        assert!((met_mm[0] - expected).abs() < 1e-10, "{met_mm:?} instead of {expected}");
    }
    let [perfect, moved] = [(CameraFlaws::default(), 12.5), (flaws, radius_mm)]
        .map(|(f, u)| meets_mm(&f, [0.0, 0.0, depth], [u, 0.0])[0]);
    assert!((moved / perfect - 1.0).abs() < 0.03, "{moved} against {perfect}");
}

/// Displacements by the formula of [`Distortion`], with r_h = 8.0914 mm.
#[test]
fn distortion_moves_all_rays_of_a_point_by_the_stated_amount() {
    let (radial, tangential) = (0.02, [0.003, -0.002]);
    let flaws =
        CameraFlaws { distortion: Distortion { radial, tangential }, ..CameraFlaws::default() };
    let half_diagonal_mm = 2352.0_f64.hypot(1768.0) * 0.0055 / 2.0;
    // A point in focus at the corner of the sensor is displaced by `radial` and the tangential
    // terms.
    let corner_mm = [2352.0, 1768.0].map(|count| count * 0.0055 / 2.0);
    let object_mm = [-corner_mm[0], -corner_mm[1], 0.0];
    let [x, y] = corner_mm.map(|place_mm| place_mm / half_diagonal_mm);
    let expected = [
        radial * x + 0.003 * 2.0 * x * y - 0.002 * (1.0 + 2.0 * x * x),
        radial * y + 0.003 * (1.0 + 2.0 * y * y) - 0.002 * 2.0 * x * y,
    ];
    for stop_mm in [[0.0; 2], [7.0, -9.0]] {
        let met_mm = meets_mm(&flaws, object_mm, stop_mm);
        let moved =
            [met_mm[0] - corner_mm[0], met_mm[1] - corner_mm[1]].map(|mm| mm / half_diagonal_mm);
        assert!(close(moved, expected, 1e-12), "{moved:?} instead of {expected:?}");
    }
}

/// Out of focus, a point's light covers many microlenses, so its centroid is not tied to their
/// centres.
#[test]
fn distortion_moves_the_light_on_the_sensor() {
    let flaws = CameraFlaws {
        distortion: Distortion { radial: 0.03, ..Distortion::default() },
        ..CameraFlaws::default()
    };
    let position_mm = [4.0, -2.5, 5.0];
    let light = |flaws: &CameraFlaws| {
        with_camera(0, flaws, |tracer| tracer.trace(&[source(position_mm)], &[1]))
    };
    let (straight, bent) =
        (centroid_mm(&light(&CameraFlaws::default())), centroid_mm(&light(&flaws)));
    // The chief ray's image is at 200/195 of the object; the micro-image grid is 1.004 times
    // larger.
    let chief_mm = [-4.0, 2.5].map(|mm| mm * 200.0 / 195.0);
    let square = (chief_mm[0] * chief_mm[0] + chief_mm[1] * chief_mm[1]) / 65.472;
    for axis in [0, 1] {
        let expected = 0.03 * chief_mm[axis] * square * 1.004;
        let moved = bent[axis] - straight[axis];
        assert!((moved - expected).abs() < 0.002, "{moved} instead of {expected} mm");
    }
}

/// Turning the camera about its point in focus turns the image in the opposite direction.
#[test]
fn a_turned_camera_sees_the_world_turned_the_other_way() {
    let position_mm = [1.0, -2.0, 1.5];
    for (turn_deg, axis) in [
        ([0.4, 0.0, 0.0], Vector3::x()),
        ([0.0, -3.0, 0.0], Vector3::y()),
        ([0.0, 0.0, 7.0], Vector3::z()),
    ] {
        let angle = f64::to_radians(turn_deg.iter().sum());
        let back = Rotation3::new(axis * -angle) * Vector3::from(position_mm);
        for camera in [0, 1] {
            let flaws = CameraFlaws { turn_deg, ..CameraFlaws::default() };
            let stop_mm = [3.0, -8.0];
            let turned = with_camera(camera, &flaws, |tracer| {
                tracer.on_microlenses_mm(position_mm, stop_mm).unwrap()
            });
            let straight = with_camera(camera, &CameraFlaws::default(), |tracer| {
                tracer.on_microlenses_mm(back.into(), stop_mm).unwrap()
            });
            assert!(close(turned, straight, 1e-12), "{turned:?} instead of {straight:?}");
        }
    }
}

#[test]
fn a_second_aperture_blocks_light_at_the_edge_but_not_on_the_axis() {
    let cut = CameraFlaws {
        vignetting: Some(SecondAperture { radius_mm: 10.0, behind_lens_mm: 40.0 }),
        ..CameraFlaws::default()
    };
    let total = |x_mm| {
        with_camera(0, &cut, |tracer| tracer.trace(&[source([x_mm, 0.0, 0.0])], &[1]).total())
    };
    // On the axis the beam's radius at the aperture is 12.5 × 160/200 = 10 mm.
    assert!(total(0.0) > 999.0 && total(6.0) < 960.0, "{} and {}", total(0.0), total(6.0));
}
