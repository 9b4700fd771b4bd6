//! Phase of each microlens: the offset of its pixel from the ideal position, because pixels are not aligned
//! with all microlenses.

use super::{
    places::{ViewAddresses, phase_px},
    tile_place::LENSES,
};
use crate::lightfield::MicrolensWindow;

/// Microlenses around the window that also have phases. Beyond them there are no pixels.
const MARGIN: i32 = LENSES as i32 + 1;

/// The phase of every microlens of a window, in microlenses along i and j for a parallax of 1. It
/// is the same in all views, because their pixels are whole numbers apart.
pub(super) struct LensPhases {
    /// Microlenses per row, including the margin.
    width: usize,
    rows: i32,
    phases: [Vec<f32>; 2],
    /// See [`Self::steps`].
    steps: Vec<[[f32; 2]; 2]>,
    /// See [`Self::range`].
    ranges: Vec<[[f32; 2]; 2]>,
}

impl LensPhases {
    /// `view` is any of the camera's.
    pub fn new(view: &ViewAddresses, window: &MicrolensWindow) -> Self {
        let [columns, rows] = [window.columns.len(), window.rows.len()].map(|n| n as i32);
        let mut phases = [Vec::new(), Vec::new()];
        for j in -MARGIN..rows + MARGIN {
            for i in -MARGIN..columns + 2 * MARGIN {
                let (i, j) = (i as f32, j as f32);
                let [column, row] =
                    [view.column_px, view.row_px].map(|[a, b, c]| a + b * i + c * j);
                let [right, up] = phase_px(column, row);
                for (phases, [by_right, by_up]) in phases.iter_mut().zip(view.lenses_per_cell) {
                    phases.push(by_right * right + by_up * up);
                }
            }
        }
        Self::of(phases, (columns + 3 * MARGIN) as usize, rows)
    }

    /// Of `phases` along i and j, with `width` per row, for a window of `rows`.
    fn of(phases: [Vec<f32>; 2], width: usize, rows: i32) -> Self {
        let steps = steps(&phases, width);
        let [along, across] = phases.each_ref().map(|phases| {
            phases.chunks_exact(width).map(|row| extent(row.iter().copied())).collect::<Vec<_>>()
        });
        let ranges = along.into_iter().zip(across).map(|(along, across)| [along, across]).collect();
        Self { width, rows, phases, steps, ranges }
    }

    /// The smallest and largest increase of the phase along i from a microlens of row `j` to the
    /// next, and along j from the previous row.
    #[inline(always)]
    pub fn steps(&self, j: i32) -> [[f32; 2]; 2] {
        self.steps[self.line(j)]
    }

    /// The smallest and largest phase along i and along j in row `j`.
    #[inline(always)]
    pub fn range(&self, j: i32) -> [[f32; 2]; 2] {
        self.ranges[self.line(j)]
    }

    #[inline(always)]
    fn line(&self, j: i32) -> usize {
        (j.clamp(-MARGIN, self.rows + MARGIN - 1) + MARGIN) as usize
    }

    /// The phases along i and j of the microlenses of row `j`, from microlens `first`. Far outside the window
    /// they are those of other microlenses.
    #[inline(always)]
    pub fn row(&self, j: i32, first: i32) -> [&[f32; LENSES]; 2] {
        let line = self.line(j);
        let last = self.width - LENSES;
        let start = line * self.width + (first.max(-MARGIN) + MARGIN).min(last as i32) as usize;
        const NONE: &[f32; LENSES] = &[0.0; LENSES];
        [0, 1].map(|n| {
            let phases = self.phases[n].get(start..).and_then(|phases| phases.first_chunk());
            phases.unwrap_or(NONE)
        })
    }
}

/// The smallest and the largest of some numbers.
fn extent(numbers: impl Iterator<Item = f32>) -> [f32; 2] {
    let none = [f32::INFINITY, f32::NEG_INFINITY];
    numbers.fold(none, |[least, most], number| [least.min(number), most.max(number)])
}

fn steps([along, across]: &[Vec<f32>; 2], width: usize) -> Vec<[[f32; 2]; 2]> {
    let rows = along.chunks_exact(width).zip(across.chunks_exact(width));
    let before = across[..width].iter().chain(across).copied().collect::<Vec<f32>>();
    rows.zip(before.chunks_exact(width))
        .map(|((along, across), before)| {
            let next = along.windows(2).map(|pair| pair[1] - pair[0]);
            let from_before = across.iter().zip(before).map(|(here, before)| here - before);
            [extent(next), extent(from_before)]
        })
        .collect()
}

#[cfg(test)]
impl LensPhases {
    /// For a window of `columns` and `rows`, from the phases of microlens (i, j).
    pub fn with(columns: i32, rows: i32, phase: impl Fn(i32, i32) -> [f32; 2]) -> Self {
        let lenses = (-MARGIN..rows + MARGIN)
            .flat_map(|j| (-MARGIN..columns + 2 * MARGIN).map(move |i| (i, j)));
        let phases: Vec<[f32; 2]> = lenses.map(|(i, j)| phase(i, j)).collect();
        let along = |n: usize| phases.iter().map(|phase| phase[n]).collect();
        Self::of([along(0), along(1)], (columns + 3 * MARGIN) as usize, rows)
    }
}
