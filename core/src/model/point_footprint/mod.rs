//! The image of a point of light on a camera's pixels, and its derivatives with respect to the point's position.
//!
//! Behind each microlens that the point's light reaches, the light of a pixel is the point's light times a
//! share for the pixel's column ([`axis`]), a share for its row, and the open share of its pupil cell
//! ([`open_cells`]). Shares and their derivatives are evaluated as a few polynomials per row and column of
//! pixels. Every microlens has its own phase. A pixel on the border of two micro-images receives the light of
//! both.
//!
//! [`super::PointImager`] is the corresponding model for extended sources in views, as in the tables.

mod axis;
mod open_cells;

use std::{ops::Range, sync::Arc};

use lfpiv_hw::{CameraName, Optics, Pose};
use multiversion::multiversion;
use nalgebra::Point3;

use super::{CameraCalibration, ModelError, VolumeGrid, mapped_optics::MappedOptics};
pub use axis::PointBlur;
use axis::{AxisPoint, AxisShares, PixelEdges};
use open_cells::OpenCells;

/// Number of pixels per vector of the kernels. Shares are padded with zeros to a multiple of it, and images
/// need this many values behind their last pixel.
pub const LANES: usize = 8;

/// Step of the derivatives of a camera's map, in mm. The map is smooth over millimetres.
const STEP_MM: f64 = 1e-3;

/// Imaging of points by one camera on its sensor.
#[derive(Debug, Clone)]
pub struct PointCamera {
    mapped: MappedOptics,
    open: Arc<OpenCells>,
    /// Pitch of the microlenses along columns and rows.
    pitch_mm: [f64; 2],
    /// Half width of the union of all pupil intervals.
    pupil_mm: f64,
    /// Blur of its images.
    pub blur: PointBlur,
    /// Whether all microlenses of a column have the same phase along the pixels' columns, and those of
    /// a row along their rows.
    aligned: bool,
}

/// Shares on consecutive pixels of one microlens, along one axis.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct LensShares {
    /// First pixel column or row.
    pub first_px: usize,
    /// Index of their first value in [`PointFootprint::shares`].
    pub start: usize,
    /// Number of pixels.
    pub len: usize,
}

/// The image of a point behind one microlens.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct LensPatch {
    /// Shares along the pixels' columns.
    pub columns: LensShares,
    /// Shares along the pixels' rows.
    pub rows: LensShares,
    /// Index of the first pixel's open share in [`PointCamera::open_shares`].
    pub open: usize,
}

/// The image of a point: a pixel's light is the product of three shares. It is reused for many points.
#[derive(Debug, Clone, Default)]
pub struct PointFootprint {
    /// Shares and, if requested, their derivatives with respect to offset (per mm) and parallax.
    pub shares: [Vec<f32>; 3],
    /// Images behind each microlens.
    pub patches: Vec<LensPatch>,
    /// Derivatives of offset and parallax along columns, then along rows, with respect to x, y, z.
    pub by_place: [[f64; 3]; 4],
    /// Pixels along columns and along rows: for each microlens, or for each column and each row of an aligned
    /// array.
    behind: [Vec<BehindLens>; 2],
}

/// Projection of a point along columns and rows.
struct ProjectedPoint {
    /// Intersection of its ray through the pupil's middle with the microlens plane, from the window's first
    /// microlens.
    places_mm: [f64; 2],
    parallaxes: [f64; 2],
    axes: [AxisShares; 2],
}

impl PointCamera {
    /// Imaging of points in `volume` by camera `camera`, from 0.
    ///
    /// # Errors
    /// The volume is not in the camera's field or extends to its lens, or the array is not square.
    pub fn new(
        optics: &Optics,
        pose: &Pose,
        calibration: &CameraCalibration,
        volume: &VolumeGrid,
        camera: CameraName,
        blur: PointBlur,
    ) -> Result<Self, ModelError> {
        let mapped = MappedOptics::new(optics, pose, calibration, volume, camera)?;
        let grid = &mapped.sampling.grid;
        let aligned = grid.column_px[2] == 0.0 && grid.row_px[1] == 0.0;
        let pupil_mm = optics.pupil_diameter_mm() / 2.0 + mapped.sampling.cell_mm / 2.0;
        let (open, pitch_mm) = (Arc::new(OpenCells::new(&mapped)), mapped.pitch_mm());
        Ok(Self { open, pitch_mm, pupil_mm, mapped, blur, aligned })
    }

    /// Open shares of the pixels of all microlenses, in units of 1/255.
    pub fn open_shares(&self) -> &[u8] {
        self.open.shares()
    }

    /// Index step between rows of open shares.
    pub fn open_stride(&self) -> usize {
        self.open.edge()
    }

    /// Width and height of the sensor, in pixels.
    pub fn sensor_px(&self) -> [usize; 2] {
        let sensor = &self.mapped.optics.sensor;
        [sensor.columns, sensor.rows]
    }

    /// Light of a pixel with an open pupil cell that receives all light through it, as a share of the light of
    /// the whole image.
    pub fn light_per_cell(&self) -> f64 {
        let radius_mm = self.mapped.optics.pupil_diameter_mm() / 2.0;
        self.mapped.sampling.cell_mm.powi(2) / (std::f64::consts::PI * radius_mm * radius_mm)
    }

    /// Diameter of the light of a point at `world_mm` on the microlens array, along the narrower axis, in pitches.
    pub fn spread_pitches(&self, world_mm: [f64; 3]) -> f64 {
        let (_, parallaxes) = self.place(world_mm);
        let diameter_mm = self.mapped.optics.pupil_diameter_mm();
        let along = |axis: usize| parallaxes[axis].abs() * diameter_mm / self.pitch_mm[axis];
        along(0).min(along(1))
    }

    /// Column and row in the window of the microlens on the ray through the pupil's middle.
    pub fn lens_at(&self, world_mm: [f64; 3]) -> [u16; 2] {
        self.mapped.project(&Point3::from(world_mm)).place.map(|place| place.round() as u16)
    }

    /// Sets `footprint` to that of a point at `world_mm`, without derivatives.
    pub fn image(&self, world_mm: [f64; 3], footprint: &mut PointFootprint) {
        self.fill::<false>(world_mm, footprint);
    }

    /// As [`Self::image`], with derivatives.
    pub fn image_and_derivatives(&self, world_mm: [f64; 3], footprint: &mut PointFootprint) {
        self.differentiate(world_mm, &mut footprint.by_place);
        self.fill::<true>(world_mm, footprint);
    }

    fn fill<const DERIVED: bool>(&self, world_mm: [f64; 3], footprint: &mut PointFootprint) {
        footprint.clear();
        let point = self.projected_point(world_mm);
        let [columns, rows] = [0, 1].map(|axis| self.reached(&point, axis));
        let lenses = [columns.clone(), rows.clone()];
        let PointFootprint { shares, patches, behind, .. } = footprint;
        for axis in 0..2 {
            // In an aligned array all microlenses of a column, or row, have the same phase.
            let [columns, rows] = if self.aligned {
                let mut lenses = lenses.clone();
                lenses[1 - axis].end = lenses[1 - axis].end.min(lenses[1 - axis].start + 1);
                lenses
            } else {
                lenses.clone()
            };
            for j in rows {
                let lens = columns.clone().map(|i| self.behind(&point, axis, [i, j]));
                behind[axis].extend(lens);
            }
            fill_shares::<DERIVED>(&point.axes[axis], &mut behind[axis], shares);
        }
        for (down, j) in rows.enumerate() {
            for (across, i) in columns.clone().enumerate() {
                let both = down * columns.len() + across;
                let [column, row] = if self.aligned { [across, down] } else { [both; 2] };
                let (column, row) = (&behind[0][column], &behind[1][row]);
                if column.shares.len > 0 && row.shares.len > 0 {
                    let in_tile = row.in_tile * self.open.edge() + column.in_tile;
                    let open = self.open.tile([i, j]) + in_tile;
                    patches.push(LensPatch { columns: column.shares, rows: row.shares, open });
                }
            }
        }
    }

    fn projected_point(&self, world_mm: [f64; 3]) -> ProjectedPoint {
        let (places_mm, parallaxes) = self.place(world_mm);
        let axes = [0, 1].map(|axis| {
            AxisShares::new(AxisPoint {
                parallax: parallaxes[axis],
                half_lens_mm: self.pitch_mm[axis] / 2.0,
                cell_mm: self.mapped.sampling.cell_mm,
                blur: self.blur,
            })
        });
        ProjectedPoint { places_mm, parallaxes, axes }
    }

    /// The microlenses of the window that a point reaches along an axis.
    fn reached(&self, point: &ProjectedPoint, axis: usize) -> Range<usize> {
        let window = &self.mapped.window;
        let lenses = [window.columns.len(), window.rows.len()][axis];
        let pitch_mm = self.pitch_mm[axis];
        let reach_mm = point.parallaxes[axis].abs() * self.pupil_mm + 3.0 * self.blur.plane_mm;
        let index = |at_mm: f64| ((at_mm / pitch_mm).round().max(0.0) as usize).min(lenses);
        let place_mm = point.places_mm[axis];
        index(place_mm - reach_mm)..index(place_mm + reach_mm + pitch_mm)
    }

    /// The lit pixels behind one microlens along an axis.
    fn behind(&self, point: &ProjectedPoint, axis: usize, lens: [usize; 2]) -> BehindLens {
        let centre_px = self.mapped.centre_px(lens)[axis];
        let tile_px = self.open.first_px(centre_px);
        let offset_mm = point.places_mm[axis] - lens[axis] as f64 * self.pitch_mm[axis];
        // The pupil coordinate decreases with columns and increases with rows, which are counted downwards.
        let sign = [-1.0, 1.0][axis];
        let shares = &point.axes[axis];
        let cell_mm = shares.cell_mm();
        let [low, high] = shares.interval_mm(offset_mm);
        let (low, high) = (low.max(-self.pupil_mm), high.min(self.pupil_mm));
        let at_px = |pupil_mm| {
            (centre_px + sign * shares.edge_at(pupil_mm, offset_mm) / cell_mm + 0.5).floor() as i64
        };
        let (one, other) = (at_px(low), at_px(high));
        let last_px = (tile_px + self.open.edge() as i64).min(self.sensor_px()[axis] as i64) - 1;
        let first = one.min(other).max(tile_px).max(0);
        let last = one.max(other).min(last_px);
        let pixels = if low < high { (last + 1 - first).max(0) as usize } else { 0 };
        BehindLens {
            edges: PixelEdges {
                first_mm: sign * (first as f64 - 0.5 - centre_px) * cell_mm,
                step_mm: sign * cell_mm,
                pixels,
                offset_mm,
            },
            in_tile: (first - tile_px) as usize,
            shares: LensShares { first_px: first as usize, start: 0, len: pixels },
        }
    }

    /// Intersection of the ray through the pupil's middle with the microlens plane, in mm from the window's first
    /// microlens, and the parallax.
    fn place(&self, world_mm: [f64; 3]) -> ([f64; 2], [f64; 2]) {
        let projected = self.mapped.project(&Point3::from(world_mm));
        ([0, 1].map(|axis| projected.place[axis] * self.pitch_mm[axis]), projected.parallax)
    }

    fn differentiate(&self, world_mm: [f64; 3], by_place: &mut [[f64; 3]; 4]) {
        for axis in 0..3 {
            let at = |step: f64| {
                let mut at_mm = world_mm;
                at_mm[axis] += step;
                self.place(at_mm)
            };
            let ((low_place, low), (high_place, high)) = (at(-STEP_MM), at(STEP_MM));
            for n in 0..2 {
                by_place[2 * n][axis] = (high_place[n] - low_place[n]) / (2.0 * STEP_MM);
                by_place[2 * n + 1][axis] = (high[n] - low[n]) / (2.0 * STEP_MM);
            }
        }
    }
}

impl PointFootprint {
    fn clear(&mut self) {
        self.shares.iter_mut().for_each(Vec::clear);
        self.patches.clear();
        self.behind.iter_mut().for_each(Vec::clear);
    }

    /// One kind of shares: 0 the shares, 1 and 2 their derivatives.
    pub fn of(&self, kind: usize, shares: &LensShares) -> &[f32] {
        &self.shares[kind][shares.start..shares.start + shares.len]
    }
}

impl PointFootprint {
    /// [`Self::of`] with zero padding to a multiple of [`LANES`].
    pub fn padded(&self, kind: usize, shares: &LensShares) -> &[f32] {
        &self.shares[kind][shares.start..shares.start + shares.len.next_multiple_of(LANES)]
    }
}

/// The pixels behind one microlens along one axis.
#[derive(Debug, Clone, Copy)]
struct BehindLens {
    edges: PixelEdges,
    /// Index of the first pixel in the microlens' tile.
    in_tile: usize,
    shares: LensShares,
}

/// Appends the shares behind the microlenses.
#[multiversion(targets("x86_64+avx512f+avx512vl", "x86_64+avx2"))]
fn fill_shares<const DERIVED: bool>(
    axis: &AxisShares,
    behind: &mut [BehindLens],
    all: &mut [Vec<f32>; 3],
) {
    for lens in behind.iter_mut().filter(|lens| lens.edges.pixels > 0) {
        lens.shares.start = all[0].len();
        axis.add_shares::<DERIVED>(&lens.edges, all);
    }
}

#[cfg(test)]
mod tests;
