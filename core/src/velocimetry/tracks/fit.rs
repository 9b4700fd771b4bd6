//! Robust fit of a field to particles.
//!
//! For every component, the spline B c that minimises
//!
//! ```text
//! Σ ρ((d − B c)/s) + Σ (y − B c)²/u² + Σ (Δ³c)²/τ²
//! ```
//!
//! over the displacements d of single particles, the correlation's vectors y and the third
//! differences of the coefficients; in an incompressible flow also the divergence of the field
//! (`divergence`), which couples the components. ρ is the negative logarithm of Student's
//! distribution: mismatched particles, and those whose light overlaps with another's, have larger
//! errors than a normal distribution allows, and their weight decreases with their residual. The sum
//! is minimised by iteratively reweighted least squares (Lange, Little and Taylor, J. Am. Stat. Assoc. 84, 1989).

use rayon::prelude::*;

use super::{
    super::{
        conjugate_gradients::{Until, solve},
        differences::Penalty,
        flow_nodes::FlowNodes,
        lattice::Lattice,
        layout::Layout,
        nodes::Taps,
    },
    divergence::Divergence,
    samples::{Samples, add_diagonal, add_product, add_transposed, cells_at, values_at},
    spline::Spline,
    variance::{Waves, near_faces},
};

/// Updates of the weights in a round.
const REWEIGHTINGS: usize = 2;

/// Prior variance of a third difference, relative to the local mean square in the previous, smoothed field.
const PRIOR_VARIANCE_FACTOR: f64 = 4.0;

/// Third differences of a regular flow below this value count as zero, in voxels.
const LEAST_DIFFERENCE_VOX: f64 = 3e-3;

/// Least uncertainty of the field, in voxels: error of the midpoint rule.
const LEAST_UNCERTAINTY_VOX: f64 = 1e-3;

/// Factor on the correlation's variance where particles are much more accurate: it uses the same particles and is
/// not an independent measurement.
const CORRELATION_DISCOUNT: f64 = 25.0;

/// Ratio of the field's standard error to that of particles with independent errors: errors of the reconstruction
/// are correlated between neighbours (docs/decisions.md, "Fitted constants").
const COMMON_ERROR_FACTOR: f64 = 1.05;

/// Common error of neighbouring particles where light is blurred, in voxels per unit of
/// √(variance inflation) − 1 (`core/tests/hard_cases/geometry.rs`, cameras 20 to 5 degrees apart).
const COMMON_BLUR_ERROR_VOX: f64 = 0.01;

/// Stopping criterion for the equations between updates of the weights, which change more than the remaining error.
const UNTIL: Until = Until { tolerance: 0.1, steps: 6 };

/// The same for components that are coupled by the divergence. With more steps the field fits errors that
/// neighbouring particles have in common: 60 double the error of the smooth bench.
const UNTIL_TOGETHER: Until = Until { tolerance: 0.03, steps: 15 };

/// One component's part of the equations.
struct Weighed {
    /// Of particles and of the correlation's vectors.
    weights: Vec<f64>,
    certainty: Vec<f64>,
    /// Weight of particles per cell at each node.
    density: Vec<f64>,
    diagonal: Vec<f64>,
    right: Vec<f64>,
}

/// The equations of all three components.
pub struct Fit<'a> {
    layout: Layout,
    nodes: [usize; 3],
    /// Whether the correlation has a vector on each node.
    has_vector: Vec<bool>,
    /// Interpolation weights at the nodes with a vector.
    at_vectors: Vec<Taps>,
    /// Per component: the vectors on these nodes, in voxels.
    vectors: [Vec<f64>; 3],
    /// Per component and node: variance of the vector, in voxel². Nodes without a vector have the mean variance of the
    /// others.
    variance: [Vec<f64>; 3],
    /// Share of the correlation's variance that unresolved third differences may have.
    unresolved_share: f64,
    /// Present if the flow is incompressible.
    divergence: Option<Divergence>,
    /// 1/τ² of the coefficients' third differences.
    penalties: [Penalty; 3],
    /// Particles near each node, and their weight per cell.
    counts: Vec<f64>,
    densities: [Vec<f64>; 3],
    /// See [`Samples::variance_inflation`].
    variance_inflation: Vec<[f64; 3]>,
    /// Which coefficients belong to the same flow; all of them if absent.
    flow: Option<&'a FlowNodes>,
}

impl<'a> Fit<'a> {
    /// Equations near the correlation's `field` with standard uncertainty `uncertainty_vox`, `None` where
    /// there is no vector, for splines whose coefficients lie in `layout`. Windows stand `window_step_vox`
    /// apart, the nodes as far or closer.
    pub fn new(
        field: &Lattice,
        uncertainty_vox: &[Option<[f32; 3]>],
        layout: Layout,
        window_step_vox: f32,
        incompressible: bool,
    ) -> Self {
        let (nodes, count) = (field.nodes, field.values.len());
        let with_vector = || (0..count).filter(|&n| uncertainty_vox[n].is_some());
        let unknown = Penalty { layout, stiffness: [0; 3].map(|_| vec![0.0; layout.len()]) };
        Self {
            layout,
            nodes,
            has_vector: uncertainty_vox.iter().map(Option::is_some).collect(),
            at_vectors: with_vector().map(|n| Taps::of_node(layout, nodes, n)).collect(),
            vectors: std::array::from_fn(|c| {
                with_vector().map(|n| f64::from(field.values[n][c])).collect()
            }),
            variance: std::array::from_fn(|c| variances(uncertainty_vox, c)),
            // The third difference of an error with a window's length scale is proportional to the cube of the step.
            unresolved_share: f64::from(field.step_vox / window_step_vox).powi(6),
            divergence: incompressible.then(|| Divergence::new(layout, f64::from(field.step_vox))),
            penalties: [unknown.clone(), unknown.clone(), unknown],
            counts: vec![0.0; count],
            densities: std::array::from_fn(|_| vec![0.0; count]),
            variance_inflation: vec![[1.0; 3]; count],
            flow: None,
        }
    }

    /// The same with coefficients that belong to several flows.
    pub fn with_flow(self, flow: Option<&'a FlowNodes>) -> Self {
        Self { flow, ..self }
    }

    /// Fits `spline` to `samples`; the result may be slightly rougher than the previous field.
    pub fn adjust(&mut self, spline: &mut Spline, samples: &Samples) {
        self.penalties = self.penalties(spline, &self.measured(samples));
        self.counts = samples.counts();
        self.variance_inflation = samples.variance_inflation().to_vec();
        for _ in 0..REWEIGHTINGS {
            let weighed: Vec<Weighed> = (0..3usize)
                .into_par_iter()
                .map(|c| self.weighed(c, &spline.coefficients[c], samples))
                .collect();
            spline.coefficients = match self.divergence {
                Some(divergence) => {
                    self.solved_together(&divergence, &spline.coefficients, samples, &weighed)
                }
                None => self.solved(&spline.coefficients, samples, &weighed),
            };
            for (density, weighed) in self.densities.iter_mut().zip(weighed) {
                *density = weighed.density;
            }
        }
    }

    /// Updates the weights of `samples` from their residuals to another field, per component, for the uncertainty on
    /// these nodes.
    pub fn weigh(&mut self, samples: &Samples, residuals: &[Vec<f64>; 3]) {
        self.counts = samples.counts();
        self.variance_inflation = samples.variance_inflation().to_vec();
        for (c, residual) in residuals.iter().enumerate() {
            self.densities[c] = samples.density(&samples.weights(c, residual));
        }
    }

    /// Equations of component `c`, with weights from the residuals.
    fn weighed(&self, c: usize, coefficients: &[f64], samples: &Samples) -> Weighed {
        let measured = samples.displacements(c);
        let values = values_at(self.layout, samples.taps(), coefficients);
        let residual: Vec<f64> = measured.iter().zip(values).map(|(m, v)| m - v).collect();
        let weights = samples.weights(c, &residual);
        let density = samples.density(&weights);
        let certainty = self.certainty_of_vectors(c, &density);
        let (mut diagonal, mut right) =
            (vec![0.0; coefficients.len()], vec![0.0; coefficients.len()]);
        self.penalties[c].add_diagonal(&mut diagonal);
        let vectors = (&self.at_vectors[..], &self.vectors[c], &certainty);
        for (taps, values, weights) in [(samples.taps(), &measured, &weights), vectors] {
            add_diagonal(self.layout, taps, weights, &mut diagonal);
            add_transposed(self.layout, taps, &products(values, weights), &mut right);
        }
        Weighed { weights, certainty, density, diagonal, right }
    }

    /// (Σ BᵀWB + ΔᵀPΔ) c of component `c`, for both kinds of samples.
    fn applied(
        &self,
        c: usize,
        coefficients: &[f64],
        samples: &Samples,
        weighed: &Weighed,
    ) -> Vec<f64> {
        let of_measured = |taps: &[Taps], weights: &[f64]| {
            let mut sum = vec![0.0; coefficients.len()];
            add_product(self.layout, taps, weights, coefficients, &mut sum);
            sum
        };
        let (mut sum, others) = rayon::join(
            || of_measured(samples.taps(), &weighed.weights),
            || {
                let mut sum = of_measured(&self.at_vectors, &weighed.certainty);
                self.penalties[c].add_forces(coefficients, &mut sum);
                sum
            },
        );
        sum.iter_mut().zip(others).for_each(|(sum, other)| *sum += other);
        sum
    }

    /// Improved coefficients, each component separately.
    fn solved(
        &self,
        start: &[Vec<f64>; 3],
        samples: &Samples,
        weighed: &[Weighed],
    ) -> [Vec<f64>; 3] {
        let mut solved: [Vec<f64>; 3] = Default::default();
        solved.par_iter_mut().enumerate().for_each(|(c, solved)| {
            let part = &weighed[c];
            let apply = |coefficients: &[f64]| self.applied(c, coefficients, samples, part);
            *solved = solve(apply, &part.diagonal, &part.right, start[c].clone(), UNTIL);
        });
        solved
    }

    /// The same for components that are coupled by the divergence.
    fn solved_together(
        &self,
        divergence: &Divergence,
        start: &[Vec<f64>; 3],
        samples: &Samples,
        weighed: &[Weighed],
    ) -> [Vec<f64>; 3] {
        let count = self.layout.len();
        let apply = |coefficients: &[f64]| {
            let parts: Vec<Vec<f64>> = coefficients
                .par_chunks(count)
                .enumerate()
                .map(|(c, part)| self.applied(c, part, samples, &weighed[c]))
                .collect();
            let mut sum = parts.concat();
            divergence.add_forces(coefficients, &mut sum, self.flow);
            sum
        };
        let own = divergence.diagonal();
        let diagonal: Vec<f64> =
            weighed.iter().flat_map(|part| part.diagonal.iter().map(|d| d + own)).collect();
        let right: Vec<f64> = weighed.iter().flat_map(|part| part.right.clone()).collect();
        let solved = solve(apply, &diagonal, &right, start.concat(), UNTIL_TOGETHER);
        std::array::from_fn(|c| solved[c * count..][..count].to_vec())
    }

    /// Weight 1/u² of the correlation's vector on node `n`: reduced where particles are more accurate. `density` is
    /// their weight per cell.
    fn certainty(&self, c: usize, n: usize, density: f64) -> f64 {
        // The particles' variance is the inverse of their weight in the eight cells at a node.
        let variance = self.variance[c][n];
        let share = variance * 8.0 * density / (variance * 8.0 * density + 1.0);
        1.0 / (variance * (1.0 + (CORRELATION_DISCOUNT - 1.0) * share))
    }

    /// The same for all vectors, with `density` per node.
    fn certainty_of_vectors(&self, c: usize, density: &[f64]) -> Vec<f64> {
        let with_vector = (0..density.len()).filter(|&n| self.has_vector[n]);
        with_vector.map(|n| self.certainty(c, n, density[n])).collect()
    }

    /// Whether each coefficient is determined by a vector or a particle.
    fn measured(&self, samples: &Samples) -> Vec<bool> {
        let mut weight = vec![0.0; self.layout.len()];
        let particles = vec![1.0; samples.taps().len()];
        let vectors = vec![1.0; self.at_vectors.len()];
        add_diagonal(self.layout, samples.taps(), &particles, &mut weight);
        add_diagonal(self.layout, &self.at_vectors, &vectors, &mut weight);
        weight.into_iter().map(|weight| weight > 0.0).collect()
    }

    /// 1/τ² for every component of a field: the flow may be as rough as it is uncertain. Unmeasured regions do not
    /// constrain the coefficients that were `measured`.
    fn penalties(&self, spline: &Spline, measured: &[bool]) -> [Penalty; 3] {
        let layout = self.layout;
        let of_component = |c: usize| {
            let stiffness = std::array::from_fn(|axis| {
                let squares = layout.roughness(axis, &spline.coefficients[c], measured, self.flow);
                let stiffness = |(n, square): (usize, f64)| {
                    let middle = node_in_the_middle(layout, self.nodes, axis, n);
                    let unresolved =
                        self.variance[c][middle] + LEAST_DIFFERENCE_VOX * LEAST_DIFFERENCE_VOX;
                    let most = PRIOR_VARIANCE_FACTOR * square + self.unresolved_share * unresolved;
                    if layout.starts(axis, n) { 1.0 / most } else { 0.0 }
                };
                squares.into_iter().enumerate().map(stiffness).collect()
            });
            let mut penalty = Penalty { layout, stiffness };
            penalty.drop_unknown(measured);
            if let Some(flow) = self.flow {
                penalty.drop_across_bodies(flow);
            }
            penalty
        };
        let (u, (v, w)) =
            rayon::join(|| of_component(0), || rayon::join(|| of_component(1), || of_component(2)));
        [u, v, w]
    }

    /// Standard uncertainty of the field on the nodes, along x, y, z, in voxels; `None` where there is neither a vector
    /// nor a particle.
    pub fn uncertainty_vox(&self) -> Vec<Option<[f32; 3]>> {
        let waves = Waves::new();
        let layout = Layout { nodes: self.nodes };
        (0..self.has_vector.len())
            .into_par_iter()
            .map(|n| {
                if !self.has_vector[n] && self.counts[n] == 0.0 {
                    return None;
                }
                let near_faces = near_faces(self.nodes, layout.place(n));
                Some(std::array::from_fn(|c| {
                    let (density, stiffness) = (self.densities[c][n], self.stiffness_at(c, n));
                    let certainty =
                        if self.has_vector[n] { self.certainty(c, n, density) } else { 0.0 };
                    let variance = near_faces * waves.variance(density, certainty, stiffness);
                    let variance = variance * few(variance * self.mean_weight(c, n));
                    let common_error =
                        COMMON_BLUR_ERROR_VOX * (self.variance_inflation[n][c].sqrt() - 1.0);
                    let uncertainty = (COMMON_ERROR_FACTOR * variance.sqrt()).hypot(common_error);
                    uncertainty.max(LEAST_UNCERTAINTY_VOX) as f32
                }))
            })
            .collect()
    }

    /// Mean weight of a particle near node `n` in component `c`.
    fn mean_weight(&self, c: usize, n: usize) -> f64 {
        self.densities[c][n] * cells_at(self.nodes, n) / self.counts[n].max(1.0)
    }

    /// 1/τ² along x, y, z at node `n`.
    fn stiffness_at(&self, c: usize, n: usize) -> [f64; 3] {
        let place = Layout { nodes: self.nodes }.place(n);
        std::array::from_fn(|along| {
            // A difference has its middle one and a half coefficients after its start; a node's own
            // coefficient is the one after its number.
            let coefficient = |axis: usize| match axis == along {
                true => place[axis].min(self.layout.nodes[axis].saturating_sub(4)),
                false => place[axis] + 1,
            };
            let start = self.layout.number(std::array::from_fn(coefficient));
            self.penalties[c].stiffness[along][start]
        })
    }
}

/// Elementwise product of values and weights.
fn products(values: &[f64], weights: &[f64]) -> Vec<f64> {
    values.iter().zip(weights).map(|(value, weight)| value * weight).collect()
}

/// Factor on a variance that is estimated from n particles: Student's distribution with n − 1 degrees of freedom has
/// (n − 1)/(n − 3) times the sample variance (JCGM 101, 6.4.9.2). `share` is 1/n.
fn few(share: f64) -> f64 {
    let n = 1.0 / share.clamp(1e-9, 0.2);
    (n - 1.0) / (n - 3.0)
}

/// Variance of component `c` of every vector; where there is none, the mean of the others'.
fn variances(uncertainty_vox: &[Option<[f32; 3]>], c: usize) -> Vec<f64> {
    let square = |u: &Option<[f32; 3]>| u.map(|u| f64::from(u[c]).powi(2));
    let known: Vec<f64> = uncertainty_vox.iter().filter_map(square).collect();
    let mean = known.iter().sum::<f64>() / known.len().max(1) as f64;
    uncertainty_vox.iter().map(|u| square(u).unwrap_or(mean)).collect()
}

/// The node nearest to the middle of the third difference along `axis` that starts at coefficient `n`.
fn node_in_the_middle(layout: Layout, nodes: [usize; 3], axis: usize, n: usize) -> usize {
    let node = |along: usize| {
        let coefficient = n / layout.stride(along) % layout.nodes[along];
        let middle = if along == axis { coefficient + 1 } else { coefficient };
        middle.saturating_sub(1).min(nodes[along] - 1)
    };
    Layout { nodes }.number(std::array::from_fn(node))
}
