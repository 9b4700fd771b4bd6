//! Penalty of a spline's divergence: its square in the middle of every cell between the nodes.

use super::super::{
    cell_divergence::{Cells, DIVERGENCE_DEVIATION},
    flow_nodes::FlowNodes,
    layout::Layout,
};

/// The penalty Σ (∇·B c)²/σ² over the middles of cells, for the coefficients c of three components, one after
/// the other.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Divergence {
    cells: Cells,
}

impl Divergence {
    /// Of splines whose components have coefficients in `layout`, on nodes `step_vox` apart.
    pub fn new(layout: Layout, step_vox: f64) -> Self {
        Self { cells: Cells { layout, step_vox } }
    }

    /// Adds half the gradient of the penalty at `coefficients` to `sum`: Dᵀ D c/σ². Cells without a corner in
    /// the `flow` have no penalty.
    pub fn add_forces(&self, coefficients: &[f64], sum: &mut [f64], flow: Option<&FlowNodes>) {
        let count = self.cells.layout.len();
        let part = |c: usize| &coefficients[c * count..][..count];
        let mut divergence = self.cells.divergence([part(0), part(1), part(2)]);
        for (n, value) in divergence.iter_mut().enumerate() {
            let is_penalised =
                self.cells.starts(n) && flow.is_none_or(|flow| self.touches(flow, n));
            *value *= if is_penalised {
                1.0 / (DIVERGENCE_DEVIATION * DIVERGENCE_DEVIATION)
            } else {
                0.0
            };
        }
        let (u, rest) = sum.split_at_mut(count);
        let (v, w) = rest.split_at_mut(count);
        self.cells.add_transposed(&divergence, [u, v, w]);
    }

    /// Whether a corner of the cell in the middle of the coefficients from `n` on is in the flow.
    fn touches(&self, flow: &FlowNodes, n: usize) -> bool {
        let layout = self.cells.layout;
        let corner = |bits: usize| -> usize {
            (0..3).map(|axis| (1 + (bits >> axis & 1)) * layout.stride(axis)).sum()
        };
        (0..8).any(|bits| flow.is_flow(n + corner(bits)))
    }

    /// The diagonal of [`Self::add_forces`] away from the faces, the same for all coefficients.
    pub fn diagonal(&self) -> f64 {
        self.cells.diagonal() / (DIVERGENCE_DEVIATION * DIVERGENCE_DEVIATION)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_stretched_flow_is_pulled_back_and_a_rotation_is_not() {
        let layout = Layout { nodes: [6; 3] };
        let divergence = Divergence::new(layout, 4.0);
        let place = |n: usize| layout.place(n).map(|n| n as f64);
        let count = layout.len();
        let forces = |of: fn([f64; 3]) -> [f64; 3]| {
            let field: Vec<f64> = (0..3 * count).map(|n| of(place(n % count))[n / count]).collect();
            let mut forces = vec![0.0; 3 * count];
            divergence.add_forces(&field, &mut forces, None);
            let work: f64 = forces.iter().zip(&field).map(|(force, value)| force * value).sum();
            (forces, work)
        };
        let (rotation, _) = forces(|[x, y, _]| [0.3 * y, -0.3 * x, 0.1]);
        assert!(rotation.iter().all(|force| force.abs() < 1e-6), "{rotation:?}");
        // 27 cells with a divergence of 0.4/4, over the square of the deviation.
        let (_, work) = forces(|[x, _, _]| [0.4 * x, 0.0, 0.0]);
        assert!((work - 27.0 * 100.0).abs() < 1e-6, "{work}");
    }
}
