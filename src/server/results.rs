//! `/api/v1/results`: velocity fields.

use std::sync::Arc;

use axum::{
    extract::State,
    http::{HeaderMap, header},
    response::Response,
};
use lfpiv_core::{
    reconstruction::ModelFit,
    velocimetry::{StageSeconds, VectorGrid, VectorStatus},
};
use serde::{Deserialize, Serialize};
use utoipa::{IntoParams, ToSchema};

use super::{
    ApiError, ApiState,
    app::App,
    binary,
    bytes::{ETag, cacheable},
    extract::{Arguments, Params, shot_number},
    schemas::{ModelFitSchema, ShotTimeSchema, StageSecondsSchema, VectorStatusSchema},
    shots::ShotState,
};
use crate::{
    archive::{ShotResult, ShotTime},
    pipeline::{Lookup, RESULTS_IN_MEMORY},
};

/// Upper bound for the JSON size of a vector.
const JSON_VECTOR_BYTES: usize = 512;

/// Encoding of a result.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq, Deserialize, ToSchema)]
#[serde(rename_all = "snake_case")]
pub(super) enum Format {
    #[default]
    Json,
    Binary,
}

#[derive(Debug, Deserialize, IntoParams)]
#[serde(deny_unknown_fields)]
#[into_params(parameter_in = Query)]
pub(super) struct FormatQuery {
    /// `json` or `binary`; by default the `Accept` header decides.
    #[param(inline)]
    format: Option<Format>,
}

/// The grid of the vectors.
#[derive(Debug, Serialize, ToSchema)]
pub(super) struct GridView {
    /// Vector counts along x, y, z.
    vectors_xyz: [usize; 3],
    first_mm: [f64; 3],
    spacing_mm: f64,
    /// Order of the arrays.
    order: &'static str,
}

impl GridView {
    pub fn new(grid: &VectorGrid) -> Self {
        Self {
            vectors_xyz: grid.vectors,
            first_mm: grid.first_mm,
            spacing_mm: grid.spacing_mm,
            order: "z, y, x (x fastest)",
        }
    }
}

/// A result as JSON: every array has one element per vector; null for invalid and masked vectors and
/// unknown derivatives.
#[derive(Debug, Serialize, ToSchema)]
#[schema(as = Result)]
pub(super) struct ResultView<'a> {
    shot: u64,
    /// Time of the trigger; `null` if unknown.
    #[schema(value_type = Option<ShotTimeSchema>)]
    time: Option<ShotTime>,
    dt_s: f64,
    voxel_mm: f64,
    grid: GridView,
    valid_share: f64,
    warnings: &'a [String],
    /// Agreement of the images with the configured bench; unavailable without images.
    #[schema(value_type = Option<ModelFitSchema>)]
    model_fit: Option<&'a ModelFit>,
    #[schema(value_type = StageSecondsSchema)]
    seconds: StageSeconds,
    velocity_m_s: Vec<[Option<f32>; 3]>,
    velocity_uncertainty_m_s: Vec<[Option<f32>; 3]>,
    displacement_vox: Vec<[Option<f32>; 3]>,
    uncertainty_vox: Vec<[Option<f32>; 3]>,
    #[schema(value_type = [VectorStatusSchema])]
    status: &'a [VectorStatus],
    peak_ratio: &'a [f32],
    vorticity_per_s: Vec<[Option<f32>; 3]>,
    divergence_per_s: Vec<Option<f32>>,
}

impl<'a> ResultView<'a> {
    fn new(shot: u64, result: &'a ShotResult) -> Self {
        let ShotResult { measured, time, .. } = result;
        let field = &measured.field;
        let speed = field.metres_per_second_per_voxel() as f32;
        let rate = (1.0 / field.dt_s) as f32;
        Self {
            shot,
            time: *time,
            dt_s: field.dt_s,
            voxel_mm: field.voxel_mm,
            grid: GridView::new(&field.grid),
            valid_share: field.valid_share(),
            warnings: &measured.warnings,
            model_fit: measured.fit.as_ref(),
            seconds: measured.seconds,
            velocity_m_s: scaled(field.or_nan(&field.displacement_vox), speed),
            velocity_uncertainty_m_s: scaled(field.or_nan(&field.uncertainty_vox), speed),
            displacement_vox: scaled(field.or_nan(&field.displacement_vox), 1.0),
            uncertainty_vox: scaled(field.or_nan(&field.uncertainty_vox), 1.0),
            status: &field.status,
            peak_ratio: &field.peak_ratio,
            vorticity_per_s: scaled(field.vorticity_or_nan(), rate),
            divergence_per_s: field.divergence_or_nan().map(|d| non_nan(d * rate)).collect(),
        }
    }
}

fn scaled(vectors: impl Iterator<Item = [f32; 3]>, factor: f32) -> Vec<[Option<f32>; 3]> {
    vectors.map(|vector| vector.map(|component| non_nan(component * factor))).collect()
}

/// `None` for NaN.
fn non_nan(number: f32) -> Option<f32> {
    (!number.is_nan()).then_some(number)
}

/// A result as JSON, or as bytes with `format=binary` or `Accept: application/octet-stream`;
/// docs/http.md describes the layout.
#[utoipa::path(get, path = "/api/v1/results/{shot}", tag = "results",
    params(
        ("shot" = String, Path, description = "Shot number, from 0, or `latest`."),
        FormatQuery),
    responses(
        (status = 200, description = "The velocity field", content(
            (ResultView<'static> = "application/json"), (Vec<u8> = "application/octet-stream"))),
        (status = 206, description = "The requested range of bytes"),
        (status = 304, description = "The client already has the result (`If-None-Match`)"),
        (status = 404, description = "No such shot, or it has no result (yet)", body = super::error::ErrorBody),
        (status = 410, description = "The result is on disk only", body = super::error::ErrorBody),
        (status = 416, description = "The range is outside of the result", body = super::error::ErrorBody)))]
pub(super) async fn one(
    State(app): State<App>,
    Params(shot): Params<String>,
    headers: HeaderMap,
    Arguments(query): Arguments<FormatQuery>,
) -> Result<Response, ApiError> {
    let format = requested(&headers, &query);
    let shot = resolved(&app.run, &shot)?;
    let result = looked_up(&app, shot).await?;
    let run = app.run.board.events().run();
    let vectors = result.measured.field.grid.len();
    match format {
        Format::Json => {
            let tag = ETag::new(run, &format!("result-{shot}-json"));
            cacheable(&headers, &tag, "application/json", || async {
                let made = move || {
                    serde_json::to_vec(&ResultView::new(shot, &result)).map_err(|error| {
                        ApiError::internal(format!(
                            "shot {shot} cannot be encoded as JSON: {error}"
                        ))
                    })
                };
                Ok((app.work.make(vectors * JSON_VECTOR_BYTES, made).await?, HeaderMap::new()))
            })
            .await
        }
        Format::Binary => {
            let tag = ETag::new(run, &format!("result-{shot}-binary"));
            cacheable(&headers, &tag, binary::MEDIA_TYPE, || async {
                let bytes = binary::field_bytes(&result.measured.field);
                let made = move || Ok(binary::encode(shot, &result.measured.field));
                Ok((app.work.make(bytes, made).await?, HeaderMap::new()))
            })
            .await
        }
    }
}

/// The result of a shot, or why there is none.
pub(super) async fn looked_up(app: &App, shot: u64) -> Result<Arc<ShotResult>, ApiError> {
    let source = app.run.results.clone();
    let looked_up = tokio::task::spawn_blocking(move || source.result(shot)).await;
    match looked_up.map_err(|error| ApiError::internal(error.to_string()))? {
        Lookup::Here(result) => Ok(result),
        other => Err(unavailable(&app.run, shot, other)),
    }
}

/// The shot that a path requests, by number or as `latest`.
pub(super) fn resolved(state: &ApiState, shot: &str) -> Result<u64, ApiError> {
    if shot != "latest" {
        return shot_number(shot);
    }
    let latest = state.board.latest().map(|(shot, _)| shot);
    latest.ok_or_else(|| ApiError::not_found("no shot has a result yet"))
}

/// The error for a result that cannot be delivered.
pub(super) fn unavailable(state: &ApiState, shot: u64, lookup: Lookup) -> ApiError {
    match lookup {
        Lookup::Here(_) | Lookup::OnDisk => on_disk(state, shot),
        Lookup::NoResult(record) => {
            let reason = record.message.unwrap_or_else(|| "it is being processed".to_owned());
            ApiError::not_found(format!("shot {shot} has no result: {reason}"))
        }
        Lookup::Unknown => not_in_pool(state, shot),
    }
}

/// The requested encoding: by the query if given, otherwise by the `Accept` header.
pub(super) fn requested(headers: &HeaderMap, query: &FormatQuery) -> Format {
    let accepts_binary = headers
        .get(header::ACCEPT)
        .and_then(|accept| accept.to_str().ok())
        .is_some_and(|accept| accept.contains(binary::MEDIA_TYPE));
    let by_header = if accepts_binary { Format::Binary } else { Format::Json };
    query.format.unwrap_or(by_header)
}

fn on_disk(state: &ApiState, shot: u64) -> ApiError {
    let folder = &state.info.results_dir;
    let message = format!(
        "the result of shot {shot} is no longer in memory, which keeps the last \
         {RESULTS_IN_MEMORY}: read it from disk"
    );
    let mut gone = ApiError::gone(message)
        .with("results_dir", folder.display().to_string())
        .with("netcdf_files", folder.join("velocity_*.nc").display().to_string());
    if state.info.configuration.place_particles {
        gone = gone.with("particle_files", folder.join("particles_*.nc").display().to_string());
    }
    if !state.info.paraview {
        return gone;
    }
    let file = folder.join(format!("shot_{shot:06}.vti"));
    gone.with("paraview_file", file.display().to_string())
}

fn not_in_pool(state: &ApiState, shot: u64) -> ApiError {
    let place = match state.ledger.lock().entry(shot).map(|entry| ShotState::of(entry, None)) {
        None => return ApiError::not_found(format!("there is no shot {shot}")),
        Some(ShotState::AwaitingFrames) => "it is waiting for frames",
        Some(ShotState::Queued) => "it is waiting for a worker",
        Some(ShotState::Shed) => "it was shed",
        Some(_) => "it was lost; see /api/v1/shots",
    };
    ApiError::not_found(format!("shot {shot} has no result: {place}"))
}
