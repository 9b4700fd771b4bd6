//! From image pairs to results.

mod board;
mod choose;
mod fitted;
mod frame;
mod latency;
mod part_errors;
mod plan;
mod pool;
mod processor;
mod scene;
mod writer;

pub use crate::{
    lightfield::ImagePair,
    reconstruction::DenseVolume,
    velocimetry::{PairResult, StageSeconds},
};
pub use board::{Board, Lookup, PoolCounts, RESULTS_IN_MEMORY, ShotRecord, Stage};
pub use latency::LatencyQuantiles;
pub use plan::Plan;
pub use pool::{Pool, PoolError, PoolLinks, PoolSettings};
pub use processor::{Measurement, ProcessError, Processor, SetupError};
pub use writer::{Observer, ResultSink};
