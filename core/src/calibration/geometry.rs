//! Neighbours and cells of a lattice.

use crate::{lightfield::MicroImageGrid, statistics};

/// Largest lattice step of a neighbour along each axis.
const STEPS: i64 = 3;

/// The smallest distance between neighbouring micro-images, in pixels.
pub(super) fn pitch_px(grid: &MicroImageGrid) -> f64 {
    let lengths = neighbour_numbers(grid, f64::INFINITY).into_iter().map(|step| {
        let [x, y] = vector(grid, step);
        x.hypot(y)
    });
    lengths.fold(f64::INFINITY, f64::min)
}

/// Vectors from a lens to its neighbours within `reach_px`, in pixels.
pub(super) fn neighbours(grid: &MicroImageGrid, reach_px: f64) -> Vec<[f64; 2]> {
    neighbour_numbers(grid, reach_px).into_iter().map(|step| vector(grid, step)).collect()
}

/// Lattice steps (i, j) from a lens to its neighbours within `reach_px`.
pub(super) fn neighbour_numbers(grid: &MicroImageGrid, reach_px: f64) -> Vec<[i64; 2]> {
    let steps = (-STEPS..=STEPS).flat_map(|j| (-STEPS..=STEPS).map(move |i| [i, j]));
    steps
        .filter(|&step| {
            let [x, y] = vector(grid, step);
            step != [0, 0] && x.hypot(y) <= reach_px
        })
        .collect()
}

fn vector(grid: &MicroImageGrid, [i, j]: [i64; 2]) -> [f64; 2] {
    [grid.column_px, grid.row_px].map(|[_, by_i, by_j]| by_i * i as f64 + by_j * j as f64)
}

/// Column and row of the pixels that are nearer to a lens' centre than to its neighbours' centres. `None` if
/// some of them are outside the image.
pub(super) fn cell_pixels(
    grid: &MicroImageGrid,
    [i, j]: [usize; 2],
    columns: usize,
    rows: usize,
) -> Option<Vec<[usize; 2]>> {
    let around = neighbours(grid, 1.6 * pitch_px(grid));
    let centre = grid.centre_px(i as f64, j as f64);
    let reach = 0.75 * pitch_px(grid);
    let span =
        |axis: usize| (centre[axis] - reach).ceil() as i64..=(centre[axis] + reach).floor() as i64;
    let mut pixels = Vec::new();
    for row in span(1) {
        for column in span(0) {
            let from = [column as f64 - centre[0], row as f64 - centre[1]];
            let is_nearest = around.iter().all(|to| {
                from[0] * to[0] + from[1] * to[1] <= (to[0] * to[0] + to[1] * to[1]) / 2.0
            });
            if !is_nearest {
                continue;
            }
            if column < 0 || row < 0 || column >= columns as i64 || row >= rows as i64 {
                return None;
            }
            pixels.push([column as usize, row as usize]);
        }
    }
    Some(pixels)
}

/// The median; NaN without values.
pub(super) fn median(values: impl Iterator<Item = f64>) -> f64 {
    statistics::median(values).unwrap_or(f64::NAN)
}
