//! What a bench can be expected to measure, before it is built: the uncertainty of vectors over the volume, from
//! optics, light and seeding alone (docs/theory.md, section 10).
//!
//! Two answers, neither of which has a constant that was fitted:
//!
//! - what the images *hold* ([`bound`]): a particle is known as exactly as its image changes when it moves (Cramér
//!   and Rao);
//! - what is *measured* ([`forecast`]): random particles in a `flow` are imaged (`exposure`) and measured as a real
//!   pair would be (`trial`), and the errors of the vectors are collected (propagation of distributions by Monte
//!   Carlo, JCGM 101). The reconstruction is no efficient estimator: it divides light between particles that lie over
//!   each other, is stopped early, and has voxels. What that costs no formula tells.

mod bound;
mod exposure;
mod flow;
mod footprint;
mod trial;

use rand::SeedableRng;
use rand_pcg::Pcg64Mcg;
use thiserror::Error;

use self::trial::SimulatedBench;
use super::{Measurement, ProcessError, SetupError};
use crate::{model::ModelError, velocimetry::VectorGrid};
pub use bound::bound;

/// The same numbers every time: a forecast does not scatter.
const SEED: u64 = 1;

/// Vectors whose errors are collected, at least: in each of five slabs a root mean square is then known to a tenth,
/// where an eighth of half-overlapping windows are independent.
const VECTORS: usize = 2000;

/// Most pairs for it.
const MOST_PAIRS: usize = 12;

/// What is in front of the cameras.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SceneConditions {
    /// Particles per microlens: their number over that of the microlens pitches on the volume's face along x
    /// and y.
    pub ppm: f64,
    /// Half-width of the uniform distribution of relative brightness about 1.
    pub intensity_spread: f64,
    /// Photo-electrons that the mean particle releases in each camera and exposure, of all its light that
    /// passes the pupil.
    pub photoelectrons: f64,
    /// Photo-electrons of stationary light in a pixel.
    pub background_electrons: f64,
    /// Standard deviation of a pixel's read-out, in electrons, without that of rounding.
    pub read_noise_electrons: f64,
    /// Counts per photo-electron.
    pub counts_per_electron: f64,
    /// Black level, in counts.
    pub offset_counts: f64,
    /// Largest count.
    pub saturation_counts: u16,
    /// Wavelength of the light, in nm, where diffraction is to be counted.
    pub diffraction_nm: Option<f64>,
}

/// The uncertainty to expect at a place.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ForecastPlace {
    /// Where, in mm.
    pub position_mm: [f64; 3],
    /// Standard uncertainty of the displacement along x, y, z, in voxels; infinite where nothing is measured.
    pub uncertainty_vox: [f64; 3],
}

/// What trials of a bench gave.
#[derive(Debug, Clone, PartialEq)]
pub struct Forecast {
    /// Every vector of the lattice that was valid in a pair, or more: the root of its mean square errors.
    pub places: Vec<ForecastPlace>,
    /// Share of the vectors that were valid, 0 to 1.
    pub valid_share: f64,
    /// Pairs that were imaged and measured.
    pub pairs: usize,
}

/// Why there is no forecast.
#[derive(Debug, Error)]
pub enum ForecastError {
    /// The cameras do not see the volume.
    #[error(transparent)]
    Setup(#[from] SetupError),
    /// A pair that cannot be measured.
    #[error(transparent)]
    Process(#[from] ProcessError),
}

impl From<ModelError> for ForecastError {
    fn from(error: ModelError) -> Self {
        Self::Setup(error.into())
    }
}

/// Forecasts the error of vectors all over the volume by trials in a flow that windows can follow.
///
/// Errors due to rougher flows and to deviations of the bench from its nominal geometry are not included. In a uniform
/// flow the error is half as large.
///
/// # Errors
/// A camera does not see the volume, or it reaches too deep for the lens.
pub fn forecast(
    measurement: &Measurement,
    conditions: &SceneConditions,
) -> Result<Forecast, ForecastError> {
    let bench = SimulatedBench::new(measurement, conditions)?;
    let vectors = bench.vector_grid().len().max(1);
    after_pairs(&bench, VECTORS.div_ceil(vectors).clamp(1, MOST_PAIRS))
}

/// The forecast from so many pairs.
fn after_pairs(bench: &SimulatedBench<'_>, pairs: usize) -> Result<Forecast, ForecastError> {
    let grid = bench.vector_grid();
    let mut sums = vec![([0.0; 3], 0usize); grid.len()];
    let mut in_flow = 0;
    for pair in 0..pairs {
        let errors = bench.errors_vox(pair as u64)?;
        in_flow += errors.in_flow;
        for (n, error) in errors.valid {
            let (squares, count) = &mut sums[n];
            (0..3).for_each(|c| squares[c] += error[c] * error[c]);
            *count += 1;
        }
    }
    let valid: usize = sums.iter().map(|(_, count)| count).sum();
    let valid_share = valid as f64 / in_flow.max(1) as f64;
    Ok(Forecast { places: places(&grid, &sums), valid_share, pairs })
}

/// The vectors that have errors: their sums of squares along x, y, z, and how many.
fn places(grid: &VectorGrid, sums: &[([f64; 3], usize)]) -> Vec<ForecastPlace> {
    let measured = sums.iter().enumerate().filter(|(_, (_, count))| *count > 0);
    measured
        .map(|(n, (squares, count))| ForecastPlace {
            position_mm: grid.position_mm(n),
            uncertainty_vox: squares.map(|square| (square / *count as f64).sqrt()),
        })
        .collect()
}

/// A seeded generator, so that a forecast is the same every time.
fn generator(stream: u64) -> Pcg64Mcg {
    Pcg64Mcg::seed_from_u64(SEED.wrapping_mul(1 << 32) + stream)
}

#[cfg(test)]
mod tests;
