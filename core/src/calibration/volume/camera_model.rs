//! Rays of a camera, traced from the microlens array back into the volume.
//!
//! A ray is described by its positions on the microlens plane and on the pupil of the nominal camera, both in mm
//! along the sensor's `right` and `up`. A pixel determines these for any lens, from its microlens and its position
//! in the micro-image.

use lfpiv_hw::{Optics, Pose, card::Wall};
use nalgebra::{Point3, Rotation3, Unit, Vector3};

use super::parameters::CameraParameters;
use crate::model::EquivalentPoint;

/// Largest number of iterations of [`CameraModel::place_mm`]. Each reduces the error to a few per cent,
/// depending on distortion and refraction.
const MOST_STEPS: usize = 30;

/// Largest distance of a ray from its point, in mm.
const TOLERANCE_MM: f64 = 1e-9;

/// Pupil position of the rays that give the parallax slope, as a share of the pupil's radius.
const PUPIL_SHARE: f64 = 0.5;

/// Model of one camera behind a wall.
#[derive(Debug, Clone)]
pub(super) struct CameraModel {
    optics: Optics,
    parameters: CameraParameters,
    /// Distance from the main lens to the microlens plane.
    image_distance_mm: f64,
    /// Distance from the main lens to the stop, towards the sensor.
    stop_mm: f64,
    half_diagonal_mm: f64,
    /// Position of the main lens in the world.
    lens_mm: Point3<f64>,
    /// Directions `right`, `up` and `axis` of the camera in the world.
    directions: [Vector3<f64>; 3],
    /// Nominal point in focus.
    origin_mm: Point3<f64>,
    wall: Option<TiltedWall>,
}

/// A flat window; the medium is behind its wet face.
#[derive(Debug, Clone)]
struct TiltedWall {
    /// Unit normal, towards the camera.
    normal: Vector3<f64>,
    /// Point on the wet face.
    wet_mm: Point3<f64>,
    thickness_mm: f64,
    glass_index: f64,
    medium_index: f64,
}

/// A ray with its unit direction into the volume.
#[derive(Debug, Clone, Copy)]
struct Ray {
    from_mm: Point3<f64>,
    direction: Vector3<f64>,
}

impl CameraModel {
    pub(super) fn new(
        optics: &Optics,
        pose: &Pose,
        wall: Option<&Wall>,
        parameters: CameraParameters,
    ) -> Self {
        let [about_right, about_up, about_axis] = parameters.turn_rad();
        let about = |direction: &Vector3<f64>, angle: f64| {
            Rotation3::from_axis_angle(&Unit::new_normalize(*direction), angle)
        };
        let turn = about(&pose.axis, about_axis)
            * about(&pose.up, about_up)
            * about(&pose.right, about_right);
        let [right, up, along] = parameters.shift_mm();
        let origin_mm = Point3::from(pose.origin_mm);
        let moved_mm = origin_mm + pose.right * right + pose.up * up + pose.axis * along;
        let directions = [pose.right, pose.up, pose.axis].map(|direction| turn * direction);
        // A layer of index n has 1/n of its thickness optically. The lens is farther away by the difference.
        let layer_shift_mm = wall.map_or(0.0, |wall| {
            wall.distance_mm * (1.0 - 1.0 / wall.medium_index)
                + wall.thickness_mm * (1.0 - 1.0 / wall.glass_index)
        });
        let [tilt_right, tilt_up] = parameters.wall_tilt_rad();
        let wall = wall.map(|wall| TiltedWall {
            normal: about(&pose.up, tilt_up) * about(&pose.right, tilt_right) * pose.axis,
            wet_mm: origin_mm + pose.axis * wall.distance_mm,
            thickness_mm: wall.thickness_mm,
            glass_index: wall.glass_index,
            medium_index: wall.medium_index,
        });
        let (columns, rows) = (optics.sensor.columns as f64, optics.sensor.rows as f64);
        Self {
            image_distance_mm: optics.image_distance_mm() * parameters.image_distance(),
            stop_mm: parameters.exit_pupil_mm(),
            half_diagonal_mm: columns.hypot(rows) * optics.pixel_pitch_mm() / 2.0,
            lens_mm: moved_mm + directions[2] * (optics.object_distance_mm + layer_shift_mm),
            directions,
            origin_mm,
            wall,
            optics: optics.clone(),
            parameters,
        }
    }

    /// Unit vector along the optical axis, towards the camera.
    pub(super) fn axis(&self) -> Vector3<f64> {
        self.directions[2]
    }

    /// Intersection of the ray through `place_mm` on the microlens plane and `pupil_mm` on the nominal pupil
    /// with the plane through `on_plane_mm` with this normal. `None` if it misses the wall or the plane.
    pub(super) fn intersection_mm(
        &self,
        place_mm: [f64; 2],
        pupil_mm: [f64; 2],
        on_plane_mm: &Point3<f64>,
        normal: &Vector3<f64>,
    ) -> Option<Point3<f64>> {
        let stop_mm = self.on_stop_mm(pupil_mm);
        let slope = self.pupil_slope(on_plane_mm);
        let principal_mm = self.parameters.principal_point_mm();
        let unscaled_mm: [f64; 2] = std::array::from_fn(|axis| {
            (place_mm[axis] - principal_mm[axis]) / self.parameters.magnification()
        });
        // Distortion displaces all rays of a point like its chief ray. It is inverted by fixed-point iteration.
        let mut chief_mm: [f64; 2] =
            std::array::from_fn(|axis| unscaled_mm[axis] - slope * stop_mm[axis]);
        let distorted_mm = chief_mm;
        for _ in 0..3 {
            let by_mm = self.displacement_mm(chief_mm);
            chief_mm = std::array::from_fn(|axis| distorted_mm[axis] - by_mm[axis]);
        }
        let by_mm = self.displacement_mm(chief_mm);
        let undistorted_mm = std::array::from_fn(|axis| unscaled_mm[axis] - by_mm[axis]);
        let ray = self.refracted_by_wall(self.object_ray(undistorted_mm, stop_mm))?;
        let cosine = ray.direction.dot(normal);
        let along = (on_plane_mm - ray.from_mm).dot(normal) / cosine;
        (along.is_finite() && along > 0.0).then(|| ray.from_mm + ray.direction * along)
    }

    /// Intersection of the microlens plane and the ray from a world point through `pupil_mm` on the nominal
    /// pupil, in mm.
    pub(super) fn place_mm(&self, point_mm: &Point3<f64>, pupil_mm: [f64; 2]) -> Option<[f64; 2]> {
        let per_mm = self.optics.image_distance_mm() / self.optics.object_distance_mm;
        let mut place_mm = [0.0; 2];
        for _ in 0..MOST_STEPS {
            let met_mm = self.intersection_mm(place_mm, pupil_mm, point_mm, &self.directions[2])?;
            let error_mm = met_mm - point_mm;
            for (place, direction) in place_mm.iter_mut().zip(&self.directions) {
                *place += error_mm.dot(direction) * per_mm;
            }
            if error_mm.norm() < TOLERANCE_MM {
                return Some(place_mm);
            }
        }
        None
    }

    /// Place of a world point's rays through the middle of the pupil, in mm, and its derivative with respect to the
    /// position on the nominal pupil along each axis (the parallax slope).
    pub(super) fn place_and_slope(&self, point_mm: &Point3<f64>) -> Option<[[f64; 2]; 2]> {
        let off_mm = PUPIL_SHARE * self.optics.pupil_diameter_mm() / 2.0;
        let mut slopes = [0.0; 2];
        for (axis, slope) in slopes.iter_mut().enumerate() {
            let through = |sign: f64| {
                let mut pupil_mm = [0.0; 2];
                pupil_mm[axis] = sign * off_mm;
                Some(self.place_mm(point_mm, pupil_mm)?[axis])
            };
            *slope = (through(1.0)? - through(-1.0)?) / (2.0 * off_mm);
        }
        Some([self.place_mm(point_mm, [0.0; 2])?, slopes])
    }

    /// Equivalent point of the nominal ideal camera for a world point.
    pub(super) fn equivalent(&self, point_mm: &Point3<f64>) -> Option<EquivalentPoint> {
        let [place_mm, slopes] = self.place_and_slope(point_mm)?;
        Some(EquivalentPoint::of_rays(&self.optics, place_mm, slopes))
    }

    /// Position on the stop, in mm, of the ray at `pupil_mm` on the nominal pupil. Both belong to the same pixel,
    /// the nominal pupil with nominal distances.
    fn on_stop_mm(&self, pupil_mm: [f64; 2]) -> [f64; 2] {
        let scale = self.parameters.parallax_slope() * (self.image_distance_mm - self.stop_mm)
            / self.optics.image_distance_mm();
        pupil_mm.map(|place| place * scale)
    }

    /// Approximate derivative of a point's place with respect to the position on the stop: a = 1 − g/s' of
    /// docs/theory.md, section 2, with the apparent depth behind the wall.
    fn pupil_slope(&self, point_mm: &Point3<f64>) -> f64 {
        let index = self.wall.as_ref().map_or(1.0, |wall| wall.medium_index);
        let depth_mm = (point_mm - self.origin_mm).dot(&self.directions[2]) / index;
        let distance_mm = self.optics.object_distance_mm - depth_mm;
        let inverse_conjugate = 1.0 / self.optics.focal_length_mm - 1.0 / distance_mm;
        let towards_image =
            (self.image_distance_mm - self.stop_mm) / (1.0 - self.stop_mm * inverse_conjugate);
        1.0 - towards_image * inverse_conjugate
    }

    /// Distortion of the chief ray, in mm (Brown-Conrady model, relative to the sensor's half diagonal).
    fn displacement_mm(&self, chief_mm: [f64; 2]) -> [f64; 2] {
        let [radial, p1, p2] = self.parameters.distortion();
        let [x, y] = chief_mm.map(|place_mm| place_mm / self.half_diagonal_mm);
        let square = x * x + y * y;
        [
            radial * x * square + 2.0 * p1 * x * y + p2 * (square + 2.0 * x * x),
            radial * y * square + p1 * (square + 2.0 * y * y) + 2.0 * p2 * x * y,
        ]
        .map(|relative| relative * self.half_diagonal_mm)
    }

    /// The ray on the object side of the lens, away from it.
    fn object_ray(&self, place_mm: [f64; 2], stop_mm: [f64; 2]) -> Ray {
        let stop_to_image_mm = self.image_distance_mm - self.stop_mm;
        let slope: [f64; 2] =
            std::array::from_fn(|axis| (place_mm[axis] - stop_mm[axis]) / stop_to_image_mm);
        let on_lens_mm: [f64; 2] =
            std::array::from_fn(|axis| place_mm[axis] - slope[axis] * self.image_distance_mm);
        // A thin lens changes the slope of a ray by its height over the focal length.
        let before: [f64; 2] = std::array::from_fn(|axis| {
            slope[axis] + on_lens_mm[axis] / self.optics.focal_length_mm
        });
        let [right, up, axis] = &self.directions;
        Ray {
            from_mm: self.lens_mm + right * on_lens_mm[0] + up * on_lens_mm[1],
            direction: -(right * before[0] + up * before[1] + axis).normalize(),
        }
    }

    /// The ray in the medium. `None` if it misses the wall.
    fn refracted_by_wall(&self, ray: Ray) -> Option<Ray> {
        let Some(wall) = &self.wall else { return Some(ray) };
        let dry_mm = wall.wet_mm + wall.normal * wall.thickness_mm;
        let in_glass = refracted(ray, &dry_mm, &wall.normal, 1.0 / wall.glass_index)?;
        refracted(in_glass, &wall.wet_mm, &wall.normal, wall.glass_index / wall.medium_index)
    }
}

/// The refracted ray behind a plane, by Snell's law in vector form. `normal` is a unit vector against the ray;
/// `ratio` is the refractive index before the plane divided by that behind it.
fn refracted(
    ray: Ray,
    on_plane_mm: &Point3<f64>,
    normal: &Vector3<f64>,
    ratio: f64,
) -> Option<Ray> {
    let cosine = -ray.direction.dot(normal);
    let along = (on_plane_mm - ray.from_mm).dot(normal) / -cosine;
    if !(along > 0.0 && cosine > 0.0) {
        return None;
    }
    let square = 1.0 - ratio * ratio * (1.0 - cosine * cosine);
    (square > 0.0).then(|| Ray {
        from_mm: ray.from_mm + ray.direction * along,
        direction: ray.direction * ratio + normal * (ratio * cosine - square.sqrt()),
    })
}
