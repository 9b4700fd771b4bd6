//! What many shots say together: means, fluctuations, Reynolds stresses, skewness, how sure each is, how it
//! converges, how far fluctuations reach in space.
//!
//! [`Ensemble`] takes shots one at a time, in any order, and keeps moments, no shots. Two ensembles of the same
//! places can be put together. [`Ensemble::estimates`] gives the statistics of each place with intervals that
//! hold the scatter of the flow and, apart from it, that of the measurement; [`Ensemble::convergence`] says how
//! they settle; [`Ensemble::correlations`] and [`Correlation::spectrum`] look along the lattice's axes.
//!
//! Velocities are in m/s, lengths in mm, as in docs/theory.md, section 8, which has the formulas.

mod convergence;
mod estimate;
mod jackknife;
mod moments;
mod places;
mod sample;
mod spectrum;
mod student;
mod two_point;

#[cfg(test)]
mod tests;

pub use convergence::Convergence;
pub use estimate::{Estimate, Estimates, Quantity};
pub use places::Ensemble;
pub use sample::{Sample, Snapshot};
pub use spectrum::Spectrum;
pub use two_point::Correlation;
