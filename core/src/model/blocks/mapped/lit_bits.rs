//! The lit pixels of a camera's views, as bits.

use rayon::prelude::*;

use crate::{
    lightfield::{ViewLayout, ViewStack},
    model::HullCriteria,
};

/// Bits per word, and number of microlenses beside the window that have bits.
const WORD: i32 = 64;

/// One bit per microlens, for each selected view and row of microlenses: whether the pixel is lit.
/// Pixels without evidence of darkness, including those outside the window, count as lit.
pub(super) struct LitBits {
    rows: usize,
    words: usize,
    bits: Vec<u64>,
}

impl LitBits {
    pub fn new(
        layout: &ViewLayout,
        stack: &ViewStack,
        criteria: &HullCriteria,
        camera: usize,
    ) -> Self {
        let dark_below = criteria.dark_below[camera];
        let (width, rows) = (layout.window.columns.len(), layout.window.rows.len());
        // One word before the window, and more than one after it.
        let words = width.div_ceil(WORD as usize) + 3;
        let of_view = |&view: &usize| {
            let mut bits = vec![u64::MAX; rows * words];
            let coverage = layout.views[view].coverage.as_ref();
            for (row, line) in stack.view(view).chunks_exact(width).enumerate() {
                let bits = &mut bits[row * words..][..words];
                for (i, &value) in line.iter().enumerate() {
                    let open = coverage.map_or(1.0, |coverage| coverage[row * width + i]);
                    // A pixel less than half open is no evidence of darkness.
                    let dark = open > 0.5 && value < dark_below * open;
                    bits[i / 64 + 1] &= !(u64::from(dark) << (i % 64));
                }
            }
            bits
        };
        let bits: Vec<Vec<u64>> = criteria.selected[camera].par_iter().map(of_view).collect();
        Self { rows, words, bits: bits.concat() }
    }

    /// The bits of the microlenses from `first` on, in row `row` of selected view `image`.
    #[inline(always)]
    pub fn row(&self, image: usize, row: i32, first: i32) -> u64 {
        let at = first + WORD;
        let last = (self.words as i32 - 1) * WORD;
        if row < 0 || row >= self.rows as i32 || at < 0 || at >= last {
            return u64::MAX;
        }
        let start = (image * self.rows + row as usize) * self.words + (at / WORD) as usize;
        let (low, high) = (self.bits[start], self.bits[start + 1]);
        let shift = at % WORD;
        if shift == 0 { low } else { low >> shift | high << (WORD - shift) }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{
        lightfield::{MicrolensWindow, View},
        test_bench,
    };

    #[test]
    fn bits_are_those_of_the_pixels_and_set_beyond_them() {
        let optics = test_bench::optics();
        let window = MicrolensWindow { columns: 10..87, rows: 5..8 };
        let mut layout = ViewLayout::new(&optics, window);
        layout.views = vec![View { k: 0, l: 0, coverage: None }];
        let lit = |n: usize| n * n % 7 < 3;
        let values = (0..77 * 3).map(|n| if lit(n) { 10.0 } else { 0.0 }).collect();
        let criteria = HullCriteria {
            selected: vec![vec![0]],
            dark_below: vec![5.0],
            tolerated: vec![0],
            displacement: vec![0.0],
        };
        let bits = LitBits::new(&layout, &ViewStack::new(77 * 3, values), &criteria, 0);
        for (row, first) in (-1..4).flat_map(|row| (-80..160).map(move |first| (row, first))) {
            let found = bits.row(0, row, first);
            for n in 0..64 {
                let i = first + n;
                let inside = (0..77).contains(&i) && (0..3).contains(&row);
                let expected = !inside || lit((row * 77 + i) as usize);
                assert_eq!(found >> n & 1 == 1, expected, "row {row}, microlens {i}");
            }
        }
    }
}
