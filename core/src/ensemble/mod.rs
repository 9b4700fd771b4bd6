//! Statistics of many shots: means, fluctuations, Reynolds stresses, skewness, their confidence intervals and
//! convergence, two-point correlations and spectra.
//!
//! [`Ensemble`] accumulates moments of shots, one at a time and in any order, without storing the shots.
//! Ensembles on the same lattice can be merged. [`Ensemble::estimates`] gives the statistics at each node with
//! uncertainties due to the flow and due to the measurement, [`Ensemble::convergence`] their convergence with
//! the number of shots, and [`Ensemble::correlations`] and [`Correlation::spectrum`] the correlations and
//! spectra along the lattice's axes.
//!
//! Velocities are in m/s, lengths in mm. The equations are in docs/theory.md, section 8.

mod convergence;
mod estimate;
mod jackknife;
mod moments;
mod nodes;

mod sample;
mod spectrum;
mod student;
mod two_point;

#[cfg(test)]
mod tests;

pub use convergence::Convergence;
pub use estimate::{Estimate, Estimates, Quantity};
pub use nodes::Ensemble;
pub use sample::{Sample, Snapshot};
pub use spectrum::Spectrum;
pub use two_point::Correlation;
