//! From views to volumes.

pub mod hull;
pub mod os_mart;
mod settings;
mod solve;
pub mod subsets;
mod volume;

pub use settings::{Footprint, ReconstructionSettings, Solver};
pub use solve::{Reconstructor, ViewLevels};
pub use volume::{DenseVolume, SparseVolume};
