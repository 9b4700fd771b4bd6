//! Kernels that project blocks with taps of pairs of voxels, one view at a time.
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

use multiversion::multiversion;

use super::{
    BlockLight,
    aligned_tables::Axes,
    pair_tap::{PairTap, SHARE_UNIT},
};

/// Where the taps of blocks in one view come from: `D` layers per block.
pub(super) trait TapSource<const L: usize, const D: usize>: Sync {
    /// What says where a batch's taps are.
    type Addresses;

    /// The addresses of `count` blocks, at most [`BATCH`], from number `start` on.
    fn addresses(&self, start: usize, count: usize) -> Self::Addresses;

    /// Asks for the taps of a batch, without waiting for them.
    fn ask_for(&self, addresses: &Self::Addresses);

    /// Copies the taps of a batch.
    fn fetch(&self, addresses: &Self::Addresses, taps: &mut [BlockTaps<L, D>; BATCH]);
}

/// Number of an arrangement in which each of a block's eight voxels is a layer of its own; the smaller
/// numbers are those of [`Axes`].
pub(super) const APART: usize = Axes::ALL.len();

/// A share along the columns times one along the rows, in the units of the tables.
const UNITS: f32 = SHARE_UNIT * SHARE_UNIT;

/// Blocks whose taps are fetched together: enough to keep as many loads in flight as a core can,
/// few enough for its nearest cache.
pub(super) const BATCH: usize = 16;

/// A block's taps along the columns and the rows, per layer.
pub(super) type BlockTaps<const L: usize, const D: usize> = [[PairTap<L>; 2]; D];

/// The children of row r and column c of a block, near and far.
const fn children_of(arrangement: usize) -> [[[usize; 2]; 2]; 2] {
    // Where each voxel is a layer of its own, nobody asks.
    Axes::ALL[arrangement % APART].children()
}

/// The light of row r and column c of a block's layer.
#[inline(always)]
fn light_of<const D: usize>(
    children: [[[usize; 2]; 2]; 2],
    light: &BlockLight,
    layer: usize,
) -> [[f32; 2]; 2] {
    if D == 8 {
        return [[light[layer & 7] * UNITS, 0.0], [0.0; 2]];
    }
    let mut quarters = [[0.0; 2]; 2];
    for r in 0..2 {
        for c in 0..2 {
            let [near, far] = children[r][c];
            quarters[r][c] = match D {
                1 => (light[near] + light[far]) * UNITS,
                _ => light[children[r][c][layer & 1]] * UNITS,
            };
        }
    }
    quarters
}

/// `A` is the number of the camera's [`Axes`], or [`APART`] with 8 layers.
#[multiversion(targets("x86_64+avx512f+avx512vl", "x86_64+avx2"))]
pub(super) fn project_blocks<S: TapSource<L, D>, const L: usize, const D: usize, const A: usize>(
    source: &S,
    width: usize,
    light: &[BlockLight],
    image: &mut [f32],
) {
    let children = const { children_of(A) };
    let mut taps = [[[PairTap::NONE; 2]; D]; BATCH];
    let mut next = source.addresses(0, light.len().min(BATCH));
    for (batch, lights) in light.chunks(BATCH).enumerate() {
        source.fetch(&next, &mut taps);
        let start = (batch + 1) * BATCH;
        next = source.addresses(start, light.len().saturating_sub(start).min(BATCH));
        source.ask_for(&next);
        for (taps, light) in taps.iter().zip(lights) {
            for (layer, [column, row]) in taps.iter().enumerate() {
                let quarters = light_of::<D>(children, light, layer);
                let mut spread = [[0.0f32; L]; 2];
                for r in 0..2 {
                    let [low, high] = quarters[r];
                    let [of_low, of_high] = &column.shares;
                    let spread = &mut spread[r];
                    for i in 0..L {
                        spread[i] = low * f32::from(of_low[i]) + high * f32::from(of_high[i]);
                    }
                }
                let mut at = usize::from(row.first) * width + usize::from(column.first);
                for j in 0..usize::from(row.len).min(L) {
                    // Tables and image belong together; a wrong image length loses light, no more.
                    let Some(pixels) = image.get_mut(at..at + L) else { break };
                    let (low, high) = (f32::from(row.shares[0][j]), f32::from(row.shares[1][j]));
                    for i in 0..L {
                        pixels[i] += low * spread[0][i] + high * spread[1][i];
                    }
                    at += width;
                }
            }
        }
    }
}

/// The adjoint of [`project_blocks`], for the blocks from number `start` on.
#[multiversion(targets("x86_64+avx512f+avx512vl", "x86_64+avx2"))]
pub(super) fn gather_blocks<S: TapSource<L, D>, const L: usize, const D: usize, const A: usize>(
    source: &S,
    width: usize,
    start: usize,
    image: &[f32],
    out: &mut [BlockLight],
) {
    let children = const { children_of(A) };
    let mut taps = [[[PairTap::NONE; 2]; D]; BATCH];
    let blocks = out.len();
    let mut next = source.addresses(start, blocks.min(BATCH));
    for (batch, out) in out.chunks_mut(BATCH).enumerate() {
        source.fetch(&next, &mut taps);
        let done = (batch + 1) * BATCH;
        next = source.addresses(start + done, blocks.saturating_sub(done).min(BATCH));
        source.ask_for(&next);
        for (taps, out) in taps.iter().zip(out) {
            for (layer, [column, row]) in taps.iter().enumerate() {
                let mut at = usize::from(row.first) * width + usize::from(column.first);
                let mut sums = [[0.0f32; L]; 2];
                for j in 0..usize::from(row.len).min(L) {
                    let Some(pixels) = image.get(at..at + L) else { break };
                    let (low, high) = (f32::from(row.shares[0][j]), f32::from(row.shares[1][j]));
                    for i in 0..L {
                        sums[0][i] += low * pixels[i];
                        sums[1][i] += high * pixels[i];
                    }
                    at += width;
                }
                let quarters = along_columns(&sums, &column.shares);
                if D == 8 {
                    out[layer & 7] += quarters[0];
                    continue;
                }
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
