//! The result of all views of a camera for the voxels at one depth.
//!
//! Views with the same index along the rows have the same rows in every voxel's support. They are
//! processed together: their lit rows are adjacent, and a line of voxels is loaded, counted for all
//! of them and stored once.

use std::ops::Range;

use multiversion::multiversion;

use super::{
    LitImages,
    maps::{ColumnMap, RowSupport, column_map, row_supports},
};
use crate::{
    lightfield::{View, ViewLayout},
    model::blocks::{
        aligned_tables::AlignedCamera,
        dark_counts::{DarkCounts, Line},
    },
};

/// The voxels at one tabulated depth of a camera, in a strip of one line's columns.
pub(super) struct Slab<'a, const L: usize> {
    pub camera: &'a AlignedCamera<L>,
    pub layout: &'a ViewLayout,
    pub images: &'a LitImages<'a>,
    pub depth: usize,
    pub first_column: usize,
    /// Number of grid voxels along the columns and along the rows.
    pub columns: usize,
    pub rows: usize,
}

impl<const L: usize> Slab<'_, L> {
    /// The lines of possibly lit and of visible voxels, in words of 64.
    pub fn evaluate<const W: usize>(&self, tolerated: usize) -> [Vec<Line<W>>; 2] {
        let columns = self.column_maps();
        let inside = line_of(self.columns - self.first_column);
        let mut dark = DarkCounts::new(self.rows, inside, tolerated);
        let mut visible = vec![[0; W]; self.rows];
        let mut first_view = 0;
        let mut group = ViewGroup::default();
        for views in self.layout.views.chunk_by(|a, b| a.l == b.l) {
            let mut supports = row_supports(&self.camera.rows, (views[0].l, self.depth), self.rows);
            let any = union(views.iter().map(|view| &columns[self.column_map_of(view)].evaluated));
            for support in &supports {
                let visible = &mut visible[support.voxel];
                *visible = union([&*visible, &any].into_iter());
            }
            supports.retain(|support| dark.is_open(support.voxel));
            let images = self.images.of_views(first_view..first_view + views.len());
            group.light(self, &columns, images, &supports);
            count_dark(&mut group, &supports, &mut dark);
            first_view += views.len();
        }
        [dark.within(), visible]
    }

    /// The maps of all view indices along the columns.
    fn column_maps<const W: usize>(&self) -> Vec<ColumnMap<W>> {
        let strip = self.first_column..self.columns.min(self.first_column + 64 * W);
        let lenses = self.layout.window.columns.len();
        let reach = self.layout.columns.reach;
        let map = |k| column_map(&self.camera.columns, (k, self.depth), strip.clone(), lenses);
        (-reach..=reach).map(map).collect()
    }

    fn column_map_of(&self, view: &View) -> usize {
        (view.k + self.layout.columns.reach) as usize
    }
}

/// The selected views of one index along the rows.
#[derive(Default)]
struct ViewGroup<const W: usize> {
    /// Per view, the voxels with sufficient light in it.
    evaluated: Vec<Line<W>>,
    /// First row of microlenses in `lit`.
    first_row: usize,
    /// Per row of microlenses and view: the voxels that the row's lit pixels may come from.
    lit: Vec<Line<W>>,
    /// Per view, the voxels that are dark in it. Scratch memory.
    dark: Vec<Line<W>>,
}

impl<const W: usize> ViewGroup<W> {
    /// Maps the rows of all supports in these images onto the voxels.
    fn light<const L: usize>(
        &mut self,
        slab: &Slab<'_, L>,
        columns: &[ColumnMap<W>],
        images: Range<usize>,
        supports: &[RowSupport],
    ) {
        self.first_row = supports.iter().map(|support| support.start).min().unwrap_or(0);
        let end = supports.iter().map(|support| support.end).max().unwrap_or(0);
        self.evaluated.clear();
        self.lit.clear();
        self.lit.resize((end - self.first_row) * images.len(), [0; W]);
        // View by view, because one view's map fits into the L1 cache.
        for (n, image) in images.clone().enumerate() {
            let view = &slab.layout.views[slab.images.views[image]];
            let columns = &columns[slab.column_map_of(view)];
            self.evaluated.push(columns.evaluated);
            let of_view = self.lit.iter_mut().skip(n).step_by(images.len());
            for (row, lit) in (self.first_row..end).zip(of_view) {
                *lit = columns.light(slab.images.row(image, row));
            }
        }
        self.dark.resize(images.len(), [0; W]);
    }
}

fn union<'a, const W: usize>(lines: impl Iterator<Item = &'a Line<W>>) -> Line<W> {
    lines.fold([0; W], |union, line| std::array::from_fn(|word| union[word] | line[word]))
}

/// A line with its first voxels set.
fn line_of<const W: usize>(voxels: usize) -> Line<W> {
    std::array::from_fn(|word| match voxels.saturating_sub(64 * word) {
        rest @ ..64 => (1 << rest) - 1,
        _ => u64::MAX,
    })
}

/// Counts the voxels without a lit row in their support, if they have sufficient light in the view.
#[multiversion(targets("x86_64+avx512f+avx512vl", "x86_64+avx2"))]
fn count_dark<const W: usize>(
    group: &mut ViewGroup<W>,
    supports: &[RowSupport],
    counts: &mut DarkCounts<W>,
) {
    let ViewGroup { evaluated, first_row, lit, dark } = group;
    let views = evaluated.len();
    for support in supports {
        dark.copy_from_slice(evaluated);
        for row in support.start..support.end {
            let lit = &lit[(row - *first_row) * views..][..views];
            for view in 0..views {
                for word in 0..W {
                    dark[view][word] &= !lit[view][word];
                }
            }
        }
        counts.count(support.voxel, dark);
    }
}
