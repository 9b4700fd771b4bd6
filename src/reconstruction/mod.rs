//! From views to volumes.

pub mod convergence;
pub mod hull;
pub mod os_mart;
pub mod quality;
mod settings;
pub mod subsets;
mod volume;

pub use convergence::{ConvergenceLog, PassReport};
pub use settings::{ReconstructionSettings, Solver};
pub use volume::{DenseVolume, SparseVolume};
