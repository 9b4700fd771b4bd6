//! From views to volumes.

pub mod convergence;
pub mod hull;
mod levels;
pub mod os_mart;
mod pr;
pub mod quality;
mod sart;
mod settings;
mod solve;
pub mod subsets;
mod volume;

pub use convergence::{ConvergenceLog, PassReport};
pub use levels::ViewLevels;
pub use pr::pr_sart;
pub use sart::{SartOptions, sart};
pub use settings::{Footprint, ReconstructionSettings, Solver};
pub use solve::{Reconstruction, Reconstructor};
pub use volume::{DenseVolume, SparseVolume};
