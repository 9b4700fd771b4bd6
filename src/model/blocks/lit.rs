//! Which voxels may hold light, 64 voxels at a time.
//!
//! One camera at a time: for each depth of blocks and each view, the image's lit pixels are carried
//! onto the voxels. A few neighbouring microlenses are looked up together, so a row of the image
//! becomes a line of bits in some twenty operations; a voxel's line is the union of the rows in its
//! support. The views that find a voxel dark are counted in bit planes, 64 voxels per operation.

use rayon::prelude::*;

use super::{
    Darkness, LitBlocks,
    aligned::{AlignedCamera, AlignedModel, Axes},
    axis_table::{PairTap, SHARE_UNIT},
    block_indices, blocks_along,
    dark_counts::DarkCounts,
};
use crate::{
    lightfield::{ViewLayout, ViewStack},
    model::{SUPPORT_SHARE, tables::LEAST_SEEN_SHARE},
};

/// One bit per voxel along a camera's columns.
type Line = Vec<u64>;

/// See [`super::BlockModel::lit`].
pub(super) fn lit_blocks<const L: usize, const D: usize>(
    model: &AlignedModel<L, D>,
    views: &[ViewStack],
    darkness: &Darkness,
) -> LitBlocks {
    let cameras: Vec<CameraBits> = model
        .cameras
        .iter()
        .zip(&model.layouts)
        .enumerate()
        .map(|(n, (camera, layout))| {
            let images = LitImages::new(layout, &views[n], darkness.dark_below[n]);
            CameraBits::new(camera, layout, &images, (model.grid.voxels, D), darkness.forgiven[n])
        })
        .collect();
    let [nx, ny, nz] = blocks_along(&model.grid);
    let mut lit = LitBlocks::default();
    for block in 0..(nx * ny * nz) as u32 {
        let at = block_indices(&model.grid, block);
        let possible = cameras.iter().fold(u8::MAX, |mask, c| mask & c.possible.children(at));
        let seen = cameras.iter().fold(0, |mask, c| mask | c.seen.children(at));
        if possible & seen != 0 {
            lit.blocks.push(block);
            lit.children.push(possible & seen);
        }
    }
    lit
}

/// Microlenses that are looked up together.
const GROUP: usize = 6;

/// With more, a group's voxels would not fit into two words: (6 + 2) · 8 = 64.
pub(super) const MOST_VOXELS_PER_MICROLENS: f64 = 8.0;

/// The lit pixels of every view of a camera: for each row and each [`GROUP`] of microlenses the
/// set of those that are lit, a bit each.
struct LitImages {
    rows: usize,
    groups: usize,
    sets: Vec<u8>,
}

impl LitImages {
    fn new(layout: &ViewLayout, views: &ViewStack, dark_below: f32) -> Self {
        let (width, rows) = (layout.window.columns.len(), layout.window.rows.len());
        let groups = width.div_ceil(GROUP);
        let mut sets = vec![0u8; views.len() * rows * groups];
        for (n, view) in layout.views.iter().enumerate() {
            for (row, line) in views.view(n).chunks_exact(width).enumerate() {
                let target = &mut sets[(n * rows + row) * groups..][..groups];
                for (i, &value) in line.iter().enumerate() {
                    let open = view.coverage.as_ref().map_or(1.0, |c| c[row * width + i]);
                    // A pixel less than half open is no evidence of darkness.
                    let lit = open <= 0.5 || value >= dark_below * open;
                    target[i / GROUP] |= u8::from(lit) << (i % GROUP);
                }
            }
        }
        Self { rows, groups, sets }
    }

    fn row(&self, view: usize, row: usize) -> &[u8] {
        &self.sets[(view * self.rows + row) * self.groups..][..self.groups]
    }
}

/// A camera's verdict on every voxel.
struct CameraBits {
    possible: VoxelBits,
    seen: VoxelBits,
}

/// One bit per voxel: for each tabulated depth and voxel across the rows a [`Line`].
struct VoxelBits {
    axes: Axes,
    /// Depths per block that have lines of their own.
    layers: usize,
    /// Voxels along the depth and across the rows.
    depths: usize,
    rows: usize,
    words: usize,
    bits: Vec<u64>,
}

impl VoxelBits {
    /// The bits of a block's children; 0 beyond the grid's end.
    fn children(&self, block: [usize; 3]) -> u8 {
        let (column, row) = (2 * block[self.axes.column], 2 * block[self.axes.row]);
        let far_inside = 2 * block[self.axes.depth] + 1 < self.depths;
        let mut mask = 0;
        for (r, children) in self.axes.children().into_iter().enumerate() {
            if row + r >= self.rows {
                break;
            }
            let pairs = [0, self.layers - 1].map(|layer| {
                let depth = self.layers * block[self.axes.depth] + layer;
                let line = (depth * self.rows + row + r) * self.words;
                self.bits[line + column / 64] >> (column % 64)
            });
            for (c, [near, far]) in children.into_iter().enumerate() {
                let [near_lit, far_lit] = pairs.map(|pair| pair >> c & 1 == 1);
                mask |= u8::from(near_lit) << near | u8::from(far_lit && far_inside) << far;
            }
        }
        mask
    }
}

impl CameraBits {
    fn new<const L: usize>(
        camera: &AlignedCamera<L>,
        layout: &ViewLayout,
        images: &LitImages,
        (voxels, layers): ([usize; 3], usize),
        forgiven: usize,
    ) -> Self {
        let (columns, rows) = (voxels[camera.axes.column], voxels[camera.axes.row]);
        let words = columns.div_ceil(64);
        let slabs: Vec<[Vec<u64>; 2]> = (0..camera.columns.depths())
            .into_par_iter()
            .map(|depth| {
                Slab { camera, layout, images, depth, columns, rows, words }.judge(forgiven)
            })
            .collect();
        let collect = |n: usize| VoxelBits {
            axes: camera.axes,
            layers,
            depths: voxels[camera.axes.depth],
            rows,
            words,
            bits: slabs.iter().flat_map(|slab| slab[n].iter().copied()).collect(),
        };
        Self { possible: collect(0), seen: collect(1) }
    }
}

/// All voxels at one tabulated depth of a camera.
struct Slab<'a, const L: usize> {
    camera: &'a AlignedCamera<L>,
    layout: &'a ViewLayout,
    images: &'a LitImages,
    depth: usize,
    columns: usize,
    rows: usize,
    words: usize,
}

/// What one view index along the columns does to a line of voxels.
struct ColumnMap {
    /// For every word of the line the groups of microlenses that can light its voxels.
    lit_by: Vec<Vec<LitByGroup>>,
    /// The voxels that the view sees well enough to judge.
    judged: Line,
}

/// The bits of a word that each set of lit microlenses of a group sets.
struct LitByGroup {
    group: usize,
    bits: [u64; 1 << GROUP],
}

/// For each voxel across the rows the microlens rows of its support; `None` where the view sees
/// too little of it.
type RowMap = Vec<Option<[usize; 2]>>;

impl<const L: usize> Slab<'_, L> {
    /// The lines of possible and of seen voxels.
    fn judge(&self, forgiven: usize) -> [Vec<u64>; 2] {
        let reach = self.layout.columns.reach;
        let column_maps: Vec<ColumnMap> = (-reach..=reach).map(|k| self.column_map(k)).collect();
        let reach = self.layout.rows.reach;
        let row_maps: Vec<RowMap> = (-reach..=reach).map(|l| self.row_map(l)).collect();
        let mut dark = DarkCounts::new(self.rows, self.words, forgiven);
        let mut line = vec![0u64; self.words];
        let mut seen = vec![0u64; self.rows * self.words];
        let mut lit_rows = vec![0u64; self.images.rows * self.words];
        for (n, view) in self.layout.views.iter().enumerate() {
            let columns = &column_maps[(view.k + self.layout.columns.reach) as usize];
            let rows = &row_maps[(view.l + self.layout.rows.reach) as usize];
            for (row, line) in lit_rows.chunks_exact_mut(self.words).enumerate() {
                light_voxels(self.images.row(n, row), columns, line);
            }
            for (y, support) in rows.iter().enumerate() {
                let Some([start, end]) = *support else { continue };
                let seen = &mut seen[y * self.words..][..self.words];
                line.copy_from_slice(&columns.judged);
                for (seen, judged) in seen.iter_mut().zip(&columns.judged) {
                    *seen |= judged;
                }
                for lit in lit_rows[start * self.words..end * self.words].chunks_exact(self.words) {
                    for (dark, lit) in line.iter_mut().zip(lit) {
                        *dark &= !lit;
                    }
                }
                dark.count(y, &mut line);
            }
        }
        let mut possible = dark.within();
        for line in possible.chunks_exact_mut(self.words) {
            for (word, bits) in line.iter_mut().enumerate() {
                let voxels = self.columns - 64 * word;
                *bits &= if voxels < 64 { (1 << voxels) - 1 } else { u64::MAX };
            }
        }
        [possible, seen]
    }

    fn column_map(&self, k: i32) -> ColumnMap {
        let lenses = self.layout.window.columns.len();
        let mut voxels_of = vec![[usize::MAX, 0]; lenses];
        let mut judged = vec![0; self.words];
        for (voxel, support) in self.supports(&self.camera.columns, k, self.columns) {
            judged[voxel / 64] |= 1 << (voxel % 64);
            for [low, high] in &mut voxels_of[support[0]..support[1]] {
                *low = (*low).min(voxel);
                *high = (*high).max(voxel + 1);
            }
        }
        let word = |word| {
            let groups = voxels_of.chunks(GROUP).enumerate();
            groups.filter_map(|(n, voxels_of)| LitByGroup::new(n, voxels_of, word)).collect()
        };
        ColumnMap { lit_by: (0..self.words).map(word).collect(), judged }
    }

    fn row_map(&self, l: i32) -> RowMap {
        let mut map = vec![None; self.rows];
        for (voxel, support) in self.supports(&self.camera.rows, l, self.rows) {
            map[voxel] = Some(support);
        }
        map
    }

    /// The microlenses of each voxel's support along one axis, where a view sees enough of it.
    fn supports<'t>(
        &self,
        table: &'t super::axis_table::PairTable<L>,
        view: i32,
        voxels: usize,
    ) -> impl Iterator<Item = (usize, [usize; 2])> + 't {
        let taps = &table.of_view(view)[self.depth * table.pairs()..][..table.pairs()];
        let both = taps.iter().enumerate().flat_map(|(pair, tap)| {
            [0, 1].into_iter().filter_map(move |n| Some((2 * pair + n, support(tap, n)?)))
        });
        both.filter(move |&(voxel, _)| voxel < voxels)
    }
}

/// The microlenses that receive a notable share of voxel `n` of a pair; `None` where the view sees
/// too little of it.
fn support<const L: usize>(tap: &PairTap<L>, n: usize) -> Option<[usize; 2]> {
    let shares = tap.shares[n].map(|share| f32::from(share) * SHARE_UNIT);
    let lit = |share: &f32| *share > SUPPORT_SHARE;
    let (start, last) = (shares.iter().position(lit)?, shares.iter().rposition(lit)?);
    let first = usize::from(tap.first);
    let seen: f32 = shares.iter().sum();
    (seen >= LEAST_SEEN_SHARE).then_some([first + start, first + last + 1])
}

impl LitByGroup {
    /// From the range of voxels that each microlens of a group lights; microlenses without voxels
    /// light none. `None` where no voxel of the word is lit by the group.
    fn new(group: usize, voxels_of: &[[usize; 2]], word: usize) -> Option<Self> {
        let mut each = [0u64; GROUP];
        for (bits, &[low, high]) in each.iter_mut().zip(voxels_of) {
            for voxel in low.max(64 * word)..high.min(64 * (word + 1)) {
                *bits |= 1 << (voxel % 64);
            }
        }
        let mut bits = [0; 1 << GROUP];
        for set in 1..bits.len() {
            bits[set] = bits[set & (set - 1)] | each[set.trailing_zeros() as usize];
        }
        each.iter().any(|&bits| bits != 0).then_some(Self { group, bits })
    }
}

/// The voxels in whose support one of the lit microlenses of an image row lies.
fn light_voxels(row: &[u8], columns: &ColumnMap, line: &mut [u64]) {
    for (word, groups) in line.iter_mut().zip(&columns.lit_by) {
        *word = groups
            .iter()
            .fold(0, |lit, group| lit | group.bits[usize::from(row[group.group]) % (1 << GROUP)]);
    }
}
