//! Sub-pixel points on the rims of micro-images.

use std::f64::consts::TAU;

use super::{
    WhiteImage,
    second_aperture::{Field, SecondAperture},
};
use crate::lightfield::MicroImageGrid;

/// Number of radial profiles per micro-image.
const DIRECTIONS: usize = 48;

/// Samples of a profile per pixel.
const PER_PIXEL: f64 = 4.0;

/// Distance from the rim at which the light levels on both sides are measured: a share of the largest distance
/// between rims of neighbours, within limits in pixels.
const LEVEL_DISTANCE_SHARE: f64 = 0.45;
const LEAST_LEVEL_DISTANCE_PX: f64 = 1.0;
const MOST_LEVEL_DISTANCE_PX: f64 = 3.0;

/// Upper limit in pitches for large micro-images, whose rims may be wide.
const MOST_LEVEL_DISTANCE_PITCHES: f64 = 0.11;

/// Least step of the light at a rim, as a share of the profile's range.
const LEAST_STEP: f64 = 0.25;

/// Search for rims in the images of one array.
#[derive(Debug, Clone)]
pub(super) struct RimSearch {
    radius_px: f64,
    /// Distance from the rim at which levels are measured, in pixels.
    level_distance_px: f64,
    /// Vectors from a lens to its neighbours, in pixels.
    neighbours: Vec<[f64; 2]>,
    second: Option<SecondAperture>,
    field: Field,
}

impl RimSearch {
    /// A search for micro-images of this radius on a grid, which a second aperture may cut.
    pub fn new(
        grid: &MicroImageGrid,
        radius_px: f64,
        second: Option<SecondAperture>,
        field: Field,
    ) -> Self {
        let most_level_distance_px =
            (MOST_LEVEL_DISTANCE_PITCHES * super::pitch_px(grid)).max(MOST_LEVEL_DISTANCE_PX);
        let neighbours = super::neighbours(grid, 2.0 * radius_px + 4.0 * most_level_distance_px);
        let mut search =
            Self { radius_px, level_distance_px: 0.0, neighbours, second: None, field };
        // The largest distance between rims is in the corners of the unit cell.
        let largest_gap = (0..DIRECTIONS)
            .map(|n| {
                search.distance_to_neighbours([0.0; 2], unit_vector(n).map(|part| part * radius_px))
            })
            .fold(0.0, f64::max);
        search.level_distance_px = (LEVEL_DISTANCE_SHARE * largest_gap)
            .clamp(LEAST_LEVEL_DISTANCE_PX, most_level_distance_px);
        search.second = second;
        search
    }

    /// Points on the rim of the micro-image centred at `centre_px`, of either aperture, in pixels. Points near a
    /// neighbour's rim are left out, because the light level between both rims is unknown.
    pub fn points(&self, image: &WhiteImage, centre_px: [f64; 2]) -> Vec<[f64; 2]> {
        let Some(from) = self.centroid_of_light(image, centre_px) else { return Vec::new() };
        (0..DIRECTIONS)
            .filter_map(|n| self.rim(image, centre_px, from, unit_vector(n)))
            .filter(|point| self.distance_to_neighbours(centre_px, *point) > self.level_distance_px)
            .collect()
    }

    /// Centroid of the bright pixels of the disc, which is inside the part that vignetting leaves.
    fn centroid_of_light(&self, image: &WhiteImage, centre_px: [f64; 2]) -> Option<[f64; 2]> {
        let reach = self.radius_px.ceil() as i64;
        let [column, row] = centre_px.map(|place| place.round() as i64);
        let inside = |place: i64, pixels: usize| place >= 0 && place < pixels as i64;
        let mut pixels = Vec::new();
        for r in row - reach..=row + reach {
            for c in column - reach..=column + reach {
                let from = (c as f64 - centre_px[0]).hypot(r as f64 - centre_px[1]);
                if from <= self.radius_px && inside(c, image.columns()) && inside(r, image.rows()) {
                    pixels.push(([c as f64, r as f64], image.at(c as usize, r as usize)));
                }
            }
        }
        let brightest = pixels.iter().map(|pixel| pixel.1).fold(f64::NEG_INFINITY, f64::max);
        let darkest = pixels.iter().map(|pixel| pixel.1).fold(f64::INFINITY, f64::min);
        let half = (brightest + darkest) / 2.0;
        let lit = pixels.iter().filter(|pixel| pixel.1 >= half);
        let sum = lit.fold([0.0; 3], |s, (p, _)| [s[0] + p[0], s[1] + p[1], s[2] + 1.0]);
        (sum[2] > 0.0).then(|| [sum[0] / sum[2], sum[1] / sum[2]])
    }

    /// Point on the rim along a ray: the mean of the levels on both sides is crossed near the steepest descent.
    fn rim(
        &self,
        image: &WhiteImage,
        centre: [f64; 2],
        from: [f64; 2],
        direction: [f64; 2],
    ) -> Option<[f64; 2]> {
        let to_end = length_to_circle(
            centre,
            from,
            direction,
            self.radius_px + self.level_distance_px + 1.5,
        )?;
        let samples = (to_end * PER_PIXEL) as usize;
        let at = |n: usize| {
            let t = n as f64 / PER_PIXEL;
            image.between(from[0] + t * direction[0], from[1] + t * direction[1])
        };
        let profile: Vec<f64> = (0..=samples).map_while(at).collect();
        let level = |middle: f64| -> Option<f64> {
            let first = ((middle - 0.5) * PER_PIXEL).round();
            let last = ((middle + 0.5) * PER_PIXEL).round();
            if first < 0.0 || last as usize >= profile.len() {
                return None;
            }
            let part = &profile[first as usize..=last as usize];
            Some(part.iter().sum::<f64>() / part.len() as f64)
        };
        let pixel = PER_PIXEL as usize;
        let steepest = (pixel..profile.len().saturating_sub(pixel)).min_by(|&a, &b| {
            let drop = |n: usize| profile[n + pixel] - profile[n - pixel];
            drop(a).total_cmp(&drop(b))
        })?;
        let t = steepest as f64 / PER_PIXEL;
        let (inner, outer) =
            (level(t - self.level_distance_px)?, level(t + self.level_distance_px)?);
        let high = profile.iter().copied().fold(f64::NEG_INFINITY, f64::max);
        let low = profile.iter().copied().fold(f64::INFINITY, f64::min);
        if inner - outer < LEAST_STEP * (high - low) {
            return None;
        }
        let crossing = crossing_near(&profile, steepest, (inner + outer) / 2.0)? / PER_PIXEL;
        ((crossing - t).abs() < self.level_distance_px)
            .then(|| [from[0] + crossing * direction[0], from[1] + crossing * direction[1]])
    }

    /// Distance of a position from the nearest rim of a neighbour, in pixels.
    fn distance_to_neighbours(&self, centre: [f64; 2], place: [f64; 2]) -> f64 {
        let distances = self.neighbours.iter().map(|neighbour| {
            let other = [0, 1].map(|axis| centre[axis] + neighbour[axis]);
            let outside =
                |[x, y]: [f64; 2], radius: f64| (place[0] - x).hypot(place[1] - y) - radius;
            let cut = self.second.map_or(f64::NEG_INFINITY, |second| {
                outside(second.centre_px(other, &self.field), second.radius_px)
            });
            outside(other, self.radius_px).max(cut).abs()
        });
        distances.fold(f64::INFINITY, f64::min)
    }
}

/// Unit vector of profile `n`.
fn unit_vector(n: usize) -> [f64; 2] {
    let (sine, cosine) = (TAU * n as f64 / DIRECTIONS as f64).sin_cos();
    [cosine, sine]
}

/// Length along a ray, from `from`, to its intersection with a circle. `None` if it misses the circle.
fn length_to_circle(
    centre: [f64; 2],
    from: [f64; 2],
    direction: [f64; 2],
    radius: f64,
) -> Option<f64> {
    let to = [from[0] - centre[0], from[1] - centre[1]];
    let along = to[0] * direction[0] + to[1] * direction[1];
    let square = radius * radius - (to[0] * to[0] + to[1] * to[1]) + along * along;
    (square > 0.0).then(|| square.sqrt() - along)
}

/// Position in samples where the profile falls through a level, nearest to sample `near`.
fn crossing_near(profile: &[f64], near: usize, level: f64) -> Option<f64> {
    let falls = |n: usize| profile[n] >= level && profile[n + 1] < level;
    let crossings = (0..profile.len().saturating_sub(1)).filter(|&n| falls(n));
    let n = crossings.min_by_key(|&n| n.abs_diff(near))?;
    Some(n as f64 + (profile[n] - level) / (profile[n] - profile[n + 1]))
}
