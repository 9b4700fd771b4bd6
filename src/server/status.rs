//! `/api/v1/status` and `/healthz`.

use std::time::Instant;

use axum::{Json, extract::State, http::StatusCode};
use lfpiv_core::{model::ModelChoice, reconstruction::ModelFit};
use serde::Serialize;
use utoipa::ToSchema;

use super::{
    ApiState, ConfigurationSummary, Phase,
    brief::{Brief, CameraView, ShotCounts},
    schemas::ModelFitSchema,
};
use crate::{
    acquisition::{Account, ControlState, Mode, Outcome},
    cluster::ClusterView,
    pipeline::{LatencyQuantiles, Watermarks},
};

/// Overview of the run.
#[derive(Debug, Serialize, ToSchema)]
pub(super) struct Status {
    state: &'static str,
    /// Why the run failed.
    error: Option<String>,
    uptime_s: f64,
    code_version: String,
    /// The present activity, in words.
    stage: String,
    shots: ShotCounts,
    ledger: LedgerView,
    /// Connection and delivered frames of each camera.
    cameras: Vec<CameraView>,
    /// Free space for results and raw data; absent if the file system does not tell.
    disk: Option<DiskView>,
    /// How many shots are safe at each level; absent if nothing is recorded.
    watermarks: Option<Watermarks>,
    /// Size of the raw log; absent if nothing is recorded.
    raw_log: Option<RawLogView>,
    /// Latency from trigger to stored velocity; absent before the first result.
    latency: Option<LatencyQuantiles>,
    /// State of the controls; absent if the run cannot be controlled.
    control: Option<ControlState>,
    /// Workers, their rates and the backlog; absent if the run measures its shots itself.
    cluster: Option<ClusterView>,
    model: String,
    /// The parts of the model and the reasons for them; absent before the first result.
    #[schema(value_type = Option<Object>)]
    model_choice: Option<ModelChoice>,
    /// Agreement of the last measured shot's images with the configured bench; absent before the
    /// first result.
    #[schema(value_type = Option<ModelFitSchema>)]
    model_fit: Option<ModelFit>,
    solver: String,
    configuration: ConfigurationSummary,
    results_dir: String,
}

impl ShotCounts {
    pub fn of(state: &ApiState) -> Self {
        // No shot ends while the ledger is locked, so ledger and board are consistent.
        let ledger = state.ledger.lock();
        let pool = state.board.counts();
        let account = ledger.accounts().first().copied().unwrap_or_default();
        let (in_pool, awaiting_frames) = (ledger.in_pool(), ledger.awaiting_frames());
        drop(ledger);
        let shed = account.outcomes.of(Outcome::Shed);
        let not_fired = account.outcomes.of(Outcome::NotFired);
        let ended_unseen = shed + not_fired;
        let pooled = in_pool + pool.done + pool.failed + pool.write_failed;
        let processing = pool.processing.min(in_pool);
        Self {
            triggered: account.triggers,
            awaiting_frames,
            queued: in_pool - processing,
            processing,
            done: pool.done,
            failed: pool.failed,
            write_failed: pool.write_failed,
            shed,
            not_fired,
            lost: account.triggers.saturating_sub(pooled + awaiting_frames + ended_unseen),
        }
    }
}

/// Size of the raw log.
#[derive(Debug, Clone, Copy, Serialize, ToSchema)]
pub(super) struct RawLogView {
    /// The highest shot number on the disk.
    last_synced: Option<u64>,
    /// Bytes of images and record headers in memory.
    pub bytes_in: u64,
    /// Bytes of all segments.
    pub bytes_written: u64,
    segments: u32,
}

impl RawLogView {
    pub fn of(state: &ApiState) -> Option<Self> {
        let marks = state.journal.log()?.watermarks();
        Some(Self {
            last_synced: state.journal.marks().last_synced,
            bytes_in: marks.bytes_in,
            bytes_written: marks.bytes_written,
            segments: marks.segments,
        })
    }
}

impl CameraView {
    fn all(state: &ApiState) -> Vec<Self> {
        let ledger = state.ledger.lock();
        let names = state.info.configuration.cameras.iter();
        let streams = ledger.streams().iter().zip(ledger.connected());
        let views = names.zip(streams).map(|(camera, (stream, connected))| Self {
            camera: camera.clone(),
            connected: *connected,
            frames: stream.completed,
        });
        views.collect()
    }
}

/// Free space on the disk of the results.
#[derive(Debug, Clone, Copy, Serialize, ToSchema)]
pub(super) struct DiskView {
    free_bytes: u64,
    /// Number of shots whose raw data fits on the disk, by the mean size so far; absent before the
    /// first shot and without raw data.
    shots_left: Option<u64>,
}

impl DiskView {
    /// Queries the file system outside of the runtime's threads.
    async fn of(state: &ApiState) -> Option<Self> {
        let folder = state.info.results_dir.clone();
        let asked = tokio::task::spawn_blocking(move || rustix::fs::statvfs(&folder));
        let disk = asked.await.ok()?.ok()?;
        let free_bytes = disk.f_bavail.saturating_mul(disk.f_frsize);
        let written = state.watermarks().map_or(0, |marks| marks.written);
        let taken = RawLogView::of(state).map_or(0, |log| log.bytes_written);
        let shots_left = (taken > 0 && written > 0)
            .then(|| (u128::from(free_bytes) * u128::from(written) / u128::from(taken)) as u64);
        Some(Self { free_bytes, shots_left })
    }
}

#[derive(Debug, Serialize, ToSchema)]
#[schema(as = Ledger)]
pub(super) struct LedgerView {
    /// Whether every trigger is accounted for.
    balanced: bool,
    cameras: Vec<CameraAccount>,
}

#[derive(Debug, Serialize, ToSchema)]
pub(super) struct CameraAccount {
    camera: String,
    #[serde(flatten)]
    account: Account,
}

/// State of the run, shot counts, ledger, summary of the configuration.
#[utoipa::path(get, path = "/api/v1/status", tag = "live", responses((status = 200, body = Status)))]
pub(super) async fn status(State(state): State<ApiState>) -> Json<Status> {
    let shots = ShotCounts::of(&state);
    let phase = state.phase();
    let info = &state.info;
    let disk = DiskView::of(&state).await;
    Json(Status {
        state: name(&state, &phase),
        error: error(&phase),
        uptime_s: state.began.elapsed().as_secs_f64(),
        code_version: info.code_version.clone(),
        stage: stage(&state, &phase, shots),
        shots,
        ledger: ledger(&state),
        cameras: CameraView::all(&state),
        disk,
        watermarks: state.watermarks(),
        raw_log: RawLogView::of(&state),
        latency: state.board.latency(),
        control: state.control(),
        cluster: state.cluster.as_ref().map(|cluster| cluster.view()),
        model: info.model.clone(),
        model_fit: state.board.latest().and_then(|(_, result)| result.measured.fit.clone()),
        model_choice: state.board.model().map(|model| (*model).clone()),
        solver: info.solver.clone(),
        configuration: info.configuration.clone(),
        results_dir: info.results_dir.display().to_string(),
    })
}

impl ApiState {
    /// Summary of the run for events.
    pub(super) fn brief(&self) -> Brief {
        let (shots, phase) = (ShotCounts::of(self), self.phase());
        Brief {
            state: name(self, &phase),
            error: error(&phase),
            stage: stage(self, &phase, shots),
            shots,
            watermarks: self.watermarks(),
            control: self.control(),
            cameras: CameraView::all(self),
        }
    }

    /// State of the controls; `None` if the run cannot be controlled.
    pub fn control(&self) -> Option<ControlState> {
        self.control_access.controls.as_ref().map(|controls| controls.state())
    }

    /// Whether the synchroniser is lost and being searched.
    pub(super) fn bench_is_lost(&self) -> bool {
        self.control().is_some_and(|control| control.mode == Mode::Lost)
    }
}

fn error(phase: &Phase) -> Option<String> {
    match phase {
        Phase::Failed(reason) => Some(reason.clone()),
        _ => None,
    }
}

fn ledger(state: &ApiState) -> LedgerView {
    let ledger = state.ledger.lock();
    let names = state.info.configuration.cameras.iter();
    let cameras = ledger.accounts().iter().zip(names);
    let cameras = cameras
        .map(|(account, camera)| CameraAccount { camera: camera.clone(), account: *account });
    LedgerView { balanced: ledger.is_balanced(), cameras: cameras.collect() }
}

fn name(state: &ApiState, phase: &Phase) -> &'static str {
    match phase {
        Phase::Starting => "starting",
        Phase::Running if state.bench_is_lost() => "bench_lost",
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
        Phase::Running if state.bench_is_lost() => "searching for the synchroniser".to_owned(),
        _ if !working.is_empty() => format!("processing shot {}", working.join(", ")),
        _ if shots.awaiting_frames > 0 => "waiting for frames".to_owned(),
        _ => "waiting for shots".to_owned(),
    }
}

/// Health of the run: `ok`, or 503 once it has failed (the status says why), while the synchroniser
/// does not answer and while a worker hangs. Needs no token, so that a supervisor can read it.
#[utoipa::path(get, path = "/healthz", tag = "live", security(()),
    responses(
        (status = 200, content_type = "text/plain", body = String),
        (status = 503, description = "The run has failed, its bench is lost, or a worker hangs", content_type = "text/plain", body = String)))]
pub(super) async fn health(State(state): State<ApiState>) -> (StatusCode, String) {
    let unwell = match (state.phase(), state.board.pair_times().hung(Instant::now())) {
        (Phase::Failed(_), _) => "failed: see /api/v1/status".to_owned(),
        (_, Some(hung)) => hung.to_string(),
        (Phase::Running, None) if state.bench_is_lost() => {
            "the synchroniser does not answer: see /api/v1/status".to_owned()
        }
        _ => return (StatusCode::OK, "ok\n".to_owned()),
    };
    (StatusCode::SERVICE_UNAVAILABLE, unwell + "\n")
}
