//! How far each microlens lies from its place for one of its pixels, because pixels do not lie alike
//! behind all of them.

use super::{places::ViewAddresses, tile::LENSES};
use crate::lightfield::{MicrolensWindow, TIE_PX};

/// Microlenses on all sides of the window that have phases, too. Beyond them there are no pixels.
const MARGIN: i32 = LENSES as i32 + 1;

/// The phase of the pixel that every microlens of a window gives to a view, in microlenses along i and
/// along j for a parallax of 1. It is the same in all views: pixels are whole numbers apart.
pub(super) struct LensPhases {
    /// Microlenses in a row, with the margin.
    width: usize,
    rows: i32,
    phases: [Vec<f32>; 2],
    /// See [`Self::steps`].
    steps: Vec<[[f32; 2]; 2]>,
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
        let width = (columns + 3 * MARGIN) as usize;
        let steps = steps(&phases, width);
        Self { width, rows, phases, steps }
    }

    /// The least and the most by which the phase along i grows from a microlens of row `j` to the next, and
    /// that along j from the row before.
    #[inline(always)]
    pub fn steps(&self, j: i32) -> [[f32; 2]; 2] {
        self.steps[self.line(j)]
    }

    #[inline(always)]
    fn line(&self, j: i32) -> usize {
        (j.clamp(-MARGIN, self.rows + MARGIN - 1) + MARGIN) as usize
    }

    /// The phases along i and along j of the microlenses of row `j` from number `first` on; far beyond
    /// the window those of others.
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

fn steps([along, across]: &[Vec<f32>; 2], width: usize) -> Vec<[[f32; 2]; 2]> {
    let range = |steps: &mut dyn Iterator<Item = f32>| {
        steps.fold([0.0f32; 2], |[least, most], step| [least.min(step), most.max(step)])
    };
    let rows = along.chunks_exact(width).zip(across.chunks_exact(width));
    let before = across[..width].iter().chain(across).copied().collect::<Vec<f32>>();
    rows.zip(before.chunks_exact(width))
        .map(|((along, across), before)| {
            let next = &mut along.windows(2).map(|pair| pair[1] - pair[0]);
            let from_before = &mut across.iter().zip(before).map(|(here, before)| here - before);
            [range(next), range(from_before)]
        })
        .collect()
}

/// How far a micro-image's centre lies right of and above the middle of the pixel that it lies in, in
/// pixels. Half-way between two pixels it is on the same side as in decoding.
#[inline(always)]
pub(super) fn phase_px(column: f32, row: f32) -> [f32; 2] {
    const HALF: f32 = 0.5 + TIE_PX as f32;
    [column - (column + HALF).floor(), (row + HALF).floor() - row]
}
