//! From views to volumes.

pub mod convergence;
pub mod hull;
pub mod os_mart;
mod pr;
pub mod quality;
mod sart;
mod settings;
mod solve;
pub mod subsets;
mod volume;

pub use convergence::{ConvergenceLog, PassReport};
pub use pr::pr_sart;
pub use sart::{SartOptions, sart};
pub use settings::{Footprint, ReconstructionSettings, Solver};
pub use solve::{Reconstruction, Reconstructor, ViewLevels};
pub use volume::{DenseVolume, SparseVolume};
