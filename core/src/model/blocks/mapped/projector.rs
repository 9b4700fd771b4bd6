//! Projection of blocks for arbitrarily oriented cameras.

use std::ops::Range;

use rayon::prelude::*;

use super::{
    MappedCamera, MappedModel,
    arrangement::Layers,
    places::{Addresses, BlockPlaces, ViewAddresses, addresses},
    share_table::{FIRST_BIAS, ShareTable},
};
use crate::model::{
    ViewId,
    blocks::{
        BlockLight, BlockProjector,
        kernels::{APART, BATCH, BlockTaps, TapSource, gather_blocks, project_blocks},
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
struct MappedTaps<'a, const L: usize> {
    camera: &'a MappedCamera<L>,
    view: ViewAddresses,
    layers: &'a [BlockPlaces],
    lenses: [i32; 2],
}

/// With as many layers as the camera's blocks have.
impl<const L: usize, const D: usize> TapSource<L, D> for MappedTaps<'_, L> {
    type Addresses = ([Addresses; D], usize);

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
            for (table, taps) in self.camera.tables.iter().zip(&addresses.tap) {
                for &at in &taps[..*count] {
                    prefetch(&table.taps, at as usize);
                }
            }
        }
    }

    #[inline(always)]
    fn fetch(&self, (layers, count): &Self::Addresses, taps: &mut [BlockTaps<L, D>; BATCH]) {
        let [columns, rows] = &self.camera.tables;
        for layer in 0..D {
            let addresses = &layers[layer];
            for (b, taps) in taps[..(*count).min(BATCH)].iter_mut().enumerate() {
                place(columns, addresses, 0, b, self.lenses[0], &mut taps[layer][0]);
                place(rows, addresses, 1, b, self.lenses[1], &mut taps[layer][1]);
            }
        }
    }
}

/// Copies the tap of block `b` along axis `n`, relative to the window's first microlens.
#[inline(always)]
fn place<const L: usize>(
    table: &ShareTable<L>,
    addresses: &Addresses,
    n: usize,
    b: usize,
    lenses: i32,
    to: &mut PairTap<L>,
) {
    let tap = table.tap(addresses.tap[n][b] as usize);
    let first = addresses.lens[n][b] + i32::from(tap.first) - FIRST_BIAS;
    // Copied whole, then modified: assembling it from parts would stall on the store buffer, which
    // took a quarter of the time.
    *to = *tap;
    to.first = first as u16;
    if first < 0 || first + L as i32 > lenses {
        *to = clipped(tap, first, lenses);
    }
}

/// The part inside the window of a tap that extends beyond it.
#[cold]
fn clipped<const L: usize>(tap: &PairTap<L>, first: i32, lenses: i32) -> PairTap<L> {
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

    fn taps(&self, id: ViewId) -> MappedTaps<'_, L> {
        let camera = &self.model.cameras[id.camera];
        let window = &camera.optics.window;
        MappedTaps {
            camera,
            view: camera.view(&self.model.layouts[id.camera].views[id.view]),
            layers: &self.places[id.camera],
            lenses: [window.columns.len() as i32, window.rows.len() as i32],
        }
    }

    fn coverage(&self, id: ViewId) -> Option<&[f32]> {
        self.model.layouts[id.camera].views[id.view].coverage.as_deref()
    }
}

impl<const L: usize> BlockProjector for MappedProjector<'_, L> {
    fn project(&self, view: ViewId, light: &[BlockLight], image: &mut [f32]) {
        let taps = self.taps(view);
        image.fill(0.0);
        let project_blocks = match (taps.camera.layers, taps.camera.axes.number()) {
            (Layers::One, 0) => project_blocks::<_, L, 1, 0>,
            (Layers::One, 1) => project_blocks::<_, L, 1, 1>,
            (Layers::One, 2) => project_blocks::<_, L, 1, 2>,
            (Layers::One, 3) => project_blocks::<_, L, 1, 3>,
            (Layers::One, 4) => project_blocks::<_, L, 1, 4>,
            (Layers::One, _) => project_blocks::<_, L, 1, 5>,
            (Layers::Two, 0) => project_blocks::<_, L, 2, 0>,
            (Layers::Two, 1) => project_blocks::<_, L, 2, 1>,
            (Layers::Two, 2) => project_blocks::<_, L, 2, 2>,
            (Layers::Two, 3) => project_blocks::<_, L, 2, 3>,
            (Layers::Two, 4) => project_blocks::<_, L, 2, 4>,
            (Layers::Two, _) => project_blocks::<_, L, 2, 5>,
            (Layers::Eight, _) => project_blocks::<_, L, 8, APART>,
        };
        project_blocks(&taps, taps.lenses[0] as usize, light, image);
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
        let taps = self.taps(view);
        let gather_blocks = match (taps.camera.layers, taps.camera.axes.number()) {
            (Layers::One, 0) => gather_blocks::<_, L, 1, 0>,
            (Layers::One, 1) => gather_blocks::<_, L, 1, 1>,
            (Layers::One, 2) => gather_blocks::<_, L, 1, 2>,
            (Layers::One, 3) => gather_blocks::<_, L, 1, 3>,
            (Layers::One, 4) => gather_blocks::<_, L, 1, 4>,
            (Layers::One, _) => gather_blocks::<_, L, 1, 5>,
            (Layers::Two, 0) => gather_blocks::<_, L, 2, 0>,
            (Layers::Two, 1) => gather_blocks::<_, L, 2, 1>,
            (Layers::Two, 2) => gather_blocks::<_, L, 2, 2>,
            (Layers::Two, 3) => gather_blocks::<_, L, 2, 3>,
            (Layers::Two, 4) => gather_blocks::<_, L, 2, 4>,
            (Layers::Two, _) => gather_blocks::<_, L, 2, 5>,
            (Layers::Eight, _) => gather_blocks::<_, L, 8, APART>,
        };
        gather_blocks(&taps, taps.lenses[0] as usize, range.start, image, out);
    }

    fn retain(&mut self, keep: &[bool]) {
        for places in self.places.iter_mut().flatten() {
            places.retain(keep);
        }
    }
}
