//! Positions of blocks relative to the microlenses, and the resulting table addresses in a view.

use super::{
    rounding::{nearest, whole},
    share_table::{PHASE_CLASSES, SLOPE_CLASSES, TableLayout},
};
use crate::{
    lightfield::TIE_PX,
    model::{blocks::kernels::BATCH, mapped_optics::ProjectedPoint},
};

/// Positions are clamped to this distance from the window, in microlenses, to limit pixel indices. No light
/// reaches it.
const BEYOND: f32 = 64.0;

/// A number of up to ± 2²² plus this is rounded to an integer, which is in the lowest bits of the mantissa.
const INTEGERS: f32 = 12_582_912.0;

/// Positions of blocks, or of one layer of each, as arrays for vectorised address computation.
#[derive(Debug, Clone, Default)]
pub(super) struct BlockPlaces {
    /// Along the array's columns and rows.
    pub axes: [AxisPlaces; 2],
}

/// One axis of [`BlockPlaces`].
#[derive(Debug, Clone, Default)]
pub(super) struct AxisPlaces {
    /// In microlenses, relative to the window's first.
    place: Vec<f32>,
    parallax: Vec<f32>,
    /// Index of the depth's first tap.
    depth: Vec<u32>,
}

/// Index of a tap in its table, and the microlens to which its first entry is relative.
#[derive(Debug, Clone, Copy)]
pub(super) struct Addresses {
    pub tap: [[u32; BATCH]; 2],
    pub lens: [[i32; BATCH]; 2],
}

impl Addresses {
    pub const NONE: Self = Self { tap: [[0; BATCH]; 2], lens: [[0; BATCH]; 2] };
}

/// Parameters common to all blocks of a view.
#[derive(Debug, Clone, Copy)]
pub(super) struct ViewAddresses {
    /// The view's pupil point along i and j, in microlenses.
    pub pupil: [f32; 2],
    /// Microlenses along i and j per pupil cell along `right` and `up`.
    pub lenses_per_cell: [[f32; 2]; 2],
    /// Column and row of the micro-images, for microlenses relative to the window's first.
    pub column_px: [f32; 3],
    pub row_px: [f32; 3],
    pub axes: [AxisAddresses; 2],
}

/// Parameters common to all blocks of a view along one axis.
#[derive(Debug, Clone, Copy)]
pub(super) struct AxisAddresses {
    pub layout: TableLayout,
    /// The microlens on the optical axis.
    pub on_axis: f32,
    /// Microlenses of the window.
    pub lenses: f32,
    /// Ratio of a distance in the plane in focus to that in its image.
    pub object_per_place: f32,
    /// Classes of ray slope per microlens.
    pub slopes: f32,
}

impl BlockPlaces {
    pub fn push(&mut self, projected: &ProjectedPoint, layouts: [&TableLayout; 2]) {
        for (n, (axis, layout)) in self.axes.iter_mut().zip(layouts).enumerate() {
            axis.place.push(projected.place[n] as f32);
            axis.parallax.push(projected.parallax[n] as f32);
            axis.depth.push(layout.depth_index(projected.depth_mm[n]) as u32);
        }
    }

    pub fn append(&mut self, more: &mut Self) {
        for (axis, more) in self.axes.iter_mut().zip(&mut more.axes) {
            axis.place.append(&mut more.place);
            axis.parallax.append(&mut more.parallax);
            axis.depth.append(&mut more.depth);
        }
    }

    pub fn retain(&mut self, keep: &[bool]) {
        for axis in &mut self.axes {
            crate::model::retain(&mut axis.place, keep);
            crate::model::retain(&mut axis.parallax, keep);
            crate::model::retain(&mut axis.depth, keep);
        }
    }
}

/// A batch of values starting with index `start`, padded with zeros.
#[inline(always)]
fn batch<T: Copy + Default>(values: &[T], start: usize) -> [T; BATCH] {
    match values.get(start..).and_then(<[T]>::first_chunk) {
        Some(batch) => *batch,
        None => last_batch(values, start),
    }
}

#[cold]
#[inline(never)]
fn last_batch<T: Copy + Default>(values: &[T], start: usize) -> [T; BATCH] {
    std::array::from_fn(|n| values.get(start + n).copied().unwrap_or_default())
}

/// Offset of a micro-image's centre from the centre of its pixel, to the right and upwards, in
/// pixels. Halfway between two pixels it is rounded as in decoding.
#[inline(always)]
pub(super) fn phase_px(column: f32, row: f32) -> [f32; 2] {
    const HALF: f32 = 0.5 + TIE_PX as f32;
    [column - (column + HALF).floor(), (row + HALF).floor() - row]
}

/// The addresses of up to [`BATCH`] blocks starting with block `start`. Written as separate loops
/// without closures, so that they become vector instructions.
#[inline(always)]
pub(super) fn addresses(places: &BlockPlaces, start: usize, view: &ViewAddresses) -> Addresses {
    let mut found = Addresses::NONE;
    let mut place = [[0.0f32; BATCH]; 2];
    let mut parallax = [[0.0f32; BATCH]; 2];
    let mut depth = [[0u32; BATCH]; 2];
    let mut lens = [[0.0f32; BATCH]; 2];
    let mut beside = [[0.0f32; BATCH]; 2];
    for n in 0..2 {
        let axis = &places.axes[n];
        place[n] = batch(&axis.place, start);
        parallax[n] = batch(&axis.parallax, start);
        depth[n] = batch(&axis.depth, start);
        let (least, most) = (-BEYOND, view.axes[n].lenses + BEYOND);
        for b in 0..BATCH {
            let nominal = place[n][b] + parallax[n][b] * view.pupil[n];
            let nominal = if nominal > least { nominal } else { least };
            let nominal = if nominal < most { nominal } else { most };
            let rounded = nominal + INTEGERS;
            found.lens[n][b] = rounded.to_bits().wrapping_sub(INTEGERS.to_bits()) as i32;
            lens[n][b] = rounded - INTEGERS;
            beside[n][b] = nominal - lens[n][b];
        }
    }
    let mut phase = [[0.0f32; BATCH]; 2];
    let [a0, a1, a2] = view.column_px;
    let [b0, b1, b2] = view.row_px;
    for b in 0..BATCH {
        let (i, j) = (lens[0][b], lens[1][b]);
        [phase[0][b], phase[1][b]] = phase_px(a0 + a1 * i + a2 * j, b0 + b1 * i + b2 * j);
    }
    for n in 0..2 {
        let AxisAddresses { layout, on_axis, slopes, object_per_place, .. } = view.axes[n];
        let [by_right, by_up] = view.lenses_per_cell[n];
        for b in 0..BATCH {
            let own = parallax[n][b] * (by_right * phase[0][b] + by_up * phase[1][b]);
            let node = (beside[n][b] + own - layout.first_place) * layout.places_per_lens;
            let class = (phase[n][b] + 0.5) * PHASE_CLASSES as f32 - 0.5;
            // U minus the ξ of an in-focus point at this position: accurate enough for a width.
            let across = (place[n][b] - on_axis) * object_per_place;
            let slope = (view.pupil[n] + across).abs() * slopes;
            found.tap[n][b] = depth[n][b]
                + index(slope, SLOPE_CLASSES) * layout.taps_per_slope() as u32
                + index(class, PHASE_CLASSES) * layout.places as u32
                + index(node, layout.places);
        }
    }
    found
}

/// The nearest of `count` classes.
#[inline(always)]
fn index(number: f32, count: usize) -> u32 {
    let last = (count - 1) as f32;
    let number = if number > 0.0 { number } else { 0.0 };
    whole(nearest(if number < last { number } else { last })) as u32
}
