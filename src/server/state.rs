//! The state of the run that handlers read.

use std::{fmt, path::PathBuf, sync::Arc, time::Instant};

use parking_lot::Mutex;
use serde::Serialize;
use utoipa::ToSchema;

use super::{
    brief::Brief,
    configuration::BenchSettings,
    control::{ControlAccess, Controls},
    frames::FrameSource,
    result_source::ResultSource,
};
use crate::{
    acquisition::{Heartbeat, Journal, Ledger},
    cluster::ClusterProgress,
    pipeline::{Board, EventKind, Watermarks},
};

/// Phase of the run.
#[derive(Debug, Clone, PartialEq, Eq, Serialize)]
#[serde(rename_all = "snake_case")]
pub enum Phase {
    /// Tables are built and devices opened.
    Starting,
    /// Shots are taken.
    Running,
    /// No further triggers; pending shots are finished.
    Stopping,
    /// Every shot is accounted for and the results are closed.
    Finished,
    /// The run ended early; the text gives the reason.
    Failed(String),
}

/// Properties that do not change during a run.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct RunInfo {
    /// Version of this program.
    pub code_version: String,
    /// The forward model in words.
    pub model: String,
    /// The reconstruction method in words.
    pub solver: String,
    /// Summary of the configuration.
    pub configuration: ConfigurationSummary,
    /// Folder of the results.
    pub results_dir: PathBuf,
    /// Whether every shot gets a file for ParaView.
    pub paraview: bool,
}

/// Summary of the configuration.
#[derive(Debug, Clone, PartialEq, Serialize, ToSchema)]
pub struct ConfigurationSummary {
    /// The configuration file.
    #[schema(value_type = String)]
    pub file: PathBuf,
    /// Whether the bench is simulated.
    pub simulated: bool,
    /// Names of the cameras.
    pub cameras: Vec<String>,
    /// Calibrations of the cameras; cameras that are not listed are taken as nominal.
    pub calibrations: Vec<CalibrationSummary>,
    /// What of the volume is flow; absent if all of it is.
    pub mask: Option<MaskSummary>,
    /// Voxels along x, y, z.
    pub voxels_xyz: [usize; 3],
    /// Edge of a voxel.
    pub voxel_mm: f64,
    /// Edge of an interrogation window.
    pub window_mm: f64,
    /// Whether particles are placed in the images, of all shots or of those that need it.
    pub place_particles: bool,
    /// Centre of the volume in the world frame.
    pub centre_mm: [f64; 3],
    /// Largest displacement that is searched.
    pub max_displacement_vox: f64,
    /// Time between the light pulses.
    pub dt_us: f64,
    /// Shots per second.
    pub rate_hz: f64,
    /// Number of requested shots; absent if unlimited.
    pub shots: Option<u64>,
    /// What happens when the queue is full: `shed` or `wait`.
    pub overload: String,
    /// Capacity of the queue in shots.
    pub queue: usize,
}

/// The calibration of a camera.
#[derive(Debug, Clone, PartialEq, Serialize, ToSchema)]
pub struct CalibrationSummary {
    /// Name of the camera.
    pub camera: String,
    /// The calibration file.
    #[schema(value_type = String)]
    pub file: PathBuf,
    /// SHA-256 hash of the file.
    pub sha256: String,
}

/// The mask of the volume.
#[derive(Debug, Clone, PartialEq, Serialize, ToSchema)]
pub struct MaskSummary {
    /// Share of the voxels that are flow, 0 to 1.
    pub flow_share: f64,
    /// The files of bodies.
    pub files: Vec<MaskFileSummary>,
}

/// A file that the mask was made from.
#[derive(Debug, Clone, PartialEq, Serialize, ToSchema)]
pub struct MaskFileSummary {
    /// As the configuration names it.
    #[schema(value_type = String)]
    pub file: PathBuf,
    /// SHA-256 hash of the file.
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
    pub(super) control_access: ControlAccess,
    pub(super) frames: Arc<dyn FrameSource>,
    pub(super) results: Arc<dyn ResultSource>,
    /// The heartbeat of the run loop.
    pub(super) run_loop: Heartbeat,
    /// Absent if the run measures its shots itself.
    pub(super) cluster: Option<Arc<ClusterProgress>>,
    /// Absent if no bench is configured.
    pub(super) bench: Option<Arc<BenchSettings>>,
    phase: Arc<Mutex<Phase>>,
    /// The last published summary.
    last_announced: Arc<Mutex<Option<Brief>>>,
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
    /// The state of a starting run.
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
            control_access: ControlAccess::default(),
            run_loop: Heartbeat::default(),
            cluster: None,
            bench: None,
            phase,
            last_announced: Arc::default(),
        }
    }

    /// Makes the run controllable over HTTP. `arm` and `start` are refused unless an operator has
    /// enabled them at the bench for this run and the configuration allows them
    /// (`server.remote_arming`).
    pub fn with_controls(mut self, controls: Arc<dyn Controls>, enabled_at_bench: bool) -> Self {
        self.control_access = ControlAccess { controls: Some(controls), enabled_at_bench };
        self
    }

    /// Takes previews from this source instead of the board's latest frames.
    pub fn with_frames(mut self, frames: Arc<dyn FrameSource>) -> Self {
        self.frames = frames;
        self
    }

    /// Takes results from this source instead of the board's latest results.
    pub fn with_results(mut self, results: Arc<dyn ResultSource>) -> Self {
        self.results = results;
        self
    }

    /// Sets the configuration of the bench.
    pub fn with_bench(mut self, bench: BenchSettings) -> Self {
        self.bench = Some(Arc::new(bench));
        self
    }

    /// Shows the workers that measure the run's shots.
    pub fn with_cluster(mut self, cluster: Arc<ClusterProgress>) -> Self {
        self.cluster = Some(cluster);
        self
    }

    /// Sets the heartbeat of the run loop.
    pub fn with_run_loop(mut self, run_loop: Heartbeat) -> Self {
        self.run_loop = run_loop;
        self
    }

    /// Sets the phase and publishes it.
    pub fn set_phase(&self, phase: Phase) {
        *self.phase.lock() = phase;
        self.announce();
    }

    /// Publishes a summary of the run if it has changed.
    pub(super) fn announce(&self) {
        // Locked throughout, so that summaries are published in the order of the states.
        let mut last_announced = self.last_announced.lock();
        let brief = self.brief();
        if let Some(marks) = brief.watermarks {
            self.board.set_watermarks(marks);
        }
        if last_announced.as_ref() != Some(&brief) {
            self.board.events().publish(EventKind::Status, &brief);
            *last_announced = Some(brief);
        }
    }

    /// How many shots are safe at each level; `None` if nothing is recorded.
    pub(super) fn watermarks(&self) -> Option<Watermarks> {
        // Later levels are read first, so that no level appears ahead of an earlier one.
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

    /// The phase of the run.
    pub fn phase(&self) -> Phase {
        self.phase.lock().clone()
    }
}
