//! The normal equations of the field, never written down: what they make of a field, and what is left of
//! their right-hand side.

use multiversion::multiversion;
use rayon::prelude::*;

use super::{
    super::differences::Layout,
    divergence::Divergence,
    lanes::{LANES, Lane, Vectors, zeros},
    nodes::{Nodes, Taps},
    noise::Noise,
};

/// What is asked of a field c: for every lane the least of
///
/// ```text
/// Σ w (y − B c)²  +  Σ λ (t − Δ³c)²  +  Σ μ (s − ∇·c)²  +  Σ κ (b − c)²
/// ```
///
/// over samples y, third differences along the axes, half-node points, and coefficients b of the field before.
/// t and s are 0 for the field itself.
pub struct Equations<'a> {
    /// Where the coefficients are.
    pub nodes: &'a Nodes,
    /// What makes a field at each sample.
    pub taps: &'a [Taps],
    /// Per component and sample: w.
    pub weights: [Vec<Lane>; 3],
    /// Per component: λ of all lanes,
    pub stiffness: [f32; 3],
    /// times a factor for each.
    pub factors: Lane,
    /// Divergence, where it costs anything.
    pub divergence: Option<Divergence>,
    /// κ, greater than zero: samples and third differences alone leave some fields open.
    pub anchor: f32,
}

/// What a field is compared with.
pub struct Targets<'a> {
    /// Per component and sample: y.
    pub samples: &'a [Vec<Lane>; 3],
    /// Per component and coefficient: b.
    pub before: &'a [Vec<f32>; 3],
    /// t √λ, s √μ, and what b √κ is in all lanes but the first.
    pub noise: Option<&'a Noise>,
}

impl Equations<'_> {
    /// The left-hand side applied to `field`.
    pub fn applied(&self, field: &Vectors) -> Vectors {
        self.forces(field, None, -1.0)
    }

    /// Right-hand side less left-hand side: what the equations still ask of `field`.
    pub fn residual(&self, field: &Vectors, targets: &Targets) -> Vectors {
        self.forces(field, Some(targets), 1.0)
    }

    fn forces(&self, field: &Vectors, targets: Option<&Targets>, sign: f32) -> Vectors {
        let layout = self.nodes.layout;
        let of_component = |c: usize| -> Vec<Lane> {
            let mut sum = vec![[0.0; LANES]; layout.len()];
            let values = targets.map(|targets| targets.samples[c].as_slice());
            add_samples(layout, self.taps, &self.weights[c], &field[c], values, sign, &mut sum);
            let stiffness = self.lanes_of_stiffness(c);
            for axis in 0..3 {
                let noise = targets.and_then(|t| t.noise).map(|noise| (noise, c));
                add_differences(layout, axis, stiffness, &field[c], noise, sign, &mut sum);
            }
            self.add_anchors(c, &field[c], targets, sign, &mut sum);
            sum
        };
        let mut sums: Vectors = zeros(0);
        sums.par_iter_mut().enumerate().for_each(|(c, sum)| *sum = of_component(c));
        if let Some(divergence) = &self.divergence {
            divergence.add_forces(layout, field, targets.and_then(|t| t.noise), sign, &mut sums);
        }
        sums
    }

    /// λ of component `c`, lane by lane.
    pub fn lanes_of_stiffness(&self, c: usize) -> Lane {
        self.factors.map(|factor| factor * self.stiffness[c])
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
                    drawn[0] = targets.before[c][n];
                    drawn
                }
                None => [targets.before[c][n]; LANES],
            });
            for l in 0..LANES {
                sum[l] += sign * self.anchor * (before[l] - field[l]);
            }
        }
    }
}

/// Adds sign · Bᵀ w (y − B c).
#[multiversion(targets("x86_64+avx512f+avx512vl", "x86_64+avx2"))]
fn add_samples(
    layout: Layout,
    taps: &[Taps],
    weights: &[Lane],
    field: &[Lane],
    values: Option<&[Lane]>,
    sign: f32,
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
        taps.scatter(layout, left, sum);
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
