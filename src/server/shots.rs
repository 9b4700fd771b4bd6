//! `/api/v1/shots`: the state of each shot.

use axum::{Json, extract::State};
use lfpiv_core::{reconstruction::ModelFit, velocimetry::StageSeconds};
use serde::{Deserialize, Serialize};
use utoipa::{IntoParams, ToSchema};

use super::{
    ApiError, ApiState,
    extract::{Arguments, Params, shot_number},
    schemas::{ModelFitSchema, RawLevelSchema, ShotTimeSchema, StageSecondsSchema},
};
use crate::{
    acquisition::{Outcome, TriggerEntry},
    archive::{RawLevel, ShotTime},
    pipeline::{ShotRecord, Stage},
};

/// Default number of listed shots.
const DEFAULT_LIMIT: usize = 100;
/// Largest number of listed shots.
const MAX_LIMIT: usize = 1000;

/// State of a shot.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, ToSchema)]
#[serde(rename_all = "snake_case")]
pub(super) enum ShotState {
    AwaitingFrames,
    Queued,
    Processing,
    Done,
    Failed,
    WriteFailed,
    Shed,
    /// The trigger was due, but no device shows that it was given.
    NotFired,
    /// A camera did not deliver; see the outcomes.
    Lost,
}

impl ShotState {
    pub fn of(entry: &TriggerEntry, record: Option<&ShotRecord>) -> Self {
        if let Some(record) = record {
            return match record.stage {
                Stage::Processing => Self::Processing,
                Stage::Done => Self::Done,
                Stage::Failed => Self::Failed,
                Stage::WriteFailed => Self::WriteFailed,
            };
        }
        match (entry.is_settled(), entry.queued) {
            (false, false) => Self::AwaitingFrames,
            (false, true) => Self::Queued,
            (true, _) if entry.cameras.contains(&Some(Outcome::Shed)) => Self::Shed,
            (true, _) if entry.cameras.contains(&Some(Outcome::NotFired)) => Self::NotFired,
            (true, _) => Self::Lost,
        }
    }
}

#[derive(Debug, Serialize, ToSchema)]
pub(super) struct CameraOutcome {
    camera: String,
    outcome: Option<Outcome>,
}

/// One shot.
#[derive(Debug, Serialize, ToSchema)]
#[schema(as = Shot)]
pub(super) struct ShotView {
    shot: u64,
    state: ShotState,
    /// Time of the trigger; `null` if unknown.
    #[schema(value_type = Option<ShotTimeSchema>)]
    time: Option<ShotTime>,
    cameras: Vec<CameraOutcome>,
    /// Durability of its raw images.
    #[schema(value_type = RawLevelSchema)]
    raw: RawLevel,
    /// Evidence that contradicts the pairing.
    suspect: Vec<String>,
    message: Option<String>,
    warnings: Vec<String>,
    /// Agreement of its images with the configured bench; absent without a result.
    #[schema(value_type = Option<ModelFitSchema>)]
    model_fit: Option<ModelFit>,
    vectors: Option<usize>,
    valid_share: Option<f64>,
    #[schema(value_type = Option<StageSecondsSchema>)]
    seconds: Option<StageSeconds>,
}

impl ShotView {
    fn new(state: &ApiState, entry: &TriggerEntry) -> Self {
        let record = state.board.record(entry.trigger);
        let names = &state.info.configuration.cameras;
        let cameras = entry.cameras.iter().zip(names);
        let cameras = cameras
            .map(|(outcome, camera)| CameraOutcome { camera: camera.clone(), outcome: *outcome });
        Self {
            shot: entry.trigger,
            state: ShotState::of(entry, record.as_ref()),
            time: entry.time,
            cameras: cameras.collect(),
            raw: state.journal.level(entry.trigger),
            suspect: entry.suspect.clone(),
            message: record.as_ref().and_then(|record| record.message.clone()),
            warnings: record.as_ref().map(|record| record.warnings.clone()).unwrap_or_default(),
            model_fit: record.as_ref().and_then(|record| record.fit.clone()),
            vectors: record.as_ref().and_then(|record| record.vectors),
            valid_share: record.as_ref().and_then(|record| record.valid_share),
            seconds: record.as_ref().and_then(|record| record.seconds),
        }
    }
}

#[derive(Debug, Deserialize, IntoParams)]
#[serde(deny_unknown_fields)]
#[into_params(parameter_in = Query)]
pub(super) struct ListQuery {
    /// Number of shots, 0 to 1000; default 100.
    #[param(maximum = 1000)]
    limit: Option<usize>,
}

#[derive(Debug, Serialize, ToSchema)]
pub(super) struct ShotList {
    shots: Vec<ShotView>,
}

/// The last shots, newest first.
#[utoipa::path(get, path = "/api/v1/shots", tag = "shots", params(ListQuery),
    responses((status = 200, body = ShotList)))]
pub(super) async fn list(
    State(state): State<ApiState>,
    Arguments(query): Arguments<ListQuery>,
) -> Result<Json<ShotList>, ApiError> {
    let limit = query.limit.unwrap_or(DEFAULT_LIMIT);
    if limit > MAX_LIMIT {
        let message = format!("limit = {limit}: allowed: 0 to {MAX_LIMIT}");
        return Err(ApiError::bad_request(message));
    }
    let entries: Vec<TriggerEntry> =
        state.ledger.lock().entries().rev().take(limit).cloned().collect();
    let shots = entries.iter().map(|entry| ShotView::new(&state, entry)).collect();
    Ok(Json(ShotList { shots }))
}

/// One shot.
#[utoipa::path(get, path = "/api/v1/shots/{shot}", tag = "shots",
    params(("shot" = u64, Path, description = "Shot number, from 0.")),
    responses(
        (status = 200, body = ShotView),
        (status = 404, description = "No such shot", body = super::error::ErrorBody)))]
pub(super) async fn one(
    State(state): State<ApiState>,
    Params(shot): Params<String>,
) -> Result<Json<ShotView>, ApiError> {
    let shot = shot_number(&shot)?;
    let entry = state.ledger.lock().entry(shot).cloned();
    match entry {
        Some(entry) => Ok(Json(ShotView::new(&state, &entry))),
        None => Err(ApiError::not_found(format!("there is no shot {shot}"))),
    }
}
