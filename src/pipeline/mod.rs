//! From image pairs to results.

mod pair;
mod processor;

pub use crate::reconstruction::DenseVolume;
pub use pair::{ImagePair, PairResult, StageSeconds};
pub use processor::{Measurement, ProcessError, Processor, SetupError};
