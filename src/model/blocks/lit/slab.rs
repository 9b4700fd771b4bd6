//! The verdict of all views of a camera on the voxels at one depth.

use multiversion::multiversion;

use super::{
    LitImages,
    maps::{ColumnMap, RowMap, column_map, row_map},
};
use crate::{
    lightfield::ViewLayout,
    model::blocks::{
        aligned::AlignedCamera,
        dark_counts::{DarkCounts, LINE_VOXELS, Line},
    },
};

/// The voxels at one tabulated depth of a camera, in a strip of [`LINE_VOXELS`] columns.
pub(super) struct Slab<'a, const L: usize> {
    pub camera: &'a AlignedCamera<L>,
    pub layout: &'a ViewLayout,
    pub images: &'a LitImages,
    pub depth: usize,
    pub first_column: usize,
    /// Voxels of the grid along the columns and across the rows.
    pub columns: usize,
    pub rows: usize,
}

impl<const L: usize> Slab<'_, L> {
    /// The lines of possible and of seen voxels.
    pub fn judge(&self, forgiven: usize) -> [Vec<Line>; 2] {
        let end = self.columns.min(self.first_column + LINE_VOXELS);
        let lenses = self.layout.window.columns.len();
        let reach = self.layout.columns.reach;
        let column_maps: Vec<ColumnMap> = (-reach..=reach)
            .map(|k| {
                column_map(&self.camera.columns, (k, self.depth), self.first_column..end, lenses)
            })
            .collect();
        let reach = self.layout.rows.reach;
        let row_maps: Vec<RowMap> = (-reach..=reach)
            .map(|l| row_map(&self.camera.rows, (l, self.depth), self.rows))
            .collect();
        let mut dark = DarkCounts::new(self.rows, forgiven);
        let mut seen = vec![Line::default(); self.rows];
        let mut lit_rows = vec![Line::default(); self.images.rows];
        for (n, view) in self.layout.views.iter().enumerate() {
            let columns = &column_maps[(view.k + self.layout.columns.reach) as usize];
            let rows = &row_maps[(view.l + self.layout.rows.reach) as usize];
            for row in rows.reached.clone() {
                lit_rows[row] = columns.light(self.images.row(n, row));
            }
            for support in &rows.supports {
                let seen = &mut seen[support.voxel];
                (0..seen.len()).for_each(|word| seen[word] |= columns.judged[word]);
            }
            count_dark(&lit_rows, &columns.judged, rows, &mut dark);
        }
        let mut possible = dark.within();
        let inside = line_of(end - self.first_column);
        for line in &mut possible {
            (0..line.len()).for_each(|word| line[word] &= inside[word]);
        }
        [possible, seen]
    }
}

/// A line whose first voxels are set.
fn line_of(voxels: usize) -> Line {
    std::array::from_fn(|word| match voxels.saturating_sub(64 * word) {
        rest @ ..64 => (1 << rest) - 1,
        _ => u64::MAX,
    })
}

/// Counts the judged voxels that find no lit row in their support.
#[multiversion(targets("x86_64+avx512f+avx512vl", "x86_64+avx2"))]
fn count_dark(lit_rows: &[Line], judged: &Line, rows: &RowMap, dark: &mut DarkCounts) {
    for support in &rows.supports {
        let mut line = *judged;
        for lit in &lit_rows[support.start..support.end] {
            for word in 0..line.len() {
                line[word] &= !lit[word];
            }
        }
        dark.count(support.voxel, line);
    }
}
