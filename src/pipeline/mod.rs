//! Worker pool and the state of shots: results in memory, events, result files.

mod board;
mod events;
mod gallery;
mod latency;
mod live_statistics;
mod monotonic;
mod pair_times;
mod pool;
#[cfg(test)]
mod test_data;
mod writer;

pub use board::{Board, Lookup, PoolCounts, RESULTS_IN_MEMORY, ShotRecord, Stage, Watermarks};
pub use events::{Batch, EVENTS_IN_MEMORY, Event, EventKind, EventLog};
pub use gallery::{Gallery, PROJECTION_MEMORY_BYTES, VOLUME_MEMORY_BYTES};
pub use latency::LatencyQuantiles;
pub use live_statistics::LiveStatistics;
pub use monotonic::monotonic;
pub use pair_times::{HungPair, PairTimes};
pub use pool::{
    Pool, PoolError, PoolLinks, PoolSettings, measuring_threads, process_guarded,
    run_after_acquisition,
};
pub use writer::{Finished, Observer, ResultSink, ResultWriter};
