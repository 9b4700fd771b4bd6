//! What the handlers read.

use std::{fmt, path::PathBuf, sync::Arc, time::Instant};

use parking_lot::Mutex;
use serde::Serialize;
use utoipa::ToSchema;

use super::{
    configuration::BenchSettings,
    control::{Controls, Desk},
    events::Brief,
    frames::FrameSource,
    results::ResultSource,
};
use crate::{
    acquisition::{Heartbeat, Journal, Ledger},
    pipeline::{Board, EventKind, Watermarks},
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
    /// Whether every shot gets a file for ParaView there.
    pub paraview: bool,
}

/// The configuration in brief.
#[derive(Debug, Clone, PartialEq, Serialize, ToSchema)]
pub struct ConfigurationSummary {
    /// The file.
    #[schema(value_type = String)]
    pub file: PathBuf,
    /// Whether the bench is simulated.
    pub simulated: bool,
    /// Names of the cameras.
    pub cameras: Vec<String>,
    /// Calibrations of the cameras; those that are not listed are taken as drawn.
    pub calibrations: Vec<CalibrationSummary>,
    /// Voxels along x, y, z.
    pub voxels_xyz: [usize; 3],
    /// Edge of a voxel.
    pub voxel_mm: f64,
    /// Edge of an interrogation window.
    pub window_mm: f64,
    /// Centre of the volume in the world frame.
    pub centre_mm: [f64; 3],
    /// Largest displacement that is looked for.
    pub max_displacement_vox: f64,
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

/// The calibration of a camera.
#[derive(Debug, Clone, PartialEq, Serialize, ToSchema)]
pub struct CalibrationSummary {
    /// Name of the camera.
    pub camera: String,
    /// The file that it was read from.
    #[schema(value_type = String)]
    pub file: PathBuf,
    /// The file's hash.
    pub sha256: String,
}

/// Shared by all handlers; cheap to clone.
#[derive(Clone)]
pub struct ApiState {
    pub(super) info: Arc<RunInfo>,
    pub(super) ledger: Arc<Mutex<Ledger>>,
    pub(super) board: Arc<Board>,
    pub(super) journal: Journal,
    pub(super) began: Instant,
    pub(super) desk: Desk,
    pub(super) frames: Arc<dyn FrameSource>,
    pub(super) results: Arc<dyn ResultSource>,
    /// Beats while the run loop turns.
    pub(super) run_loop: Heartbeat,
    /// Absent where no bench is configured.
    pub(super) bench: Option<Arc<BenchSettings>>,
    phase: Arc<Mutex<Phase>>,
    /// What was told last.
    told: Arc<Mutex<Option<Brief>>>,
}

impl fmt::Debug for ApiState {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let phase = self.phase();
        f.debug_struct("ApiState")
            .field("info", &self.info)
            .field("phase", &phase)
            .finish_non_exhaustive()
    }
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
        Self {
            info: Arc::new(info),
            ledger,
            frames: board.clone(),
            results: board.clone(),
            board,
            journal,
            began: Instant::now(),
            desk: Desk::default(),
            run_loop: Heartbeat::default(),
            bench: None,
            phase,
            told: Arc::default(),
        }
    }

    /// The run can be controlled over HTTP. `arm` and `start` are refused unless an operator has
    /// enabled them at the bench for this run, and the configuration has (`server.remote_arming`).
    pub fn with_controls(mut self, controls: Arc<dyn Controls>, enabled_at_bench: bool) -> Self {
        self.desk = Desk { controls: Some(controls), enabled_at_bench };
        self
    }

    /// Previews show the frames of this source, instead of the latest ones only.
    pub fn with_frames(mut self, frames: Arc<dyn FrameSource>) -> Self {
        self.frames = frames;
        self
    }

    /// Results are those of this source, instead of the latest ones only.
    pub fn with_results(mut self, results: Arc<dyn ResultSource>) -> Self {
        self.results = results;
        self
    }

    /// The bench is configured like this.
    pub fn with_bench(mut self, bench: BenchSettings) -> Self {
        self.bench = Some(Arc::new(bench));
        self
    }

    /// The run is alive while this beats.
    pub fn with_run_loop(mut self, run_loop: Heartbeat) -> Self {
        self.run_loop = run_loop;
        self
    }

    /// The run has come this far; whoever watches is told.
    pub fn set_phase(&self, phase: Phase) {
        *self.phase.lock() = phase;
        self.announce();
    }

    /// Tells of the run where it is not as it was told last.
    pub(super) fn announce(&self) {
        // Locked throughout: what is told last is what is true last.
        let mut told = self.told.lock();
        let brief = self.brief();
        if let Some(marks) = brief.watermarks {
            self.board.set_watermarks(marks);
        }
        if told.as_ref() != Some(&brief) {
            self.board.events().publish(EventKind::Status, &brief);
            *told = Some(brief);
        }
    }

    /// How far data is safe, in numbers of shots; `None` where nothing is recorded.
    pub(super) fn watermarks(&self) -> Option<Watermarks> {
        // What comes last is read first: nothing seems to be further than what it follows from.
        let processed = self.board.counts().done;
        let marks = self.journal.log().map(|_| self.journal.marks());
        let Some(marks) = marks else { return self.board.watermarks() };
        let acquired = {
            let ledger = self.ledger.lock();
            let triggers = ledger.accounts().first().map_or(0, |account| account.triggers);
            triggers - ledger.awaiting_frames()
        };
        Some(Watermarks {
            acquired,
            paired: marks.paired,
            written: marks.written,
            fsynced: marks.synced,
            processed: processed.min(marks.written),
        })
    }

    /// How far the run is.
    pub fn phase(&self) -> Phase {
        self.phase.lock().clone()
    }
}
