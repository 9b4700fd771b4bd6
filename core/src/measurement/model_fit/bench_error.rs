//! Errors of a configured bench, and the apparent particle positions that they cause.

use lfpiv_hw::{CameraPoint, Optics, Pose};
use nalgebra::{Point3, Rotation3, SMatrix, Vector3};

/// Parameters of a bench error: shift of the second camera along x, y, z in mm, its rotation about
/// x, y, z through the middle of the volume in rad, and the object distance of both cameras in mm.
pub const PARAMETERS: usize = 7;

/// Steps for finite differences, in the units of the parameters.
const STEPS: [f64; PARAMETERS] = [0.01, 0.01, 0.01, 1e-3, 1e-3, 1e-3, 0.1];

/// Derivative of the difference between both cameras' particle positions by each parameter.
pub type Sensitivity = SMatrix<f64, 3, PARAMETERS>;

/// The configured bench.
#[derive(Debug, Clone, Copy)]
pub struct ConfiguredBench<'a> {
    pub optics: &'a Optics,
    pub poses: [&'a Pose; 2],
    /// Middle of the volume, the centre of rotation of the second camera.
    pub middle: Vector3<f64>,
}

impl ConfiguredBench<'_> {
    /// Derivatives of (position by camera 2) − (position by camera 1) for a particle at `at_mm`, by the
    /// parameters of the bench error.
    pub fn sensitivity(&self, at_mm: &Point3<f64>) -> Sensitivity {
        let mut sensitivity = Sensitivity::zeros();
        for (n, step) in STEPS.into_iter().enumerate() {
            let [low, high] = [-step, step].map(|value| self.apart(n, value, at_mm));
            sensitivity.set_column(n, &((high - low) / (2.0 * step)));
        }
        sensitivity
    }

    /// Difference between the positions that the configured cameras assign to a particle, if
    /// parameter `n` of the real bench differs by `value`.
    fn apart(&self, n: usize, value: f64, at_mm: &Point3<f64>) -> Vector3<f64> {
        let [first, second] = self.poses;
        let mut optics = self.optics.clone();
        let mut moved = second.clone();
        match n {
            0..3 => moved.origin_mm[n] += value,
            3..6 => {
                let mut axis_angle = Vector3::zeros();
                axis_angle[n - 3] = value;
                let turn = Rotation3::new(axis_angle);
                moved = Pose {
                    right: turn * moved.right,
                    up: turn * moved.up,
                    axis: turn * moved.axis,
                    origin_mm: self.middle + turn * (moved.origin_mm - self.middle),
                };
            }
            _ => optics.object_distance_mm += value,
        }
        let place = |real: &Pose, configured: &Pose| {
            let seen = real.to_camera(at_mm);
            in_world(&apparent(&optics, self.optics, &seen), configured)
        };
        place(&moved, second) - place(first, first)
    }
}

/// Apparent position: where a camera with the `configured` optics places a point that a camera with the
/// `real` optics sees.
///
/// The ray through pupil point U meets the microlens plane at x = a U + b ξ. It is interpreted as a
/// ray through U' = x − (x − U) s_i'/s_i, because pixels measure the slope of rays behind the lens.
/// Depth and position follow from the line x(U') as in [`crate::model::footprint`].
fn apparent(real: &Optics, configured: &Optics, seen: &CameraPoint) -> CameraPoint {
    let s = real.object_distance_mm - seen.depth_mm;
    let (s_i, s_i_configured) = (real.image_distance_mm(), configured.image_distance_mm());
    let slope = 1.0 - s_i / real.conjugate_distance_mm(s);
    let k = s_i_configured / s_i;
    let slope_seen = slope / (slope * (1.0 - k) + k);
    let behind_mm = s_i_configured / (1.0 - slope_seen);
    let s_seen = configured.conjugate_distance_mm(behind_mm);
    let lateral = |position_mm: f64| {
        let x = -s_i / s * position_mm * (1.0 - slope_seen * (1.0 - k));
        -x * s_seen / s_i_configured
    };
    CameraPoint {
        xi_mm: lateral(seen.xi_mm),
        eta_mm: lateral(seen.eta_mm),
        depth_mm: configured.object_distance_mm - s_seen,
    }
}

fn in_world(point: &CameraPoint, pose: &Pose) -> Vector3<f64> {
    pose.origin_mm + pose.right * point.xi_mm + pose.up * point.eta_mm + pose.axis * point.depth_mm
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::test_bench;

    #[test]
    fn a_configured_bench_puts_points_where_they_are() {
        let optics = test_bench::optics();
        let seen = CameraPoint { xi_mm: 3.0, eta_mm: -2.0, depth_mm: 1.5 };
        let found = apparent(&optics, &optics, &seen);
        assert!((found.xi_mm - 3.0).abs() < 1e-9 && (found.eta_mm + 2.0).abs() < 1e-9);
        assert!((found.depth_mm - 1.5).abs() < 1e-9);
    }

    #[test]
    fn a_shift_moves_all_particles_and_a_distance_scales_them() {
        let (optics, poses) = (test_bench::optics(), test_bench::poses());
        let bench = ConfiguredBench {
            optics: &optics,
            poses: [&poses[0], &poses[1]],
            middle: Vector3::zeros(),
        };
        let at = Point3::new(2.0, 3.0, -1.0);
        let sensitivity = bench.sensitivity(&at);
        for axis in 0..3 {
            let column = sensitivity.column(axis);
            assert!((column[axis] + 1.0).abs() < 1e-6 && (column.norm() - 1.0).abs() < 1e-6);
        }
        // Closer cameras magnify the transverse directions, and stretch depth twice as much.
        let by_distance = sensitivity.column(PARAMETERS - 1);
        assert!(by_distance[0].abs() < 1e-3, "{by_distance}");
        assert!(by_distance[1].abs() > 0.02 && by_distance[2].abs() > 0.005, "{by_distance}");
    }
}
