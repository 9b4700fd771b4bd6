//! A fitted field: values, derivatives, uncertainty.

use super::{
    super::nodes::Nodes,
    lanes::{LANES, Vectors},
};

/// A displacement field as a sum of cubic B-splines, with its standard uncertainty, in voxels.
#[derive(Debug, Clone, PartialEq)]
pub struct SplineField {
    nodes: Nodes,
    coefficients: Vec<[f32; 3]>,
    /// Variance of the field at each coefficient's place.
    variance: Vec<[f32; 3]>,
    /// Penalty of third differences, per component.
    pub stiffness: [f32; 3],
}

impl SplineField {
    /// From a field in lane 0 and samples of its error in the others.
    pub fn new(nodes: Nodes, lanes: &Vectors, stiffness: [f32; 3]) -> Self {
        let coefficients =
            (0..nodes.layout.len()).map(|n| std::array::from_fn(|c| lanes[c][n][0])).collect();
        let variance = variances(&nodes, lanes);
        Self { nodes, coefficients, variance, stiffness }
    }

    /// The same field with variances multiplied by these factors at the coefficients' positions.
    pub fn widened(mut self, factors: &[[f32; 3]]) -> Self {
        for (variance, factors) in self.variance.iter_mut().zip(factors) {
            for (variance, factor) in variance.iter_mut().zip(factors) {
                *variance *= factor;
            }
        }
        self
    }

    /// The vector at a place, or at the nearest one where the field was fitted.
    pub fn value(&self, at_vox: [f32; 3]) -> [f32; 3] {
        self.nodes.taps(at_vox).gather(self.nodes.layout, &self.coefficients)
    }

    /// Derivatives of the vector along x, y, z, per voxel: `[along][component]`.
    pub fn gradient(&self, at_vox: [f32; 3]) -> [[f32; 3]; 3] {
        std::array::from_fn(|along| {
            let taps = self.nodes.derivative_taps(at_vox, along);
            taps.gather(self.nodes.layout, &self.coefficients)
        })
    }

    /// Standard uncertainty of the vector along x, y, z.
    pub fn uncertainty_vox(&self, at_vox: [f32; 3]) -> [f32; 3] {
        self.variance[self.nodes.nearest(at_vox)].map(f32::sqrt)
    }

    /// Volume between the nodes, in voxel³.
    pub fn volume_vox3(&self) -> f32 {
        (0..3).map(|axis| self.nodes.cells(axis) as f32 * self.nodes.step_vox).product()
    }
}

/// Local mean square of the samples of the error around each coefficient.
fn variances(nodes: &Nodes, lanes: &Vectors) -> Vec<[f32; 3]> {
    let layout = nodes.layout;
    let mut variance: Vec<[f32; 3]> = (0..layout.len())
        .map(|n| {
            let taps = nodes.taps(nodes.place_vox(n));
            std::array::from_fn(|c| {
                let [_, errors @ ..] = taps.gather(layout, &lanes[c]);
                errors.iter().map(|e| e * e).sum::<f32>() / (LANES - 1) as f32
            })
        })
        .collect();
    for axis in 0..3 {
        let (s, along) = (layout.stride(axis), layout.nodes[axis]);
        let from = variance.clone();
        for (n, value) in variance.iter_mut().enumerate() {
            let place = n / s % along;
            let below = if place > 0 { from[n - s] } else { from[n] };
            let above = if place + 1 < along { from[n + s] } else { from[n] };
            for c in 0..3 {
                value[c] = (below[c] + 2.0 * from[n][c] + above[c]) / 4.0;
            }
        }
    }
    variance
}
