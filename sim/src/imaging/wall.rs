//! Rays through a flat glass wall: exact by Snell's law at knots of the stop, interpolated in
//! between.
//!
//! Positions are relative to the centre of the main lens, along the camera's right, up and axis.

use lfpiv_hw::Pose;
use nalgebra::{Matrix5, Point3, Rotation3, Unit, Vector3};

use super::{
    flaws::WallSettings,
    main_lens::{MainLens, RayBundle},
};

/// Knots per axis of the interpolation over the stop.
pub(super) const KNOTS: usize = 5;

/// Largest number of iteration steps; five are enough in practice.
const MAX_STEPS: usize = 50;

/// A camera that looks through a wall.
#[derive(Debug, Clone)]
pub(super) struct WallView {
    /// Lens centre and camera directions in the world frame.
    lens_mm: Vector3<f64>,
    directions: [Vector3<f64>; 3],
    /// Layers of the wall in the camera's frame.
    layers: Layers,
    lens: MainLens,
    /// Knots on each axis of the stop, and the matrix that turns values at the knots into
    /// coefficients of a polynomial of u/R.
    knots_mm: [f64; KNOTS],
    to_coefficients: Matrix5<f64>,
}

/// Medium, glass and air, bounded by two parallel planes.
#[derive(Debug, Clone)]
struct Layers {
    /// Unit normal of the wall, towards the camera.
    normal: Vector3<f64>,
    /// Coordinate along `normal` of the wet face.
    wet_face_mm: f64,
    thickness_mm: f64,
    medium_index: f64,
    glass_index: f64,
}

impl WallView {
    /// The view of a camera with the nominal pose `planned`, turned by `turn` about the pose's
    /// origin and then moved by `shift_mm`.
    pub(super) fn new(
        settings: &WallSettings,
        lens: &MainLens,
        planned: &Pose,
        turn: &Rotation3<f64>,
        shift_mm: Vector3<f64>,
    ) -> Self {
        let world = Layers::in_world(settings, planned);
        let planned_lens_mm = world.lens_that_sees(planned, lens.object_distance_mm);
        let lens_mm = planned.origin_mm + shift_mm + turn * (planned_lens_mm - planned.origin_mm);
        let directions = [planned.right, planned.up, planned.axis].map(|d| turn * d);
        let [knots_mm, relative] = knots(lens.stop_radius_mm);
        let powers = Matrix5::from_fn(|knot, power| relative[knot].powi(power as i32));
        Self {
            lens_mm,
            directions,
            layers: Layers {
                normal: Vector3::from(directions.map(|d| d.dot(&world.normal))),
                wet_face_mm: world.wet_face_mm - lens_mm.dot(&world.normal),
                ..world
            },
            lens: lens.clone(),
            knots_mm,
            to_coefficients: powers.try_inverse().expect("the knots are distinct"),
        }
    }

    /// A world position relative to the lens centre.
    fn to_camera(&self, position_mm: &Point3<f64>) -> Vector3<f64> {
        let from_lens_mm = position_mm.coords - self.lens_mm;
        Vector3::from(self.directions.map(|direction| direction.dot(&from_lens_mm)))
    }

    /// The rays of a point in the medium; `None` for a point that is not in the medium.
    pub(super) fn bundle(&self, position_mm: &Point3<f64>) -> Option<RefractedPoint> {
        let seen_mm = self.to_camera(position_mm);
        let mut values = [Matrix5::zeros(), Matrix5::zeros()];
        for (i, &u) in self.knots_mm.iter().enumerate() {
            for (j, &v) in self.knots_mm.iter().enumerate() {
                let place_mm = self.undistorted_mm(seen_mm, [u, v])?;
                for (axis, value) in values.iter_mut().enumerate() {
                    value[(i, j)] = place_mm[axis];
                }
            }
        }
        let mut coefficients =
            values.map(|v| self.to_coefficients * v * self.to_coefficients.transpose());
        let displacement_mm =
            self.lens.displacement_mm(std::array::from_fn(|axis| coefficients[axis][(0, 0)]));
        for (axis, polynomial) in coefficients.iter_mut().enumerate() {
            polynomial[(0, 0)] += displacement_mm[axis];
        }
        Some(RefractedPoint { per_stop_radius: 1.0 / self.lens.stop_radius_mm, coefficients })
    }

    /// Position on the microlens plane, without distortion, of the ray of a point (relative to the
    /// lens) through `stop_mm`. Searches for the position A on the lens whose ray passes the stop
    /// there.
    fn undistorted_mm(&self, seen_mm: Vector3<f64>, stop_mm: [f64; 2]) -> Option<[f64; 2]> {
        let lens = &self.lens;
        // du/dA for the point in focus. It differs little for other points, so the iteration
        // converges fast.
        let per_step = lens.image_distance_mm / lens.stop_to_microlenses_mm();
        let mut on_lens_mm = stop_mm.map(|coordinate| coordinate * per_step);
        for _ in 0..MAX_STEPS {
            let incident = self.layers.slope(seen_mm, on_lens_mm)?;
            // A thin lens changes the slope by the position over the focal length.
            let slope: [f64; 2] = std::array::from_fn(|axis| {
                incident[axis] - on_lens_mm[axis] / lens.focal_length_mm
            });
            let missed: [f64; 2] = std::array::from_fn(|axis| {
                stop_mm[axis] - on_lens_mm[axis] - slope[axis] * lens.stop_mm
            });
            if missed[0].hypot(missed[1]) < 1e-11 {
                let place = |axis: usize| on_lens_mm[axis] + slope[axis] * lens.image_distance_mm;
                return Some([place(0), place(1)]);
            }
            (0..2).for_each(|axis| on_lens_mm[axis] += missed[axis] * per_step);
        }
        None
    }
}

impl Layers {
    /// The wall in the world frame.
    fn in_world(settings: &WallSettings, planned: &Pose) -> Self {
        let about = |direction: Vector3<f64>, angle_deg: f64| {
            Rotation3::from_axis_angle(&Unit::new_normalize(direction), angle_deg.to_radians())
        };
        let [about_right, about_up] = settings.tilt_deg;
        let normal = about(planned.up, about_up) * about(planned.right, about_right) * planned.axis;
        let on_wet_face_mm = planned.origin_mm + planned.axis * settings.distance_mm;
        Self {
            normal,
            wet_face_mm: on_wet_face_mm.dot(&normal),
            thickness_mm: settings.thickness_mm,
            medium_index: settings.medium_index,
            glass_index: settings.glass_index,
        }
    }

    /// Lens position for which the optical axis in air is along `axis` and passes through the
    /// pose's origin, with the origin in focus. The equivalent distance along the ray is l/n for
    /// neighbouring rays perpendicular to the plane of incidence, and l cos²θ/(n cos²θ_n) for those
    /// in the plane (Coddington's equations for a plane). Their mean is the object distance.
    fn lens_that_sees(&self, pose: &Pose, object_distance_mm: f64) -> Vector3<f64> {
        let cosine = pose.axis.dot(&self.normal);
        let along_wall = pose.axis - self.normal * cosine;
        let depth_mm = self.wet_face_mm - pose.origin_mm.dot(&self.normal);
        let layers = [(depth_mm, self.medium_index), (self.thickness_mm, self.glass_index)];
        let (mut place_mm, mut equivalent_mm) = (pose.origin_mm, 0.0);
        for (height_mm, index) in layers {
            let sine = along_wall / index;
            let layer_cosine = (1.0 - sine.norm_squared()).sqrt();
            let length_mm = height_mm / layer_cosine;
            place_mm += (sine + self.normal * layer_cosine) * length_mm;
            let in_plane = (cosine / layer_cosine).powi(2);
            equivalent_mm += length_mm / index * (1.0 + in_plane) / 2.0;
        }
        place_mm + pose.axis * (object_distance_mm - equivalent_mm)
    }

    /// Slope against the optical axis, in air, of the ray from `point_mm` to a position on the
    /// lens. `None` if the point is not in the medium or the lens position is not in air.
    ///
    /// By Snell's law n sin θ is equal in all layers. With the tangent τ in air, the ray advances
    /// by h τ/√(n² + (n² − 1) τ²) along the wall in a layer of height h and index n. The sum is
    /// increasing and concave in τ, so Newton's method started from the tangent at zero never
    /// overshoots.
    fn slope(&self, point_mm: Vector3<f64>, on_lens_mm: [f64; 2]) -> Option<[f64; 2]> {
        let on_lens_mm = Vector3::new(on_lens_mm[0], on_lens_mm[1], 0.0);
        let dry_face_mm = self.wet_face_mm + self.thickness_mm;
        let layers = [
            (self.wet_face_mm - self.normal.dot(&point_mm), self.medium_index),
            (self.thickness_mm, self.glass_index),
            (self.normal.dot(&on_lens_mm) - dry_face_mm, 1.0),
        ];
        // NaN fails this condition, too.
        if !(layers[0].0 > 0.0 && layers[2].0 > 0.0) {
            return None;
        }
        let across_mm = on_lens_mm - point_mm;
        let along_wall_mm = across_mm - self.normal * self.normal.dot(&across_mm);
        let reach_mm = along_wall_mm.norm();
        let paraxial: f64 = layers.iter().map(|(height_mm, index)| height_mm / index).sum();
        let mut tangent = reach_mm / paraxial;
        for _ in 0..MAX_STEPS {
            let (mut missed_mm, mut change_mm) = (reach_mm, 0.0);
            for (height_mm, index) in layers {
                let square = index * index;
                let inverse = 1.0 / (square + (square - 1.0) * tangent * tangent).sqrt();
                missed_mm -= height_mm * tangent * inverse;
                change_mm += height_mm * square * inverse.powi(3);
            }
            let step = missed_mm / change_mm;
            tangent += step;
            if step <= 1e-15 * tangent {
                break;
            }
        }
        let per_mm = if reach_mm > 0.0 { tangent / reach_mm } else { 1.0 / paraxial };
        let direction = self.normal + along_wall_mm * per_mm;
        (direction.z > 0.0).then(|| [direction.x / direction.z, direction.y / direction.z])
    }
}

/// Chebyshev knots on [−R, R] and on [−1, 1].
pub(super) fn knots(radius_mm: f64) -> [[f64; KNOTS]; 2] {
    let relative: [f64; KNOTS] = std::array::from_fn(|knot| {
        (std::f64::consts::PI * (knot as f64 + 0.5) / KNOTS as f64).cos()
    });
    [relative.map(|place| place * radius_mm), relative]
}

/// The rays of a point behind a wall: polynomials of fourth degree along both axes of the stop.
/// Without a wall the first degree is exact. Refraction adds some micrometres of spherical
/// aberration, coma and astigmatism, which are terms of second and third degree.
#[derive(Debug, Clone)]
pub(super) struct RefractedPoint {
    per_stop_radius: f64,
    /// Coefficients of (u/R)^i (v/R)^j for x and y on the microlens plane.
    coefficients: [Matrix5<f64>; 2],
}

impl RayBundle for RefractedPoint {
    #[inline]
    fn on_microlenses_mm(&self, stop_mm: [f64; 2]) -> [f64; 2] {
        let [u, v] = stop_mm.map(|coordinate| coordinate * self.per_stop_radius);
        std::array::from_fn(|axis| {
            let c = &self.coefficients[axis];
            (0..KNOTS).rev().fold(0.0, |sum, j| {
                sum * v + (0..KNOTS).rev().fold(0.0, |inner, i| inner * u + c[(i, j)])
            })
        })
    }
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;
    use crate::{
        imaging::CameraFlaws,
        test_bench::{optics, poses},
    };

    fn view(tilt_deg: [f64; 2], exit_pupil_mm: f64) -> WallView {
        let settings = WallSettings { distance_mm: 40.0, tilt_deg, ..WallSettings::default() };
        let flaws = CameraFlaws { exit_pupil_mm, ..CameraFlaws::default() };
        let lens = MainLens::new(&optics(), &flaws);
        let turn = Rotation3::from_euler_angles(0.01, -0.02, 0.03);
        WallView::new(&settings, &lens, &poses()[1], &turn, Vector3::new(0.1, -0.2, 0.05))
    }

    /// Intersections with both faces of the ray that leaves the lens backwards with a given slope,
    /// by the vector form of Snell's law, n₁ (d₁ × n) = n₂ (d₂ × n).
    fn crossings(layers: &Layers, on_lens: Vector3<f64>, slope: [f64; 2]) -> [Vector3<f64>; 3] {
        let n = layers.normal;
        let refracted = |direction: Vector3<f64>, ratio: f64| {
            let along = (direction - n * direction.dot(&n)) * ratio;
            along - n * (1.0 - along.norm_squared()).sqrt()
        };
        let in_air = -Vector3::new(slope[0], slope[1], 1.0).normalize();
        let in_glass = refracted(in_air, 1.0 / layers.glass_index);
        let in_medium = refracted(in_glass, layers.glass_index / layers.medium_index);
        let reach = |from: Vector3<f64>, direction: Vector3<f64>, face_mm: f64| {
            from + direction * ((face_mm - from.dot(&n)) / direction.dot(&n))
        };
        let dry = reach(on_lens, in_air, layers.wet_face_mm + layers.thickness_mm);
        let wet = reach(dry, in_glass, layers.wet_face_mm);
        [dry, wet, in_medium]
    }

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(64))]

        /// The ray obeys Snell's law at each face.
        #[test]
        fn rays_obey_snells_law_at_both_faces(
            x in -6.0..6.0_f64, y in -6.0..6.0_f64, z in -6.0..6.0_f64,
            about_right in -20.0..20.0_f64, about_up in -20.0..20.0_f64,
            u in -12.0..12.0_f64, v in -12.0..12.0_f64,
        ) {
            let view = view([about_right, about_up], 0.0);
            let point = view.to_camera(&Point3::new(x, y, z));
            let slope = view.layers.slope(point, [u, v]).unwrap();
            let on_lens = Vector3::new(u, v, 0.0);
            let [_, wet, in_medium] = crossings(&view.layers, on_lens, slope);
            let distance = (point - wet).cross(&in_medium).norm();
            prop_assert!(distance < 1e-9, "the ray misses the point by {} mm", distance);
        }

        /// Fermat's principle: to first order the optical path does not change when the
        /// intersections are moved.
        #[test]
        fn the_optical_path_is_stationary(
            x in -6.0..6.0_f64, y in -6.0..6.0_f64, z in -6.0..6.0_f64,
            tilt in -20.0..20.0_f64, u in -12.0..12.0_f64, v in -12.0..12.0_f64,
        ) {
            let view = view([tilt, tilt / 3.0], 0.0);
            let layers = &view.layers;
            let (point, on_lens) = (view.to_camera(&Point3::new(x, y, z)), Vector3::new(u, v, 0.0));
            let slope = layers.slope(point, [u, v]).unwrap();
            let [dry, wet, _] = crossings(layers, on_lens, slope);
            let path_mm = |dry: Vector3<f64>, wet: Vector3<f64>| {
                (on_lens - dry).norm()
                    + layers.glass_index * (dry - wet).norm()
                    + layers.medium_index * (wet - point).norm()
            };
            let along = layers.normal.cross(&Vector3::new(0.3, 0.9, 0.1)).normalize();
            for direction in [along, layers.normal.cross(&along)] {
                for (at_dry, at_wet) in [(1.0, 0.0), (0.0, 1.0), (1.0, 1.0)] {
                    let moved = |mm: f64| {
                        path_mm(dry + direction * (at_dry * mm), wet + direction * (at_wet * mm))
                    };
                    let change = (moved(3e-4) - moved(-3e-4)) / 6e-4;
                    prop_assert!(change.abs() < 1e-8, "{} per mm", change);
                    prop_assert!(moved(1e-2) > moved(0.0) && moved(-1e-2) > moved(0.0));
                }
            }
        }

        /// Interpolated rays between the knots, and beyond the stop's edge up to the corners of its
        /// bounding square, agree with the exact rays within a nanometre.
        #[test]
        fn rays_between_the_knots_are_interpolated_within_a_nanometre(
            x in -6.0..6.0_f64, y in -6.0..6.0_f64, z in -6.0..6.0_f64,
            about_right in -20.0..20.0_f64, about_up in -20.0..20.0_f64,
            exit_pupil_mm in -50.0..80.0_f64,
            u in -1.0..1.0_f64, v in -1.0..1.0_f64,
        ) {
            let view = view([about_right, about_up], exit_pupil_mm);
            let position = Point3::new(x, y, z);
            let stop_mm = [u, v].map(|place| place * view.lens.stop_radius_mm);
            let exact = view.undistorted_mm(view.to_camera(&position), stop_mm).unwrap();
            let drawn = view.bundle(&position).unwrap().on_microlenses_mm(stop_mm);
            let missed = (exact[0] - drawn[0]).hypot(exact[1] - drawn[1]);
            prop_assert!(missed < 1e-6, "{} mm", missed);
        }
    }
}
