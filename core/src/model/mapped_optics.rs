//! Projection of points onto a camera's array, in microlenses.
//!
//! A ray from a point in front of the thin lens meets the microlens plane at x = a U + b ξ
//! (docs/theory.md, sections 2 and 4), with separate a and b for columns and rows according to
//! their depths. In microlenses this is position + a V, with V the pupil point U in the same unit.

use std::sync::Arc;

use lfpiv_hw::{CameraName, Optics, Pose};
use nalgebra::Point3;

use crate::{
    lightfield::{GridSampling, MicroImageGrid, MicrolensWindow},
    model::{
        CameraCalibration, EquivalentPoint, ModelError, VolumeGrid, VolumeMap, footprint::RayMap,
    },
};

/// Margin around the microlenses that light from the volume's corners and midpoints reaches, in microlenses.
const MARGIN: f64 = 2.0;

/// Geometry of one camera with its calibration.
#[derive(Debug, Clone)]
pub struct MappedOptics {
    pub optics: Optics,
    pub sampling: Arc<GridSampling>,
    /// The microlenses that light from the grid can reach.
    pub window: MicrolensWindow,
    pose: Pose,
    map: Option<VolumeMap>,
    /// Microlenses along i and j per mm on the microlens plane along `right` and `up`.
    lenses_per_mm: [[f64; 2]; 2],
    /// Fractional microlens index on the optical axis, relative to the array's first.
    on_axis: [f64; 2],
}

/// Projection of a point by one camera, along the array's columns and rows.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ProjectedPoint {
    /// Fractional microlens index of the ray through the pupil's centre, relative to the window's first.
    pub place: [f64; 2],
    /// Scale of the map from pupil points to the microlens plane (a).
    pub parallax: [f64; 2],
    /// Depths of the equivalent point, in mm.
    pub depth_mm: [f64; 2],
}

impl MappedOptics {
    /// The geometry of camera `camera` for `volume`.
    ///
    /// # Errors
    /// The array is not square, the grid is not in the camera's field, or it extends to the lens.
    pub fn new(
        optics: &Optics,
        pose: &Pose,
        calibration: &CameraCalibration,
        volume: &VolumeGrid,
        camera: CameraName,
    ) -> Result<Self, ModelError> {
        let nominal = || MicroImageGrid::nominal(optics);
        let grid = calibration.grid.clone().unwrap_or_else(nominal);
        if !grid.is_square() {
            return Err(ModelError::NotSquare { camera });
        }
        let middle = [optics.sensor.columns, optics.sensor.rows].map(|n| (n as f64 - 1.0) / 2.0);
        // The micro-image pitch is larger than the microlens pitch by 1 + f_m/s_i.
        let mm_per_px = optics.pixel_pitch_mm() / optics.micro_image_magnification();
        let at = |column: f64, row: f64| grid.lens_at(middle[0] + column, middle[1] - row);
        let (on_axis, right, up) = (at(0.0, 0.0), at(1.0, 0.0), at(0.0, 1.0));
        let lenses_per_mm =
            [0, 1].map(|n| [right, up].map(|next| (next[n] - on_axis[n]) / mm_per_px));
        let mut mapped = Self {
            optics: optics.clone(),
            sampling: Arc::new(GridSampling::new(optics, &grid)),
            window: MicrolensWindow { columns: 0..1, rows: 0..1 },
            pose: pose.clone(),
            map: calibration.map.clone(),
            lenses_per_mm,
            on_axis,
        };
        mapped.window = mapped.window_of(volume, camera)?;
        Ok(mapped)
    }

    fn equivalent(&self, world_mm: &Point3<f64>) -> EquivalentPoint {
        match &self.map {
            Some(map) => map.at(world_mm),
            None => {
                let point = self.pose.to_camera(world_mm);
                EquivalentPoint {
                    lateral_mm: [point.xi_mm, point.eta_mm],
                    depth_mm: [point.depth_mm; 2],
                }
            }
        }
    }

    /// Projects a world point.
    pub fn project(&self, world_mm: &Point3<f64>) -> ProjectedPoint {
        let mut projected = self.project_on_array(world_mm);
        projected.place[0] -= self.window.columns.start as f64;
        projected.place[1] -= self.window.rows.start as f64;
        projected
    }

    /// As [`Self::project`], with positions relative to the array's first microlens.
    fn project_on_array(&self, world_mm: &Point3<f64>) -> ProjectedPoint {
        let EquivalentPoint { lateral_mm: [xi, eta], depth_mm } = self.equivalent(world_mm);
        let maps = depth_mm.map(|depth| RayMap::at_depth(&self.optics, depth));
        let place = [0, 1].map(|n| {
            let [by_right, by_up] = self.lenses_per_mm[n];
            self.on_axis[n] + maps[n].position * (by_right * xi + by_up * eta)
        });
        ProjectedPoint { place, parallax: maps.map(|map| map.pupil), depth_mm }
    }

    /// Microlenses along i and j per pupil cell along `right` and `up`.
    pub fn lenses_per_cell(&self) -> [[f64; 2]; 2] {
        self.lenses_per_mm.map(|row| row.map(|lenses| lenses * self.sampling.cell_mm))
    }

    /// Fractional microlens index on the optical axis, relative to the window's first.
    pub fn on_axis(&self) -> [f64; 2] {
        let first = [self.window.columns.start, self.window.rows.start];
        [0, 1].map(|n| self.on_axis[n] - first[n] as f64)
    }

    /// Microlens pitch along i and j, in mm.
    pub fn pitch_mm(&self) -> [f64; 2] {
        let mm_per_px = self.optics.pixel_pitch_mm() / self.optics.micro_image_magnification();
        self.sampling.grid.pitch_px().map(|pitch_px| pitch_px * mm_per_px)
    }

    /// Column and row of the centre of a micro-image, for a microlens of the window.
    pub fn centre_px(&self, lens: [usize; 2]) -> [f64; 2] {
        let first = [self.window.columns.start, self.window.rows.start];
        self.sampling.grid.centre_px((lens[0] + first[0]) as f64, (lens[1] + first[1]) as f64)
    }

    /// Radius of the pupil, in microlenses along i and along j.
    pub fn pupil_radius(&self) -> [f64; 2] {
        let radius_mm = self.optics.pupil_diameter_mm() / 2.0;
        self.lenses_per_mm.map(|[by_right, by_up]| radius_mm * by_right.hypot(by_up))
    }

    /// The microlenses that light from the grid can reach.
    fn window_of(
        &self,
        volume: &VolumeGrid,
        camera: CameraName,
    ) -> Result<MicrolensWindow, ModelError> {
        let limit_mm = self.optics.object_distance_mm - self.optics.focal_length_mm;
        let radius = self.pupil_radius();
        let (mut low, mut high) = ([f64::INFINITY; 2], [f64::NEG_INFINITY; 2]);
        for world in corners_and_middles(volume) {
            let deepest_mm = self.equivalent(&world).depth_mm.into_iter().fold(0.0, f64::max);
            if deepest_mm >= limit_mm {
                return Err(ModelError::TooDeep { camera, depth_mm: deepest_mm, limit_mm });
            }
            let ProjectedPoint { place, parallax, .. } = self.project_on_array(&world);
            for n in 0..2 {
                let reach = parallax[n].abs() * radius[n] + MARGIN;
                low[n] = low[n].min(place[n] - reach);
                high[n] = high[n].max(place[n] + reach);
            }
        }
        let lenses = self.sampling.grid.microlenses;
        let out_of_view = (0..2).any(|n| high[n] < MARGIN || low[n] >= lenses[n] as f64 - MARGIN);
        if out_of_view || low.iter().chain(&high).any(|place| place.is_nan()) {
            return Err(ModelError::VolumeOutOfView { camera });
        }
        let range =
            |n: usize| low[n].max(0.0) as usize..(high[n].ceil() as usize + 1).min(lenses[n]);
        Ok(MicrolensWindow { columns: range(0), rows: range(1) })
    }
}

/// Corners of a volume, and midpoints of its edges, faces and the whole.
fn corners_and_middles(volume: &VolumeGrid) -> impl Iterator<Item = Point3<f64>> + '_ {
    (0..27).map(|n| {
        let steps = [n % 3, n / 3 % 3, n / 9];
        Point3::from(std::array::from_fn::<f64, 3, _>(|axis| {
            let voxels = volume.voxels[axis] as f64;
            volume.coordinate_mm(axis, steps[axis] as f64 / 2.0 * voxels - 0.5)
        }))
    })
}
