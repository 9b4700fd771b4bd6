//! Model of all rims: the stop's disc, and the disc of a second aperture that may cut it.
//!
//! With the signed distances s₁ and s₂ from both circles, positive outside, the rim is where max(s₁, s₂) = 0. This
//! also holds for the half level of blurred rims where both circles are close together, as at the onset of
//! vignetting.

use nalgebra::{SMatrix, SVector};

use super::second_aperture::{Field, SecondAperture};
use crate::{lightfield::MicroImageGrid, statistics::NORMAL_OF_MEDIAN};

/// Number of parameters: six of the grid, the stop's radius, and four of the second aperture.
const RIM_PARAMETERS: usize = 11;
/// Number of parameters without a second aperture.
const WITHOUT_SECOND: usize = 7;

/// Initial displacements of the second disc at the corner, in radii of the stop.
const SHIFTS: [f64; 10] = [-3.0, -1.5, -0.8, -0.35, -0.15, 0.15, 0.35, 0.8, 1.5, 3.0];

/// Least relative decrease of the cost for which a second aperture is accepted.
const LEAST_GAIN: f64 = 0.25;

/// Range of the second disc's radius and largest displacement at the corner, in radii of the stop.
const RADII: std::ops::RangeInclusive<f64> = 0.5..=8.0;
const LARGEST_SHIFT: f64 = 8.0;

const ROUNDS: usize = 40;

/// Limit of a step of any parameter, in pixels.
const LARGEST_STEP_PX: f64 = 1.0;

/// Threshold of Huber's loss, in robust standard deviations.
const HUBER_DEVIATIONS: f64 = 1.5;

/// Least threshold of Huber's loss, in pixels.
const LEAST_HUBER_PX: f64 = 0.1;

/// A point on the rim of a lens' micro-image.
#[derive(Debug, Clone, Copy)]
pub(super) struct RimPoint {
    pub lens: [usize; 2],
    pub place_px: [f64; 2],
}

/// Parameters of all circles; lengths in pixels.
#[derive(Debug, Clone)]
pub(super) struct RimModel {
    pub grid: MicroImageGrid,
    pub radius_px: f64,
    pub second: Option<SecondAperture>,
}

/// Signed distance of a point from the rim, positive outside, and its derivatives.
pub(super) struct RimDistance {
    pub distance_px: f64,
    /// Derivatives with respect to the micro-image's centre, with which both discs move.
    pub by_centre: [f64; 2],
    /// Derivatives with respect to the stop's radius and to the second aperture's radius, shift and offset.
    by_shape: [f64; 5],
}

impl RimModel {
    /// Signed distance of a position from the rim of the micro-image centred at `centre_px`.
    pub fn rim_distance(
        &self,
        centre_px: [f64; 2],
        place_px: [f64; 2],
        field: &Field,
    ) -> RimDistance {
        let away = |from: [f64; 2]| {
            let offset = [place_px[0] - from[0], place_px[1] - from[1]];
            let distance = offset[0].hypot(offset[1]).max(1e-9);
            (distance, offset.map(|part| part / distance))
        };
        let (distance, [nx, ny]) = away(centre_px);
        let stop = distance - self.radius_px;
        let Some(second) = &self.second else {
            return RimDistance {
                distance_px: stop,
                by_centre: [-nx, -ny],
                by_shape: [-1.0, 0.0, 0.0, 0.0, 0.0],
            };
        };
        let (distance, [mx, my]) = away(second.centre_px(centre_px, field));
        let cut = distance - second.radius_px;
        let [of_stop, of_cut] = if stop >= cut { [1.0, 0.0] } else { [0.0, 1.0] };
        let share = field.share(centre_px);
        let stretch = 1.0 + second.shift_at_corner_px / field.half_diagonal_px;
        RimDistance {
            distance_px: stop.max(cut),
            by_centre: [
                -of_stop * nx - of_cut * stretch * mx,
                -of_stop * ny - of_cut * stretch * my,
            ],
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
        points
            .iter()
            .map(|p| self.rim_distance(self.centre_px(p.lens), p.place_px, field).distance_px)
    }

    /// Robust standard deviation of the points' distances from the rim, in pixels.
    pub fn deviation_px(&self, points: &[RimPoint], field: &Field) -> f64 {
        NORMAL_OF_MEDIAN * super::median(self.distances(points, field).map(f64::abs))
    }

    /// Threshold of Huber's loss, in pixels.
    fn huber_px(&self, points: &[RimPoint], field: &Field) -> f64 {
        (HUBER_DEVIATIONS * self.deviation_px(points, field)).max(LEAST_HUBER_PX)
    }

    /// Sum of Huber's loss over the points.
    fn cost(&self, points: &[RimPoint], field: &Field, huber_px: f64) -> f64 {
        let loss = |distance: f64| {
            let length = distance.abs();
            if length < huber_px {
                0.5 * length * length
            } else {
                huber_px * (length - 0.5 * huber_px)
            }
        };
        self.distances(points, field).map(loss).sum()
    }

    /// Fits a second aperture from several initial values, and adopts it if the cost decreases sufficiently.
    pub fn find_second(&mut self, points: &[RimPoint], field: &Field) {
        let huber_px = self.huber_px(points, field);
        let without = self.cost(points, field, huber_px);
        let fitted = SHIFTS.iter().filter_map(|shift| {
            let second = SecondAperture {
                radius_px: self.radius_px * (1.0 + 0.5 * shift.abs()),
                shift_at_corner_px: shift * self.radius_px,
                offset_px: [0.0; 2],
            };
            let mut model = Self { second: Some(second), ..self.clone() };
            model.fit(points, field)?;
            model.order_discs(field);
            model.is_plausible().then(|| (model.cost(points, field, huber_px), model))
        });
        let best = fitted.min_by(|a, b| a.0.total_cmp(&b.0));
        if let Some((cost, model)) = best
            && cost < (1.0 - LEAST_GAIN) * without
        {
            *self = model;
        }
    }

    /// Exchanges both discs if the second one is smaller: the stop limits the light in the middle of the field.
    fn order_discs(&mut self, field: &Field) {
        let Some(second) = self.second else { return };
        if second.radius_px >= self.radius_px {
            return;
        }
        // The centres of the second discs are also an affine map of the lens indices.
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

    /// Whether the second disc has a plausible size, and its axis intersects the sensor.
    fn is_plausible(&self) -> bool {
        self.second.is_some_and(|second| {
            RADII.contains(&(second.radius_px / self.radius_px))
                && second.shift_at_corner_px.abs() < LARGEST_SHIFT * self.radius_px
                && second.offset_px[0].hypot(second.offset_px[1]) < second.shift_at_corner_px.abs()
        })
    }

    /// Levenberg-Marquardt fit to the points. `None` if they do not determine the parameters.
    pub fn fit(&mut self, points: &[RimPoint], field: &Field) -> Option<()> {
        let mut damping = 1e-4;
        for _ in 0..ROUNDS {
            let huber_px = self.huber_px(points, field);
            let cost = self.cost(points, field, huber_px);
            let step = self.step(points, field, huber_px, damping)?;
            let next = self.moved(&step);
            let next_cost = next.cost(points, field, huber_px);
            if next_cost <= cost {
                let converged = cost - next_cost < 1e-7 * cost;
                *self = next;
                damping = (damping * 0.2).max(1e-9);
                if converged {
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
        huber_px: f64,
        damping: f64,
    ) -> Option<SVector<f64, RIM_PARAMETERS>> {
        let mut normal = SMatrix::<f64, RIM_PARAMETERS, RIM_PARAMETERS>::zeros();
        let mut right = SVector::<f64, RIM_PARAMETERS>::zeros();
        let scale = self.scale();
        for point in points {
            let [u, v] = [0, 1].map(|axis| point.lens[axis] as f64 / scale[axis] - 1.0);
            let rim = self.rim_distance(self.centre_px(point.lens), point.place_px, field);
            let [x, y] = rim.by_centre;
            let [r, s, t, p, q] = rim.by_shape;
            let slope = SVector::<f64, RIM_PARAMETERS>::from([
                x,
                x * u,
                x * v,
                y,
                y * u,
                y * v,
                r,
                s,
                t,
                p,
                q,
            ]);
            let weight = (huber_px / rim.distance_px.abs().max(huber_px)).min(1.0);
            normal += weight * slope * slope.transpose();
            right -= weight * rim.distance_px * slope;
        }
        let used = if self.second.is_some() { RIM_PARAMETERS } else { WITHOUT_SECOND };
        for n in 0..RIM_PARAMETERS {
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

    /// Number of lenses from the middle of the array to its edge along i and j.
    fn scale(&self) -> [f64; 2] {
        self.grid.microlenses.map(|count| (count as f64 / 2.0).max(1.0))
    }

    fn moved(&self, step: &SVector<f64, RIM_PARAMETERS>) -> Self {
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
