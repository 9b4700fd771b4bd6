//! From image pairs to results.

mod board;
mod choose;
mod events;
mod fitted;
mod frame;
mod gallery;
mod latency;
mod model_fit;
mod pair_times;
mod part_errors;
mod plan;
mod pool;
mod processor;
mod scene;
#[cfg(test)]
mod test_data;
mod writer;

pub use crate::{
    lightfield::ImagePair,
    reconstruction::DenseVolume,
    velocimetry::{PairResult, StageSeconds},
};
pub use board::{Board, Lookup, PoolCounts, RESULTS_IN_MEMORY, ShotRecord, Stage, Watermarks};
pub use events::{Batch, EVENTS_IN_MEMORY, Event, EventKind, EventLog};
pub use gallery::{Gallery, PROJECTION_MEMORY_BYTES, VOLUME_MEMORY_BYTES};
pub use latency::LatencyQuantiles;
pub use pair_times::{HungPair, PairTimes};
pub use plan::Plan;
pub use pool::{Pool, PoolError, PoolLinks, PoolSettings};
pub use processor::{Measurement, ProcessError, Processor, SetupError};
pub use writer::{Observer, ResultSink};
