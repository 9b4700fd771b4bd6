//! Photo-hull for arbitrarily oriented cameras.
//!
//! For one camera, tile by tile ([`super::tile`]); tiles are small enough that a view maps
//! microlenses onto their voxels linearly.

use rayon::prelude::*;

use super::{
    MappedModel,
    lens_phases::LensPhases,
    lit_bits::LitBits,
    places::ViewAddresses,
    support::Support,
    tile::{TileResult, Views},
    tile_place::{LENSES, MAX_BITS, MAX_LINES, MAX_THICKNESS, TilePlace},
};
use crate::{
    lightfield::ViewStack,
    model::{
        HullCriteria, LitBlocks, VolumeGrid,
        blocks::{aligned_tables::Axes, blocks_along},
        mapped_optics::ProjectedPoint,
    },
};

/// Largest deviation of a tile's voxel from its linear position in any view, in microlenses.
/// Supports are widened by the actual deviation.
const MAX_DEVIATION: f64 = 0.04;

/// Edge of the smallest tile, in voxels.
const MIN_EDGE: usize = 8;

/// See [`crate::model::BlockModel::lit`].
pub(super) fn lit_blocks<const L: usize>(
    model: &MappedModel<L>,
    views: &[ViewStack],
    criteria: &HullCriteria,
) -> LitBlocks {
    let verdicts: Vec<CameraResult> = (0..model.cameras.len())
        .map(|n| CameraResult::new(model, n, &views[n], criteria))
        .collect();
    let mut lit = LitBlocks::default();
    for block in 0..blocks_along(&model.grid).into_iter().product() {
        let possible = verdicts.iter().fold(u8::MAX, |all, camera| all & camera.possible[block]);
        if possible == 0 {
            continue;
        }
        let children =
            possible & verdicts.iter().fold(0, |any, camera| any | camera.visible[block]);
        if children != 0 {
            lit.blocks.push(block as u32);
            lit.children.push(children);
        }
    }
    lit
}

/// One camera's result for every voxel: one bit per child of every block.
struct CameraResult {
    possible: Vec<u8>,
    visible: Vec<u8>,
}

/// Voxels `first..first + count` along columns and rows, in one slab of a tile's thickness.
#[derive(Debug, Clone, Copy)]
struct Span {
    first: [usize; 2],
    count: [usize; 2],
    slab: usize,
}

/// A camera's tiles.
struct Tiles<'a> {
    grid: &'a VolumeGrid,
    axes: Axes,
    /// Number of depths of a tile, and of depths that are evaluated as one.
    thickness: usize,
    layer_thickness: usize,
    camera: Camera<'a>,
}

/// Properties of a camera that do not depend on the width of its tables.
#[derive(Clone, Copy)]
pub(super) struct Camera<'a> {
    pub project: &'a (dyn Fn([f64; 3]) -> ProjectedPoint + Sync),
    pub support: &'a (dyn Fn([f64; 2]) -> Support + Sync),
    pub pupil_radius: [f64; 2],
}

impl CameraResult {
    fn new<const L: usize>(
        model: &MappedModel<L>,
        number: usize,
        stack: &ViewStack,
        criteria: &HullCriteria,
    ) -> Self {
        let (camera, layout) = (&model.cameras[number], &model.layouts[number]);
        let bits = LitBits::new(layout, stack, criteria, number);
        let addresses = |view: usize| camera.view(&layout.views[view]);
        let selected: Vec<ViewAddresses> =
            criteria.selected[number].iter().copied().map(addresses).collect();
        // Views near the pupil's middle contain nearly all visible voxels.
        let from_middle = |view: &ViewAddresses| view.pupil[0].hypot(view.pupil[1]);
        let mut all: Vec<ViewAddresses> = (0..layout.views.len()).map(addresses).collect();
        all.sort_by(|a, b| from_middle(a).total_cmp(&from_middle(b)));
        let phases = LensPhases::new(&addresses(0), &camera.optics.window);
        let views = Views {
            selected: &selected,
            all: &all,
            bits: &bits,
            phases: &phases,
            tolerated: criteria.tolerated[number],
        };
        let project = |index: [f64; 3]| camera.project(&model.grid, index);
        let support = |depth_mm: [f64; 2]| camera.support(depth_mm);
        let mut tiles = Tiles {
            grid: &model.grid,
            axes: camera.axes,
            thickness: 1,
            layer_thickness: 1,
            camera: Camera {
                project: &project,
                support: &support,
                pupil_radius: camera.pupil_radius(),
            },
        };
        let most = criteria.displacement[number];
        // Layers share the bits, so they differ little along the columns.
        tiles.thickness = tiles.largest_thickness(MAX_THICKNESS, 0, most);
        tiles.layer_thickness = tiles.largest_thickness(tiles.thickness, 1, most);
        let evaluated: Vec<(Span, TileResult)> = tiles
            .spans()
            .into_par_iter()
            .flat_map_iter(|span| tiles.straight(span))
            .map(|(span, place, support)| (span, place.evaluate(&views, &support)))
            .collect();
        tiles.collect(evaluated)
    }
}

impl Tiles<'_> {
    /// All tiles, as large as possible.
    fn spans(&self) -> Vec<Span> {
        let Axes { column, row, depth } = self.axes;
        let most_lenses = LENSES as f64 - self.lenses_beyond();
        let [lenses_per_bit, lenses_per_line] =
            [column, row].map(|axis| self.lenses_per_voxel(axis)[0]);
        let mut lines = MAX_LINES;
        // If lines are inclined to the columns, fewer lines allow more bits.
        while lines > MIN_EDGE && lines as f64 * lenses_per_line > most_lenses / 3.0 {
            lines /= 2;
        }
        let room = most_lenses - lines as f64 * lenses_per_line;
        let bits = room / lenses_per_bit.max(1e-3);
        let bits = even(bits as usize / 2 * 2).clamp(MIN_EDGE, MAX_BITS);
        let slabs = self.grid.voxels[depth].div_ceil(self.thickness);
        let columns = parts(self.grid.voxels[column], bits);
        let rows = parts(self.grid.voxels[row], lines);
        let mut spans = Vec::new();
        for slab in 0..slabs {
            for &(first_row, lines) in &rows {
                for &(first_column, bits) in &columns {
                    let (first, count) = ([first_column, first_row], [bits, lines]);
                    spans.push(Span { first, count, slab });
                }
            }
        }
        spans
    }

    /// The largest thickness, of at most `thickness`, that displaces no voxel by more than `most`
    /// microlenses along columns (0) or rows (1).
    fn largest_thickness(&self, mut thickness: usize, along: usize, most: f64) -> usize {
        let per_voxel = self.lenses_per_voxel(self.axes.depth)[along];
        let displacement = |thickness: usize| (thickness as f64 - 1.0) / 2.0 * per_voxel;
        while thickness > 1 && displacement(thickness) > most {
            thickness /= 2;
        }
        thickness
    }

    /// Fractional index of the grid's middle.
    fn middle(&self) -> [f64; 3] {
        self.grid.voxels.map(|n| (n as f64 - 1.0) / 2.0)
    }

    /// Distance between neighbouring voxels along an axis of the grid, in microlenses along the
    /// array's columns and rows, in the view where it is largest.
    fn lenses_per_voxel(&self, axis: usize) -> [f64; 2] {
        let middle = self.middle();
        let mut next = middle;
        next[axis] += 1.0;
        let (here, there) = ((self.camera.project)(middle), (self.camera.project)(next));
        [0, 1].map(|n| {
            let parallax = (there.parallax[n] - here.parallax[n]).abs();
            (there.place[n] - here.place[n]).abs() + parallax * self.camera.pupil_radius[n]
        })
    }

    /// Number of microlenses of a row beyond a tile's voxels that its light reaches.
    fn lenses_beyond(&self) -> f64 {
        let middle = self.middle();
        let beside = [0.0, 1.0].map(|end| {
            let mut index = middle;
            index[self.axes.depth] *= 2.0 * end;
            let support = (self.camera.support)((self.camera.project)(index).depth_mm);
            2.0 * (support.reach[0] + support.phase[0])
        });
        let displacement = self.lenses_per_voxel(self.axes.depth)[0] * self.half_thickness();
        // One more for the row's first microlens, which has an arbitrary offset to the tile, and
        // one for the growth of the reach in the grid's corners.
        beside[0].max(beside[1]) + 2.0 * displacement + 2.0
    }

    /// A tile, split if necessary into parts with linear positions.
    fn straight(&self, span: Span) -> Vec<(Span, TilePlace, Support)> {
        let (place, deviation, depths_mm) = self.place(&span);
        let longest = usize::from(span.count[1] > span.count[0]);
        if deviation > MAX_DEVIATION && span.count[longest] > MIN_EDGE {
            let halves = parts(span.count[longest], even(span.count[longest].div_ceil(2)));
            let part = |(first, count): (usize, usize)| {
                let mut part = span;
                part.first[longest] += first;
                part.count[longest] = count;
                part
            };
            return halves.into_iter().flat_map(|half| self.straight(part(half))).collect();
        }
        let [one, other] = depths_mm.map(|depth_mm| (self.camera.support)(depth_mm));
        let mut support = one.union(&other);
        support.reach.iter_mut().for_each(|reach| *reach += deviation);
        vec![(span, place, support)]
    }

    /// Fractional grid index of a position in a tile, in the middle of its thickness.
    fn index(&self, span: &Span, voxel: [f64; 2]) -> [f64; 3] {
        let mut index = [0.0; 3];
        index[self.axes.column] = span.first[0] as f64 + voxel[0];
        index[self.axes.row] = span.first[1] as f64 + voxel[1];
        index[self.axes.depth] = (span.slab * self.thickness) as f64 + self.half_thickness();
        index
    }

    /// Distance from the middle of a tile's thickness to its outermost voxels, in voxels.
    fn half_thickness(&self) -> f64 {
        (self.thickness as f64 - 1.0) / 2.0
    }

    /// The linear positions of a tile's voxels, the largest deviation of a corner in any view, and
    /// the depths of its outermost voxels in thickness, for columns and rows.
    fn place(&self, span: &Span) -> (TilePlace, f64, [[f64; 2]; 2]) {
        let half = span.count.map(|count| (count as f64 - 1.0) / 2.0);
        let project = |steps: [f64; 2]| {
            (self.camera.project)(self.index(span, [0, 1].map(|n| half[n] * (1.0 + steps[n]))))
        };
        let middle = project([0.0; 2]);
        // For a single voxel the distance is arbitrary.
        let width = half.map(|half| 2.0 * half.max(0.25));
        let ends = [
            [project([-1.0, 0.0]), project([1.0, 0.0])],
            [project([0.0, -1.0]), project([0.0, 1.0])],
        ];
        let slope = |value: &dyn Fn(&ProjectedPoint) -> [f64; 2]| -> [[f64; 2]; 2] {
            [0, 1]
                .map(|n| [0, 1].map(|v| (value(&ends[v][1])[n] - value(&ends[v][0])[n]) / width[v]))
        };
        let outermost = [-1.0, 1.0].map(|side| {
            let mut index = self.index(span, half);
            index[self.axes.depth] += side * self.half_thickness();
            (self.camera.project)(index)
        });
        let to_outermost = |value: &dyn Fn(&ProjectedPoint) -> [f64; 2]| {
            [0, 1].map(|n| (value(&outermost[1])[n] - value(&outermost[0])[n]) / 2.0)
        };
        let place = TilePlace {
            place: middle.place,
            to_outermost: to_outermost(&|projected| projected.place),
            parallax_to_outermost: to_outermost(&|projected| projected.parallax),
            layers: self.thickness / self.layer_thickness,
            layer_share: (self.layer_thickness as f64 - 1.0)
                / (self.thickness as f64 - 1.0).max(1.0),
            by_voxel: slope(&|projected| projected.place),
            parallax: middle.parallax,
            parallax_by_voxel: slope(&|projected| projected.parallax),
            middle: half,
            bits: span.count[0],
            lines: span.count[1],
        };
        let deviation = [[-1.0, -1.0], [-1.0, 1.0], [1.0, -1.0], [1.0, 1.0]]
            .into_iter()
            .map(|steps| {
                self.deviation(&place, &project(steps), [steps[0] * half[0], steps[1] * half[1]])
            })
            .fold(0.0, f64::max);
        (place, deviation, outermost.map(|projected| projected.depth_mm))
    }

    /// Deviation of a point from its linear position, in the view where it is largest.
    fn deviation(&self, place: &TilePlace, projected: &ProjectedPoint, voxel: [f64; 2]) -> f64 {
        let of = |n: usize| {
            let linear = |middle: [f64; 2], slope: [[f64; 2]; 2]| {
                middle[n] + slope[n][0] * voxel[0] + slope[n][1] * voxel[1]
            };
            let beside = projected.place[n] - linear(place.place, place.by_voxel);
            let parallax = projected.parallax[n] - linear(place.parallax, place.parallax_by_voxel);
            beside.abs() + parallax.abs() * self.camera.pupil_radius[n]
        };
        of(0).max(of(1))
    }

    /// Combines the results of all tiles, block by block.
    fn collect(&self, evaluated: Vec<(Span, TileResult)>) -> CameraResult {
        let blocks: usize = blocks_along(self.grid).into_iter().product();
        let mut verdict = CameraResult { possible: vec![0; blocks], visible: vec![0; blocks] };
        for (span, tile) in &evaluated {
            self.add(span, &tile.possible, &mut verdict.possible);
            self.add(span, &tile.visible, &mut verdict.visible);
        }
        verdict
    }

    /// Adds a tile's voxels to the blocks' children.
    fn add(&self, span: &Span, lines: &[u64], children: &mut [u8]) {
        for (layer, lines) in lines.chunks_exact(span.count[1]).enumerate() {
            let first = span.slab * self.thickness + layer * self.layer_thickness;
            self.add_layer(span, first, lines, children);
        }
    }

    /// Adds the voxels of a layer whose first depth is `first`.
    fn add_layer(&self, span: &Span, first: usize, lines: &[u64], children: &mut [u8]) {
        let Axes { column, row, depth } = self.axes;
        let strides = {
            let [nx, ny, _] = blocks_along(self.grid);
            [1, nx, nx * ny]
        };
        let depths = first..(first + self.layer_thickness).min(self.grid.voxels[depth]);
        // Of each block in the layer: its index along the depth and its children there.
        let mut layers: Vec<(usize, u8)> = Vec::new();
        for d in depths {
            let children = 1u8 << ((d % 2) << depth);
            match layers.last_mut() {
                Some((block, before)) if *block == d / 2 => *before |= children,
                _ => layers.push((d / 2, children)),
            }
        }
        for (line, &bits) in lines.iter().enumerate() {
            let r = span.first[1] + line;
            let mut bits = bits;
            while bits != 0 {
                let c = span.first[0] + bits.trailing_zeros() as usize;
                bits &= bits - 1;
                let block = c / 2 * strides[column] + r / 2 * strides[row];
                let child = ((c % 2) << column) + ((r % 2) << row);
                for &(at_depth, of_depth) in &layers {
                    children[block + at_depth * strides[depth]] |= of_depth << child;
                }
            }
        }
    }
}

fn even(count: usize) -> usize {
    count.div_ceil(2) * 2
}

/// Divides `count` voxels into as few and as equal parts of at most `most` as possible, all but the
/// last even: start and count of each.
fn parts(count: usize, most: usize) -> Vec<(usize, usize)> {
    let each = even(count.div_ceil(count.div_ceil(most.max(2)).max(1))).max(2);
    (0..count).step_by(each).map(|first| (first, each.min(count - first))).collect()
}
