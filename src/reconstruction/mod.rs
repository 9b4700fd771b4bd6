//! From views to volumes.

mod settings;

pub use settings::{ReconstructionSettings, Solver};
