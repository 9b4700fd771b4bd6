//! `/api/v1/results`: velocity fields.

use std::sync::Arc;

use axum::{
    Json,
    extract::{Path, Query, State, rejection::QueryRejection},
    http::{HeaderMap, header},
    response::{IntoResponse, Response},
};
use serde::{Deserialize, Serialize};

use super::{ApiError, ApiState, binary, shot_number, shots::ShotState};
use crate::{
    pipeline::{Lookup, PairResult, RESULTS_IN_MEMORY, StageSeconds},
    velocimetry::VectorStatus,
};

#[derive(Debug, Clone, Copy, Default, PartialEq, Eq, Deserialize)]
#[serde(rename_all = "snake_case")]
enum Format {
    #[default]
    Json,
    Binary,
}

#[derive(Debug, Deserialize)]
pub(super) struct FormatQuery {
    format: Option<Format>,
}

/// Where the vectors are.
#[derive(Debug, Serialize)]
struct GridView {
    /// Vector counts along x, y, z.
    vectors_xyz: [usize; 3],
    first_mm: [f64; 3],
    spacing_mm: f64,
    /// How the arrays below are ordered.
    order: &'static str,
}

/// A result as JSON: one element per vector in every array.
#[derive(Debug, Serialize)]
struct ResultView<'a> {
    shot: u64,
    dt_s: f64,
    voxel_mm: f64,
    grid: GridView,
    valid_share: f64,
    warnings: &'a [String],
    seconds: StageSeconds,
    velocity_m_s: Vec<[f32; 3]>,
    velocity_uncertainty_m_s: Vec<[f32; 3]>,
    displacement_vox: &'a [[f32; 3]],
    uncertainty_vox: &'a [[f32; 3]],
    status: &'a [VectorStatus],
    peak_ratio: &'a [f32],
    vorticity_per_s: Vec<[f32; 3]>,
    divergence_per_s: Vec<f32>,
}

impl<'a> ResultView<'a> {
    fn new(shot: u64, result: &'a PairResult) -> Self {
        let field = &result.field;
        let speed = field.metres_per_second_per_voxel() as f32;
        let rate = (1.0 / field.dt_s) as f32;
        Self {
            shot,
            dt_s: field.dt_s,
            voxel_mm: field.voxel_mm,
            grid: GridView {
                vectors_xyz: field.grid.vectors,
                first_mm: field.grid.first_mm,
                spacing_mm: field.grid.spacing_mm,
                order: "z, y, x (x fastest)",
            },
            valid_share: field.valid_share(),
            warnings: &result.warnings,
            seconds: result.seconds,
            velocity_m_s: scaled(&field.displacement_vox, speed),
            velocity_uncertainty_m_s: scaled(&field.uncertainty_vox, speed),
            displacement_vox: &field.displacement_vox,
            uncertainty_vox: &field.uncertainty_vox,
            status: &field.status,
            peak_ratio: &field.peak_ratio,
            vorticity_per_s: scaled(&field.vorticity, rate),
            divergence_per_s: field.divergence.iter().map(|d| d * rate).collect(),
        }
    }
}

fn scaled(vectors: &[[f32; 3]], factor: f32) -> Vec<[f32; 3]> {
    vectors.iter().map(|vector| vector.map(|component| component * factor)).collect()
}

pub(super) async fn latest(
    State(state): State<ApiState>,
    headers: HeaderMap,
    query: Result<Query<FormatQuery>, QueryRejection>,
) -> Result<Response, ApiError> {
    let format = requested(&headers, query)?;
    match state.board.latest() {
        Some((shot, result)) => Ok(answer(shot, &result, format)),
        None => Err(ApiError::not_found("no shot has a result yet")),
    }
}

pub(super) async fn one(
    State(state): State<ApiState>,
    Path(shot): Path<String>,
    headers: HeaderMap,
    query: Result<Query<FormatQuery>, QueryRejection>,
) -> Result<Response, ApiError> {
    let shot = shot_number(&shot)?;
    let format = requested(&headers, query)?;
    match state.board.result(shot) {
        Lookup::Here(result) => Ok(answer(shot, &result, format)),
        Lookup::OnDisk => Err(on_disk(&state, shot)),
        Lookup::NoResult(record) => {
            let reason = record.message.unwrap_or_else(|| "it is being processed".to_owned());
            Err(ApiError::not_found(format!("shot {shot} has no result: {reason}")))
        }
        Lookup::Unknown => Err(not_in_pool(&state, shot)),
    }
}

/// The query decides; without one, the `Accept` header does.
fn requested(
    headers: &HeaderMap,
    query: Result<Query<FormatQuery>, QueryRejection>,
) -> Result<Format, ApiError> {
    let Query(query) = query.map_err(|error| {
        ApiError::bad_request(format!("{}; allowed: format=json, format=binary", error.body_text()))
    })?;
    let accepts_binary = headers
        .get(header::ACCEPT)
        .and_then(|accept| accept.to_str().ok())
        .is_some_and(|accept| accept.contains(binary::MEDIA_TYPE));
    let by_header = if accepts_binary { Format::Binary } else { Format::Json };
    Ok(query.format.unwrap_or(by_header))
}

fn answer(shot: u64, result: &Arc<PairResult>, format: Format) -> Response {
    match format {
        Format::Json => Json(ResultView::new(shot, result)).into_response(),
        Format::Binary => {
            let body = binary::encode(shot, &result.field);
            ([(header::CONTENT_TYPE, binary::MEDIA_TYPE)], body).into_response()
        }
    }
}

fn on_disk(state: &ApiState, shot: u64) -> ApiError {
    let folder = &state.info.results_dir;
    let message = format!(
        "the result of shot {shot} has left the memory, which holds the last {RESULTS_IN_MEMORY}: \
         read it from disk"
    );
    ApiError::gone(message)
        .with("results_dir", folder.display().to_string())
        .with("paraview_file", folder.join(format!("shot_{shot:06}.vti")).display().to_string())
        .with("netcdf_files", folder.join("velocity_*.nc").display().to_string())
}

fn not_in_pool(state: &ApiState, shot: u64) -> ApiError {
    let place = match state.ledger.lock().entry(shot).map(|entry| ShotState::of(entry, None)) {
        None => return ApiError::not_found(format!("no shot {shot} is known")),
        Some(ShotState::AwaitingFrames) => "its frames are still waited for",
        Some(ShotState::Queued) => "it waits for a worker",
        Some(ShotState::Shed) => "it was shed",
        Some(_) => "it was lost; see /api/v1/shots",
    };
    ApiError::not_found(format!("shot {shot} has no result: {place}"))
}
