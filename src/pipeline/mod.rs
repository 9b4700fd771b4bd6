//! From image pairs to results.

mod pair;
mod processor;

pub use pair::{ImagePair, PairResult, StageSeconds};
pub use processor::{DenseVolume, Measurement, ProcessError, Processor, SetupError};
