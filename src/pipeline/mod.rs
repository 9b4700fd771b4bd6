//! From image pairs to results.

mod board;
mod pair;
mod plan;
mod pool;
mod processor;
mod writer;

pub use crate::reconstruction::DenseVolume;
pub use board::{Board, Lookup, PoolCounts, RESULTS_IN_MEMORY, ShotRecord, Stage};
pub use pair::{ImagePair, PairResult, StageSeconds};
pub use plan::Plan;
pub use pool::{Pool, PoolError, PoolLinks, PoolSettings};
pub use processor::{Measurement, ProcessError, Processor, SetupError};
pub use writer::{Observer, ResultSink};
