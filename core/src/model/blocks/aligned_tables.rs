//! Tables for cameras along an axis of the grid, and the position of a block's taps in them.

use std::sync::Arc;

use super::{axis_table::PairTable, pair_tap::PairTap};
use crate::{
    lightfield::ViewLayout,
    model::{ViewId, VolumeGrid, camera::CameraView},
};

/// The separable footprint of every block in every view, from tables of up to `L` microlenses per
/// pair of voxels and axis, with `D` depths per block: 1 if both voxels may use the depth between
/// them, 2 if each needs its own (see [`DepthsPerBlock`]).
#[derive(Debug)]
pub struct AlignedModel<const L: usize, const D: usize> {
    pub(super) grid: VolumeGrid,
    pub(super) layouts: Vec<ViewLayout>,
    pub(super) cameras: Vec<AlignedCamera<L>>,
}

/// One camera's tables, and the orientation of its axes in the grid.
#[derive(Debug)]
pub(super) struct AlignedCamera<const L: usize> {
    pub axes: Axes,
    pub columns: Arc<PairTable<L>>,
    pub rows: Arc<PairTable<L>>,
    /// Pixels per row of the window.
    pub width: usize,
}

/// The grid axes (0, 1, 2 for x, y, z) along a camera's columns, rows and depth.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) struct Axes {
    pub column: usize,
    pub row: usize,
    pub depth: usize,
}

/// Indices of a block's taps in a camera's two tables.
#[derive(Debug, Clone, Copy)]
pub(super) struct Place {
    pub column: u32,
    pub row: u32,
}

impl Axes {
    pub fn of(view: &CameraView) -> Option<Self> {
        Some(Self { column: view.xi.along?, row: view.eta.along?, depth: view.depth.along? })
    }

    /// All orientations of a camera along the grid.
    pub const ALL: [Self; 6] = [
        Self { column: 0, row: 1, depth: 2 },
        Self { column: 0, row: 2, depth: 1 },
        Self { column: 1, row: 0, depth: 2 },
        Self { column: 1, row: 2, depth: 0 },
        Self { column: 2, row: 0, depth: 1 },
        Self { column: 2, row: 1, depth: 0 },
    ];

    /// For row r and column c of a block in the camera's orientation, the near and the far child.
    pub fn children(self) -> [[[usize; 2]; 2]; 2] {
        let (c, r, d) = (1 << self.column, 1 << self.row, 1 << self.depth);
        [[[0, d], [c, c + d]], [[r, r + d], [r + c, r + c + d]]]
    }
}

impl<const L: usize, const D: usize> AlignedModel<L, D> {
    /// The tables of one view: columns, rows, coverage.
    pub(super) fn view(&self, id: ViewId) -> ViewTables<'_, L> {
        let camera = &self.cameras[id.camera];
        let view = &self.layouts[id.camera].views[id.view];
        ViewTables {
            columns: camera.columns.of_view(view.k),
            column_pairs: camera.columns.pairs(),
            rows: camera.rows.of_view(view.l),
            row_pairs: camera.rows.pairs(),
            width: camera.width,
            coverage: view.coverage.as_deref(),
        }
    }
}

/// The tables used to project into one view.
pub(super) struct ViewTables<'a, const L: usize> {
    pub columns: &'a [PairTap<L>],
    /// Stride between depths.
    pub column_pairs: usize,
    pub rows: &'a [PairTap<L>],
    pub row_pairs: usize,
    pub width: usize,
    pub coverage: Option<&'a [f32]>,
}

impl<const L: usize> AlignedCamera<L> {
    /// The indices of the taps of a block's first layer of `layers`. Those of the next layer follow after one
    /// row of pairs.
    pub fn place(&self, block: [usize; 3], layers: usize) -> Place {
        let Axes { column, row, depth } = self.axes;
        Place {
            column: (layers * block[depth] * self.columns.pairs() + block[column]) as u32,
            row: (layers * block[depth] * self.rows.pairs() + block[row]) as u32,
        }
    }
}
