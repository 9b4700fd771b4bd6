//! What the handlers read.

use std::{path::PathBuf, sync::Arc, time::Instant};

use parking_lot::Mutex;
use serde::Serialize;

use crate::{
    acquisition::{Journal, Ledger},
    pipeline::Board,
};

/// How far the run is.
#[derive(Debug, Clone, PartialEq, Eq, Serialize)]
#[serde(rename_all = "snake_case")]
pub enum Phase {
    /// Tables are built, devices opened.
    Starting,
    /// Shots are taken.
    Running,
    /// No more triggers; shots in hand are finished.
    Stopping,
    /// Every shot is accounted for and the results are closed.
    Finished,
    /// The run ended before its time; the text says why.
    Failed(String),
}

/// What does not change during a run.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct RunInfo {
    /// Version of this program.
    pub code_version: String,
    /// What a voxel does to a pixel, in words.
    pub model: String,
    /// How volumes are reconstructed, in words.
    pub solver: String,
    /// The configuration in brief.
    pub configuration: ConfigurationSummary,
    /// Where the results are.
    pub results_dir: PathBuf,
}

/// The configuration in brief.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct ConfigurationSummary {
    /// The file.
    pub file: PathBuf,
    /// Whether the bench is simulated.
    pub simulated: bool,
    /// Names of the cameras.
    pub cameras: Vec<String>,
    /// Voxels along x, y, z.
    pub voxels_xyz: [usize; 3],
    /// Edge of a voxel.
    pub voxel_mm: f64,
    /// Edge of an interrogation window.
    pub window_mm: f64,
    /// Time between the light pulses.
    pub dt_us: f64,
    /// Shots per second that the bench gives.
    pub rate_hz: f64,
    /// Shots asked for; unbounded when absent.
    pub shots: Option<u64>,
    /// What happens when the queue is full: `shed` or `wait`.
    pub overload: String,
    /// Shots that fit in the queue.
    pub queue: usize,
}

/// Shared by all handlers; cheap to clone.
#[derive(Clone)]
pub struct ApiState {
    pub(super) info: Arc<RunInfo>,
    pub(super) ledger: Arc<Mutex<Ledger>>,
    pub(super) board: Arc<Board>,
    pub(super) journal: Journal,
    pub(super) began: Instant,
    phase: Arc<Mutex<Phase>>,
}

impl ApiState {
    /// The state of a run that is starting.
    pub fn new(
        info: RunInfo,
        ledger: Arc<Mutex<Ledger>>,
        board: Arc<Board>,
        journal: Journal,
    ) -> Self {
        let phase = Arc::new(Mutex::new(Phase::Starting));
        Self { info: Arc::new(info), ledger, board, journal, began: Instant::now(), phase }
    }

    /// The run has come this far.
    pub fn set_phase(&self, phase: Phase) {
        *self.phase.lock() = phase;
    }

    /// How far the run is.
    pub fn phase(&self) -> Phase {
        self.phase.lock().clone()
    }
}
