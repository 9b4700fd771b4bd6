//! From views to volumes.

pub mod hull;
pub mod os_mart;
mod settings;
pub mod subsets;
mod volume;

pub use settings::{ReconstructionSettings, Solver};
pub use volume::{DenseVolume, SparseVolume};
