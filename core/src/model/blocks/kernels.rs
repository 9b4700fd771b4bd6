//! Kernels that project blocks with taps of pairs of voxels, one view at a time.
//!
//! A block's light is first summed over its two depths if they share their taps, then distributed
//! over the microlenses along the columns, then along the rows. Rows have `L` values whatever the
//! footprint: shares beyond it are 0, so that the loops unroll into vector instructions. The
//! kernels are plain loops: with iterator chains, two of three instructions were calls.
//!
//! A view's tables are in main memory or an outer cache level, at a different address for each block: the
//! tables of all views are larger than most last-level caches. Waiting for them took a third of the time:
//! out-of-order execution covers only two or three blocks. The taps of a batch of blocks are therefore
//! prefetched ([`prefetch`](super::prefetch)) while the previous batch is processed.

use multiversion::multiversion;

use super::{
    BlockLight,
    child_order::ChildOrder,
    pair_tap::{PairTap, SHARE_UNIT},
};

/// Source of the taps of blocks in one view, with `D` layers per block and `C` voxels per tap: pairs
/// if a layer's voxels share their depth, or two pairs at different depths.
pub(super) trait TapSource<const L: usize, const D: usize, const C: usize>: Sync {
    /// Addresses of a batch's taps.
    type Addresses;

    /// Order of a block's children in the camera's orientation. Not used with 8 layers.
    fn child_order(&self) -> ChildOrder;

    /// The addresses of `count` blocks, at most [`BATCH`], starting with block `start`.
    fn addresses(&self, start: usize, count: usize) -> Self::Addresses;

    /// Prefetches the taps of a batch.
    fn prefetch_taps(&self, addresses: &Self::Addresses);

    /// The taps of a block of a batch along columns and rows. `scratch` stores them if they differ from those
    /// in the tables.
    fn taps<'a>(
        &'a self,
        addresses: &Self::Addresses,
        block: usize,
        layer: usize,
        scratch: &'a mut [PairTap<L, C>; 2],
    ) -> [PlacedTap<'a, L, C>; 2];
}

/// A tap, and its first microlens relative to the window.
#[derive(Debug, Clone, Copy)]
pub(super) struct PlacedTap<'a, const L: usize, const C: usize> {
    pub tap: &'a PairTap<L, C>,
    pub first: usize,
}

/// Unit of a share along the columns times one along the rows.
const UNITS: f32 = SHARE_UNIT * SHARE_UNIT;

/// Blocks whose taps are prefetched together: enough to keep a core's load buffers full, few enough
/// for its L1 cache.
pub(super) const BATCH: usize = 16;

/// The light of a block's layer by row and column, with the voxels behind them: `C` rows. `light` is in the camera's
/// order, or in the grid's with 8 layers: one voxel each.
#[inline(always)]
fn light_of<const D: usize, const C: usize>(light: &BlockLight, layer: usize) -> [[f32; 2]; C] {
    let mut quarters = [[0.0; 2]; C];
    if D == 8 {
        quarters[0][0] = light[layer & 7] * UNITS;
        return quarters;
    }
    for q in 0..C {
        for c in 0..2 {
            let mut sum = light[(4 * layer + 2 * q + c) & 7];
            if (D, C) == (1, 2) {
                sum += light[4 + 2 * (q & 1) + c];
            }
            quarters[q][c] = sum * UNITS;
        }
    }
    quarters
}

/// Adds a projection of the blocks' `light` to `image`, `width` pixels per row.
#[multiversion(targets("x86_64+avx512f+avx512vl", "x86_64+avx2"))]
pub(super) fn project_blocks<
    S: TapSource<L, D, C>,
    const L: usize,
    const D: usize,
    const C: usize,
>(
    source: &S,
    width: usize,
    light: &[BlockLight],
    image: &mut [f32],
) {
    let order = source.child_order();
    let mut scratch = [PairTap::NONE; 2];
    let mut next = source.addresses(0, light.len().min(BATCH));
    for (batch, lights) in light.chunks(BATCH).enumerate() {
        let addresses = next;
        let start = (batch + 1) * BATCH;
        next = source.addresses(start, light.len().saturating_sub(start).min(BATCH));
        source.prefetch_taps(&next);
        // In a loop of its own, as is the opposite in `gather_blocks`: between the others it keeps them from becoming
        // vector instructions.
        let mut reordered = [[0.0; 8]; BATCH];
        for (block, &light) in lights.iter().enumerate() {
            reordered[block % BATCH] = if D == 8 { light } else { order.to_camera(light) };
        }
        for (block, light) in reordered.iter().enumerate().take(lights.len()) {
            for layer in 0..D {
                let [columns, rows] = source.taps(&addresses, block % BATCH, layer, &mut scratch);
                let (column, row) = (columns.tap, rows.tap);
                let quarters = light_of::<D, C>(light, layer);
                let mut spread = [[0.0f32; L]; C];
                for q in 0..C {
                    let [low, high] = quarters[q];
                    let (of_low, of_high) = (&column.shares[q & !1], &column.shares[q | 1]);
                    let spread = &mut spread[q];
                    for i in 0..L {
                        spread[i] = low * f32::from(of_low[i]) + high * f32::from(of_high[i]);
                    }
                }
                let mut at = rows.first * width + columns.first;
                for j in 0..usize::from(row.len).min(L) {
                    // Tables and image match; a wrong image length would only lose light.
                    let Some(pixels) = image.get_mut(at..at + L) else { break };
                    let mut shares = [0.0f32; C];
                    for q in 0..C {
                        shares[q] = f32::from(row.shares[q][j]);
                    }
                    for i in 0..L {
                        let mut sum = shares[0] * spread[0][i];
                        for q in 1..C {
                            sum += shares[q] * spread[q][i];
                        }
                        pixels[i] += sum;
                    }
                    at += width;
                }
            }
        }
    }
}

/// The adjoint of [`project_blocks`], for the blocks from number `start` on.
#[multiversion(targets("x86_64+avx512f+avx512vl", "x86_64+avx2"))]
pub(super) fn gather_blocks<
    S: TapSource<L, D, C>,
    const L: usize,
    const D: usize,
    const C: usize,
>(
    source: &S,
    width: usize,
    start: usize,
    image: &[f32],
    out: &mut [BlockLight],
) {
    let order = source.child_order();
    let mut scratch = [PairTap::NONE; 2];
    let blocks = out.len();
    let mut next = source.addresses(start, blocks.min(BATCH));
    for (batch, out) in out.chunks_mut(BATCH).enumerate() {
        let addresses = next;
        let done = (batch + 1) * BATCH;
        next = source.addresses(start + done, blocks.saturating_sub(done).min(BATCH));
        source.prefetch_taps(&next);
        // Near and far quarters of each block, in the camera's order.
        let mut gathered = [[[0.0; 4]; 2]; BATCH];
        for (block, out) in out.iter_mut().enumerate() {
            let halves = &mut gathered[block % BATCH];
            for layer in 0..D {
                let [columns, rows] = source.taps(&addresses, block, layer, &mut scratch);
                let (column, row) = (columns.tap, rows.tap);
                let mut at = rows.first * width + columns.first;
                let mut sums = [[0.0f32; L]; C];
                for j in 0..usize::from(row.len).min(L) {
                    let Some(pixels) = image.get(at..at + L) else { break };
                    for q in 0..C {
                        let share = f32::from(row.shares[q][j]);
                        for i in 0..L {
                            sums[q][i] += share * pixels[i];
                        }
                    }
                    at += width;
                }
                for d in 0..C / 2 {
                    let quarters = along_columns(
                        [&sums[2 * d], &sums[2 * d + 1]],
                        [&column.shares[2 * d], &column.shares[2 * d + 1]],
                    );
                    if D == 8 {
                        out[layer & 7] += quarters[0];
                        continue;
                    }
                    halves[(layer + d) & 1] = quarters;
                    if (D, C) == (1, 2) {
                        halves[1] = quarters;
                    }
                }
            }
        }
        if D < 8 {
            for (block, out) in out.iter_mut().enumerate() {
                let [[a, b, c, d], [e, f, g, h]] = gathered[block % BATCH];
                let light = order.to_grid([a, b, c, d, e, f, g, h]);
                for child in 0..8 {
                    out[child] += light[child];
                }
            }
        }
    }
}

/// Σ_i sums[r][i] shares[c][i] at index 2 r + c, summed in halves: four sums per vector. `L` is a
/// power of two.
#[inline(always)]
fn along_columns<const L: usize>(sums: [&[f32; L]; 2], shares: [&[u16; L]; 2]) -> [f32; 4] {
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
