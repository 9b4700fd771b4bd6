//! Shares of a volume in the cameras' fields of view, and the angle between cameras.

use lfpiv_hw::{Optics, Pose};
use nalgebra::{Point3, Vector3};

use super::{VolumeGrid, footprint::RayMap};

/// Largest number of test points along each axis of the volume. The error of a share is about 1/40.
const MOST_POINTS: usize = 40;

/// Shares of a volume in the cameras' fields of view, 0 to 1.
#[derive(Debug, Clone, PartialEq)]
pub struct Sight {
    /// Share in the field of view of each camera.
    pub each: Vec<f64>,
    /// Share in the common field of view of all cameras.
    pub common: f64,
}

impl Sight {
    /// The shares for these cameras. A point is in the field of view if its ray through the middle of the main lens
    /// meets a microlens.
    pub fn new(optics: &Optics, poses: &[Pose], grid: &VolumeGrid) -> Self {
        let places = grid.voxels.map(|n| n.clamp(1, MOST_POINTS));
        let (mut each, mut common) = (vec![0_usize; poses.len()], 0_usize);
        for linear in 0..places.iter().product::<usize>() {
            let [nx, ny, _] = places;
            let ijk = [linear % nx, linear / nx % ny, linear / (nx * ny)];
            let place = Point3::from(std::array::from_fn::<f64, 3, _>(|axis| {
                let share = (ijk[axis] as f64 + 0.5) / places[axis] as f64;
                grid.coordinate_mm(axis, share * grid.voxels[axis] as f64 - 0.5)
            }));
            let mut by_all = true;
            for (pose, seen) in poses.iter().zip(&mut each) {
                let by_this = is_in_field(optics, pose, &place);
                *seen += usize::from(by_this);
                by_all &= by_this;
            }
            common += usize::from(by_all);
        }
        let all = places.iter().product::<usize>() as f64;
        let each = each.into_iter().map(|seen| seen as f64 / all).collect();
        Self { each, common: common as f64 / all }
    }
}

fn is_in_field(optics: &Optics, pose: &Pose, place: &Point3<f64>) -> bool {
    let at = pose.to_camera(place);
    if at.depth_mm >= optics.object_distance_mm - optics.focal_length_mm {
        return false;
    }
    let array = &optics.microlens;
    let magnification = RayMap::at_depth(optics, at.depth_mm).position.abs();
    let inside = |lateral_mm: f64, microlenses: usize| {
        magnification * lateral_mm.abs() <= microlenses as f64 * array.pitch_mm / 2.0
    };
    inside(at.xi_mm, array.columns) && inside(at.eta_mm, array.rows)
}

/// Angle at the volume's centre between the directions to the lenses of two cameras, in degrees.
pub fn degrees_apart(optics: &Optics, poses: [&Pose; 2], grid: &VolumeGrid) -> f64 {
    let centre = Vector3::from(grid.centre_mm);
    let [one, other] =
        poses.map(|pose| pose.origin_mm + optics.object_distance_mm * pose.axis - centre);
    one.angle(&other).to_degrees()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::test_bench;

    fn grid(voxels: [usize; 3], centre_mm: [f64; 3]) -> VolumeGrid {
        VolumeGrid { voxels, voxel_mm: 0.1, centre_mm }
    }

    #[test]
    fn shares_are_those_of_the_field_of_view() {
        let (optics, poses) = (test_bench::optics(), test_bench::poses());
        let of = |voxels, centre_mm| Sight::new(&optics, &poses, &grid(voxels, centre_mm));
        assert_eq!(of([100, 80, 80], [0.0; 3]), Sight { each: vec![1.0, 1.0], common: 1.0 });
        // 12.9 of 40 mm along x, which is lateral for both cameras.
        let long = of([400, 80, 80], [0.0; 3]);
        assert!((long.common - 12.9 / 40.0).abs() < 0.02, "{long:?}");
        // The field of camera 1 is 9.7 of 20 mm along y. Camera 2 is along y, where its field changes in width.
        let high = of([80, 200, 80], [0.0; 3]);
        assert!((high.each[0] - 9.7 / 20.0).abs() < 0.03 && high.each[1] > 0.99, "{high:?}");
        assert_eq!(of([80, 80, 80], [50.0, 0.0, 0.0]).common, 0.0);
    }

    #[test]
    fn a_volume_that_reaches_the_lens_is_not_seen_there() {
        let (optics, poses) = (test_bench::optics(), test_bench::poses());
        let grid = VolumeGrid { voxels: [4, 4, 400], voxel_mm: 1.0, centre_mm: [0.0; 3] };
        assert!(Sight::new(&optics, &poses[..1], &grid).each[0] < 0.8);
    }

    #[test]
    fn cameras_look_from_as_far_apart_as_their_lenses_stand() {
        let (optics, mut poses) = (test_bench::optics(), test_bench::poses());
        let grid = grid([10; 3], [0.0; 3]);
        let apart = |poses: &[Pose]| degrees_apart(&optics, [&poses[0], &poses[1]], &grid);
        assert!((apart(&poses) - 90.0).abs() < 1e-9);
        poses[1] = poses[0].clone();
        assert_eq!(apart(&poses), 0.0);
        // 10 mm apart at a distance of 200 mm.
        poses[1].origin_mm.x = 10.0;
        assert!((apart(&poses) - (10.0_f64 / 200.0).atan().to_degrees()).abs() < 1e-9);
    }
}
