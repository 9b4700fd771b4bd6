//! Weights by direct quadrature over voxel, pixel and pupil, without tables.
//!
//! The weight of a pixel is the mean, over the voxel, of the area of the pupil from which a ray
//! reaches the pixel, divided by the area of a pupil cell (docs/theory.md, section 2).
//! The ray from a pixel point x_s through the microlens with centre X_c to the position ξ is exact:
//! with t = (x_s − X_c) s_i/f_m, x = a U + b ξ and x_s = X_c + f_m (x − U)/s_i,
//!
//! ```text
//! U = (b ξ − t) / (1 − a),   x = (b ξ − a t) / (1 − a),   dU = (s_i/f_m) dx_s / (1 − a)
//! ```
//!
//! and the ray passes that microlens for |x − X_c| ≤ p_m/2, which is an interval of ξ. The quadrature is a
//! midpoint rule over small cubes of the voxel and points of the pixel. It is exact in the lateral positions
//! inside a cube. The aperture is evaluated for the ray of the interval's middle. The edges of small cubes are
//! assumed to be along the camera's axes, which is exact unless the camera is oblique to the grid. For a point
//! source the error is one in 2·`PIXEL_POINTS` of its light per axis, because only the pixel points resolve its
//! steps.

use lfpiv_hw::{Optics, Pose};

use super::{
    ModelError, SUPPORT_SHARE, ViewId, VolumeGrid,
    camera::CameraView,
    footprint::RayMap,
    thin_lens::{camera_views, coverage_bytes},
    weights::{Weight, WeightSource},
};
use crate::lightfield::{AxisSampling, ViewLayout};

/// Small cubes along a voxel's edge.
const CUBES: usize = 3;

/// Points across a pixel.
const PIXEL_POINTS: usize = 8;

/// Weights that are integrated for every voxel and view.
pub struct QuadratureWeights {
    optics: Optics,
    poses: Vec<Pose>,
    grid: VolumeGrid,
    footprint_mm: f64,
    layouts: Vec<ViewLayout>,
}

impl QuadratureWeights {
    /// Weights for cubes of edge `footprint_mm` around the voxels' centres.
    ///
    /// # Errors
    /// As [`super::thin_lens_model`], without a limit of the footprint's width.
    pub fn new(
        optics: &Optics,
        poses: &[Pose],
        grid: &VolumeGrid,
        footprint_mm: f64,
    ) -> Result<Self, ModelError> {
        let views = camera_views(optics, poses, grid, footprint_mm)?;
        let layout = |view: CameraView| ViewLayout::new(optics, view.window);
        let layouts = views.into_iter().map(layout).collect();
        Ok(Self {
            optics: optics.clone(),
            poses: poses.to_vec(),
            grid: grid.clone(),
            footprint_mm,
            layouts,
        })
    }

    /// Centres of the small cubes of a voxel, in world coordinates.
    fn cubes_mm(&self, voxel: u32) -> impl Iterator<Item = [f64; 3]> {
        let centre = self.grid.centre_of(self.grid.indices(voxel));
        let edge_mm = self.footprint_mm / CUBES as f64;
        let offset = move |n: usize| (n as f64 - (CUBES as f64 - 1.0) / 2.0) * edge_mm;
        (0..CUBES.pow(3)).map(move |n| {
            let steps = [n % CUBES, n / CUBES % CUBES, n / (CUBES * CUBES)];
            std::array::from_fn(|axis| centre[axis] + offset(steps[axis]))
        })
    }

    /// Adds the light of one small cube in a view to the pixels' sums.
    fn add_cube(&self, id: ViewId, cube_mm: [f64; 3], sums: &mut PixelSums) {
        let layout = &self.layouts[id.camera];
        let view = &layout.views[id.view];
        let seen = self.poses[id.camera].to_camera(&cube_mm.into());
        let map = RayMap::at_depth(&self.optics, seen.depth_mm);
        let (lens, sensor) = (&self.optics.microlens, &self.optics.sensor);
        let axis = |sampling, position_mm| CubeAxis {
            optics: &self.optics,
            map,
            sampling,
            position_mm,
            edge_mm: self.footprint_mm / CUBES as f64,
        };
        let columns = axis(&layout.columns, seen.xi_mm).fans(
            view.k,
            &layout.window.columns,
            |i| lens.column_centre_mm(i),
            |c| sensor.column_centre_mm(c),
        );
        let rows = axis(&layout.rows, seen.eta_mm).fans(
            view.l,
            &layout.window.rows,
            |j| lens.row_centre_mm(j),
            |r| sensor.row_centre_mm(r),
        );
        let radius_mm = self.optics.pupil_diameter_mm() / 2.0;
        for row in &rows {
            for column in &columns {
                let pixel = row.microlens * layout.window.columns.len() + column.microlens;
                sums.add(pixel as u32, column.pair(row, radius_mm));
            }
        }
    }
}

impl WeightSource for QuadratureWeights {
    fn grid(&self) -> &VolumeGrid {
        &self.grid
    }

    fn layouts(&self) -> &[ViewLayout] {
        &self.layouts
    }

    fn weights(&self, view: ViewId, voxel: u32, out: &mut Vec<Weight>) {
        let mut sums = PixelSums::default();
        for cube_mm in self.cubes_mm(voxel) {
            self.add_cube(view, cube_mm, &mut sums);
        }
        sums.0.sort_unstable_by_key(|&(pixel, _)| pixel);
        let cubes = CUBES.pow(3) as f64;
        out.extend(sums.0.into_iter().map(|(pixel, light)| Weight {
            pixel,
            weight: (light.open / cubes) as f32,
            support: light.all / cubes > f64::from(SUPPORT_SHARE),
        }));
    }

    fn memory_bytes(&self) -> usize {
        self.layouts.iter().map(coverage_bytes).sum()
    }
}

/// One axis of a small cube.
struct CubeAxis<'a> {
    optics: &'a Optics,
    map: RayMap,
    sampling: &'a AxisSampling,
    position_mm: f64,
    edge_mm: f64,
}

/// The rays between a small cube and the points of one pixel, along one axis.
struct Fan {
    /// Index of the microlens in the window.
    microlens: usize,
    /// Mean position on the pupil of each pixel point's rays, in mm.
    pupil_mm: [f64; PIXEL_POINTS],
    /// Contribution of each pixel point to the weight along this axis.
    light: [f64; PIXEL_POINTS],
}

impl CubeAxis<'_> {
    /// The pixels of view index `k` that the cube's light reaches.
    fn fans(
        &self,
        k: i32,
        window: &std::ops::Range<usize>,
        microlens_mm: impl Fn(usize) -> f64,
        pixel_mm: impl Fn(usize) -> f64,
    ) -> Vec<Fan> {
        let RayMap { pupil: a, position: b } = self.map;
        let cell_mm = self.sampling.cell_mm;
        let centre_mm = a * f64::from(k) * cell_mm + b * self.position_mm;
        // Pupil points of a view deviate from the nominal one by at most one cell plus x − X_c.
        let pitch_mm = self.optics.microlens.pitch_mm;
        let reach_mm = a.abs() * (cell_mm + pitch_mm) + (b * self.edge_mm).abs() + pitch_mm;
        let first_mm = microlens_mm(0);
        let index = |x_mm: f64| ((x_mm - first_mm) / pitch_mm).round().max(0.0) as usize;
        let low = index(centre_mm - reach_mm).max(window.start);
        let high = (index(centre_mm + reach_mm) + 1).min(window.end);
        (low..high)
            .filter_map(|i| {
                let pixel = self.sampling.sample(k, i)?.pixel as usize;
                let (pupil_mm, light) = self.rays(microlens_mm(i), pixel_mm(pixel));
                let fan = Fan { microlens: i - window.start, pupil_mm, light };
                fan.light.iter().any(|&light| light > 0.0).then_some(fan)
            })
            .collect()
    }

    /// Pupil points and contributions of the pixel at `pixel_mm` behind the microlens at `x_c`.
    fn rays(&self, x_c: f64, pixel_mm: f64) -> ([f64; PIXEL_POINTS], [f64; PIXEL_POINTS]) {
        let RayMap { pupil: a, position: b } = self.map;
        let half_pitch_mm = self.optics.microlens.pitch_mm / 2.0;
        let per_sensor = self.optics.image_distance_mm() / self.optics.microlens.focal_length_mm;
        let centre = b * self.position_mm;
        let half = (b * self.edge_mm / 2.0).abs();
        let mut pupil_mm = [0.0; PIXEL_POINTS];
        let mut light = [0.0; PIXEL_POINTS];
        for n in 0..PIXEL_POINTS {
            let fraction = (n as f64 + 0.5) / PIXEL_POINTS as f64 - 0.5;
            let t = (pixel_mm - x_c + fraction * self.optics.pixel_pitch_mm()) * per_sensor;
            // The interval of b ξ for which the ray passes this microlens, intersected with that of the cube.
            let low = (1.0 - a) * (x_c - half_pitch_mm) + a * t;
            let high = (1.0 - a) * (x_c + half_pitch_mm) + a * t;
            let (from, to) = (low.max(centre - half), high.min(centre + half));
            let share = if half > 0.0 {
                ((to - from) / (2.0 * half)).max(0.0)
            } else {
                f64::from(u8::from(low <= centre && centre < high))
            };
            pupil_mm[n] = ((from + to) / 2.0 - t) / (1.0 - a);
            light[n] = share / (1.0 - a).abs() / PIXEL_POINTS as f64;
        }
        (pupil_mm, light)
    }
}

impl Fan {
    /// The light of the pixel at the intersection of this column and `row`.
    fn pair(&self, row: &Fan, radius_mm: f64) -> PixelLight {
        let mut pair = PixelLight::default();
        for (u, light_u) in self.pupil_mm.iter().zip(self.light) {
            for (v, light_v) in row.pupil_mm.iter().zip(row.light) {
                let light = light_u * light_v;
                pair.all += light;
                if u * u + v * v <= radius_mm * radius_mm {
                    pair.open += light;
                }
            }
        }
        pair
    }
}

/// Light on one pixel.
#[derive(Debug, Clone, Copy, Default)]
struct PixelLight {
    /// Light through the aperture.
    open: f64,
    /// Light through an unlimited pupil.
    all: f64,
}

/// Light per pixel of a view, for the few pixels that one voxel reaches.
#[derive(Debug, Default)]
struct PixelSums(Vec<(u32, PixelLight)>);

impl PixelSums {
    fn add(&mut self, pixel: u32, light: PixelLight) {
        match self.0.iter_mut().find(|(known, _)| *known == pixel) {
            Some((_, sum)) => {
                sum.open += light.open;
                sum.all += light.all;
            }
            None => self.0.push((pixel, light)),
        }
    }
}
