//! The state of shots handed to the pool. The pool writes it and the server reads it; every change
//! is published to the event log.

use std::{
    collections::{BTreeMap, BTreeSet},
    sync::Arc,
    time::Duration,
};

use lfpiv_core::{model::ModelChoice, reconstruction::ModelFit, velocimetry::StageSeconds};
use parking_lot::Mutex;
use serde::Serialize;

use super::{
    EventKind, EventLog, Gallery, LiveStatistics, PairTimes,
    latency::{Latencies, LatencyQuantiles},
};
use crate::{acquisition::Heartbeat, archive::ShotResult};

/// Number of results kept in memory; older ones are on disk only.
pub const RESULTS_IN_MEMORY: usize = 32;
/// Number of records kept in memory: a few hours of shots.
const RECORDS_IN_MEMORY: usize = 10_000;

/// Stage of a shot in the pool.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize)]
#[serde(rename_all = "snake_case")]
pub enum Stage {
    /// In process by a worker.
    Processing,
    /// Measured and written.
    Done,
    /// No result; `message` says why.
    Failed,
    /// Measured, but not written; `message` says why.
    WriteFailed,
}

/// One shot in the pool.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct ShotRecord {
    /// Shot number.
    pub shot: u64,
    /// Its stage.
    pub stage: Stage,
    /// Why there is no result, or no file.
    pub message: Option<String>,
    /// Warnings for readers of the result, including why a shot is suspect.
    pub warnings: Vec<String>,
    /// Whether the images match the configured bench; absent without a result.
    pub fit: Option<ModelFit>,
    /// Number of vectors; absent without a result.
    pub vectors: Option<usize>,
    /// Share of vectors that are valid, 0 to 1; absent without a result.
    pub valid_share: Option<f64>,
    /// Seconds per stage; absent without a result.
    pub seconds: Option<StageSeconds>,
}

impl ShotRecord {
    fn new(shot: u64, stage: Stage, message: Option<String>) -> Self {
        let (warnings, fit, vectors, valid_share, seconds) = (Vec::new(), None, None, None, None);
        Self { shot, stage, message, warnings, fit, vectors, valid_share, seconds }
    }

    fn of_result(shot: u64, stage: Stage, message: Option<String>, result: &ShotResult) -> Self {
        let measured = &result.measured;
        Self {
            warnings: measured.warnings.clone(),
            fit: measured.fit.clone(),
            vectors: Some(measured.field.grid.len()),
            valid_share: Some(measured.field.valid_share()),
            seconds: Some(measured.seconds),
            ..Self::new(shot, stage, message)
        }
    }
}

/// Number of shots per stage.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq, Serialize)]
pub struct PoolCounts {
    /// In process now.
    pub processing: u64,
    /// Measured and written.
    pub done: u64,
    /// Without a result.
    pub failed: u64,
    /// Measured, but not written.
    pub write_failed: u64,
}

impl PoolCounts {
    fn add(&mut self, ended: Stage) {
        match ended {
            Stage::Processing => {}
            Stage::Done => self.done += 1,
            Stage::Failed => self.failed += 1,
            Stage::WriteFailed => self.write_failed += 1,
        }
    }
}

/// Durability of the run's data: the number of shots at each level.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq, Serialize)]
pub struct Watermarks {
    /// Their frames have arrived.
    pub acquired: u64,
    /// Their frames are paired.
    pub paired: u64,
    /// Their raw data has been written to the kernel: it survives a crash of this program.
    pub written: u64,
    /// Their raw data has been synced to disk: it survives a power cut.
    pub fsynced: u64,
    /// Their velocity is stored, and their raw data is at least written.
    pub processed: u64,
}

/// Result of a lookup.
#[derive(Debug, Clone)]
// One answer at a time: its size costs nothing.
#[allow(clippy::large_enum_variant)]
pub enum Lookup {
    /// In memory.
    Here(Arc<ShotResult>),
    /// No longer in memory, but on disk.
    OnDisk,
    /// The shot has no result (yet); its record says why.
    NoResult(ShotRecord),
    /// The pool has no such shot.
    Unknown,
}

/// See the module.
#[derive(Debug, Default)]
pub struct Board {
    state: Mutex<State>,
    writing: Heartbeat,
    pair_times: PairTimes,
    events: EventLog,
    gallery: Gallery,
    statistics: LiveStatistics,
}

#[derive(Debug, Default)]
struct State {
    records: BTreeMap<u64, ShotRecord>,
    results: BTreeMap<u64, Arc<ShotResult>>,
    processing: BTreeSet<u64>,
    counts: PoolCounts,
    latencies: Latencies,
    /// The model of the last result.
    model: Option<Arc<ModelChoice>>,
    /// `None` if nothing is recorded.
    watermarks: Option<Watermarks>,
    /// Highest shot number whose record was dropped.
    highest_dropped: Option<u64>,
}

impl Board {
    /// An empty board.
    pub fn new() -> Self {
        Self::default()
    }

    /// Beats when the result writer starts a shot, rests when it is done.
    pub fn writing(&self) -> &Heartbeat {
        &self.writing
    }

    /// An empty board with this time limit for the first pair.
    pub fn with_patience(first_pair: Duration) -> Self {
        Self { pair_times: PairTimes::new(first_pair), ..Self::default() }
    }

    /// Processing times and hung workers.
    pub fn pair_times(&self) -> &PairTimes {
        &self.pair_times
    }

    /// The event log.
    pub fn events(&self) -> &EventLog {
        &self.events
    }

    /// Images of the latest shots.
    pub fn gallery(&self) -> &Gallery {
        &self.gallery
    }

    /// The statistics of the results that were written.
    pub fn statistics(&self) -> &LiveStatistics {
        &self.statistics
    }

    /// A shot of a run that is over, as it ended; nobody is told. Its result is kept as the latest ones are.
    pub fn restore(&self, record: ShotRecord, result: Option<Arc<ShotResult>>) {
        let mut state = self.state.lock();
        state.counts.add(record.stage);
        if let Some(result) = result {
            state.keep(record.shot, result);
        }
        state.record(record);
    }

    /// Records that a worker has started a shot.
    pub fn processing(&self, shot: u64) {
        let mut state = self.state.lock();
        state.processing.insert(shot);
        state.record(ShotRecord::new(shot, Stage::Processing, None));
    }

    /// Records that a shot gave no result.
    pub fn failed(&self, shot: u64, message: String) -> ShotRecord {
        self.finish(ShotRecord::new(shot, Stage::Failed, Some(message)), None)
    }

    /// Records that a shot was measured and written.
    pub fn done(&self, shot: u64, result: Arc<ShotResult>) -> ShotRecord {
        self.statistics.add_field(shot, &result.measured.field);
        self.finish(ShotRecord::of_result(shot, Stage::Done, None, &result), Some(result))
    }

    /// Records that a shot was measured, but its result could not be written.
    pub fn write_failed(&self, shot: u64, result: Arc<ShotResult>, message: String) -> ShotRecord {
        let record = ShotRecord::of_result(shot, Stage::WriteFailed, Some(message), &result);
        self.finish(record, Some(result))
    }

    /// Records that a shot was measured, and its result was lost before it was written.
    pub fn write_lost(&self, shot: u64, message: String) -> ShotRecord {
        self.finish(ShotRecord::new(shot, Stage::WriteFailed, Some(message)), None)
    }

    /// Events are published under the lock, so that a reader of an event finds the shot here, and the
    /// last event of a shot is that of its end.
    fn finish(&self, record: ShotRecord, result: Option<Arc<ShotResult>>) -> ShotRecord {
        let mut state = self.state.lock();
        state.counts.add(record.stage);
        let fetchable = result.map(|result| state.keep(record.shot, result)).is_some();
        state.processing.remove(&record.shot);
        state.record(record.clone());
        self.events.publish(EventKind::Shot, &record);
        if fetchable {
            self.events.publish(EventKind::Result, &ResultReady::of(&record));
        }
        record
    }

    /// Sets the watermarks, and publishes them if they have changed.
    pub fn set_watermarks(&self, watermarks: Watermarks) {
        let mut state = self.state.lock();
        if state.watermarks != Some(watermarks) {
            state.watermarks = Some(watermarks);
            self.events.publish(EventKind::Watermarks, &watermarks);
        }
    }

    /// The watermarks; `None` if nothing is recorded.
    pub fn watermarks(&self) -> Option<Watermarks> {
        self.state.lock().watermarks
    }

    /// Records the time from a shot's trigger to its stored velocity.
    pub fn record_latency(&self, latency: Duration) {
        self.state.lock().latencies.add(latency);
    }

    /// Latency of the last shots; `None` before the first.
    pub fn latency(&self) -> Option<LatencyQuantiles> {
        self.state.lock().latencies.quantiles()
    }

    /// Number of shots per stage.
    pub fn counts(&self) -> PoolCounts {
        let state = self.state.lock();
        PoolCounts { processing: state.processing.len() as u64, ..state.counts }
    }

    /// Shots in process.
    pub fn in_process(&self) -> Vec<u64> {
        self.state.lock().processing.iter().copied().collect()
    }

    /// A shot's record.
    pub fn record(&self, shot: u64) -> Option<ShotRecord> {
        self.state.lock().records.get(&shot).cloned()
    }

    /// The result of the highest shot number in memory.
    pub fn latest(&self) -> Option<(u64, Arc<ShotResult>)> {
        let state = self.state.lock();
        state.results.last_key_value().map(|(shot, result)| (*shot, result.clone()))
    }

    /// The forward model of the last result; `None` before the first.
    pub fn model(&self) -> Option<Arc<ModelChoice>> {
        self.state.lock().model.clone()
    }

    /// Looks up a shot's result.
    pub fn result(&self, shot: u64) -> Lookup {
        let state = self.state.lock();
        match (state.results.get(&shot), state.records.get(&shot)) {
            (Some(result), _) => Lookup::Here(result.clone()),
            (None, Some(record)) if record.stage == Stage::Done => Lookup::OnDisk,
            (None, Some(record)) => Lookup::NoResult(record.clone()),
            (None, None) if state.highest_dropped.is_some_and(|last| shot <= last) => {
                Lookup::OnDisk
            }
            (None, None) => Lookup::Unknown,
        }
    }
}

impl State {
    fn keep(&mut self, shot: u64, result: Arc<ShotResult>) {
        self.model = Some(result.measured.model.clone());
        self.results.insert(shot, result);
        while self.results.len() > RESULTS_IN_MEMORY {
            self.results.pop_first();
        }
    }

    fn record(&mut self, record: ShotRecord) {
        self.records.insert(record.shot, record);
        while self.records.len() > RECORDS_IN_MEMORY {
            let oldest = self.records.pop_first().map(|(shot, _)| shot);
            self.highest_dropped = self.highest_dropped.max(oldest);
        }
    }
}

/// The event of a result that can be fetched.
#[derive(Debug, Serialize)]
struct ResultReady {
    shot: u64,
    vectors: Option<usize>,
    valid_share: Option<f64>,
}

impl ResultReady {
    fn of(record: &ShotRecord) -> Self {
        Self { shot: record.shot, vectors: record.vectors, valid_share: record.valid_share }
    }
}

#[cfg(test)]
#[path = "board_tests.rs"]
mod tests;
