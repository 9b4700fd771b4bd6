//! Disparity: the distance between the positions that both cameras assign to the same particles.
//!
//! The residual images around a reconstructed particle give a position correction for each camera:
//! a Gauss–Newton step with this camera's pixels only. The difference between both cameras' steps
//! is random on a correct bench and follows a pattern on a wrong one. A bench error
//! ([`ConfiguredBench`]) is fitted to the differences, each particle weighted by its information
//! matrix. This is volume self-calibration (Wieneke, Experiments in Fluids 45, 2008) on the
//! particles of one frame.

use lfpiv_hw::{CameraPoint, Pose};
use nalgebra::{Matrix3, Matrix4, Point3, SMatrix, SVector, Vector3, Vector4};
use rayon::prelude::*;

use super::bench_error::{ConfiguredBench, PARAMETERS, Sensitivity};
use crate::{
    lightfield::ViewStack,
    model::PointImager,
    reconstruction::ProjectedView,
    statistics::{MEDIAN_OF_THREE_SQUARES, median},
};

/// Minimum number of particles to determine a bench error.
const MIN_PARTICLES: usize = 40;

/// Iterations of reweighting.
const ROUNDS: usize = 6;

/// Squared distance, in variances, of half weight in the Cauchy weights: ghost particles and merged
/// ones are mostly further out.
const HALF_WEIGHT: f64 = 9.0;

/// Prior standard deviation of each parameter, as displacement in mm: matters only for directions
/// that the images do not determine.
const PRIOR_MM: f64 = 1.0;

/// Information matrices whose elements are all below this, per mm², are treated as zero.
const MIN_INFORMATION: f64 = 1e-6;

/// A reconstructed particle.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Source {
    /// Its position, in mm.
    pub at_mm: Point3<f64>,
    /// Its light in a fully open view, in counts.
    pub counts: f64,
}

/// Normal equations of one camera for a particle's position: N δ = g for a step δ in mm in the
/// world frame, and the residual statistics of the pixels used.
#[derive(Debug, Clone, Copy)]
pub struct PositionEquations {
    information: Matrix3<f64>,
    force: Vector3<f64>,
    misfit: f64,
    pixels: usize,
}

/// A bench error fitted to the differences between the cameras.
#[derive(Debug, Clone, PartialEq)]
pub struct Disparity {
    /// Deviation of the real bench from the configured one; see [`ConfiguredBench`].
    pub parameters: [f64; PARAMETERS],
    /// Root mean square distance between the cameras' particle positions, in mm.
    pub rms_mm: f64,
    /// Expected value of that distance on a correct bench, in mm.
    pub noise_mm: f64,
    /// Its components by shift, rotation and object distance, in mm.
    pub parts_mm: [f64; 3],
}

/// The normal equations of one camera for each particle.
pub fn position_equations(
    imager: &PointImager<'_>,
    pose: &Pose,
    views: &ViewStack,
    projected: &[&ProjectedView],
    sources: &[Source],
) -> Vec<PositionEquations> {
    let to_camera =
        Matrix3::from_rows(&[pose.right.transpose(), pose.up.transpose(), pose.axis.transpose()]);
    let equations_of = |source: &Source| {
        let point: CameraPoint = pose.to_camera(&source.at_mm);
        let (mut normal, mut right) = (Matrix4::zeros(), Vector4::zeros());
        let (mut misfit, mut pixels) = (0.0, 0);
        let image = imager.image(&point);
        for view in projected {
            let measured = views.view(view.id.view);
            image.pixels(view.id.view, |pixel| {
                let residual = f64::from(measured[pixel.at] - view.image[pixel.at]);
                let [x, y, z] = pixel.gradient.map(|slope| slope * source.counts);
                let row = Vector4::new(x, y, z, pixel.weight);
                normal += row * row.transpose();
                right += row * residual;
                misfit += residual * residual;
                pixels += 1;
            });
        }
        let (information, force) = without_light(&normal, &right);
        PositionEquations {
            information: to_camera.transpose() * information * to_camera,
            force: to_camera.transpose() * force,
            misfit,
            pixels,
        }
    };
    sources.par_iter().map(equations_of).collect()
}

/// The normal equations for the position only, with the particle's light eliminated (Schur complement).
fn without_light(normal: &Matrix4<f64>, right: &Vector4<f64>) -> (Matrix3<f64>, Vector3<f64>) {
    let mut information = normal.fixed_view::<3, 3>(0, 0).into_owned();
    let mut force = right.fixed_rows::<3>(0).into_owned();
    if normal[(3, 3)] > 0.0 {
        let light = normal.fixed_view::<3, 1>(0, 3).into_owned();
        information -= light * light.transpose() / normal[(3, 3)];
        force -= light * (right[3] / normal[(3, 3)]);
    }
    (information, force)
}

/// One particle's equations K d = f for the difference d between the cameras' positions, in mm.
struct Equation {
    information: Matrix3<f64>,
    /// The inverse of the information matrix.
    covariance: Matrix3<f64>,
    force: Vector3<f64>,
    sensitivity: Sensitivity,
}

impl Equation {
    /// From both cameras' equations. The particle's own position is free, so the informations
    /// combine in parallel, K = N₂ − N₂ (N₁ + N₂)⁻¹ N₂ and f = g₂ − N₂ (N₁ + N₂)⁻¹ (g₁ + g₂).
    fn new(
        [first, second]: [&PositionEquations; 2],
        variances: [f64; 2],
        sensitivity: Sensitivity,
    ) -> Option<Self> {
        let [n1, n2] = [first.information / variances[0], second.information / variances[1]];
        let [g1, g2] = [first.force / variances[0], second.force / variances[1]];
        let inverse = |n: Matrix3<f64>| (n + Matrix3::identity() * MIN_INFORMATION).try_inverse();
        let both = inverse(n1 + n2)?;
        let information = n2 - n2 * both * n2;
        let covariance = inverse(information)?;
        let force = g2 - n2 * both * (g1 + g2);
        Some(Self { information, covariance, force, sensitivity })
    }

    /// Squared distance of the particle from the bench error `parameters`, in variances.
    fn distance(&self, parameters: &SVector<f64, PARAMETERS>) -> f64 {
        let miss = self.force - self.information * (self.sensitivity * parameters);
        miss.dot(&(self.covariance * miss)).max(0.0)
    }
}

/// Fits a bench error to both cameras' equations for `sources`. `None` with too few particles.
pub fn disparity(
    bench: &ConfiguredBench<'_>,
    sources: &[Source],
    [first, second]: [&[PositionEquations]; 2],
) -> Option<Disparity> {
    let variances = [first, second].map(variance);
    if sources.len() < MIN_PARTICLES || variances.iter().any(|&variance| variance <= 0.0) {
        return None;
    }
    let equations: Vec<Equation> = sources
        .par_iter()
        .zip(first.par_iter().zip(second))
        .filter_map(|(source, (first, second))| {
            Equation::new([first, second], variances, bench.sensitivity(&source.at_mm))
        })
        .collect();
    let prior = prior(&equations);
    let mut parameters = SVector::<f64, PARAMETERS>::zeros();
    let mut covariance = SMatrix::<f64, PARAMETERS, PARAMETERS>::zeros();
    for _ in 0..ROUNDS {
        let mut normal = SMatrix::<f64, PARAMETERS, PARAMETERS>::zeros();
        let mut right = SVector::<f64, PARAMETERS>::zeros();
        for equation in &equations {
            let weight = HALF_WEIGHT / (HALF_WEIGHT + equation.distance(&parameters));
            let transposed = equation.sensitivity.transpose() * weight;
            normal += transposed * equation.information * equation.sensitivity;
            right += transposed * equation.force;
        }
        normal += SMatrix::from_diagonal(&prior);
        let factors = normal.cholesky()?;
        parameters = factors.solve(&right);
        covariance = factors.inverse();
    }
    let scatter = median_distance(&equations, &parameters) / MEDIAN_OF_THREE_SQUARES;
    let noise: f64 = equations
        .iter()
        .map(|e| (e.sensitivity * covariance * e.sensitivity.transpose()).trace())
        .sum();
    let rms = |range: std::ops::Range<usize>| {
        let part = SVector::<f64, PARAMETERS>::from_fn(|n, _| {
            if range.contains(&n) { parameters[n] } else { 0.0 }
        });
        let sum: f64 = equations.iter().map(|e| (e.sensitivity * part).norm_squared()).sum();
        (sum / equations.len().max(1) as f64).sqrt()
    };
    Some(Disparity {
        parameters: std::array::from_fn(|n| parameters[n]),
        rms_mm: rms(0..PARAMETERS),
        noise_mm: (scatter * noise / equations.len().max(1) as f64).sqrt(),
        parts_mm: [rms(0..3), rms(3..6), rms(6..PARAMETERS)],
    })
}

/// Prior precisions of the parameters: a standard deviation of [`PRIOR_MM`] for the mean particle.
fn prior(equations: &[Equation]) -> SVector<f64, PARAMETERS> {
    let mut squares = SVector::<f64, PARAMETERS>::zeros();
    for equation in equations {
        squares += SVector::from_fn(|n, _| equation.sensitivity.column(n).norm_squared());
    }
    squares / (equations.len().max(1) as f64 * PRIOR_MM * PRIOR_MM)
}

/// Median squared distance of the particles from a bench error, in variances.
fn median_distance(equations: &[Equation], parameters: &SVector<f64, PARAMETERS>) -> f64 {
    median(equations.iter().map(|e| e.distance(parameters))).unwrap_or_default()
}

/// Variance of a pixel's residual near the particles of one camera, in counts².
fn variance(position_equations: &[PositionEquations]) -> f64 {
    let (misfit, pixels) = position_equations
        .iter()
        .fold((0.0, 0usize), |(misfit, pixels), p| (misfit + p.misfit, pixels + p.pixels));
    misfit / pixels.max(1) as f64
}
