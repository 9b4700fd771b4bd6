//! Reconstruction of volumes from views.

mod block_volume;
mod coarse_to_fine;
pub mod convergence;
pub mod hull;
mod levels;
mod light;
mod model_fit;
mod os_mart;
mod os_sart;
mod pass;
mod pr;
mod probes;
pub mod quality;
mod sart;
mod scheme;
mod settings;
mod solve;
pub mod subsets;
mod volume;

pub use block_volume::BlockVolume;
pub use convergence::{ConvergenceLog, PassReport};
pub use levels::ViewLevels;
pub use light::{FrameLight, MaximumProjection};
pub use model_fit::{CameraFit, FitVerdict, ModelFit};
pub use pr::pr_sart;
pub use probes::ProjectedView;
pub use sart::{SartOptions, sart};
pub use settings::{Domain, Footprint, ReconstructionSettings, Solver};
pub use solve::{Reconstruction, Reconstructor};
pub use volume::{DenseVolume, SparseVolume};
