//! State of each lens: whether its micro-image can be used, and its share that vignetting leaves.

use std::collections::HashMap;

use serde::{Deserialize, Serialize};

use super::{
    WhiteImage,
    affine_fit::AffineFit,
    cell_light::CellLight,
    cell_pixels,
    rendered_discs::Discs,
    second_aperture::{Field, SecondAperture},
};
use crate::lightfield::MicroImageGrid;

/// A lens is dark below this share of the median light of its neighbours.
const DARK: f64 = 0.4;

/// A lens is dark below this share of the light of bright lenses.
const DARK_ANYWHERE: f64 = 0.05;

/// Least residual of the rendered micro-image, relative to the median lens, that indicates dust.
const DISTURBED: f64 = 2.5;

/// Whether a lens' micro-image can be used.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum LensState {
    /// The whole micro-image is on the sensor, and it agrees with the model.
    Valid,
    /// Some or all of its pixels are not on the sensor.
    PartlyImaged,
    /// It has little or no light.
    Dark,
    /// It differs from the rendered micro-image, or its centre is off the grid: dust, a scratch.
    Disturbed,
}

/// One lens of the array.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Lens {
    /// Whether its micro-image can be used.
    pub state: LensState,
    /// Share of the stop's disc that the second aperture leaves open.
    pub open_share: f64,
    /// Mean light relative to the brightest lenses.
    pub light: f64,
    /// Measured centre minus grid point, column and row, in pixels.
    pub residual_px: Option<[f64; 2]>,
}

/// Lenses with whole and lit micro-images, which the estimators use.
pub(super) fn usable(
    image: &WhiteImage,
    grid: &MicroImageGrid,
    light: &CellLight,
) -> Vec<[usize; 2]> {
    let [nx, ny] = grid.microlenses;
    let is_usable = |&lens: &[usize; 2]| {
        !is_dark(light, lens) && cell_pixels(grid, lens, image.columns(), image.rows()).is_some()
    };
    (0..nx * ny).map(|n| [n % nx, n / nx]).filter(is_usable).collect()
}

fn is_dark(light: &CellLight, lens: [usize; 2]) -> bool {
    let Some(own) = light.on_image(lens) else { return false };
    let steps = (-2..=2).flat_map(|j| (-2..=2).map(move |i| [i, j]));
    let around = super::median(steps.filter_map(|step| light.of_neighbour(lens, step)));
    own < DARK_ANYWHERE * light.bright() || own < DARK * around
}

/// The states of the lenses of `grid`, row by row from (0, 0). Lens (0, 0) of `grid` is lens `first` in `light`,
/// `discs` and `fit`.
pub(super) fn states(
    image: &WhiteImage,
    grid: &MicroImageGrid,
    first: [i64; 2],
    light: &CellLight,
    discs: &Discs,
    fit: &AffineFit,
) -> Vec<Lens> {
    let field = Field::of(image.columns(), image.rows());
    let typical = super::median(discs.misfits.iter().copied());
    let measured: HashMap<[usize; 2], usize> =
        discs.centres.iter().enumerate().map(|(n, centre)| (centre.lens, n)).collect();
    let [nx, ny] = grid.microlenses;
    let bright = light.bright();
    let lens = |n: usize| {
        let [i, j] = [n % nx, n / nx];
        let centre_px = grid.centre_px(i as f64, j as f64);
        let before = light.in_array([i as i64 + first[0], j as i64 + first[1]]);
        let found = before.and_then(|lens| measured.get(&lens)).copied();
        let residual_px = found.map(|n| {
            let found = discs.centres[n].centre_px;
            [found[0] - centre_px[0], found[1] - centre_px[1]]
        });
        let whole = cell_pixels(grid, [i, j], image.columns(), image.rows()).is_some();
        let state = match (whole, before, found) {
            (false, _, _) | (_, None, _) => LensState::PartlyImaged,
            (_, Some(lens), _) if is_dark(light, lens) => LensState::Dark,
            (_, _, Some(n)) if fit.kept[n] && discs.misfits[n] <= DISTURBED * typical => {
                LensState::Valid
            }
            _ => LensState::Disturbed,
        };
        Lens {
            state,
            open_share: open_share(centre_px, discs.radius_px, discs.second.as_ref(), &field),
            light: before.and_then(|lens| light.on_image(lens)).map_or(0.0, |own| own / bright),
            residual_px,
        }
    };
    (0..nx * ny).map(lens).collect()
}

/// Share of the stop's disc inside the second aperture's disc: the area between two arcs.
fn open_share(
    stop_px: [f64; 2],
    radius_px: f64,
    second: Option<&SecondAperture>,
    field: &Field,
) -> f64 {
    let Some(second) = second else { return 1.0 };
    let other = second.centre_px(stop_px, field);
    let apart = (other[0] - stop_px[0]).hypot(other[1] - stop_px[1]);
    let (r, s) = (radius_px, second.radius_px);
    let area = std::f64::consts::PI * r * r;
    if apart <= (r - s).abs() {
        return (s * s / (r * r)).min(1.0);
    }
    if apart >= r + s {
        return 0.0;
    }
    let segment = |own: f64, other: f64| {
        let along = (apart * apart + own * own - other * other) / (2.0 * apart);
        let angle = (along / own).clamp(-1.0, 1.0).acos();
        own * own * (angle - 0.5 * (2.0 * angle).sin())
    };
    (segment(r, s) + segment(s, r)) / area
}
