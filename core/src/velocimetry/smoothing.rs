//! The most probable field, given uncertain vectors.
//!
//! Of all fields on the lattice, the one that minimises
//!
//! ```text
//! Σ (d − y)² / σ²  +  Σ (Δ³d)² / τ²
//! ```
//!
//! for every component: close to each measured vector y within its uncertainty σ, and with third
//! differences Δ³ along the axes no larger than the flow's own, τ. This is the penalised least
//! squares of Whittaker (1923) and Eilers (Anal. Chem. 75, 2003), used on PIV fields by Garcia (Exp.
//! Fluids 50, 2011), with two changes: weights are measured uncertainties, and τ is estimated locally, so that
//! a vortex core is smoothed less than the surrounding flow. Fields up to second order are reproduced exactly,
//! also at the faces of the volume.
//!
//! A node without a vector has zero weight. Nodes beyond the outermost vectors do not influence them
//! ([`Penalty::drop_unknown`]): the result is the same as if the volume ended there.

use rayon::prelude::*;

use super::{
    conjugate_gradients::{Until, solve},
    differences::Penalty,
    flow_nodes::FlowNodes,
    lattice::Lattice,
    layout::Layout,
};

/// Variance of the third difference of vectors of variance 1 from windows that overlap by half:
/// 1 + 9 + 9 + 1, less 2 · (3 + 9 + 3) times their correlation of 1/2.
const NOISE_GAIN: f64 = 5.0;

/// Standard deviation added to every vector, as a share of the flow's third differences: a window does not
/// respond to a wave as long as itself, and the spread of its particles does not contain that error. Error of
/// the true particles in windows of 24 voxels on a wave of 100: 0.08 voxel without, 0.03 with 0.1 or 0.17, 0.06
/// with 0.3; the bench and the ring vortex are best between 0.05 and 0.15 (docs/decisions.md, "Fitted
/// constants").
const UNRESOLVED_SHARE: f64 = 0.1;

/// Third differences of a regular flow below this value count as zero, in voxels.
const LEAST_DIFFERENCE_VOX: f64 = 1e-3;

/// Stopping criterion: residual relative to the first one, and number of steps.
const UNTIL: Until = Until { tolerance: 1e-3, steps: 20 };

/// Data from which the roughness of the flow is estimated.
#[derive(Debug, Clone, Copy)]
struct Known<'a> {
    /// Nodes whose vectors were measured.
    measured: &'a [bool],
    /// Which nodes belong to the same flow; all of them if absent.
    flow: Option<&'a FlowNodes>,
}

/// One component's equations (S + Σ Δᵀ P Δ) d = S y.
struct SmoothingEquations {
    /// 1/σ² of each node, with the unresolved part in σ²; 0 where there is no vector.
    certainty: Vec<f64>,
    /// 1/τ² of every third difference.
    penalty: Penalty,
}

impl Lattice {
    /// The most probable field, given vectors with standard uncertainty `uncertainty_vox` (> 0); `None` where
    /// nothing was measured: there the field is interpolated from its neighbours, or unchanged if it has none.
    ///
    /// Roughness and noise are estimated from `measured` vectors only, because replaced ones have arbitrary
    /// smoothness and error. Nodes of different flows (`flow`) are not coupled.
    pub fn likeliest(
        &self,
        uncertainty_vox: &[Option<[f32; 3]>],
        measured: &[bool],
        flow: Option<&FlowNodes>,
    ) -> Self {
        let layout = Layout { nodes: self.nodes };
        let components: Vec<Vec<f64>> = (0..3usize)
            .into_par_iter()
            .map(|c| {
                let value: Vec<f64> = self.values.iter().map(|v| f64::from(v[c])).collect();
                let square = |u: &Option<[f32; 3]>| u.map(|u| f64::from(u[c]).powi(2));
                let variance: Vec<Option<f64>> = uncertainty_vox.iter().map(square).collect();
                SmoothingEquations::new(layout, &value, &variance, Known { measured, flow })
                    .solve(value)
            })
            .collect();
        let values = (0..self.values.len())
            .map(|n| std::array::from_fn(|c| components[c][n] as f32))
            .collect();
        Self { values, ..*self }
    }
}

impl SmoothingEquations {
    fn new(layout: Layout, value: &[f64], variance: &[Option<f64>], known: Known) -> Self {
        let squares: [Vec<f64>; 3] =
            std::array::from_fn(|axis| expected_squares(layout, axis, value, variance, known));
        let of_measured = (0..3).flat_map(|axis| {
            let squares = &squares[axis];
            layout.within(axis, known.measured, known.flow).map(move |n| squares[n])
        });
        let (sum, count) =
            of_measured.fold((0.0, 0usize), |(sum, count), square| (sum + square, count + 1));
        let unresolved = UNRESOLVED_SHARE * UNRESOLVED_SHARE * sum / count.max(1) as f64;
        let stiffness = squares
            .map(|of_axis| of_axis.iter().map(|&t| if t > 0.0 { 1.0 / t } else { 0.0 }).collect());
        let certainty =
            variance.iter().map(|v| v.map_or(0.0, |v| 1.0 / (v + unresolved))).collect();
        let mut penalty = Penalty { layout, stiffness };
        let has_vector: Vec<bool> = variance.iter().map(Option::is_some).collect();
        penalty.drop_unknown(&has_vector);
        if let Some(flow) = known.flow {
            penalty.drop_across_bodies(flow);
        }
        Self { certainty, penalty }
    }

    /// The left-hand side applied to `value`.
    fn apply(&self, value: &[f64]) -> Vec<f64> {
        let mut sum = self.right(value);
        self.penalty.add_forces(value, &mut sum);
        sum
    }

    /// The right-hand side for measured values.
    fn right(&self, measured: &[f64]) -> Vec<f64> {
        measured.iter().zip(&self.certainty).map(|(value, weight)| value * weight).collect()
    }

    fn solve(&self, measured: Vec<f64>) -> Vec<f64> {
        let mut diagonal = self.certainty.clone();
        self.penalty.add_diagonal(&mut diagonal);
        let right = self.right(&measured);
        solve(|value| self.apply(value), &diagonal, &right, measured, UNTIL)
    }
}

/// Expected mean square τ² of the third difference along `axis` that starts at each node, in voxel²; 0 where
/// none starts, and where it contains no vector.
///
/// It is the sum of the local roughness and the value due to the vectors' uncertainty: third differences of
/// smoothed vectors are too small, and the flow may be as rough as its vectors are uncertain.
fn expected_squares(
    layout: Layout,
    axis: usize,
    value: &[f64],
    variance: &[Option<f64>],
    known: Known,
) -> Vec<f64> {
    let s = layout.stride(axis);
    let mut squares = layout.roughness(axis, value, known.measured, known.flow);
    for n in (0..value.len()).filter(|&n| layout.starts(axis, n)) {
        let touched = (0..4).filter_map(|k| variance[n + k * s]);
        let (sum, count) = touched.fold((0.0, 0.0), |(sum, count), v| (sum + v, count + 1.0));
        if count == 0.0 {
            squares[n] = 0.0;
        } else {
            squares[n] += NOISE_GAIN * sum / count + LEAST_DIFFERENCE_VOX.powi(2);
        }
    }
    squares
}

#[cfg(test)]
mod tests;
