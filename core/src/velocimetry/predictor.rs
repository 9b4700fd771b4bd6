//! What a measured field says of the displacement anywhere.

use super::{VectorGrid, VelocityField, lattice::Lattice};

/// A field's displacement between its vectors, by cubic convolution, and beyond them, linearly.
pub struct Predictor {
    lattice: Lattice,
    grid: VectorGrid,
    voxel_mm: f64,
}

impl Predictor {
    /// Of all vectors of a field, those that are not valid too: what stands for them is the best guess.
    pub fn new(field: &VelocityField) -> Self {
        let lattice = Lattice {
            nodes: field.grid.vectors,
            first_vox: [0.0; 3],
            step_vox: 1.0,
            values: field.displacement_vox.clone(),
        };
        Self { lattice, grid: field.grid.clone(), voxel_mm: field.voxel_mm }
    }

    /// The displacement of the particle that is at `at_mm` in the middle of the pair, in mm.
    pub fn displacement_mm(&self, at_mm: [f64; 3]) -> [f64; 3] {
        let node = std::array::from_fn(|axis| {
            ((at_mm[axis] - self.grid.first_mm[axis]) / self.grid.spacing_mm) as f32
        });
        self.lattice.at(node).map(|vox| f64::from(vox) * self.voxel_mm)
    }
}
