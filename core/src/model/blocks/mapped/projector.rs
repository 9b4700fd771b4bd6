//! Projection of blocks for arbitrarily oriented cameras.

use std::ops::Range;

use rayon::prelude::*;

use super::{
    CameraTables, MappedCamera, MappedModel,
    arrangement::Layers,
    places::{Addresses, BlockPlaces, ViewAddresses, addresses},
    share_table::{FIRST_BIAS, ShareTable},
};
use crate::model::{
    ViewId,
    blocks::{
        BlockLight, BlockProjector,
        child_order::ChildOrder,
        kernels::{PlacedTap, TapSource, gather_blocks, project_blocks},
        pair_tap::PairTap,
        prefetch::prefetch,
        projector::cover,
    },
};

/// Blocks per parallel task when computing positions.
const BLOCKS_PER_TASK: usize = 4096;

/// A [`MappedModel`] restricted to active blocks.
pub(super) struct MappedProjector<'a, const L: usize> {
    model: &'a MappedModel<L>,
    /// Per camera, per layer of the blocks.
    places: Vec<Vec<BlockPlaces>>,
}

/// One view's tables, and the blocks' positions in them.
struct MappedTaps<'a, const L: usize, const C: usize> {
    tables: &'a [ShareTable<L, C>; 2],
    child_order: ChildOrder,
    view: ViewAddresses,
    layers: &'a [BlockPlaces],
    lenses: [i32; 2],
    /// Number of places along columns and rows at which a tap is inside the window.
    fitting: [u32; 2],
}

/// `D` is the number of layers of the camera's blocks.
impl<const L: usize, const D: usize, const C: usize> TapSource<L, D, C> for MappedTaps<'_, L, C> {
    type Addresses = ([Addresses; D], usize);

    fn child_order(&self) -> ChildOrder {
        self.child_order
    }

    #[inline(always)]
    fn addresses(&self, start: usize, count: usize) -> Self::Addresses {
        // A closure would not be compiled with the target features of the kernels.
        let mut found = [Addresses::NONE; D];
        for (found, places) in found.iter_mut().zip(self.layers) {
            *found = addresses(places, start, &self.view);
        }
        (found, count)
    }

    #[inline(always)]
    fn prefetch_taps(&self, (layers, count): &Self::Addresses) {
        for addresses in layers {
            for (table, taps) in self.tables.iter().zip(&addresses.tap) {
                for &at in &taps[..*count] {
                    prefetch(&table.taps, at as usize);
                }
            }
        }
    }

    #[inline(always)]
    fn taps<'t>(
        &'t self,
        (layers, _): &Self::Addresses,
        block: usize,
        layer: usize,
        [columns, rows]: &'t mut [PairTap<L, C>; 2],
    ) -> [PlacedTap<'t, L, C>; 2] {
        let addresses = &layers[layer];
        [self.placed(addresses, 0, block, columns), self.placed(addresses, 1, block, rows)]
    }
}

impl<const L: usize, const C: usize> MappedTaps<'_, L, C> {
    /// The tap of block `b` along axis `n`, relative to the window's first microlens.
    #[inline(always)]
    fn placed<'a>(
        &'a self,
        addresses: &Addresses,
        n: usize,
        b: usize,
        scratch: &'a mut PairTap<L, C>,
    ) -> PlacedTap<'a, L, C> {
        let tap = self.tables[n].tap(addresses.tap[n][b] as usize);
        let first = addresses.lens[n][b] + i32::from(tap.first) - FIRST_BIAS;
        // Negative numbers become large unsigned ones.
        if first as u32 >= self.fitting[n] {
            *scratch = clipped(tap, first, self.lenses[n]);
            return PlacedTap { tap: scratch, first: usize::from(scratch.first) };
        }
        PlacedTap { tap, first: first as usize }
    }
}

/// The part inside the window of a tap that extends beyond it.
#[cold]
fn clipped<const L: usize, const C: usize>(
    tap: &PairTap<L, C>,
    first: i32,
    lenses: i32,
) -> PairTap<L, C> {
    let kept = first.clamp(0, (lenses - L as i32).max(0));
    let mut clipped = PairTap { first: kept as u16, ..PairTap::NONE };
    for n in 0..L {
        let from = usize::try_from(kept + n as i32 - first).ok().filter(|&from| from < L);
        let Some(from) = from.filter(|_| kept + (n as i32) < lenses) else { continue };
        for (to, shares) in clipped.shares.iter_mut().zip(&tap.shares) {
            to[n] = shares[from];
        }
        if clipped.shares.iter().any(|shares| shares[n] > 0) {
            clipped.len = n as u16 + 1;
        }
    }
    clipped
}

impl<'a, const L: usize> MappedProjector<'a, L> {
    pub fn new(model: &'a MappedModel<L>, blocks: &[u32]) -> Self {
        let places = |camera: &MappedCamera<L>| {
            let parts: Vec<Vec<BlockPlaces>> = blocks
                .par_chunks(BLOCKS_PER_TASK)
                .map(|blocks| model.places(camera, blocks))
                .collect();
            let mut all = vec![BlockPlaces::default(); camera.layers.count()];
            for mut part in parts {
                for (all, part) in all.iter_mut().zip(&mut part) {
                    all.append(part);
                }
            }
            all
        };
        Self { model, places: model.cameras.iter().map(places).collect() }
    }

    /// The taps of view `id` from its camera's `tables`.
    fn taps<'t, const C: usize>(
        &'t self,
        id: ViewId,
        tables: &'t [ShareTable<L, C>; 2],
    ) -> MappedTaps<'t, L, C> {
        let camera = &self.model.cameras[id.camera];
        let window = &camera.optics.window;
        let lenses = [window.columns.len() as i32, window.rows.len() as i32];
        MappedTaps {
            tables,
            child_order: ChildOrder::of(camera.axes),
            view: camera.view(&self.model.layouts[id.camera].views[id.view]),
            layers: &self.places[id.camera],
            lenses,
            fitting: lenses.map(|lenses| (lenses - L as i32 + 1).max(0) as u32),
        }
    }

    fn coverage(&self, id: ViewId) -> Option<&[f32]> {
        self.model.layouts[id.camera].views[id.view].coverage.as_deref()
    }
}

/// The kernel for pairs of voxels.
macro_rules! kernel_of_pairs {
    ($kernel:ident, $camera:expr) => {
        match $camera.layers {
            Layers::One => $kernel::<_, L, 1, 2>,
            Layers::Two => $kernel::<_, L, 2, 2>,
            Layers::Eight => $kernel::<_, L, 8, 2>,
        }
    };
}

impl<const L: usize> BlockProjector for MappedProjector<'_, L> {
    fn project(&self, view: ViewId, light: &[BlockLight], image: &mut [f32]) {
        let camera = &self.model.cameras[view.camera];
        let width = camera.optics.window.columns.len();
        image.fill(0.0);
        match &camera.tables {
            CameraTables::Pairs(tables) => {
                let project = kernel_of_pairs!(project_blocks, camera);
                project(&self.taps(view, tables), width, light, image);
            }
            CameraTables::Quads(tables) => {
                project_blocks::<_, L, 1, 4>(&self.taps(view, tables), width, light, image);
            }
        }
        cover(self.coverage(view), image);
    }

    fn prepare(&self, view: ViewId, image: &mut [f32]) {
        cover(self.coverage(view), image);
    }

    fn back_project(
        &self,
        view: ViewId,
        image: &[f32],
        range: Range<usize>,
        out: &mut [BlockLight],
    ) {
        let camera = &self.model.cameras[view.camera];
        let width = camera.optics.window.columns.len();
        match &camera.tables {
            CameraTables::Pairs(tables) => {
                let gather = kernel_of_pairs!(gather_blocks, camera);
                gather(&self.taps(view, tables), width, range.start, image, out);
            }
            CameraTables::Quads(tables) => {
                let taps = self.taps(view, tables);
                gather_blocks::<_, L, 1, 4>(&taps, width, range.start, image, out);
            }
        }
    }

    fn retain(&mut self, keep: &[bool]) {
        for places in self.places.iter_mut().flatten() {
            places.retain(keep);
        }
    }
}
