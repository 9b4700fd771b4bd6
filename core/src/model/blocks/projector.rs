//! Projection of blocks with pair tables, one view at a time.
//!
//! A block's light is first summed over its two depths where they share their taps, then spread
//! over the microlenses along the columns, then along the rows. Rows are `L` values long whatever the
//! footprint: shares beyond it are 0, and the loops unroll into vector instructions. The kernels
//! are plain loops, not iterator chains: two of three instructions were calls otherwise.
//!
//! A view's tables come from memory or a far cache, block by block from another place. Waiting for
//! them was a third of the time, because a processor looks ahead over two or three blocks only.
//! So the taps of a batch of blocks are copied first: loads that wait for nothing but memory
//! overlap. While a batch is worked on, the taps of the next one are on their way ([`prefetch`]):
//! the tables of all views are larger than most last caches, and copying waited for two fifths of
//! the time.

use std::ops::Range;

use multiversion::multiversion;

use super::{
    BlockLight, BlockProjector,
    aligned_tables::{AlignedModel, Axes, Place, ViewTables},
    pair_tap::{PairTap, SHARE_UNIT},
    prefetch::prefetch,
};
use crate::model::ViewId;

/// An [`AlignedModel`] restricted to active blocks.
pub(super) struct AlignedProjector<'a, const L: usize, const D: usize> {
    pub(super) model: &'a AlignedModel<L, D>,
    /// Per camera, per active block.
    pub(super) places: Vec<Vec<Place>>,
}

impl<const L: usize, const D: usize> BlockProjector for AlignedProjector<'_, L, D> {
    fn project(&self, view: ViewId, light: &[BlockLight], image: &mut [f32]) {
        let tables = self.model.view(view);
        image.fill(0.0);
        // Children at constant places are shuffled in registers instead of loaded one by one.
        let project_blocks = match self.model.cameras[view.camera].axes.number() {
            0 => project_blocks::<L, D, 0>,
            1 => project_blocks::<L, D, 1>,
            2 => project_blocks::<L, D, 2>,
            3 => project_blocks::<L, D, 3>,
            4 => project_blocks::<L, D, 4>,
            _ => project_blocks::<L, D, 5>,
        };
        project_blocks(&tables, &self.places[view.camera], light, image);
        cover(&tables, image);
    }

    fn prepare(&self, view: ViewId, image: &mut [f32]) {
        cover(&self.model.view(view), image);
    }

    fn back_project(
        &self,
        view: ViewId,
        image: &[f32],
        range: Range<usize>,
        out: &mut [BlockLight],
    ) {
        let tables = self.model.view(view);
        let gather_blocks = match self.model.cameras[view.camera].axes.number() {
            0 => gather_blocks::<L, D, 0>,
            1 => gather_blocks::<L, D, 1>,
            2 => gather_blocks::<L, D, 2>,
            3 => gather_blocks::<L, D, 3>,
            4 => gather_blocks::<L, D, 4>,
            _ => gather_blocks::<L, D, 5>,
        };
        gather_blocks(&tables, &self.places[view.camera][range], image, out);
    }

    fn retain(&mut self, keep: &[bool]) {
        for places in &mut self.places {
            let mut flags = keep.iter();
            places.retain(|_| flags.next().copied().unwrap_or(false));
        }
    }
}

/// Weighs pixels by the open share of their pupil cells.
fn cover<const L: usize>(tables: &ViewTables<'_, L>, image: &mut [f32]) {
    for (pixel, &open) in image.iter_mut().zip(tables.coverage.unwrap_or(&[])) {
        *pixel *= open;
    }
}

/// A share along the columns times one along the rows, in the units of the tables.
const UNITS: f32 = SHARE_UNIT * SHARE_UNIT;

/// Blocks whose taps are fetched together: enough to keep as many loads in flight as a core can,
/// few enough for its nearest cache.
const BATCH: usize = 16;

/// A block's taps along the columns and the rows, per layer.
type BlockTaps<const L: usize, const D: usize> = [[PairTap<L>; 2]; D];

#[inline(always)]
fn fetch<const L: usize, const D: usize>(
    tables: &ViewTables<'_, L>,
    places: &[Place],
    taps: &mut [BlockTaps<L, D>; BATCH],
) {
    for (taps, place) in taps.iter_mut().zip(places) {
        for (layer, [column, row]) in taps.iter_mut().enumerate() {
            *column = tables.columns[place.column as usize + layer * tables.column_pairs];
            *row = tables.rows[place.row as usize + layer * tables.row_pairs];
        }
    }
}

/// Asks for the taps of the batch after this one.
#[inline(always)]
fn ask_for<const L: usize, const D: usize>(tables: &ViewTables<'_, L>, places: &[Place]) {
    for place in places {
        for layer in 0..D {
            prefetch(&tables.columns[place.column as usize + layer * tables.column_pairs]);
            prefetch(&tables.rows[place.row as usize + layer * tables.row_pairs]);
        }
    }
}

/// `A` is the number of the camera's [`Axes`].
#[multiversion(targets("x86_64+avx512f+avx512vl", "x86_64+avx2"))]
fn project_blocks<const L: usize, const D: usize, const A: usize>(
    tables: &ViewTables<'_, L>,
    places: &[Place],
    light: &[BlockLight],
    image: &mut [f32],
) {
    let children = const { Axes::ALL[A].children() };
    let mut taps = [[[PairTap::NONE; 2]; D]; BATCH];
    let mut next = places.chunks(BATCH).skip(1);
    for (places, light) in places.chunks(BATCH).zip(light.chunks(BATCH)) {
        fetch(tables, places, &mut taps);
        ask_for::<L, D>(tables, next.next().unwrap_or(&[]));
        for (taps, light) in taps.iter().zip(light) {
            for layer in 0..D {
                let [column, row] = &taps[layer];
                let mut spread = [[0.0f32; L]; 2];
                for r in 0..2 {
                    let [low, high] = [0, 1].map(|c| {
                        let [near, far] = children[r][c];
                        match D {
                            1 => (light[near] + light[far]) * UNITS,
                            _ => light[children[r][c][layer & 1]] * UNITS,
                        }
                    });
                    let [of_low, of_high] = &column.shares;
                    let spread = &mut spread[r];
                    for i in 0..L {
                        spread[i] = low * f32::from(of_low[i]) + high * f32::from(of_high[i]);
                    }
                }
                let mut at = usize::from(row.first) * tables.width + usize::from(column.first);
                for j in 0..usize::from(row.len).min(L) {
                    // Tables and image belong together; a wrong image length loses light, no more.
                    let Some(pixels) = image.get_mut(at..at + L) else { break };
                    let (low, high) = (f32::from(row.shares[0][j]), f32::from(row.shares[1][j]));
                    for i in 0..L {
                        pixels[i] += low * spread[0][i] + high * spread[1][i];
                    }
                    at += tables.width;
                }
            }
        }
    }
}

/// The adjoint of [`project_blocks`].
#[multiversion(targets("x86_64+avx512f+avx512vl", "x86_64+avx2"))]
fn gather_blocks<const L: usize, const D: usize, const A: usize>(
    tables: &ViewTables<'_, L>,
    places: &[Place],
    image: &[f32],
    out: &mut [BlockLight],
) {
    let children = const { Axes::ALL[A].children() };
    let mut taps = [[[PairTap::NONE; 2]; D]; BATCH];
    let mut next = places.chunks(BATCH).skip(1);
    for (places, out) in places.chunks(BATCH).zip(out.chunks_mut(BATCH)) {
        fetch(tables, places, &mut taps);
        ask_for::<L, D>(tables, next.next().unwrap_or(&[]));
        for (taps, out) in taps.iter().zip(out) {
            for layer in 0..D {
                let [column, row] = &taps[layer];
                let mut at = usize::from(row.first) * tables.width + usize::from(column.first);
                let mut sums = [[0.0f32; L]; 2];
                for j in 0..usize::from(row.len).min(L) {
                    let Some(pixels) = image.get(at..at + L) else { break };
                    let (low, high) = (f32::from(row.shares[0][j]), f32::from(row.shares[1][j]));
                    for i in 0..L {
                        sums[0][i] += low * pixels[i];
                        sums[1][i] += high * pixels[i];
                    }
                    at += tables.width;
                }
                let quarters = along_columns(&sums, &column.shares);
                for r in 0..2 {
                    for c in 0..2 {
                        let sum = quarters[2 * r + c];
                        let [near, far] = children[r][c];
                        if D == 1 {
                            out[near] += sum;
                            out[far] += sum;
                        } else {
                            out[children[r][c][layer & 1]] += sum;
                        }
                    }
                }
            }
        }
    }
}

/// Σ_i sums[r][i] shares[c][i] at 2 r + c, halves first: four sums side by side in a vector. `L` is
/// a power of two.
#[inline(always)]
fn along_columns<const L: usize>(sums: &[[f32; L]; 2], shares: &[[u16; L]; 2]) -> [f32; 4] {
    let mut products = [[0.0f32; 4]; L];
    for i in 0..L {
        for q in 0..4 {
            products[i][q] = sums[q / 2][i] * f32::from(shares[q % 2][i]);
        }
    }
    let mut half = L / 2;
    while half > 0 {
        for i in 0..half {
            let (mut lower, upper) = (products[i], products[i + half]);
            for q in 0..4 {
                lower[q] += upper[q];
            }
            products[i] = lower;
        }
        half /= 2;
    }
    products[0].map(|sum| sum * UNITS)
}
