//! Arrangement of a block's voxels relative to the microlenses of a camera.

use nalgebra::Point3;

use crate::model::mapped_optics::MappedOptics;
use crate::model::{VolumeGrid, blocks::aligned_tables::Axes, footprint::RayMap};

/// Largest displacement of a shadow by sharing a position, relative to the source's edge.
const SHARED_PLACE_TOLERANCE: f64 = 1.0 / 16.0;

/// Displacement that is always allowed, in microlenses: a step of the tables.
const MIN_TOLERANCE: f64 = 1.0 / 64.0;

/// Number of separate positions per block. Each has its own address in the tables.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub(super) enum Layers {
    /// The block's centre for all voxels, which form pairs along columns and rows. If the pairs at
    /// its two depths are too far from each other, but by the same distance in all views, tables
    /// hold both.
    One,
    /// One for each of its two depths.
    Two,
    /// One per voxel.
    Eight,
}

/// Orientation of the grid relative to a camera's array.
#[derive(Debug, Clone)]
pub(super) struct Arrangement {
    /// The grid axes approximately along the array's columns and rows, and in depth.
    pub axes: Axes,
    pub layers: Layers,
    /// Distance between the voxels of a pair, along columns and rows, in microlenses for a ray map
    /// with b = 1; 0 without pairs.
    pub pair_step: [f64; 2],
    /// Distance between a pair and the one behind it, likewise; 0 if they share their position.
    pub depth_step: [f64; 2],
    /// Lowest and highest depth of the grid, for columns and rows.
    pub depths_mm: [[f64; 2]; 2],
}

/// Changes between neighbouring voxels along each axis of the grid.
struct Slopes {
    /// Of the position along columns and rows, in microlenses.
    place: [[f64; 3]; 2],
    /// Of the shadow of a ray through the pupil's edge, minus that of the central ray.
    edge: [[f64; 3]; 2],
}

impl Arrangement {
    pub fn new(optics: &MappedOptics, grid: &VolumeGrid, footprint_mm: f64) -> Self {
        let slopes = Slopes::new(optics, grid);
        let apart = |axes: &Axes| (slopes.place[0][axes.column] * slopes.place[1][axes.row]).abs();
        let axes = Axes::ALL
            .into_iter()
            .max_by(|a, b| apart(a).total_cmp(&apart(b)))
            .unwrap_or(Axes::ALL[0]);
        let position = RayMap::at_depth(&optics.optics, 0.0).position;
        let pitch_mm = optics.pitch_mm();
        let tolerance = [0, 1].map(|n| {
            let source = footprint_mm * position.abs() / pitch_mm[n];
            (SHARED_PLACE_TOLERANCE * source).max(MIN_TOLERANCE)
        });
        let layers = slopes.layers(axes, tolerance);
        let pair_step = match layers {
            Layers::Eight => [0.0; 2],
            _ => [slopes.place[0][axes.column], slopes.place[1][axes.row]],
        };
        let [pair_step, depth_step] = [pair_step, slopes.depth_step(axes, layers, tolerance)]
            .map(|steps| steps.map(|step| step / position));
        Self { axes, layers, pair_step, depth_step, depths_mm: depths_mm(optics, grid) }
    }

    /// Whether tables have two pairs per block, one for each of its depths.
    pub fn has_quads(&self) -> bool {
        self.depth_step != [0.0; 2]
    }
}

impl Layers {
    pub fn count(self) -> usize {
        match self {
            Self::One => 1,
            Self::Two => 2,
            Self::Eight => 8,
        }
    }

    /// Offsets of a block's layers, in voxels from the block's first voxel.
    pub fn offsets(self, axes: Axes) -> Vec<[f64; 3]> {
        let at_depth = |depth: f64| {
            let mut offset = [0.5; 3];
            offset[axes.depth] = depth;
            offset
        };
        match self {
            Self::One => vec![[0.5; 3]],
            Self::Two => vec![at_depth(0.0), at_depth(1.0)],
            Self::Eight => {
                (0..8).map(|child| [0, 1, 2].map(|axis| (child >> axis & 1) as f64)).collect()
            }
        }
    }
}

impl Slopes {
    fn new(optics: &MappedOptics, grid: &VolumeGrid) -> Self {
        let middle = Point3::from(grid.centre_mm);
        let radius = optics.pupil_radius();
        let mut slopes = Self { place: [[0.0; 3]; 2], edge: [[0.0; 3]; 2] };
        for axis in 0..3 {
            let [before, after] = [-0.5, 0.5].map(|step| {
                let mut place = middle;
                place[axis] += step * grid.voxel_mm;
                optics.project(&place)
            });
            for (n, radius) in radius.iter().enumerate() {
                slopes.place[n][axis] = after.place[n] - before.place[n];
                slopes.edge[n][axis] = (after.parallax[n] - before.parallax[n]) * radius;
            }
        }
        slopes
    }

    /// The fewest positions that displace no shadow by more than `tolerance`: a voxel is half a
    /// step from a shared position.
    fn layers(&self, axes: Axes, tolerance: [f64; 2]) -> Layers {
        let exceeds = |shift: [f64; 2]| (0..2).any(|n| shift[n] / 2.0 > tolerance[n]);
        let (place, edge) = (&self.place, &self.edge);
        let Axes { column, row, depth } = axes;
        let all = |axis: usize| [0, 1].map(|n| place[n][axis].abs() + edge[n][axis].abs());
        // Along its own axis, the voxels of a pair have separate positions.
        let along_column = [edge[0][column].abs(), all(column)[1]];
        let along_row = [all(row)[0], edge[1][row].abs()];
        if exceeds(along_column) || exceeds(along_row) {
            Layers::Eight
        } else if exceeds(edge.map(|edge| edge[depth].abs())) {
            Layers::Two
        } else {
            Layers::One
        }
    }

    /// Distance between the two depths of a block with one position, in microlenses; 0 if they may
    /// share it.
    fn depth_step(&self, axes: Axes, layers: Layers, tolerance: [f64; 2]) -> [f64; 2] {
        let step = [0, 1].map(|n| self.place[n][axes.depth]);
        let shift = [0, 1].map(|n| step[n].abs() + self.edge[n][axes.depth].abs());
        let shared = (0..2).all(|n| shift[n] / 2.0 <= tolerance[n]);
        if layers == Layers::One && !shared { step } else { [0.0; 2] }
    }
}

/// Lowest and highest depths of the grid's voxels, with a margin of one voxel.
fn depths_mm(optics: &MappedOptics, grid: &VolumeGrid) -> [[f64; 2]; 2] {
    let mut range = [[f64::INFINITY, f64::NEG_INFINITY]; 2];
    for n in 0..27 {
        let steps = [n % 3, n / 3 % 3, n / 9];
        let world: [f64; 3] = std::array::from_fn(|axis| {
            let last = grid.voxels[axis] as f64 - 1.0;
            grid.coordinate_mm(axis, steps[axis] as f64 / 2.0 * last)
        });
        let depth_mm = optics.project(&Point3::from(world)).depth_mm;
        for (range, depth) in range.iter_mut().zip(depth_mm) {
            *range = [range[0].min(depth - grid.voxel_mm), range[1].max(depth + grid.voxel_mm)];
        }
    }
    range
}
