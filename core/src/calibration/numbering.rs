//! Numbering of the lenses.

use lfpiv_hw::Optics;

use super::{affine_fit::renumbered, cell_light::CellLight};
use crate::lightfield::MicroImageGrid;

/// Least light of a lit lens, relative to bright lenses.
const LIT: f64 = 0.05;

/// Least share of lit lenses in a row or column of the array.
const LIT_SHARE: f64 = 0.25;

/// First and last lens along i and along j.
pub(super) type Range = [[usize; 2]; 2];

/// The range of lit columns and rows of lenses. `None` if there are none.
pub(super) fn lit_range(grid: &MicroImageGrid, light: &CellLight) -> Option<Range> {
    let [nx, ny] = grid.microlenses;
    let bright = light.bright();
    let mut counts = [vec![[0.0; 2]; nx], vec![[0.0; 2]; ny]];
    for j in 0..ny {
        for i in 0..nx {
            let Some(own) = light.on_image([i, j]) else { continue };
            let lit = if own > LIT * bright { 1.0 } else { 0.0 };
            for (axis, lens) in [i, j].into_iter().enumerate() {
                let count = &mut counts[axis][lens];
                *count = [count[0] + lit, count[1] + 1.0];
            }
        }
    }
    let range = |counts: &[[f64; 2]]| {
        let is_lit = |[lit, all]: &[f64; 2]| *lit > 0.0 && *lit >= LIT_SHARE * all;
        Some([counts.iter().position(is_lit)?, counts.iter().rposition(is_lit)?])
    };
    Some([range(&counts[0])?, range(&counts[1])?])
}

/// Renumbers the grid. Without optics, the first lit lens is (0, 0). With optics, which give the number of lenses,
/// the array is centred on the image, and shifted if it would not cover the lit lenses. Also returns the lens that
/// becomes (0, 0).
pub(super) fn number(
    grid: &MicroImageGrid,
    lit: Range,
    optics: Option<&Optics>,
    size: [usize; 2],
) -> (MicroImageGrid, [i64; 2]) {
    let lit_counts = lit.map(|[first, last]| last - first + 1);
    let Some(optics) = optics else {
        let first = lit.map(|[first, _]| first as i64);
        return (renumbered(grid, first, lit_counts), first);
    };
    let counts = [optics.microlens.columns, optics.microlens.rows];
    let middle = size.map(|pixels| (pixels as f64 - 1.0) / 2.0);
    let lens_in_middle = grid.lens_at(middle[0], middle[1]);
    let first = [0, 1].map(|axis| {
        let nominal = (lens_in_middle[axis] - (counts[axis] as f64 - 1.0) / 2.0).round() as i64;
        let [first, last] = lit[axis].map(|lens| lens as i64);
        let least = last + 1 - counts[axis] as i64;
        if least <= first { nominal.clamp(least, first) } else { nominal }
    });
    (renumbered(grid, first, counts), first)
}
