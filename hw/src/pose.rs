//! Camera poses: the transformation from world to camera coordinates.

use nalgebra::{Point3, Vector3};
use serde::{Deserialize, Serialize};

/// Orientation and position of one camera in the world frame (right-handed, millimetres).
///
/// `axis` points from the volume to the camera; `right × up = axis`, and `-axis` for a camera that looks
/// into a mirror, whose images are mirrored. `origin_mm` is the world point at which the optical axis
/// crosses the focal plane.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Pose {
    /// Unit vector along increasing pixel column.
    pub right: Vector3<f64>,
    /// Unit vector along decreasing pixel row.
    pub up: Vector3<f64>,
    /// Unit vector from the volume to the camera.
    pub axis: Vector3<f64>,
    /// World point in focus on the optical axis, in mm.
    #[serde(default = "Vector3::zeros")]
    pub origin_mm: Vector3<f64>,
}

/// A world point in camera coordinates, all in mm.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct CameraPoint {
    /// Lateral coordinate along `right`.
    pub xi_mm: f64,
    /// Lateral coordinate along `up`.
    pub eta_mm: f64,
    /// Coordinate along `axis`: positive is nearer to the camera than the focal plane.
    pub depth_mm: f64,
}

impl Pose {
    /// The camera coordinates of a world point.
    pub fn to_camera(&self, world_mm: &Point3<f64>) -> CameraPoint {
        let offset = world_mm.coords - self.origin_mm;
        CameraPoint {
            xi_mm: offset.dot(&self.right),
            eta_mm: offset.dot(&self.up),
            depth_mm: offset.dot(&self.axis),
        }
    }
}

/// Tolerance of configured directions in length and orthogonality.
const DIRECTION_TOLERANCE: f64 = 1e-6;

/// A rule for garde: the vector has unit length.
///
/// # Errors
/// It has another.
pub fn unit_vector(v: &Vector3<f64>, _: &()) -> garde::Result {
    if (v.norm() - 1.0).abs() <= DIRECTION_TOLERANCE {
        Ok(())
    } else {
        Err(garde::Error::new(format!("has length {}, allowed: 1 within 1e-6", v.norm())))
    }
}

/// A rule for garde: an axis completes `right` and `up` to a right-handed triple, or to a left-handed
/// one for a `mirrored` camera.
pub fn completes<'a>(
    right: &'a Vector3<f64>,
    up: &'a Vector3<f64>,
    mirrored: bool,
) -> impl FnOnce(&Vector3<f64>, &()) -> garde::Result + 'a {
    move |axis, _| {
        let (sign, allowed) = match mirrored {
            false => (1.0, "is not right x up; allowed: a right-handed orthonormal triple"),
            true => {
                (-1.0, "is not -(right x up); allowed with mirrored = true: a left-handed triple")
            }
        };
        if (right.cross(up) * sign - axis).norm() <= DIRECTION_TOLERANCE {
            Ok(())
        } else {
            Err(garde::Error::new(allowed))
        }
    }
}

/// A rule for garde: each coordinate is within 100 mm.
///
/// # Errors
/// One is not.
pub fn near_origin(v: &Vector3<f64>, _: &()) -> garde::Result {
    if v.iter().all(|c| c.abs() <= 100.0) {
        Ok(())
    } else {
        Err(garde::Error::new("allowed: each coordinate within -100 to 100 mm"))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Camera 2 of docs/theory.md, section 2.
    fn camera_two() -> Pose {
        Pose {
            right: Vector3::x(),
            up: -Vector3::z(),
            axis: Vector3::y(),
            origin_mm: Vector3::zeros(),
        }
    }

    #[test]
    fn camera_coordinates_are_projections_on_its_directions() {
        let seen = camera_two().to_camera(&Point3::new(1.0, 2.0, 3.0));
        assert_eq!(seen, CameraPoint { xi_mm: 1.0, eta_mm: -3.0, depth_mm: 2.0 });
    }

    #[test]
    fn a_left_handed_triple_is_that_of_a_mirrored_camera() {
        let Pose { right, up, axis, .. } = camera_two();
        let said = |axis: Vector3<f64>, mirrored| completes(&right, &up, mirrored)(&axis, &());
        assert!(said(axis, false).is_ok() && said(-axis, true).is_ok());
        assert!(said(-axis, false).unwrap_err().to_string().contains("right x up"));
        assert!(said(axis, true).unwrap_err().to_string().contains("mirrored"));
        assert!(unit_vector(&Vector3::new(f64::NAN, 0.0, 0.0), &()).is_err());
    }
}
