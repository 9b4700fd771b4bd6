//! Kernels that project blocks with taps of pairs of voxels, one view at a time.
//!
//! A block's light is first summed over its two depths if they share their taps, then distributed
//! over the microlenses along the columns, then along the rows. Rows have `L` values whatever the
//! footprint: shares beyond it are 0, so that the loops unroll into vector instructions. The
//! kernels are plain loops: with iterator chains, two of three instructions were calls.
//!
//! A view's tables come from memory or a far cache, at a different place for each block. Waiting
//! for them took a third of the time, because a processor looks ahead over only two or three
//! blocks. So the taps of a batch of blocks are copied first, so that their loads overlap. While a
//! batch is processed, the taps of the next one are prefetched ([`prefetch`]): the tables of all
//! views are larger than most last-level caches, and copying spent two fifths of the time waiting.

use multiversion::multiversion;

use super::{
    BlockLight,
    aligned_tables::Axes,
    pair_tap::{PairTap, SHARE_UNIT},
};

/// Source of the taps of blocks in one view, with `D` layers per block.
pub(super) trait TapSource<const L: usize, const D: usize>: Sync {
    /// Addresses of a batch's taps.
    type Addresses;

    /// The addresses of `count` blocks, at most [`BATCH`], starting with block `start`.
    fn addresses(&self, start: usize, count: usize) -> Self::Addresses;

    /// Prefetches the taps of a batch.
    fn prefetch_taps(&self, addresses: &Self::Addresses);

    /// Copies the taps of a batch.
    fn fetch(&self, addresses: &Self::Addresses, taps: &mut [BlockTaps<L, D>; BATCH]);
}

/// Index of the arrangement in which each of a block's eight voxels is its own layer; smaller
/// indices are those of [`Axes`].
pub(super) const APART: usize = Axes::ALL.len();

/// Unit of a share along the columns times one along the rows.
const UNITS: f32 = SHARE_UNIT * SHARE_UNIT;

/// Blocks whose taps are fetched together: enough to keep a core's load buffers full, few enough
/// for its L1 cache.
pub(super) const BATCH: usize = 16;

/// A block's taps along columns and rows, per layer.
pub(super) type BlockTaps<const L: usize, const D: usize> = [[PairTap<L>; 2]; D];

/// The children of row r and column c of a block, near and far.
const fn children_of(arrangement: usize) -> [[[usize; 2]; 2]; 2] {
    // Unused if each voxel is its own layer.
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

/// `A` is the index of the camera's [`Axes`], or [`APART`] with 8 layers.
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
        source.prefetch_taps(&next);
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
                    // Tables and image match; a wrong image length would only lose light.
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
        source.prefetch_taps(&next);
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

/// Σ_i sums[r][i] shares[c][i] at index 2 r + c, summed in halves: four sums per vector. `L` is a
/// power of two.
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
