//! From the images of a pair to vectors: what is measured with which model, and how well it fits.

mod choose;
mod fitted;
mod frame;
mod model_fit;
mod part_errors;
mod plan;
mod processor;
mod scene;

pub use plan::Plan;
pub use processor::{Measurement, ProcessError, Processor, SetupError};
