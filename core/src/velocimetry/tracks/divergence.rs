//! Penalty of a spline's divergence: its square in the middle of every cell between the nodes (Gesemann et
//! al., From noisy particle tracks to velocity, acceleration and pressure fields using B-splines and
//! penalties, 18th Int. Symp. Lisbon, 2016).

use super::super::{
    b_spline::{HALFWAY, HALFWAY_SLOPES},
    flow_nodes::FlowNodes,
    layout::Layout,
};

/// Standard deviation of the divergence in an incompressible flow, in voxel per voxel. It is not zero, because
/// displacements are chords of curved paths, splines only approximate short waves, and errors of neighbouring
/// particles are correlated.
const DEVIATION: f64 = 0.01;

/// The penalty Σ (∇·B c)²/σ² over the middles of cells, for the coefficients c of three components, one after
/// the other.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Divergence {
    /// The coefficients of one component.
    pub layout: Layout,
    /// Node spacing, in voxels.
    pub step_vox: f64,
}

impl Divergence {
    /// Adds half the gradient of the penalty at `coefficients` to `sum`: Dᵀ D c/σ². Cells without a corner in
    /// the `flow` have no penalty.
    pub fn add_forces(&self, coefficients: &[f64], sum: &mut [f64], flow: Option<&FlowNodes>) {
        let count = self.layout.len();
        let mut divergence = vec![0.0; count];
        for (c, part) in coefficients.chunks(count).enumerate() {
            let mut along = part.to_vec();
            for axis in 0..3 {
                gather(self.layout.stride(axis), self.weights(c, axis), &mut along);
            }
            divergence.iter_mut().zip(along).for_each(|(sum, part)| *sum += part);
        }
        for (n, value) in divergence.iter_mut().enumerate() {
            let is_cell = (0..3).all(|axis| self.layout.starts(axis, n))
                && flow.is_none_or(|flow| self.touches(flow, n));
            *value *= if is_cell { 1.0 / (DEVIATION * DEVIATION) } else { 0.0 };
        }
        for (c, sum) in sum.chunks_mut(count).enumerate() {
            let mut part = divergence.clone();
            for axis in 0..3 {
                scatter(self.layout.stride(axis), self.weights(c, axis), &mut part);
            }
            sum.iter_mut().zip(part).for_each(|(sum, part)| *sum += part);
        }
    }

    /// Whether a corner of the cell in the middle of the coefficients from `n` on is in the flow.
    fn touches(&self, flow: &FlowNodes, n: usize) -> bool {
        let corner = |bits: usize| -> usize {
            (0..3).map(|axis| (1 + (bits >> axis & 1)) * self.layout.stride(axis)).sum()
        };
        (0..8).any(|bits| flow.is_flow(n + corner(bits)))
    }

    /// The diagonal of [`Self::add_forces`] away from the faces, the same for all coefficients.
    pub fn diagonal(&self) -> f64 {
        let square = |weights: [f64; 4]| weights.iter().map(|w| w * w).sum::<f64>();
        (0..3).map(|axis| square(self.weights(0, axis))).product::<f64>() / (DEVIATION * DEVIATION)
    }

    /// Weights along `axis` of component `c`.
    fn weights(&self, c: usize, axis: usize) -> [f64; 4] {
        if axis == c { HALFWAY_SLOPES.map(|slope| slope / self.step_vox) } else { HALFWAY }
    }
}

/// Each value replaced by the weighted sum of itself and the three after it, `s` apart; what is beyond the
/// end counts as zero.
fn gather(s: usize, weights: [f64; 4], values: &mut [f64]) {
    for n in 0..values.len() {
        let taps = weights.iter().enumerate();
        values[n] = taps.filter_map(|(k, w)| values.get(n + k * s).map(|v| w * v)).sum();
    }
}

/// The transpose of [`gather`].
fn scatter(s: usize, weights: [f64; 4], values: &mut [f64]) {
    for n in (0..values.len()).rev() {
        let taps = weights.iter().enumerate().take_while(|(k, _)| k * s <= n);
        values[n] = taps.map(|(k, w)| w * values[n - k * s]).sum();
    }
}

#[cfg(test)]
mod tests {
    use rand::{RngExt, SeedableRng};
    use rand_pcg::Pcg64Mcg;

    use super::*;

    /// The divergence of every cell written out, squared and derived.
    #[test]
    fn forces_are_those_of_the_sum_that_they_stand_for() {
        let divergence = Divergence { layout: Layout { nodes: [5, 6, 4] }, step_vox: 4.0 };
        let (layout, count) = (divergence.layout, divergence.layout.len());
        let mut random = Pcg64Mcg::seed_from_u64(3);
        let field: Vec<f64> = (0..3 * count).map(|_| random.random::<f64>() - 0.5).collect();
        let mut expected = vec![0.0; 3 * count];
        let mut diagonal = vec![0.0; 3 * count];
        for cell in (0..count).filter(|&n| (0..3).all(|axis| layout.starts(axis, n))) {
            let mut terms = Vec::new();
            for c in 0..3 {
                for tap in 0..64usize {
                    let at = [tap % 4, tap / 4 % 4, tap / 16];
                    let offset: usize = (0..3).map(|axis| at[axis] * layout.stride(axis)).sum();
                    let weight: f64 = (0..3)
                        .map(|axis| {
                            if axis == c {
                                HALFWAY_SLOPES[at[axis]] / 4.0
                            } else {
                                HALFWAY[at[axis]]
                            }
                        })
                        .product();
                    terms.push((c * count + cell + offset, weight));
                }
            }
            let value: f64 = terms.iter().map(|&(n, weight)| weight * field[n]).sum();
            for (n, weight) in terms {
                expected[n] += weight * value / (DEVIATION * DEVIATION);
                diagonal[n] += weight * weight / (DEVIATION * DEVIATION);
            }
        }
        let mut found = vec![0.0; 3 * count];
        divergence.add_forces(&field, &mut found, None);
        let largest = expected.iter().fold(0.0f64, |most, value| most.max(value.abs()));
        for (found, expected) in found.iter().zip(&expected) {
            assert!((found - expected).abs() < 1e-9 * largest, "{found} {expected}");
        }
        assert!(diagonal.iter().all(|own| *own <= 1.0001 * divergence.diagonal()));
    }

    #[test]
    fn a_rotation_has_none() {
        let divergence = Divergence { layout: Layout { nodes: [5; 3] }, step_vox: 4.0 };
        let place = |n: usize| divergence.layout.place(n).map(|n| n as f64);
        let count = divergence.layout.len();
        let rotation = |n: usize| {
            let [x, y, _] = place(n % count);
            [0.3 * y, -0.3 * x, 0.1][n / count]
        };
        let field: Vec<f64> = (0..3 * count).map(rotation).collect();
        let mut forces = vec![0.0; 3 * count];
        divergence.add_forces(&field, &mut forces, None);
        assert!(forces.iter().all(|force| force.abs() < 1e-6), "{forces:?}");
    }
}
