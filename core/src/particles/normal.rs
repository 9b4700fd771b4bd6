//! Normal equations of one particle's position and lights.

use std::ops::AddAssign;

use nalgebra::{SMatrix, SVector};

use super::kernels::{Equations, UNKNOWNS};

/// Largest number of cameras.
pub const CAMERAS: usize = 2;

/// Place and lights.
const PARAMETERS: usize = 3 + CAMERAS;

type Matrix = SMatrix<f64, PARAMETERS, PARAMETERS>;
type Vector = SVector<f64, PARAMETERS>;

/// A particle of one frame.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Particle {
    /// Its place, in mm.
    pub at_mm: [f64; 3],
    /// Its light in each camera, in counts of an open pixel that gets all of it.
    pub light: [f64; CAMERAS],
}

/// Prior of a particle's lights: their ratio is about that of the cameras.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct LightPrior {
    /// A typical particle's light in each camera, in counts.
    pub typical: [f64; CAMERAS],
    /// Standard deviation of the difference of relative lights, over their mean.
    pub spread: f64,
}

/// Rule for steps.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct StepRule {
    /// Relaxation factor of a particle's step.
    pub relaxation: f64,
    /// Levenberg–Marquardt damping, relative to the diagonal.
    pub damping: f64,
    /// Longest step, in mm.
    pub longest_mm: f64,
}

/// A particle's normal equations from all cameras.
#[derive(Debug, Clone)]
pub struct Normal {
    /// Inverse covariance of place and lights, without any prior.
    pub matrix: Matrix,
    /// Gradient.
    pub right: Vector,
}

impl Default for Normal {
    fn default() -> Self {
        Self { matrix: Matrix::zeros(), right: Vector::zeros() }
    }
}

impl AddAssign<&Self> for Normal {
    fn add_assign(&mut self, other: &Self) {
        self.matrix += other.matrix;
        self.right += other.right;
    }
}

impl Normal {
    /// Adds a camera's equations by light and array coordinates, as they are by light and place.
    pub fn add(&mut self, of: &Equations, by_place: &[[f64; 3]; 4], light: f64, camera: usize) {
        let full = of.full();
        // Derivatives of the five unknowns by place.
        let by = |unknown: usize, axis: usize| light * by_place[unknown - 1][axis];
        for axis in 0..3 {
            let mut along = [0.0; UNKNOWNS];
            for (i, row) in full.iter().enumerate().skip(1) {
                for (along, entry) in along.iter_mut().zip(row) {
                    *along += by(i, axis) * entry;
                }
                self.right[axis] += by(i, axis) * of.right[i];
            }
            for other in 0..3 {
                let sum: f64 = (1..UNKNOWNS).map(|i| along[i] * by(i, other)).sum();
                self.matrix[(axis, other)] += sum;
            }
            self.matrix[(axis, 3 + camera)] += along[0];
            self.matrix[(3 + camera, axis)] += along[0];
        }
        self.matrix[(3 + camera, 3 + camera)] += full[0][0];
        self.right[3 + camera] += of.right[0];
    }

    /// Adds what is known before: a ratio of the lights, and that a camera that is not there has none.
    fn with_prior(&self, particle: &Particle, cameras: usize, prior: &LightPrior) -> Self {
        let mut normal = self.clone();
        for camera in cameras..CAMERAS {
            normal.matrix[(3 + camera, 3 + camera)] += 1.0;
        }
        if cameras == CAMERAS {
            let relative = [0, 1].map(|c| particle.light[c] / prior.typical[c]);
            let mean = ((relative[0] + relative[1]) / 2.0).max(0.05);
            let weight = 1.0 / (prior.spread * mean).powi(2);
            let slope = [1.0 / prior.typical[0], -1.0 / prior.typical[1]];
            let apart = relative[0] - relative[1];
            for i in 0..2 {
                normal.right[3 + i] -= weight * slope[i] * apart;
                for j in 0..2 {
                    normal.matrix[(3 + i, 3 + j)] += weight * slope[i] * slope[j];
                }
            }
        }
        normal
    }

    /// Where the particle goes, and how far that is, in mm.
    pub fn stepped(
        &self,
        particle: &Particle,
        cameras: usize,
        prior: &LightPrior,
        rule: &StepRule,
    ) -> (Particle, f64) {
        let Self { mut matrix, right, .. } = self.with_prior(particle, cameras, prior);
        for n in 0..PARAMETERS {
            matrix[(n, n)] += rule.damping * matrix[(n, n)] + 1e-12;
        }
        // A place that no image determines stays.
        let scale = (matrix[(0, 0)] + matrix[(1, 1)] + matrix[(2, 2)]) * 1e-6;
        for n in 0..3 {
            matrix[(n, n)] += scale;
        }
        let Some(cholesky) = matrix.cholesky() else { return (*particle, 0.0) };
        let step = cholesky.solve(&right) * rule.relaxation;
        let length = step.fixed_rows::<3>(0).norm();
        if !length.is_finite() {
            return (*particle, 0.0);
        }
        let shorter = if length > rule.longest_mm { rule.longest_mm / length } else { 1.0 };
        let mut moved = *particle;
        for axis in 0..3 {
            moved.at_mm[axis] += shorter * step[axis];
        }
        for camera in 0..cameras {
            let least = 0.01 * prior.typical[camera];
            moved.light[camera] = (moved.light[camera] + step[3 + camera]).max(least);
        }
        (moved, shorter * length)
    }

    /// Covariance of the place, in mm²: H⁻¹ J H⁻¹ with H the matrix of these equations and J the
    /// covariance of their gradient, which `gradient` has as its matrix. A residual larger than noise, or
    /// noise where the image is steep, widens it. What no image determines is known to a voxel.
    pub fn covariance_mm2(
        &self,
        gradient: &Self,
        particle: &Particle,
        (cameras, prior, voxel_mm): (usize, &LightPrior, f64),
    ) -> [[f64; 3]; 3] {
        let Self { mut matrix, .. } = self.with_prior(particle, cameras, prior);
        let mut spread = gradient.matrix;
        for axis in 0..3 {
            let before = 1.0 / (voxel_mm * voxel_mm);
            matrix[(axis, axis)] += before;
            spread[(axis, axis)] += before;
        }
        let unknown = || Matrix::identity() * voxel_mm * voxel_mm;
        let inverse = matrix.try_inverse().unwrap_or_else(unknown);
        let covariance = inverse * spread * inverse;
        std::array::from_fn(|row| std::array::from_fn(|column| covariance[(row, column)]))
    }
}
