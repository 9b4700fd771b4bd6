//! Two-point correlations of fluctuations along the lines of the lattice.
//!
//! Means and covariance are accumulated for each pair of nodes on a line, from the shots with samples at both
//! nodes. Gaps therefore cause no bias, and the mean flow need not be homogeneous.

use rayon::prelude::*;
use serde::{Deserialize, Serialize};

use super::{Sample, Spectrum, spectrum};
use crate::velocimetry::VectorGrid;

/// Moments of a pair of nodes, of u, v, w.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
struct Pair {
    /// Number of shots with both samples.
    count: f64,
    /// Mean at the first node.
    first: [f64; 3],
    /// Mean at the second node.
    second: [f64; 3],
    /// Summed products of the differences from the means.
    products: [f64; 3],
}

impl Pair {
    fn add(&mut self, first: &[f64; 3], second: &[f64; 3]) {
        self.count += 1.0;
        let weight = 1.0 / self.count;
        for c in 0..3 {
            // Welford's update: one difference is from the old mean, the other from the new one.
            let before = first[c] - self.first[c];
            self.first[c] += before * weight;
            self.second[c] += (second[c] - self.second[c]) * weight;
            self.products[c] += before * (second[c] - self.second[c]);
        }
    }

    fn merge(&mut self, other: &Self) {
        if other.count == 0.0 {
            return;
        }
        let count = self.count + other.count;
        for c in 0..3 {
            let [first, second] =
                [other.first[c] - self.first[c], other.second[c] - self.second[c]];
            self.products[c] +=
                other.products[c] + first * second * self.count * other.count / count;
            self.first[c] += first * other.count / count;
            self.second[c] += second * other.count / count;
        }
        self.count = count;
    }
}

/// The pairs of nodes on all lines along one axis.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct LinePairs {
    /// Number of nodes on a line.
    length: usize,
    /// Index of the first node of each line.
    starts: Vec<usize>,
    /// Index step between the nodes of a line.
    stride: usize,
    /// For each line: the pairs (i, j ≥ i), ordered by i, then j.
    pairs: Vec<Pair>,
}

impl LinePairs {
    pub fn new(grid: &VectorGrid, axis: usize) -> Self {
        let [nx, ny, _] = grid.vectors;
        let (length, stride) = (grid.vectors[axis], [1, nx, nx * ny][axis]);
        let starts: Vec<usize> =
            (0..grid.len()).filter(|index| index / stride % length == 0).collect();
        let pairs = vec![Pair::default(); starts.len() * pairs_of(length)];
        Self { length, starts, stride, pairs }
    }

    /// Adds a shot: a sample or `None` at each node of the lattice.
    pub fn add(&mut self, samples: &[Option<Sample>]) {
        let (length, stride) = (self.length, self.stride);
        let lines = self.pairs.par_chunks_mut(pairs_of(length).max(1)).zip(&self.starts);
        lines.for_each(|(pairs, start)| {
            let at = |i: usize| {
                let sample = samples.get(start + i * stride).copied().flatten();
                sample.filter(Sample::is_finite).map(|sample| sample.velocity_m_s)
            };
            let line: Vec<Option<[f64; 3]>> = (0..length).map(at).collect();
            let mut rest = pairs;
            for i in 0..length {
                let (own, others) = rest.split_at_mut(length - i);
                rest = others;
                let Some(first) = line[i] else { continue };
                for (pair, second) in own.iter_mut().zip(&line[i..]) {
                    if let Some(second) = second {
                        pair.add(&first, second);
                    }
                }
            }
        });
    }

    pub fn merge(&mut self, other: &Self) {
        self.pairs.iter_mut().zip(&other.pairs).for_each(|(own, more)| own.merge(more));
    }

    /// Correlation from all lines. `noise` is the variance of the measurement, which affects only pairs of a
    /// node with itself.
    pub fn correlation(&self, axis: usize, spacing_mm: f64, noise: [f64; 3]) -> Correlation {
        let n = self.length;
        let mut covariance = vec![[0.0; 3]; n];
        let mut coefficient = vec![[None; 3]; n];
        let at = |i: usize, j: usize| i * n - i * i.saturating_sub(1) / 2 + j - i;
        let lines = || self.pairs.chunks(pairs_of(n).max(1));
        for lag in 0..n {
            for c in 0..3 {
                // Sums over pairs: degrees of freedom, covariances, and products of standard deviations.
                let [mut weight, mut covariances, mut deviations] = [0.0; 3];
                for pairs in lines() {
                    for i in 0..n - lag {
                        let pair = &pairs[at(i, i + lag)];
                        if pair.count < 2.0 {
                            continue;
                        }
                        let bias = if lag == 0 { noise[c] } else { 0.0 };
                        let degrees = pair.count - 1.0;
                        let variance = |node: usize| {
                            let own = &pairs[at(node, node)];
                            (own.products[c] / (own.count - 1.0) - noise[c]).max(0.0)
                        };
                        weight += degrees;
                        covariances += pair.products[c] - bias * degrees;
                        deviations += degrees * (variance(i) * variance(i + lag)).sqrt();
                    }
                }
                if weight > 0.0 {
                    covariance[lag][c] = covariances / weight;
                }
                // The covariance at separation 0 is the variance of the flow.
                if deviations > 0.0 && covariance[0][c] > noise[c] {
                    coefficient[lag][c] = Some(covariances / deviations);
                }
            }
        }
        let separation_mm = (0..n).map(|lag| lag as f64 * spacing_mm).collect();
        Correlation { axis, separation_mm, covariance_m2_s2: covariance, coefficient }
    }
}

/// Number of pairs of nodes on a line, including each node with itself.
fn pairs_of(length: usize) -> usize {
    length * (length + 1) / 2
}

/// Two-point covariance of each component along an axis, averaged over the volume.
///
/// Overlapping windows share particles and thus errors. At separations below one window the covariance contains the
/// covariance of errors.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Correlation {
    /// Axis; 0 is x.
    pub axis: usize,
    /// Separations from 0, in mm.
    pub separation_mm: Vec<f64>,
    /// Autocovariance of u, v, w; the variance of the measurement is subtracted at separation 0.
    pub covariance_m2_s2: Vec<[f64; 3]>,
    /// Autocovariance divided by the standard deviations at both nodes. `None` if the variance of the flow is below
    /// that of the measurement, because correlated errors of overlapping windows would dominate.
    pub coefficient: Vec<[Option<f64>; 3]>,
}

impl Correlation {
    /// Integral length scale of each component, in mm: the integral of the coefficient up to its first zero or
    /// to the largest separation (trapezoidal rule). `None` without coefficients.
    pub fn integral_scale_mm(&self) -> [Option<f64>; 3] {
        std::array::from_fn(|c| {
            let mut sum = 0.0;
            self.coefficient.first()?[c]?;
            for (separations, lags) in
                self.separation_mm.windows(2).zip(self.coefficient.windows(2))
            {
                let (Some(near), Some(far)) = (lags[0][c], lags[1][c]) else { break };
                let step = separations[1] - separations[0];
                if far <= 0.0 {
                    // Triangle up to the zero of the linear interpolation.
                    return Some(sum + 0.5 * near * step * near / (near - far));
                }
                sum += 0.5 * (near + far) * step;
            }
            Some(sum)
        })
    }

    /// One-dimensional spectra of u, v, w along the axis.
    pub fn spectrum(&self) -> Spectrum {
        spectrum::spectrum(self)
    }
}
