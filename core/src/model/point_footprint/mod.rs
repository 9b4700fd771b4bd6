//! The image of a point of light on a camera's pixels, and how it changes when the point moves.
//!
//! Behind each microlens that the point reaches, its image is a product: a share of the pixel's column
//! ([`axis`]), a share of its row, and the open part of the aperture that the pixel sees
//! ([`open_cells`]), times the point's light. Shares need no more than a few polynomials per row and
//! column of pixels, and their derivatives come with them. Every microlens has its own phase. Where two
//! micro-images meet on a pixel, it gets the light of both: nothing is dropped.
//!
//! [`super::PointImager`] is the same for sources of some size in views, as tables see them.

mod axis;
mod open_cells;

use std::{ops::Range, sync::Arc};

use lfpiv_hw::{CameraName, Optics, Pose};
use nalgebra::Point3;

use super::{CameraCalibration, ModelError, VolumeGrid, mapped_optics::MappedOptics};
pub use axis::PointBlur;
use axis::{AxisPoint, AxisShares, Share};
use open_cells::OpenCells;

/// Pixels that kernels take at a time: shares are padded with zeros to a multiple of it, and images need as
/// many values behind their last pixel.
pub const LANES: usize = 8;

/// Step of the derivatives of a camera's map, in mm. The map is smooth over millimetres.
const STEP_MM: f64 = 1e-3;

/// How one camera images points on its sensor.
#[derive(Debug, Clone)]
pub struct PointCamera {
    seen: MappedOptics,
    open: Arc<OpenCells>,
    /// How its images are smeared.
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
    /// Where they begin among [`PointFootprint::shares`].
    pub start: usize,
    /// Pixels.
    pub len: usize,
}

/// What a point leaves behind one microlens.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct LensPatch {
    /// Along the pixels' columns.
    pub columns: LensShares,
    /// Along the pixels' rows.
    pub rows: LensShares,
    /// Where the open share of the first pixel is among [`PointCamera::open_shares`].
    pub open: usize,
}

/// The image of a point: a pixel's light is the product of three shares. To be filled again and again.
#[derive(Debug, Clone, Default)]
pub struct PointFootprint {
    /// Shares, and their derivatives by offset per mm and by parallax.
    pub shares: [Vec<f32>; 3],
    /// By microlens.
    pub patches: Vec<LensPatch>,
    /// Derivatives of offset and parallax along the columns, and along the rows, by x, y, z.
    pub by_place: [[f64; 3]; 4],
    /// Of every column and of every row of microlenses, where phases are theirs.
    aligned: [Vec<Option<LensShares>>; 2],
}

/// A point as the camera sees it along columns and rows.
struct SeenPoint {
    /// Where its ray through the pupil's middle meets the microlens plane, from the window's first
    /// microlens.
    places_mm: [f64; 2],
    parallaxes: [f64; 2],
    axes: [AxisShares; 2],
}

impl PointCamera {
    /// The camera number `camera` (from 0) before `volume`, beyond which light is not looked for.
    ///
    /// # Errors
    /// The camera does not see the volume, the volume reaches its lens, or its array is not square.
    pub fn new(
        optics: &Optics,
        pose: &Pose,
        calibration: &CameraCalibration,
        volume: &VolumeGrid,
        camera: CameraName,
        blur: PointBlur,
    ) -> Result<Self, ModelError> {
        let seen = MappedOptics::new(optics, pose, calibration, volume, camera)?;
        let grid = &seen.sampling.grid;
        let aligned = grid.column_px[2] == 0.0 && grid.row_px[1] == 0.0;
        Ok(Self { open: Arc::new(OpenCells::new(&seen)), seen, blur, aligned })
    }

    /// Open shares of the pixels of all microlenses, in steps of 1/255.
    pub fn open_shares(&self) -> &[u8] {
        self.open.shares()
    }

    /// Pixels from a row of open shares to the next.
    pub fn open_stride(&self) -> usize {
        self.open.edge()
    }

    /// Width of the sensor and its height, in pixels.
    pub fn sensor_px(&self) -> [usize; 2] {
        let sensor = &self.seen.optics.sensor;
        [sensor.columns, sensor.rows]
    }

    /// Light of a point in a pixel that sees an open part of the aperture and gets all of it, over the
    /// light of the whole image.
    pub fn light_per_cell(&self) -> f64 {
        let radius_mm = self.seen.optics.pupil_diameter_mm() / 2.0;
        self.seen.sampling.cell_mm.powi(2) / (std::f64::consts::PI * radius_mm * radius_mm)
    }

    /// Diameter of the light of a point at `world_mm` on the microlens array, in pitches: of the narrower axis.
    pub fn spread_pitches(&self, world_mm: [f64; 3]) -> f64 {
        let (_, parallaxes) = self.place(world_mm);
        let (pitch_mm, diameter_mm) = (self.seen.pitch_mm(), self.seen.optics.pupil_diameter_mm());
        let along = |axis: usize| parallaxes[axis].abs() * diameter_mm / pitch_mm[axis];
        along(0).min(along(1))
    }

    /// Makes `footprint` that of a point at `world_mm`.
    pub fn image(&self, world_mm: [f64; 3], footprint: &mut PointFootprint) {
        footprint.clear();
        self.differentiate(world_mm, &mut footprint.by_place);
        let point = self.seen_point(world_mm);
        let PointFootprint { shares, patches, aligned, .. } = footprint;
        let [columns, rows] = [0, 1].map(|axis| self.reached(&point, axis));
        if self.aligned {
            let first = [columns.start, rows.start];
            let along_columns =
                columns.clone().map(|i| self.behind(&point, 0, [i, first[1]], shares));
            aligned[0].extend(along_columns);
            let along_rows = rows.clone().map(|j| self.behind(&point, 1, [first[0], j], shares));
            aligned[1].extend(along_rows);
        }
        for j in rows.clone() {
            for i in columns.clone() {
                let lens = [i, j];
                let seen = if self.aligned {
                    aligned[0][i - columns.start].zip(aligned[1][j - rows.start])
                } else {
                    let along_columns = self.behind(&point, 0, lens, shares);
                    along_columns.zip(self.behind(&point, 1, lens, shares))
                };
                if let Some((columns, rows)) = seen {
                    let first = self.open.first_px(self.seen.centre_px(lens));
                    let across = (columns.first_px as i64 - first[0]) as usize;
                    let down = (rows.first_px as i64 - first[1]) as usize;
                    let open = self.open.tile(lens) + down * self.open.edge() + across;
                    patches.push(LensPatch { columns, rows, open });
                }
            }
        }
    }

    fn seen_point(&self, world_mm: [f64; 3]) -> SeenPoint {
        let (places_mm, parallaxes) = self.place(world_mm);
        let pitch_mm = self.seen.pitch_mm();
        let axes = [0, 1].map(|axis| {
            AxisShares::new(AxisPoint {
                parallax: parallaxes[axis],
                half_lens_mm: pitch_mm[axis] / 2.0,
                cell_mm: self.seen.sampling.cell_mm,
                blur: self.blur,
            })
        });
        SeenPoint { places_mm, parallaxes, axes }
    }

    /// The microlenses of the window that a point reaches along an axis.
    fn reached(&self, point: &SeenPoint, axis: usize) -> Range<usize> {
        let window = &self.seen.window;
        let lenses = [window.columns.len(), window.rows.len()][axis];
        let pitch_mm = self.seen.pitch_mm()[axis];
        let reach_mm = point.parallaxes[axis].abs() * self.pupil_mm() + 3.0 * self.blur.plane_mm;
        let index = |at_mm: f64| ((at_mm / pitch_mm).round().max(0.0) as usize).min(lenses);
        let place_mm = point.places_mm[axis];
        index(place_mm - reach_mm)..index(place_mm + reach_mm + pitch_mm)
    }

    /// Adds the shares behind one microlens along an axis.
    fn behind(
        &self,
        point: &SeenPoint,
        axis: usize,
        lens: [usize; 2],
        shares: &mut [Vec<f32>; 3],
    ) -> Option<LensShares> {
        let centre = self.seen.centre_px(lens);
        let first = self.open.first_px(centre)[axis];
        let lens = BehindLens {
            axis: &point.axes[axis],
            offset_mm: point.places_mm[axis] - lens[axis] as f64 * self.seen.pitch_mm()[axis],
            centre_px: centre[axis],
            first_px: first.max(0),
            end_px: (first + self.open.edge() as i64).min(self.sensor_px()[axis] as i64),
            pupil_mm: self.pupil_mm(),
        };
        lens.shares([Direction::Columns, Direction::Rows][axis], shares)
    }

    /// Half the widest pupil interval that pixels see, in mm.
    fn pupil_mm(&self) -> f64 {
        self.seen.optics.pupil_diameter_mm() / 2.0 + self.seen.sampling.cell_mm / 2.0
    }

    /// Where the ray through the pupil's middle meets the microlens plane, in mm from the window's
    /// first microlens, and the parallax.
    fn place(&self, world_mm: [f64; 3]) -> ([f64; 2], [f64; 2]) {
        let seen = self.seen.see(&Point3::from(world_mm));
        let pitch_mm = self.seen.pitch_mm();
        ([0, 1].map(|axis| seen.place[axis] * pitch_mm[axis]), seen.parallax)
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
        self.aligned.iter_mut().for_each(Vec::clear);
    }

    /// One kind of shares: 0 the shares, 1 and 2 their derivatives.
    pub fn of(&self, kind: usize, shares: &LensShares) -> &[f32] {
        &self.shares[kind][shares.start..shares.start + shares.len]
    }
}

impl PointFootprint {
    /// [`Self::of`] with the zeros that fill the last lanes.
    pub fn padded(&self, kind: usize, shares: &LensShares) -> &[f32] {
        &self.shares[kind][shares.start..shares.start + shares.len.next_multiple_of(LANES)]
    }
}

/// Whether pixels count along or against the pupil's coordinate.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Direction {
    /// Columns see the pupil from right to left.
    Columns,
    /// Rows, which count downwards, see it upwards.
    Rows,
}

/// The pixels behind one microlens along one axis.
struct BehindLens<'a> {
    axis: &'a AxisShares,
    offset_mm: f64,
    centre_px: f64,
    /// First pixel of the tile, and the one after the last.
    first_px: i64,
    end_px: i64,
    /// Half the widest interval of the pupil that pixels see.
    pupil_mm: f64,
}

impl BehindLens<'_> {
    /// Adds the shares of the pixels that the point lights, padded with zeros; `None` where there
    /// are none.
    fn shares(&self, direction: Direction, all: &mut [Vec<f32>; 3]) -> Option<LensShares> {
        let [low, high] = self.axis.interval_mm(self.offset_mm);
        let (low, high) = (low.max(-self.pupil_mm), high.min(self.pupil_mm));
        if low >= high {
            return None;
        }
        let cell_mm = self.axis.cell_mm();
        let sign = if direction == Direction::Columns { -1.0 } else { 1.0 };
        let at_px = |pupil_mm| {
            self.centre_px + sign * self.axis.edge_at(pupil_mm, self.offset_mm) / cell_mm
        };
        let (one, other) = (at_px(low), at_px(high));
        let first = ((one.min(other) + 0.5).floor() as i64).max(self.first_px);
        let last = ((one.max(other) + 0.5).floor() as i64).min(self.end_px - 1);
        if last < first {
            return None;
        }
        let edge = |n: i64| {
            let edge_mm = sign * (n as f64 - 0.5 - self.centre_px) * cell_mm;
            self.axis.beyond(edge_mm, self.offset_mm)
        };
        let start = all[0].len();
        let mut before = edge(first);
        for n in first..=last {
            let after = edge(n + 1);
            let share =
                if direction == Direction::Columns { after - before } else { before - after };
            let Share { value, by_offset, by_parallax } = share;
            for (all, value) in all.iter_mut().zip([value, by_offset, by_parallax]) {
                all.push(value as f32);
            }
            before = after;
        }
        let len = (last + 1 - first) as usize;
        for all in all.iter_mut() {
            all.resize(start + len.next_multiple_of(LANES), 0.0);
        }
        Some(LensShares { first_px: first as usize, start, len })
    }
}

#[cfg(test)]
mod tests;
