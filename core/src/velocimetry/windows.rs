//! Interrogation windows on a regular lattice, and the cells that they cover.

use super::{lattice::Lattice, raster::Raster};

/// Cubic windows on a regular lattice, in cells of `cell_vox` voxels.
#[derive(Debug, Clone, PartialEq)]
pub struct Windows {
    /// Windows along x, y, z.
    pub nodes: [usize; 3],
    /// Edge of a window, in cells.
    pub edge: usize,
    /// Cells from one window to the next.
    pub step: usize,
    /// Edge of a cell, in voxels.
    pub cell_vox: f32,
    /// Centre of the first window, in voxels.
    pub first_vox: [f32; 3],
}

/// Values are summed over x in groups of this many cells, so rows are a multiple of it.
pub const LANES: usize = 8;

impl Windows {
    /// A field of zero displacement on the windows' centres.
    pub fn at_rest(&self) -> Lattice {
        Lattice {
            nodes: self.nodes,
            first_vox: self.first_vox,
            step_vox: self.step as f32 * self.cell_vox,
            values: vec![[0.0; 3]; self.nodes.iter().product()],
        }
    }

    /// Cells from the first window's corner to the last window's end.
    pub fn span(&self, axis: usize) -> usize {
        (self.nodes[axis] - 1) * self.step + self.edge
    }

    /// Cells under the windows and `border` more on every side. Rows are longer, so that whole
    /// groups of [`LANES`] cells fit.
    pub fn raster(&self, border: usize) -> Raster {
        let to_centre = (self.edge as f32 - 1.0) / 2.0 + border as f32;
        let mut cells = std::array::from_fn(|axis| self.span(axis) + 2 * border);
        cells[0] = self.span(0).next_multiple_of(LANES) + 2 * border;
        Raster {
            cells,
            first_vox: self.first_vox.map(|centre| centre - to_centre * self.cell_vox),
            cell_vox: self.cell_vox,
        }
    }
}
