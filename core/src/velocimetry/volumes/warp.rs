//! Warping of a volume by a displacement field.
//!
//! Axes are interpolated one after the other (Catmull and Smith, SIGGRAPH 1980). Neighbouring cells read
//! neighbouring values: a group of cells, one per vector lane, reads the union of their supports, and each lane
//! applies its own weights.

use std::ops::Range;

use multiversion::multiversion;

use super::{expansion::Expansion, light::CellLight};
use crate::velocimetry::{b_spline, lattice::Lattice};

/// Cells interpolated together.
const LANES: usize = 16;

/// A cubic B-spline reaches less than this many cells.
const REACH: i64 = 2;

/// Fixed-point iterations that invert a displacement. Each reduces the error by the displacement's gradient.
const INVERSION_STEPS: usize = 2;

/// Frame b warped onto frame a: the value at x is that of `source` at x + `field`(x), with `field` in voxels
/// and `source` a sum of cubic B-splines with nodes one cell apart; outside the volume the light is 0. The
/// result extends `border` cells beyond it.
pub fn warped(source: &CellLight, field: &Lattice, border: usize) -> CellLight {
    let mut found = CellLight::dark(source.cells, source.cell_vox, border);
    let [row, _] = found.strides();
    let (here, around) = (source.axes(0), source.axes(border));
    let steps = axis_by_axis(field);
    // Axes after the current one have the result's coordinates, those before it the source's.
    let along_z = Expansion::new(&steps, 2, [here[0], here[1], around[2]]);
    let along_y = Expansion::new(&steps, 1, [here[0], around[1], around[2]]);
    let along_x = Expansion::new(&steps, 0, around);
    let per_cell = 1.0 / source.cell_vox as f32;
    let ([source_row, source_plane], [sx, sy, sz]) = (source.strides(), source.cells);
    let light = &source.stored()[source.origin()..];

    found.each_stored_plane(|plane, z| {
        let across_planes = Line::across(z, border, sz, source_plane);
        let mut steps = vec![0.0; sx.max(row)];
        let mut rows = vec![0.0; sx * sy + LANES];
        for (y, to) in rows.chunks_exact_mut(sx).take(sy).enumerate() {
            along_z.write_row([y, z], per_cell, &mut steps[..sx]);
            interpolate(&light[y * source_row..], across_planes, &steps[..sx], to);
        }
        let (mut steps_y, mut padded) = (vec![0.0; sx], Vec::new());
        for (y, to) in plane.chunks_exact_mut(row).enumerate() {
            along_x.write_row([y, z], per_cell, &mut steps[..row]);
            let (line, within) = Line::padded(sx, border, &steps[..row], &mut padded);
            along_y.write_row([y, z], per_cell, &mut steps_y);
            interpolate(&rows, Line::across(y, border, sy, sx), &steps_y, &mut padded[within]);
            interpolate(&padded, line, &steps[..row], to);
        }
    });
    found
}

/// Steps for interpolation along one axis after the other: along z at nodes whose x and y are already displaced,
/// along y at nodes whose x is, along x at those of `field`.
fn axis_by_axis(field: &Lattice) -> Lattice {
    field.clone().sampling(|at| {
        let step = field.at(at);
        let unmoved = |axes: Range<usize>| {
            let mut own = step;
            for _ in 0..INVERSION_STEPS {
                let mut from = at;
                axes.clone().for_each(|axis| from[axis] -= own[axis]);
                own = field.at(from);
            }
            own
        };
        [step[0], unmoved(0..1)[1], unmoved(0..2)[2]]
    })
}

/// Light along an axis for a row of adjacent cells: cell x reads the values `origin + x + n · stride`, n from
/// `low` to `high`; n = 0 is its own position.
#[derive(Debug, Clone, Copy)]
struct Line {
    origin: i64,
    stride: i64,
    low: i64,
    high: i64,
}

impl Line {
    /// Across `count` rows, `stride` apart, at position `place` counted from the border.
    fn across(place: usize, border: usize, count: usize, stride: usize) -> Self {
        let own = place as i64 - border as i64;
        let stride = stride as i64;
        Self { origin: own * stride, stride, low: -own, high: count as i64 - 1 - own }
    }

    /// Along a row of `length` cells, to be written to the returned range of `padded`. Zeros surround it as far as
    /// `steps`, counted from the border, reach.
    fn padded(
        length: usize,
        border: usize,
        steps: &[f32],
        padded: &mut Vec<f32>,
    ) -> (Self, Range<usize>) {
        let farthest = steps.iter().fold(0.0f32, |most, step| most.max(step.abs()));
        // Beyond the length of the row all values are zero.
        let reach = farthest.ceil().min(length as f32) as usize + REACH as usize;
        let pad = border + reach;
        padded.clear();
        padded.resize(length + 2 * pad + LANES, 0.0);
        let reach = reach as i64;
        (Self { origin: reach, stride: 1, low: -reach, high: reach }, pad..pad + length)
    }
}

/// `to[x] = Σ_n spline(n − steps[x]) light[origin + x + n · stride]`. `light` is padded by
/// [`LANES`] values.
#[multiversion(targets("x86_64+avx512f+avx512vl", "x86_64+avx2"))]
fn interpolate(light: &[f32], from: Line, steps: &[f32], to: &mut [f32]) {
    let (groups, rest) = steps.as_chunks::<LANES>();
    let (group_to, rest_to) = to.as_chunks_mut::<LANES>();
    let mut line = from;
    for (steps, to) in groups.iter().zip(group_to) {
        *to = interpolate_group(light, line, steps);
        line.origin += LANES as i64;
    }
    if let Some(&first) = rest.first() {
        let mut steps = [first; LANES];
        steps[..rest.len()].copy_from_slice(rest);
        rest_to.copy_from_slice(&interpolate_group(light, line, &steps)[..rest_to.len()]);
    }
}

#[inline(always)]
fn interpolate_group(light: &[f32], from: Line, steps: &[f32; LANES]) -> [f32; LANES] {
    let [low, high] = extremes(steps);
    let (low, high) = (low.floor() as i64 - REACH + 1, high.floor() as i64 + REACH);
    let mut sum = [0.0; LANES];
    for n in low.max(from.low)..=high.min(from.high) {
        let light = &light[(from.origin + n * from.stride) as usize..][..LANES];
        for lane in 0..LANES {
            sum[lane] += b_spline::value(n as f32 - steps[lane]) * light[lane];
        }
    }
    sum
}

/// Minimum and maximum, by pairwise reduction in lanes.
#[inline(always)]
fn extremes(values: &[f32; LANES]) -> [f32; 2] {
    let (mut low, mut high) = (*values, *values);
    let mut half = LANES / 2;
    while half > 0 {
        for lane in 0..half {
            let (l, h) = (low[lane + half], high[lane + half]);
            low[lane] = if l < low[lane] { l } else { low[lane] };
            high[lane] = if h > high[lane] { h } else { high[lane] };
        }
        half /= 2;
    }
    [low[0], high[0]]
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The sum of B-splines at a place, in cells.
    fn naive(source: &CellLight, at: [f32; 3]) -> f64 {
        let [_, ny, nz] = source.cells;
        let weight = |n: usize, axis: usize| f64::from(b_spline::value(n as f32 - at[axis]));
        let mut sum = 0.0;
        for (z, y) in (0..nz).flat_map(|z| (0..ny).map(move |y| (z, y))) {
            for (x, light) in source.row([y, z]).iter().enumerate() {
                sum += f64::from(*light) * weight(x, 0) * weight(y, 1) * weight(z, 2);
            }
        }
        sum
    }

    /// Light in waves.
    fn waves(cells: [usize; 3], cell_vox: usize) -> CellLight {
        let mut light = CellLight::dark(cells, cell_vox, 1);
        light.each_row(|row, [y, z]| {
            for (x, light) in row.iter_mut().enumerate() {
                let wave = |n: usize| 1.0 + (n as f32 * std::f32::consts::TAU / 12.0).sin();
                *light = wave(x) * wave(y + 2) * wave(z + 4);
            }
        });
        light
    }

    fn compare(source: &CellLight, field: &Lattice, tolerance: f64) {
        let border = 2;
        let found = warped(source, field, border);
        let ([row, plane], axes) = (found.strides(), source.axes(border));
        for (n, value) in found.stored().iter().enumerate().take(plane * axes[2].count).step_by(7) {
            let place = [n % row, n % plane / row, n / plane];
            let at_vox =
                std::array::from_fn(|c| axes[c].first_vox + place[c] as f32 * axes[c].step_vox);
            let step_vox = field.at(at_vox);
            let at = std::array::from_fn(|c| {
                place[c] as f32 - border as f32 + step_vox[c] / source.cell_vox as f32
            });
            let expected = naive(source, at);
            let error = (f64::from(*value) - expected).abs();
            assert!(error < tolerance, "{place:?} {value} {expected}");
        }
    }

    #[test]
    fn every_cell_has_the_light_at_its_displaced_position() {
        for (cells, cell_vox) in [([30, 9, 11], 1), ([13, 8, 10], 2)] {
            let source = waves(cells, cell_vox);
            let even = Lattice {
                nodes: [7, 4, 5],
                first_vox: [-6.0; 3],
                step_vox: 7.0,
                values: vec![[1.3, -2.6, 0.45]; 140],
            };
            compare(&source, &even, 1e-4);
            let far = even.clone().sampling(|_| [40.0, -6.0, 3.0]);
            compare(&source, &far, 1e-4);
            // Light is up to 8. The remaining error is the curvature of the field within the support of a spline.
            let wave = |t: f32| (t / 16.0).sin();
            let bent = even.sampling(|[x, y, z]| [wave(y) + 2.0, wave(z - x), wave(x + y)]);
            compare(&source, &bent, 0.1);
        }
    }
}
