//! Workers, rates and backlog, for readers.

use std::{
    sync::{
        Arc, OnceLock,
        atomic::{AtomicU64, Ordering},
    },
    time::{Duration, Instant},
};

use serde::Serialize;
use utoipa::ToSchema;

use super::{Coordinator, JobQueue, WorkerView};

/// Shots of a run that workers measure.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq, Serialize, ToSchema)]
pub struct ShotsView {
    /// Shots without a result that are still to be measured.
    pub backlog: u64,
    /// Those of them that workers are measuring.
    pub in_hand: u64,
    /// Shots that were given up: too many failures or lost workers.
    pub given_up: u64,
    /// Measurements that workers have begun.
    pub attempts: u64,
    /// Measurements that their workers did not end.
    pub lost_workers: u64,
    /// Results that were refused: damaged, or not of this run.
    pub refused_results: u64,
}

/// A shot that was given up.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, ToSchema)]
pub struct GivenUpView {
    pub shot: u64,
    /// What workers have reported of it, and which were lost over it.
    pub reasons: Vec<String>,
}

/// Workers, and what has become of the shots.
#[derive(Debug, Clone, Default)]
pub struct Progress {
    pub workers: Vec<WorkerView>,
    pub shots: ShotsView,
    pub given_up: Vec<GivenUpView>,
}

/// A cluster as readers see it.
#[derive(Debug, Clone, PartialEq, Serialize, ToSchema)]
pub struct ClusterView {
    /// Address of the broker.
    pub broker: String,
    /// Whether the broker answers. While it does not, shots wait.
    pub connected: bool,
    /// Time without a sign of life after which a worker is lost.
    pub heartbeat_timeout_s: f64,
    /// First results a second, of all workers, over the last minute.
    pub shots_per_s: f64,
    /// What has become of the shots.
    pub shots: ShotsView,
    /// The first hundred of the shots that were given up.
    pub given_up: Vec<GivenUpView>,
    /// All workers that were heard of, by name.
    pub workers: Vec<WorkerView>,
}

/// See the module.
pub struct ClusterProgress {
    queue: JobQueue,
    heartbeat_timeout: Duration,
    /// There is none before the forward model is decided.
    coordinator: OnceLock<Arc<Coordinator>>,
    /// Shots that the coordinator does not have yet.
    waiting: AtomicU64,
}

impl ClusterProgress {
    /// Of the jobs in `queue`; a worker without a heartbeat for so long is lost.
    pub fn new(queue: JobQueue, heartbeat_timeout: Duration) -> Self {
        let (coordinator, waiting) = (OnceLock::new(), AtomicU64::new(0));
        Self { queue, heartbeat_timeout, coordinator, waiting }
    }

    /// From now on, that is the one that knows.
    pub fn follow(&self, coordinator: Arc<Coordinator>) {
        // A run has one.
        let _ = self.coordinator.set(coordinator);
    }

    /// Number of shots that the coordinator does not have yet.
    pub fn set_waiting(&self, shots: usize) {
        self.waiting.store(shots as u64, Ordering::Relaxed);
    }

    /// All of it, now.
    pub fn view(&self) -> ClusterView {
        let progress = self.coordinator.get().map(|known| known.progress(Instant::now()));
        let Progress { workers, mut shots, given_up } = progress.unwrap_or_default();
        shots.backlog += self.waiting.load(Ordering::Relaxed);
        ClusterView {
            broker: self.queue.address().to_owned(),
            connected: self.queue.is_connected(),
            heartbeat_timeout_s: self.heartbeat_timeout.as_secs_f64(),
            shots_per_s: workers.iter().map(|worker| worker.shots_per_s).sum(),
            shots,
            given_up,
            workers,
        }
    }
}
