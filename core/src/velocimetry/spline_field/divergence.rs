//! Penalty of a field's divergence: its square in the middle of every cell between the nodes.

use super::{
    super::{cell_divergence::Cells, layout::Layout},
    lanes::{LANES, Vectors},
    noise::Noise,
};

/// The penalty Σ μ (∇·c)² over half-node points, of a field that has a vector for each component.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Divergence {
    /// Node spacing, in voxels.
    pub step_vox: f32,
    /// μ, in 1/(voxel/voxel)².
    pub stiffness: f32,
}

impl Divergence {
    /// Adds sign · ∇·ᵀ μ (s − ∇·c); `noise` gives s √μ.
    pub fn add_forces(
        &self,
        layout: Layout,
        field: &Vectors,
        noise: Option<&Noise>,
        sign: f32,
        sums: &mut Vectors,
    ) {
        let cells = Cells { layout, step_vox: f64::from(self.step_vox) };
        let mut force = cells.divergence(std::array::from_fn(|c| &field[c][..]));
        let root = self.stiffness.sqrt();
        for (n, force) in force.iter_mut().enumerate() {
            let target = noise.map_or([0.0; LANES], |noise| noise.of_divergence(n));
            let starts = cells.starts(n);
            for l in 0..LANES {
                let asked = sign * (root * target[l] - self.stiffness * force[l]);
                force[l] = if starts { asked } else { 0.0 };
            }
        }
        let [u, v, w] = &mut sums[..] else { return };
        cells.add_transposed(&force, [u, v, w]);
    }
}
