//! First estimator: circles with common radii, fitted to points on the rims.

use rayon::prelude::*;

use super::{
    WhiteImage,
    affine_fit::LensCentre,
    rim_model::{RimModel, RimPoint},
    rim_points::RimSearch,
    second_aperture::Field,
};

/// Largest number of lenses, distributed over the field, for the fit of common parameters.
const MOST_LENSES: usize = 1500;

/// Points farther from the rim than this many robust standard deviations are outliers.
const OUTLIER: f64 = 5.0;

/// Least standard deviation of a rim point, in pixels.
const LEAST_ERROR_PX: f64 = 0.04;

/// Least number of rim points of a centre.
const LEAST_POINTS: usize = 8;

/// Least eigenvalue of the information matrix of a centre. Each rim point contributes 1 along its normal.
const LEAST_EIGENVALUE: f64 = 1.5;

/// Result of the fit.
#[derive(Debug, Clone)]
pub(super) struct Arcs {
    pub circles: RimModel,
    pub centres: Vec<LensCentre>,
}

/// Fits the parameters common to all rims of these lenses, starting from `circles`, and then the centre of each
/// lens.
pub(super) fn fit(image: &WhiteImage, circles: RimModel, lenses: &[[usize; 2]]) -> Option<Arcs> {
    let field = Field::of(image.columns(), image.rows());
    // The stride is odd: a common divisor with the row length would leave out columns.
    let stride = lenses.len().div_ceil(MOST_LENSES).max(1) | 1;
    let some: Vec<[usize; 2]> = lenses.iter().copied().step_by(stride).collect();
    let circles = refined(image, circles, &some, &field)?;
    let points = find_points(image, &circles, lenses);
    let all: Vec<RimPoint> = points.iter().flatten().copied().collect();
    let error_px = circles.deviation_px(&all, &field).max(LEAST_ERROR_PX);
    let centres =
        points.par_iter().filter_map(|rim| centre(&circles, rim, &field, error_px)).collect();
    Some(Arcs { circles, centres })
}

/// The circles fitted to the rims of some lenses, starting from `circles`.
fn refined(
    image: &WhiteImage,
    mut circles: RimModel,
    lenses: &[[usize; 2]],
    field: &Field,
) -> Option<RimModel> {
    let points = find_points(image, &circles, lenses).concat();
    circles.fit(&points, field)?;
    Some(circles)
}

/// As [`refined`], with a second aperture if it explains the rims clearly better.
pub(super) fn with_second_aperture(
    image: &WhiteImage,
    mut circles: RimModel,
    lenses: &[[usize; 2]],
    field: &Field,
) -> Option<RimModel> {
    let points = find_points(image, &circles, lenses).concat();
    circles.fit(&points, field)?;
    circles.find_second(&points, field);
    Some(circles)
}

/// The points on the rim of each lens.
fn find_points(
    image: &WhiteImage,
    circles: &RimModel,
    lenses: &[[usize; 2]],
) -> Vec<Vec<RimPoint>> {
    let field = Field::of(image.columns(), image.rows());
    let search = RimSearch::new(&circles.grid, circles.radius_px, circles.second, field);
    let rim = |&lens: &[usize; 2]| {
        let places = search.points(image, circles.centre_px(lens));
        places.into_iter().map(|place_px| RimPoint { lens, place_px }).collect()
    };
    lenses.par_iter().map(rim).collect()
}

/// Fits the centre of one lens to its rim points. `None` if they do not determine it.
fn centre(
    circles: &RimModel,
    rim: &[RimPoint],
    field: &Field,
    error_px: f64,
) -> Option<LensCentre> {
    let lens = rim.first()?.lens;
    let mut centre_px = circles.centre_px(lens);
    let mut information = [0.0; 3];
    for _ in 0..4 {
        let [mut xx, mut xy, mut yy, mut x, mut y] = [0.0; 5];
        let mut count = 0;
        for point in rim {
            let to_rim = circles.rim_distance(centre_px, point.place_px, field);
            if to_rim.distance_px.abs() > OUTLIER * error_px {
                continue;
            }
            count += 1;
            let [by_x, by_y] = to_rim.by_centre;
            (xx, xy, yy) = (xx + by_x * by_x, xy + by_x * by_y, yy + by_y * by_y);
            x -= by_x * to_rim.distance_px;
            y -= by_y * to_rim.distance_px;
        }
        let determinant = xx * yy - xy * xy;
        let smallest = (xx + yy) / 2.0 - ((xx - yy).powi(2) / 4.0 + xy * xy).sqrt();
        if count < LEAST_POINTS || smallest < LEAST_EIGENVALUE {
            return None;
        }
        centre_px[0] += (yy * x - xy * y) / determinant;
        centre_px[1] += (xx * y - xy * x) / determinant;
        information = [xx, xy, yy];
    }
    Some(LensCentre { lens, centre_px, information })
}
