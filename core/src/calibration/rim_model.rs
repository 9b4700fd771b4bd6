//! Circles that all rims have in common: the stop's, and a second aperture's where it cuts that off.
//!
//! A point is on a rim where it is on one of the circles and inside of the other: at max(s₁, s₂) = 0 with its
//! distances outside of both. That holds for half levels of blurred rims, too, where both circles
//! run side by side, as they do where vignetting begins.

use nalgebra::{SMatrix, SVector};

use super::second_aperture::{Field, SecondAperture};
use crate::{lightfield::MicroImageGrid, statistics::NORMAL_OF_MEDIAN};

/// Six of the grid, the stop's radius, and four of the second aperture.
const UNKNOWNS: usize = 11;
const WITHOUT_SECOND: usize = 7;

/// Displacements of the second disc at the corner that are tried, in radii of the stop.
const SHIFTS: [f64; 10] = [-3.0, -1.5, -0.8, -0.35, -0.15, 0.15, 0.35, 0.8, 1.5, 3.0];

/// A second aperture is believed in that takes at least this share of what is left without it.
const LEAST_GAIN: f64 = 0.25;

/// Second discs are within these radii of the stop's, and displaced by no more than this many.
const RADII: std::ops::RangeInclusive<f64> = 0.5..=8.0;
const LARGEST_SHIFT: f64 = 8.0;

const ROUNDS: usize = 40;

/// Steps are cut to this, in pixels.
const LARGEST_STEP_PX: f64 = 1.0;

/// Points beyond this many robust standard deviations pull no more than those there.
const HUBER: f64 = 1.5;

/// Points closer than this, in pixels, are on the rim.
const LEAST_REACH_PX: f64 = 0.1;

/// A point on the rim of a lens' micro-image.
#[derive(Debug, Clone, Copy)]
pub(super) struct RimPoint {
    pub lens: [usize; 2],
    pub place_px: [f64; 2],
}

/// All circles.
#[derive(Debug, Clone)]
pub(super) struct RimModel {
    pub grid: MicroImageGrid,
    pub radius_px: f64,
    pub second: Option<SecondAperture>,
}

/// How far a point is outside of the common rim, and how that changes.
pub(super) struct Outside {
    pub distance_px: f64,
    /// By the centre of the lens' micro-image, both discs moving.
    pub by_centre: [f64; 2],
    /// By the stop's radius and the second aperture's radius, shift and offset.
    by_shape: [f64; 5],
}

impl RimModel {
    /// The distance of a place from the rim of the micro-image centred at `centre_px`.
    pub fn outside(&self, centre_px: [f64; 2], place_px: [f64; 2], field: &Field) -> Outside {
        let away = |from: [f64; 2]| {
            let offset = [place_px[0] - from[0], place_px[1] - from[1]];
            let distance = offset[0].hypot(offset[1]).max(1e-9);
            (distance, offset.map(|part| part / distance))
        };
        let (distance, [nx, ny]) = away(centre_px);
        let stop = distance - self.radius_px;
        let Some(second) = &self.second else {
            return Outside {
                distance_px: stop,
                by_centre: [-nx, -ny],
                by_shape: [-1.0, 0.0, 0.0, 0.0, 0.0],
            };
        };
        let (distance, [mx, my]) = away(second.centre_px(centre_px, field));
        let cut = distance - second.radius_px;
        let [of_stop, of_cut] = if stop >= cut { [1.0, 0.0] } else { [0.0, 1.0] };
        let share = field.share(centre_px);
        let moves = 1.0 + second.shift_at_corner_px / field.half_diagonal_px;
        Outside {
            distance_px: stop.max(cut),
            by_centre: [-of_stop * nx - of_cut * moves * mx, -of_stop * ny - of_cut * moves * my],
            by_shape: [
                -of_stop,
                -of_cut,
                -of_cut * (mx * share[0] + my * share[1]),
                -of_cut * mx,
                -of_cut * my,
            ],
        }
    }

    pub fn centre_px(&self, lens: [usize; 2]) -> [f64; 2] {
        self.grid.centre_px(lens[0] as f64, lens[1] as f64)
    }

    fn distances<'a>(
        &'a self,
        points: &'a [RimPoint],
        field: &'a Field,
    ) -> impl Iterator<Item = f64> + 'a {
        points.iter().map(|p| self.outside(self.centre_px(p.lens), p.place_px, field).distance_px)
    }

    /// The robust standard deviation of points from the rim, in pixels.
    pub fn deviation_px(&self, points: &[RimPoint], field: &Field) -> f64 {
        NORMAL_OF_MEDIAN * super::median(self.distances(points, field).map(f64::abs))
    }

    /// How far points pull: by the square of their distance up to here, and beyond by its length.
    fn reach(&self, points: &[RimPoint], field: &Field) -> f64 {
        (HUBER * self.deviation_px(points, field)).max(LEAST_REACH_PX)
    }

    /// What is left, by Huber's measure.
    fn left(&self, points: &[RimPoint], field: &Field, reach: f64) -> f64 {
        let measure = |distance: f64| {
            let length = distance.abs();
            if length < reach { 0.5 * length * length } else { reach * (length - 0.5 * reach) }
        };
        self.distances(points, field).map(measure).sum()
    }

    /// Looks for a second aperture from several starts, and keeps what explains the points clearly better.
    pub fn look_for_second(&mut self, points: &[RimPoint], field: &Field) {
        let reach = self.reach(points, field);
        let without = self.left(points, field, reach);
        let tried = SHIFTS.iter().filter_map(|shift| {
            let second = SecondAperture {
                radius_px: self.radius_px * (1.0 + 0.5 * shift.abs()),
                shift_at_corner_px: shift * self.radius_px,
                offset_px: [0.0; 2],
            };
            let mut model = Self { second: Some(second), ..self.clone() };
            model.follow(points, field)?;
            model.tell_stop(field);
            model.is_sensible().then(|| (model.left(points, field, reach), model))
        });
        let best = tried.min_by(|a, b| a.0.total_cmp(&b.0));
        if let Some((left, model)) = best
            && left < (1.0 - LEAST_GAIN) * without
        {
            *self = model;
        }
    }

    /// The stop is what limits the light in the middle of the field: the smaller disc.
    fn tell_stop(&mut self, field: &Field) {
        let Some(second) = self.second else { return };
        if second.radius_px >= self.radius_px {
            return;
        }
        // The second disc's centres are an affine map of the lenses, too.
        let stretch = 1.0 + second.shift_at_corner_px / field.half_diagonal_px;
        for (axis, affine) in
            [&mut self.grid.column_px, &mut self.grid.row_px].into_iter().enumerate()
        {
            let from_middle = affine[0] - field.middle_px[axis];
            affine[0] = field.middle_px[axis] + stretch * from_middle + second.offset_px[axis];
            affine[1] *= stretch;
            affine[2] *= stretch;
        }
        let [stop_px, cut_px] = [second.radius_px, self.radius_px];
        self.radius_px = stop_px;
        self.second = Some(SecondAperture {
            radius_px: cut_px,
            shift_at_corner_px: field.half_diagonal_px * (1.0 / stretch - 1.0),
            offset_px: second.offset_px.map(|offset| -offset / stretch),
        });
    }

    /// Of a size that there is, on an axis that meets the sensor.
    fn is_sensible(&self) -> bool {
        self.second.is_some_and(|second| {
            RADII.contains(&(second.radius_px / self.radius_px))
                && second.shift_at_corner_px.abs() < LARGEST_SHIFT * self.radius_px
                && second.offset_px[0].hypot(second.offset_px[1]) < second.shift_at_corner_px.abs()
        })
    }

    /// Damped Gauss-Newton steps until nothing moves. `None` where the points do not determine the circles.
    pub fn follow(&mut self, points: &[RimPoint], field: &Field) -> Option<()> {
        let mut damping = 1e-4;
        for _ in 0..ROUNDS {
            let reach = self.reach(points, field);
            let left = self.left(points, field, reach);
            let step = self.step(points, field, reach, damping)?;
            let next = self.moved(&step);
            let next_left = next.left(points, field, reach);
            if next_left <= left {
                let done = left - next_left < 1e-7 * left;
                *self = next;
                damping = (damping * 0.2).max(1e-9);
                if done {
                    break;
                }
            } else if damping > 1e3 {
                break;
            } else {
                damping *= 10.0;
            }
        }
        self.radius_px.is_finite().then_some(())
    }

    fn step(
        &self,
        points: &[RimPoint],
        field: &Field,
        reach: f64,
        damping: f64,
    ) -> Option<SVector<f64, UNKNOWNS>> {
        let mut normal = SMatrix::<f64, UNKNOWNS, UNKNOWNS>::zeros();
        let mut right = SVector::<f64, UNKNOWNS>::zeros();
        let scale = self.scale();
        for point in points {
            let [u, v] = [0, 1].map(|axis| point.lens[axis] as f64 / scale[axis] - 1.0);
            let outside = self.outside(self.centre_px(point.lens), point.place_px, field);
            let [x, y] = outside.by_centre;
            let [r, s, t, p, q] = outside.by_shape;
            let slope =
                SVector::<f64, UNKNOWNS>::from([x, x * u, x * v, y, y * u, y * v, r, s, t, p, q]);
            let weight = (reach / outside.distance_px.abs().max(reach)).min(1.0);
            normal += weight * slope * slope.transpose();
            right -= weight * outside.distance_px * slope;
        }
        let used = if self.second.is_some() { UNKNOWNS } else { WITHOUT_SECOND };
        for n in 0..UNKNOWNS {
            if n < used {
                normal[(n, n)] += damping * normal[(n, n)].max(1e-6);
            } else {
                normal[(n, n)] = 1.0;
            }
        }
        let step = normal.cholesky()?.solve(&right);
        let largest = step.iter().fold(0.0f64, |most, part| most.max(part.abs()));
        Some(step * (LARGEST_STEP_PX / largest.max(LARGEST_STEP_PX)))
    }

    /// Lenses from the array's middle to its edge.
    fn scale(&self) -> [f64; 2] {
        self.grid.microlenses.map(|count| (count as f64 / 2.0).max(1.0))
    }

    fn moved(&self, step: &SVector<f64, UNKNOWNS>) -> Self {
        let scale = self.scale();
        let mut next = self.clone();
        for (at, affine) in [(0, &mut next.grid.column_px), (3, &mut next.grid.row_px)] {
            let (by_u, by_v) = (step[at + 1], step[at + 2]);
            affine[0] += step[at] - by_u - by_v;
            affine[1] += by_u / scale[0];
            affine[2] += by_v / scale[1];
        }
        next.radius_px += step[6];
        if let Some(second) = &mut next.second {
            second.radius_px += step[7];
            second.shift_at_corner_px += step[8];
            second.offset_px = [second.offset_px[0] + step[9], second.offset_px[1] + step[10]];
        }
        next
    }
}
