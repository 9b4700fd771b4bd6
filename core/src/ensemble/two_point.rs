//! How fluctuations at two places go together, along the lattice's lines.
//!
//! Means and covariance of each pair of places on a line are kept, of the shots that have both: gaps do
//! no harm, and the flow need not be the same everywhere. What is averaged over a line is said where it is.

use rayon::prelude::*;
use serde::{Deserialize, Serialize};

use super::{Sample, Spectrum, spectrum};
use crate::velocimetry::VectorGrid;

/// Two places: samples of both, means, and summed products of differences from the means, of u, v, w.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
struct Pair {
    count: f64,
    first: [f64; 3],
    second: [f64; 3],
    products: [f64; 3],
}

impl Pair {
    fn add(&mut self, first: &[f64; 3], second: &[f64; 3]) {
        self.count += 1.0;
        let weight = 1.0 / self.count;
        for c in 0..3 {
            // Welford's: one difference from the mean before, one from the mean after.
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

/// The pairs on all lines along one axis.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct LinePairs {
    /// Places on a line.
    length: usize,
    /// Index of each line's first place, and steps between its places.
    starts: Vec<usize>,
    stride: usize,
    /// For each line: the pairs (i, j ≥ i), all j of i = 0 first.
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

    /// Adds a shot: a sample, or none, at each place of the lattice.
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

    /// What all lines say together; `noise` is the measurement's variance, which only a place with itself has.
    pub fn correlation(&self, axis: usize, spacing_mm: f64, noise: [f64; 3]) -> Correlation {
        let n = self.length;
        let mut covariance = vec![[0.0; 3]; n];
        let mut coefficient = vec![[None; 3]; n];
        let at = |i: usize, j: usize| i * n - i * i.saturating_sub(1) / 2 + j - i;
        let lines = || self.pairs.chunks(pairs_of(n).max(1));
        for lag in 0..n {
            for c in 0..3 {
                // Samples but one of each pair; covariances; the places' own standard deviations.
                let [mut weight, mut together, mut apart] = [0.0; 3];
                for pairs in lines() {
                    for i in 0..n - lag {
                        let pair = &pairs[at(i, i + lag)];
                        if pair.count < 2.0 {
                            continue;
                        }
                        let less = if lag == 0 { noise[c] } else { 0.0 };
                        let degrees = pair.count - 1.0;
                        let variance = |place: usize| {
                            let own = &pairs[at(place, place)];
                            (own.products[c] / (own.count - 1.0) - noise[c]).max(0.0)
                        };
                        weight += degrees;
                        together += pair.products[c] - less * degrees;
                        apart += degrees * (variance(i) * variance(i + lag)).sqrt();
                    }
                }
                if weight > 0.0 {
                    covariance[lag][c] = together / weight;
                }
                // At separation 0 the covariance is the variance of the flow.
                if apart > 0.0 && covariance[0][c] > noise[c] {
                    coefficient[lag][c] = Some(together / apart);
                }
            }
        }
        let separation_mm = (0..n).map(|lag| lag as f64 * spacing_mm).collect();
        Correlation { axis, separation_mm, covariance_m2_s2: covariance, coefficient }
    }
}

/// Pairs of places on a line, each place with itself among them.
fn pairs_of(length: usize) -> usize {
    length * (length + 1) / 2
}

/// Covariance of a component at two places some way apart along an axis, averaged over the volume.
///
/// Windows that overlap share particles, and so errors: below one window's width some of the covariance is
/// theirs.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Correlation {
    /// 0 is x.
    pub axis: usize,
    /// Separations, from 0.
    pub separation_mm: Vec<f64>,
    /// Covariance of u, v, w with itself; the measurement's variance is taken out at separation 0.
    pub covariance_m2_s2: Vec<[f64; 3]>,
    /// The same over the standard deviations at both places; absent where the flow fluctuates less than the
    /// measurement errs: windows that overlap share errors, which would be taken for the flow's.
    pub coefficient: Vec<[Option<f64>; 3]>,
}

impl Correlation {
    /// Integral scale of each component, in mm: the coefficient's integral up to its first zero (trapezoids),
    /// or as far as the volume reaches. Absent without coefficients.
    pub fn integral_scale_mm(&self) -> [Option<f64>; 3] {
        std::array::from_fn(|c| {
            let mut sum = 0.0;
            self.coefficient.first()?[c]?;
            for (places, lags) in self.separation_mm.windows(2).zip(self.coefficient.windows(2)) {
                let (Some(near), Some(far)) = (lags[0][c], lags[1][c]) else { break };
                let step = places[1] - places[0];
                if far <= 0.0 {
                    // The line between them meets zero here.
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
