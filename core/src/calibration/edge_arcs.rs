//! The first estimator: arcs of common circles through rim points.

use rayon::prelude::*;

use super::{
    WhiteImage,
    affine_fit::LensCentre,
    rim_model::{RimModel, RimPoint},
    rim_points::RimSearch,
    second_aperture::Field,
};

/// At most this many lenses, all over the field, decide on the circles.
const MOST_LENSES: usize = 1500;

/// Points further from the rim than this many robust standard deviations are dust.
const OUTLIER: f64 = 5.0;

/// The error of a rim point is taken to be at least this, in pixels.
const LEAST_ERROR_PX: f64 = 0.04;

/// A centre needs this many points, and this much of each direction: rim points seen at right angles.
const LEAST_POINTS: usize = 8;
const LEAST_ACROSS: f64 = 1.5;

/// What the arcs say.
#[derive(Debug, Clone)]
pub(super) struct Arcs {
    pub circles: RimModel,
    pub centres: Vec<LensCentre>,
}

/// Fits common circles, from a first guess of them, to the rims of these lenses, and then each lens'
/// own centre.
pub(super) fn fit(image: &WhiteImage, circles: RimModel, lenses: &[[usize; 2]]) -> Option<Arcs> {
    let field = Field::of(image.columns(), image.rows());
    // A stride without a common divisor with the rows of lenses does not pick columns.
    let stride = lenses.len().div_ceil(MOST_LENSES).max(1) | 1;
    let some: Vec<[usize; 2]> = lenses.iter().copied().step_by(stride).collect();
    let circles = followed(image, circles, &some, &field)?;
    let points = find_points(image, &circles, lenses);
    let all: Vec<RimPoint> = points.iter().flatten().copied().collect();
    let error_px = circles.deviation_px(&all, &field).max(LEAST_ERROR_PX);
    let centres =
        points.par_iter().filter_map(|rim| centre(&circles, rim, &field, error_px)).collect();
    Some(Arcs { circles, centres })
}

/// Circles through the rims of some lenses, from circles near them.
fn followed(
    image: &WhiteImage,
    mut circles: RimModel,
    lenses: &[[usize; 2]],
    field: &Field,
) -> Option<RimModel> {
    let points = find_points(image, &circles, lenses).concat();
    circles.follow(&points, field)?;
    Some(circles)
}

/// Circles through the rims of some lenses, with a second aperture where rims ask for one.
pub(super) fn first_circles(
    image: &WhiteImage,
    mut circles: RimModel,
    lenses: &[[usize; 2]],
    field: &Field,
) -> Option<RimModel> {
    let points = find_points(image, &circles, lenses).concat();
    circles.follow(&points, field)?;
    circles.look_for_second(&points, field);
    Some(circles)
}

/// The rim points of each lens.
fn find_points(
    image: &WhiteImage,
    circles: &RimModel,
    lenses: &[[usize; 2]],
) -> Vec<Vec<RimPoint>> {
    let field = Field::of(image.columns(), image.rows());
    let looking = RimSearch::new(&circles.grid, circles.radius_px, circles.second, field);
    let rim = |&lens: &[usize; 2]| {
        let places = looking.points(image, circles.centre_px(lens));
        places.into_iter().map(|place_px| RimPoint { lens, place_px }).collect()
    };
    lenses.par_iter().map(rim).collect()
}

/// The centre of the common circles through the points of one lens.
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
            let outside = circles.outside(centre_px, point.place_px, field);
            if outside.distance_px.abs() > OUTLIER * error_px {
                continue;
            }
            count += 1;
            let [by_x, by_y] = outside.by_centre;
            (xx, xy, yy) = (xx + by_x * by_x, xy + by_x * by_y, yy + by_y * by_y);
            x -= by_x * outside.distance_px;
            y -= by_y * outside.distance_px;
        }
        let determinant = xx * yy - xy * xy;
        let least = (xx + yy) / 2.0 - ((xx - yy).powi(2) / 4.0 + xy * xy).sqrt();
        if count < LEAST_POINTS || least < LEAST_ACROSS {
            return None;
        }
        centre_px[0] += (yy * x - xy * y) / determinant;
        centre_px[1] += (xx * y - xy * x) / determinant;
        information = [xx, xy, yy];
    }
    Some(LensCentre { lens, centre_px, information })
}
