//! Projection of blocks for cameras along the grid's axes.

use std::ops::Range;

use super::{
    BlockLight, BlockProjector,
    aligned_tables::{AlignedModel, Place, ViewTables},
    child_order::ChildOrder,
    kernels::{PlacedTap, TapSource, gather_blocks, project_blocks},
    pair_tap::PairTap,
    prefetch::prefetch,
};
use crate::model::ViewId;

/// An [`AlignedModel`] restricted to active blocks.
pub(super) struct AlignedProjector<'a, const L: usize, const D: usize> {
    pub(super) model: &'a AlignedModel<L, D>,
    /// Per camera, per active block.
    pub(super) places: Vec<Vec<Place>>,
}

/// One view's tables, and the blocks' positions in them.
struct AlignedTaps<'a, const L: usize> {
    tables: ViewTables<'a, L>,
    places: &'a [Place],
    child_order: ChildOrder,
}

impl<'a, const L: usize, const D: usize> TapSource<L, D, 2> for AlignedTaps<'a, L> {
    type Addresses = &'a [Place];

    fn child_order(&self) -> ChildOrder {
        self.child_order
    }

    #[inline(always)]
    fn addresses(&self, start: usize, count: usize) -> &'a [Place] {
        self.places.get(start..start + count).unwrap_or(&[])
    }

    #[inline(always)]
    fn prefetch_taps(&self, places: &&'a [Place]) {
        let tables = &self.tables;
        for place in *places {
            for layer in 0..D {
                prefetch(tables.columns, place.column as usize + layer * tables.column_pairs);
                prefetch(tables.rows, place.row as usize + layer * tables.row_pairs);
            }
        }
    }

    #[inline(always)]
    fn taps<'t>(
        &'t self,
        places: &&'a [Place],
        block: usize,
        layer: usize,
        _: &'t mut [PairTap<L>; 2],
    ) -> [PlacedTap<'t, L, 2>; 2] {
        let tables = &self.tables;
        let place = places[block];
        let column = &tables.columns[place.column as usize + layer * tables.column_pairs];
        let row = &tables.rows[place.row as usize + layer * tables.row_pairs];
        [column, row].map(|tap| PlacedTap { tap, first: usize::from(tap.first) })
    }
}

impl<const L: usize, const D: usize> AlignedProjector<'_, L, D> {
    fn taps(&self, view: ViewId) -> AlignedTaps<'_, L> {
        AlignedTaps {
            tables: self.model.view(view),
            places: &self.places[view.camera],
            child_order: ChildOrder::of(self.model.cameras[view.camera].axes),
        }
    }
}

impl<const L: usize, const D: usize> BlockProjector for AlignedProjector<'_, L, D> {
    fn project(&self, view: ViewId, light: &[BlockLight], image: &mut [f32]) {
        let taps = self.taps(view);
        image.fill(0.0);
        project_blocks::<_, L, D, 2>(&taps, taps.tables.width, light, image);
        cover(taps.tables.coverage, image);
    }

    fn prepare(&self, view: ViewId, image: &mut [f32]) {
        cover(self.model.view(view).coverage, image);
    }

    fn back_project(
        &self,
        view: ViewId,
        image: &[f32],
        range: Range<usize>,
        out: &mut [BlockLight],
    ) {
        let taps = self.taps(view);
        gather_blocks::<_, L, D, 2>(&taps, taps.tables.width, range.start, image, out);
    }

    fn retain(&mut self, keep: &[bool]) {
        for places in &mut self.places {
            crate::model::retain(places, keep);
        }
    }
}

/// Weights pixels by the open share of their pupil cells.
pub(super) fn cover(coverage: Option<&[f32]>, image: &mut [f32]) {
    for (pixel, &open) in image.iter_mut().zip(coverage.unwrap_or(&[])) {
        *pixel *= open;
    }
}
