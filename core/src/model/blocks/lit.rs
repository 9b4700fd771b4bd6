//! Photo-hull in blocks: the voxels that may contain light, up to 256 at a time.
//!
//! For one camera, each depth of blocks and each view, the image's lit pixels are mapped onto the voxels.
//! Several neighbouring microlenses are looked up together, so that some twenty operations convert a row of the
//! image to a line of bits ([`maps`]). A voxel's line is the union of the rows in its support. The views in
//! which a voxel is dark are counted in bit planes ([`slab`]). Lines have the number of words that a grid's
//! columns need, at most four.

mod maps;
mod slab;
#[cfg(test)]
mod tests;

use std::ops::Range;

use rayon::prelude::*;

use super::{
    HullCriteria, LitBlocks,
    aligned_tables::{AlignedCamera, AlignedModel, Axes},
    blocks_along,
    dark_counts::Line,
};
use crate::lightfield::{ViewLayout, ViewStack};
use maps::GROUP;
use slab::Slab;

/// Limit for which a group's voxels fit into two words: (6 + 2) · 8 = 64.
pub(super) const MAX_VOXELS_PER_MICROLENS: f64 = 8.0;

/// See [`super::BlockModel::lit`].
pub(super) fn lit_blocks<const L: usize, const D: usize>(
    model: &AlignedModel<L, D>,
    views: &[ViewStack],
    criteria: &HullCriteria,
) -> LitBlocks {
    let columns = model.cameras.iter().map(|camera| model.grid.voxels[camera.axes.column]);
    match columns.max().unwrap_or(0) {
        0..=64 => lit_in_lines::<1, L, D>(model, views, criteria),
        65..=128 => lit_in_lines::<2, L, D>(model, views, criteria),
        _ => lit_in_lines::<4, L, D>(model, views, criteria),
    }
}

/// [`lit_blocks`] with lines of `W` words.
fn lit_in_lines<const W: usize, const L: usize, const D: usize>(
    model: &AlignedModel<L, D>,
    views: &[ViewStack],
    criteria: &HullCriteria,
) -> LitBlocks {
    let cameras: Vec<CameraBits<W>> = model
        .cameras
        .iter()
        .zip(&model.layouts)
        .enumerate()
        .map(|(n, (camera, layout))| {
            let images = LitImages::new(layout, &views[n], criteria, n);
            CameraBits::new(camera, layout, &images, (model.grid.voxels, D), criteria.tolerated[n])
        })
        .collect();
    let [nx, ny, nz] = blocks_along(&model.grid);
    let slabs: Vec<LitBlocks> = (0..nz)
        .into_par_iter()
        .map(|z| {
            let mut lit = LitBlocks::default();
            for y in 0..ny {
                for x in 0..nx {
                    let children = lit_children(&cameras, [x, y, z]);
                    if children != 0 {
                        lit.blocks.push(((z * ny + y) * nx + x) as u32);
                        lit.children.push(children);
                    }
                }
            }
            lit
        })
        .collect();
    LitBlocks {
        blocks: slabs.iter().flat_map(|lit| lit.blocks.iter().copied()).collect(),
        children: slabs.iter().flat_map(|lit| lit.children.iter().copied()).collect(),
    }
}

/// The children of a block that may be lit in all cameras and are visible in at least one.
fn lit_children<const W: usize>(cameras: &[CameraBits<W>], block: [usize; 3]) -> u8 {
    let mut possible = u8::MAX;
    for camera in cameras {
        possible &= camera.possible.children(block);
        // Most blocks are dark in the first camera.
        if possible == 0 {
            return 0;
        }
    }
    possible & cameras.iter().fold(0, |mask, camera| mask | camera.visible.children(block))
}

/// The lit pixels of a camera's selected views: for each row and each [`GROUP`] of microlenses, one
/// bit per lit microlens.
struct LitImages<'a> {
    /// The views' indices in the layout, ascending.
    views: &'a [usize],
    rows: usize,
    groups: usize,
    sets: Vec<u8>,
}

impl<'a> LitImages<'a> {
    fn new(
        layout: &ViewLayout,
        stack: &ViewStack,
        criteria: &'a HullCriteria,
        camera: usize,
    ) -> Self {
        let (views, dark_below) = (&criteria.selected[camera], criteria.dark_below[camera]);
        let (width, rows) = (layout.window.columns.len(), layout.window.rows.len());
        let groups = width.div_ceil(GROUP);
        let mut sets = vec![0u8; views.len() * rows * groups];
        for (&view, sets) in views.iter().zip(sets.chunks_exact_mut((rows * groups).max(1))) {
            let coverage = layout.views[view].coverage.as_ref();
            for (row, line) in stack.view(view).chunks_exact(width).enumerate() {
                let target = &mut sets[row * groups..][..groups];
                for (i, &value) in line.iter().enumerate() {
                    let open = coverage.map_or(1.0, |c| c[row * width + i]);
                    // A pixel less than half open is no evidence of darkness.
                    let lit = open <= 0.5 || value >= dark_below * open;
                    target[i / GROUP] |= u8::from(lit) << (i % GROUP);
                }
            }
        }
        Self { views, rows, groups, sets }
    }

    /// The images of the layout's views `of`.
    fn of_views(&self, of: Range<usize>) -> Range<usize> {
        let first_from = |start| self.views.partition_point(|&view| view < start);
        first_from(of.start)..first_from(of.end)
    }

    fn row(&self, image: usize, row: usize) -> &[u8] {
        &self.sets[(image * self.rows + row) * self.groups..][..self.groups]
    }
}

/// One camera's result for every voxel.
struct CameraBits<const W: usize> {
    possible: VoxelBits<W>,
    visible: VoxelBits<W>,
}

/// One bit per voxel: a [`Line`] for each strip of columns, tabulated depth and voxel along the rows.
struct VoxelBits<const W: usize> {
    axes: Axes,
    /// Depths per block with their own lines.
    layers: usize,
    /// Number of voxels along the depth and along the rows.
    depths: usize,
    rows: usize,
    lines: Vec<Line<W>>,
}

impl<const W: usize> VoxelBits<W> {
    /// The bits of a block's children; 0 outside the grid.
    fn children(&self, block: [usize; 3]) -> u8 {
        let (column, row) = (2 * block[self.axes.column], 2 * block[self.axes.row]);
        let (strip, column) = (column / (64 * W), column % (64 * W));
        let tabulated = self.layers * self.depths.div_ceil(2);
        let far_inside = 2 * block[self.axes.depth] + 1 < self.depths;
        let mut mask = 0;
        for (r, children) in self.axes.children().into_iter().enumerate() {
            if row + r >= self.rows {
                break;
            }
            let pairs = [0, self.layers - 1].map(|layer| {
                let depth = self.layers * block[self.axes.depth] + layer;
                let line = (strip * tabulated + depth) * self.rows + row + r;
                self.lines[line][column / 64] >> (column % 64) & 3
            });
            if pairs == [0, 0] {
                continue;
            }
            for (c, [near, far]) in children.into_iter().enumerate() {
                let [near_lit, far_lit] = pairs.map(|pair| pair >> c & 1 == 1);
                mask |= u8::from(near_lit) << near | u8::from(far_lit && far_inside) << far;
            }
        }
        mask
    }
}

impl<const W: usize> CameraBits<W> {
    fn new<const L: usize>(
        camera: &AlignedCamera<L>,
        layout: &ViewLayout,
        images: &LitImages<'_>,
        (voxels, layers): ([usize; 3], usize),
        tolerated: usize,
    ) -> Self {
        let (columns, rows) = (voxels[camera.axes.column], voxels[camera.axes.row]);
        let depths = camera.columns.depths();
        let slabs: Vec<[Vec<Line<W>>; 2]> = (0..depths * columns.div_ceil(64 * W))
            .into_par_iter()
            .map(|n| {
                let first_column = n / depths * 64 * W;
                let slab =
                    Slab { camera, layout, images, depth: n % depths, first_column, columns, rows };
                slab.evaluate::<W>(tolerated)
            })
            .collect();
        let collect = |n: usize| VoxelBits {
            axes: camera.axes,
            layers,
            depths: voxels[camera.axes.depth],
            rows,
            lines: slabs.iter().flat_map(|slab| slab[n].iter().copied()).collect(),
        };
        Self { possible: collect(0), visible: collect(1) }
    }
}
