//! `/api/v1/status` and `/healthz`.

use axum::{Json, extract::State, http::StatusCode};
use serde::Serialize;

use super::{ApiState, ConfigurationSummary, Phase};
use crate::{
    acquisition::{Account, Outcome, journal::ShotMarks},
    model::ModelChoice,
    pipeline::LatencyQuantiles,
};

/// The run at a glance.
#[derive(Debug, Serialize)]
pub(super) struct Status {
    state: &'static str,
    /// Why the run failed.
    error: Option<String>,
    uptime_s: f64,
    code_version: String,
    /// What is being done right now, in words.
    stage: String,
    shots: ShotCounts,
    ledger: LedgerView,
    /// How far the raw data has got; absent where none is kept.
    raw: Option<RawMarks>,
    /// From trigger to stored velocity; absent before the first result.
    latency: Option<LatencyQuantiles>,
    model: String,
    /// The parts of the model and why; absent before the first result.
    model_choice: Option<ModelChoice>,
    solver: String,
    configuration: ConfigurationSummary,
    results_dir: String,
}

/// How many shots are where; the sum of all but `triggered` is `triggered`.
#[derive(Debug, Clone, Copy, Default, Serialize)]
pub(super) struct ShotCounts {
    pub triggered: u64,
    pub awaiting_frames: u64,
    pub queued: u64,
    pub processing: u64,
    pub done: u64,
    pub failed: u64,
    pub write_failed: u64,
    pub shed: u64,
    pub lost: u64,
}

impl ShotCounts {
    pub fn of(state: &ApiState) -> Self {
        // While the ledger is locked no shot ends: both books tell of the same moment.
        let ledger = state.ledger.lock();
        let pool = state.board.counts();
        let account = ledger.accounts().first().copied().unwrap_or_default();
        let (handed_on, awaiting_frames) = (ledger.handed_on(), ledger.awaiting_frames());
        drop(ledger);
        let shed = account.outcomes.of(Outcome::Shed);
        let pooled = handed_on + pool.done + pool.failed + pool.write_failed;
        let processing = pool.processing.min(handed_on);
        Self {
            triggered: account.triggers,
            awaiting_frames,
            queued: handed_on - processing,
            processing,
            done: pool.done,
            failed: pool.failed,
            write_failed: pool.write_failed,
            shed,
            lost: account.triggers.saturating_sub(pooled + awaiting_frames + shed),
        }
    }
}

/// Watermarks of the raw data: how many shots have got how far, and what it takes.
#[derive(Debug, Clone, Copy, Serialize)]
pub(super) struct RawMarks {
    #[serde(flatten)]
    pub shots: ShotMarks,
    /// Shots with a stored result.
    pub processed: u64,
    pub bytes_in: u64,
    pub bytes_written: u64,
    pub segments: u32,
}

impl RawMarks {
    pub fn of(state: &ApiState) -> Option<Self> {
        let marks = state.journal.log()?.watermarks();
        Some(Self {
            shots: state.journal.marks(),
            processed: state.board.counts().done,
            bytes_in: marks.bytes_in,
            bytes_written: marks.bytes_written,
            segments: marks.segments,
        })
    }
}

#[derive(Debug, Serialize)]
struct LedgerView {
    /// Whether every trigger is accounted for.
    balanced: bool,
    cameras: Vec<CameraAccount>,
}

#[derive(Debug, Serialize)]
struct CameraAccount {
    camera: String,
    #[serde(flatten)]
    account: Account,
}

pub(super) async fn status(State(state): State<ApiState>) -> Json<Status> {
    let shots = ShotCounts::of(&state);
    let phase = state.phase();
    let info = &state.info;
    Json(Status {
        state: name(&phase),
        error: match &phase {
            Phase::Failed(reason) => Some(reason.clone()),
            _ => None,
        },
        uptime_s: state.began.elapsed().as_secs_f64(),
        code_version: info.code_version.clone(),
        stage: stage(&state, &phase, shots),
        shots,
        ledger: ledger(&state),
        raw: RawMarks::of(&state),
        latency: state.board.latency(),
        model: info.model.clone(),
        model_choice: state.board.model().map(|model| (*model).clone()),
        solver: info.solver.clone(),
        configuration: info.configuration.clone(),
        results_dir: info.results_dir.display().to_string(),
    })
}

fn ledger(state: &ApiState) -> LedgerView {
    let ledger = state.ledger.lock();
    let names = state.info.configuration.cameras.iter();
    let cameras = ledger.accounts().iter().zip(names);
    let cameras = cameras
        .map(|(account, camera)| CameraAccount { camera: camera.clone(), account: *account });
    LedgerView { balanced: ledger.is_balanced(), cameras: cameras.collect() }
}

fn name(phase: &Phase) -> &'static str {
    match phase {
        Phase::Starting => "starting",
        Phase::Running => "running",
        Phase::Stopping => "stopping",
        Phase::Finished => "finished",
        Phase::Failed(_) => "failed",
    }
}

fn stage(state: &ApiState, phase: &Phase, shots: ShotCounts) -> String {
    let working: Vec<String> =
        state.board.in_process().iter().map(|shot| shot.to_string()).collect();
    match phase {
        Phase::Starting => "building tables and opening devices".to_owned(),
        Phase::Finished => "all shots are accounted for, results are closed".to_owned(),
        Phase::Failed(_) => "stopped".to_owned(),
        _ if !working.is_empty() => format!("processing shot {}", working.join(", ")),
        _ if shots.awaiting_frames > 0 => "waiting for frames".to_owned(),
        _ => "waiting for shots".to_owned(),
    }
}

pub(super) async fn health(State(state): State<ApiState>) -> (StatusCode, String) {
    match state.phase() {
        Phase::Failed(reason) => (StatusCode::SERVICE_UNAVAILABLE, format!("failed: {reason}\n")),
        _ => (StatusCode::OK, "ok\n".to_owned()),
    }
}
