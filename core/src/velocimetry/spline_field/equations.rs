//! Normal equations of the field in matrix-free form: the left-hand side applied to a field, and the residual.

use multiversion::multiversion;
use rayon::prelude::*;

use super::{
    super::{
        layout::Layout,
        nodes::{Nodes, Taps},
    },
    divergence::Divergence,
    lanes::{LANES, Lane, Vectors},
    noise::Noise,
};

/// Equations of a field c that minimises, for every lane,
///
/// ```text
/// Σ w (y − B c)²  +  Σ λ (t − Δ³c)²  +  Σ μ (s − ∇·c)²  +  Σ κ (b − c)²
/// ```
///
/// over samples y, third differences along the axes, half-node points, and coefficients b of the previous
/// field. t and s are 0 for the field itself.
pub struct Equations<'a> {
    /// Nodes of the coefficients.
    pub nodes: &'a Nodes,
    /// Interpolation weights at each sample. The samples are in the order of the coefficients.
    pub taps: &'a [Taps],
    /// Per vector and sample: w.
    pub weights: Vec<Vec<Lane>>,
    /// Per vector: λ.
    pub stiffness: Vec<Lane>,
    /// Penalty of the divergence, if there is one; requires a vector for each component.
    pub divergence: Option<Divergence>,
    /// κ, greater than zero: samples and third differences alone do not determine all fields.
    pub anchor: f32,
}

/// Targets of the fit.
pub struct Targets<'a> {
    /// Per vector and sample: y.
    pub samples: &'a [Vec<Lane>],
    /// Per vector and coefficient: b.
    pub before: &'a [Vec<Lane>],
    /// t √λ, s √μ, and b √κ in all lanes except the first; requires a vector for each component.
    pub noise: Option<&'a Noise>,
}

impl Equations<'_> {
    /// The left-hand side applied to `field`.
    pub fn applied(&self, field: &Vectors) -> Vectors {
        self.forces(field, None, -1.0)
    }

    /// Residual: right-hand side minus left-hand side.
    pub fn residual(&self, field: &Vectors, targets: &Targets) -> Vectors {
        self.forces(field, Some(targets), 1.0)
    }

    fn forces(&self, field: &Vectors, targets: Option<&Targets>, sign: f32) -> Vectors {
        let layout = self.nodes.layout;
        let of_vector = |c: usize| -> Vec<Lane> {
            let values = targets.map(|targets| targets.samples[c].as_slice());
            let mut sum = self.forces_of_samples(c, &field[c], values, sign);
            for axis in 0..3 {
                let noise = targets.and_then(|t| t.noise).map(|noise| (noise, c));
                add_differences(layout, axis, self.stiffness[c], &field[c], noise, sign, &mut sum);
            }
            self.add_anchors(c, &field[c], targets, sign, &mut sum);
            sum
        };
        let mut sums: Vectors = (0..field.len()).into_par_iter().map(of_vector).collect();
        if let Some(divergence) = &self.divergence {
            divergence.add_forces(layout, field, targets.and_then(|t| t.noise), sign, &mut sums);
        }
        sums
    }

    /// sign · Bᵀ w (y − B c) of vector `c`. Parts of the samples are summed in parallel, each into separate
    /// coefficients, so the sum does not depend on the number of threads.
    fn forces_of_samples(
        &self,
        c: usize,
        field: &[Lane],
        values: Option<&[Lane]>,
        sign: f32,
    ) -> Vec<Lane> {
        let layout = self.nodes.layout;
        let weights = &self.weights[c];
        let of_part = |(number, taps): (usize, &[Taps])| {
            let samples = number * PART..number * PART + taps.len();
            let (weights, values) = (&weights[samples.clone()], values.map(|all| &all[samples]));
            let [first, last] = [taps[0].first, taps[taps.len() - 1].first];
            let touched = first..last + Taps::span(layout);
            let mut sum = vec![[0.0; LANES]; touched.len()];
            add_samples(layout, taps, weights, field, values, (sign, first), &mut sum);
            (first, sum)
        };
        let parts: Vec<(usize, Vec<Lane>)> =
            self.taps.par_chunks(PART).enumerate().map(of_part).collect();
        let mut sum = vec![[0.0; LANES]; layout.len()];
        for (first, part) in parts {
            for (sum, part) in sum[first..].iter_mut().zip(part) {
                for l in 0..LANES {
                    sum[l] += part[l];
                }
            }
        }
        sum
    }

    /// Adds sign · κ (b − c).
    fn add_anchors(
        &self,
        c: usize,
        field: &[Lane],
        targets: Option<&Targets>,
        sign: f32,
        sum: &mut [Lane],
    ) {
        let root = self.anchor.sqrt();
        for (n, (sum, field)) in sum.iter_mut().zip(field).enumerate() {
            let before = targets.map_or([0.0; LANES], |targets| match targets.noise {
                Some(noise) => {
                    let mut drawn = noise.of_anchor(c, n).map(|sign| sign / root);
                    drawn[0] = targets.before[c][n][0];
                    drawn
                }
                None => targets.before[c][n],
            });
            for l in 0..LANES {
                sum[l] += sign * self.anchor * (before[l] - field[l]);
            }
        }
    }
}

/// Number of samples in a part.
const PART: usize = 2048;

/// Adds sign · Bᵀ w (y − B c) to the coefficients from number `first` on.
#[multiversion(targets("x86_64+avx512f+avx512vl", "x86_64+avx2"))]
fn add_samples(
    layout: Layout,
    taps: &[Taps],
    weights: &[Lane],
    field: &[Lane],
    values: Option<&[Lane]>,
    (sign, first): (f32, usize),
    sum: &mut [Lane],
) {
    for (n, taps) in taps.iter().enumerate() {
        let mut left = taps.gather(layout, field).map(|value| -value);
        if let Some(values) = values {
            for (left, value) in left.iter_mut().zip(values[n]) {
                *left += value;
            }
        }
        for (left, weight) in left.iter_mut().zip(weights[n]) {
            *left *= sign * weight;
        }
        taps.scatter(layout, left, &mut sum[taps.first - first..]);
    }
}

/// Adds sign · Δᵀ λ (t − Δ c) along an axis; `noise` of a component gives t √λ.
#[multiversion(targets("x86_64+avx512f+avx512vl", "x86_64+avx2"))]
fn add_differences(
    layout: Layout,
    axis: usize,
    stiffness: Lane,
    field: &[Lane],
    noise: Option<(&Noise, usize)>,
    sign: f32,
    sum: &mut [Lane],
) {
    let (s, count) = (layout.stride(axis), layout.nodes[axis]);
    let roots = stiffness.map(f32::sqrt);
    for start in (0..field.len()).step_by(s * count) {
        for n in start..start + s * count.saturating_sub(3) {
            let (a, b, c, d) = (field[n], field[n + s], field[n + 2 * s], field[n + 3 * s]);
            let mut force = [0.0; LANES];
            for l in 0..LANES {
                force[l] = -sign * stiffness[l] * (d[l] - a[l] + 3.0 * (b[l] - c[l]));
            }
            if let Some((noise, component)) = noise {
                let signs = noise.of_difference(component, axis, n);
                for l in 0..LANES {
                    force[l] += sign * roots[l] * signs[l];
                }
            }
            for (place, factor) in [-1.0, 3.0, -3.0, 1.0].into_iter().enumerate() {
                let sum = &mut sum[n + place * s];
                for l in 0..LANES {
                    sum[l] += factor * force[l];
                }
            }
        }
    }
}

/// Values of a field of several lanes at all `taps`: B c.
#[multiversion(targets("x86_64+avx512f+avx512vl", "x86_64+avx2"))]
pub fn values_at(layout: Layout, taps: &[Taps], field: &[Lane]) -> Vec<Lane> {
    taps.iter().map(|taps| taps.gather(layout, field)).collect()
}
