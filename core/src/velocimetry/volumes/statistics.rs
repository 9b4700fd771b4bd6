//! Peak statistics of all windows at once, by sums that overlapping windows share.
//!
//! What a cell adds to a window's asymmetry is A − m Y: its own asymmetry A and symmetric part Y, and
//! the window's m = ΣA/ΣY (see [`PeakStatistics`]). Sums over blocks of cells and their squares then
//! come from ΣA, ΣY, ΣA², ΣAY and ΣY², in which m does not occur: they are summed once, whatever the
//! overlap.

use super::{
    cells::{
        BLOCK, CELL, COMMON, COMMON_SQUARES, Cells, ENERGY, MIXED, SQUARES, SUMS, SYMMETRIC,
        SYMMETRIC_SQUARES,
    },
    light::CellLight,
    profile::{Profile, Span},
};
use crate::velocimetry::{
    uncertainty::{Influence, MOST_PARTICLES, PeakStatistics, coefficient},
    windows::Windows,
};

/// Statistics of every window's peak at zero lag; `None` where there is no peak, and in volumes that are too
/// thin. Both frames have zero mean, the same cells, and a border. A single layer has no variance across it.
pub fn statistics_at_zero_lag(
    frames: [&CellLight; 2],
    windows: &Windows,
    profile: &Profile,
) -> Vec<Option<PeakStatistics>> {
    if profile.is_flat() {
        // Cells of two layers, of which the windows have half. Blocks beyond the layer have the same squares.
        let [a, b] = frames.map(CellLight::doubled_layer);
        return of_windows([&a, &b], windows, profile, BLOCK as f64);
    }
    of_windows(frames, windows, profile, 1.0)
}

/// The statistics, where blocks that are centred on the cells are every one in `blocks` that hold them.
fn of_windows(
    frames: [&CellLight; 2],
    windows: &Windows,
    profile: &Profile,
    blocks: f64,
) -> Vec<Option<PeakStatistics>> {
    if frames[0].cells.iter().any(|&n| n < CELL) {
        return vec![None; windows.nodes.iter().product()];
    }
    let products = Cells::products(frames);
    let spans = spans_in_cells(&profile.spans(windows), products.counts);
    let squared = spans.each_ref().map(|of_axis| of_axis.iter().map(Span::squared).collect());
    let sums = products.rows().box_sums(&spans);
    let squares = products.squares().rows().box_sums(&squared);
    let chance = share_of_a_block(profile);
    let windows = sums.as_chunks().0.iter().zip(squares.as_chunks().0);
    windows.map(|(sums, squares)| of_window(sums, squares, chance, blocks)).collect()
}

/// The formulas of [`PeakStatistics::of`], for a window of which a share `chance` is taken for one
/// particle by chance.
fn of_window(
    sums: &[f32; SUMS],
    squares: &[f32; SQUARES],
    chance: f64,
    blocks: f64,
) -> Option<PeakStatistics> {
    let (sums, squares) = (sums.map(f64::from), squares.map(f64::from));
    let common = sums[COMMON];
    let mut variance_vox2 = [0.0; 3];
    for (axis, variance) in variance_vox2.iter_mut().enumerate() {
        let Influence { mean, scale } =
            Influence::along(sums[axis], sums[SYMMETRIC + axis], common, 1.0)?;
        let [aa, ay, yy] = [0, MIXED, SYMMETRIC_SQUARES].map(|first| squares[first + axis]);
        let spread = (aa - 2.0 * mean * ay + mean * mean * yy).max(0.0) * scale * scale;
        *variance = (blocks * spread / (1.0 - chance).max(0.1)) as f32;
    }
    let clustered = squares[COMMON_SQUARES].max(squares[COMMON_SQUARES + 1]);
    // Of n equal particles each has its share, and shares a block with others by chance.
    let of_one = (clustered / (common * common) - chance) / (1.0 - chance).max(0.1);
    Some(PeakStatistics {
        variance_vox2,
        particles: 1.0 / (of_one as f32).max(1.0 / MOST_PARTICLES),
        coefficient: coefficient(common, [sums[ENERGY], sums[ENERGY + 1]]),
    })
}

/// The mean share of a window that lies in a block with one of its cells.
fn share_of_a_block(profile: &Profile) -> f64 {
    let share = |axis: usize| {
        let weights = profile.weights(axis);
        let squares: f32 = weights.iter().map(|weight| weight * weight).sum();
        let along = (BLOCK * CELL) as f32 * squares / weights.iter().sum::<f32>().powi(2);
        f64::from(along.min(1.0))
    };
    (0..3).map(share).product()
}

/// Windows along every axis, in cells: a cell that is half inside has half the weight.
fn spans_in_cells(spans: &[Vec<Span>; 3], counts: [usize; 3]) -> [Vec<Span>; 3] {
    std::array::from_fn(|axis| {
        let in_cells = |span: &Span| {
            let end = (span.first + span.weights.len()).div_ceil(CELL).min(counts[axis]);
            let first = (span.first / CELL).min(end);
            let weight = |cell: usize| {
                let parts = cell * CELL..(cell + 1) * CELL;
                let inside = parts.filter_map(|at| span.weights.get(at.checked_sub(span.first)?));
                inside.sum::<f32>() / CELL as f32
            };
            Span { first, weights: (first..end).map(weight).collect() }
        };
        spans[axis].iter().map(in_cells).collect()
    })
}
