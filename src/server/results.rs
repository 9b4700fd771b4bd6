//! `/api/v1/results`: velocity fields.

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
    bytes::{ETag, unchanging},
    extract::{Arguments, Params, shot_number},
    schemas::{ModelFitSchema, ShotTimeSchema, StageSecondsSchema, VectorStatusSchema},
    shots::ShotState,
};
use crate::{
    archive::{ShotResult, ShotTime},
    pipeline::{Board, Lookup, RESULTS_IN_MEMORY},
};

/// Where results come from.
pub trait ResultSource: Send + Sync + 'static {
    /// What is known of a shot's result. May read a disk: it is not called on the runtime's threads.
    fn result(&self, shot: u64) -> Lookup;
}

/// The results in memory.
impl ResultSource for Board {
    fn result(&self, shot: u64) -> Lookup {
        self.result(shot)
    }
}

/// What a vector takes in JSON, generously.
const JSON_VECTOR_BYTES: usize = 512;

/// How a result is written.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq, Deserialize, ToSchema)]
#[serde(rename_all = "snake_case")]
enum Format {
    #[default]
    Json,
    Binary,
}

#[derive(Debug, Deserialize, IntoParams)]
#[serde(deny_unknown_fields)]
#[into_params(parameter_in = Query)]
pub(super) struct FormatQuery {
    /// `json` or `binary`; without it, the `Accept` header decides.
    #[param(inline)]
    format: Option<Format>,
}

/// Where the vectors are.
#[derive(Debug, Serialize, ToSchema)]
pub(super) struct GridView {
    /// Vector counts along x, y, z.
    vectors_xyz: [usize; 3],
    first_mm: [f64; 3],
    spacing_mm: f64,
    /// How the arrays below are ordered.
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

/// A result as JSON: one element per vector in every array; null where a vector is invalid, and where its
/// derivatives are not known.
#[derive(Debug, Serialize, ToSchema)]
#[schema(as = Result)]
pub(super) struct ResultView<'a> {
    shot: u64,
    /// When its trigger was given; `null` where that is not known.
    #[schema(value_type = Option<ShotTimeSchema>)]
    time: Option<ShotTime>,
    dt_s: f64,
    voxel_mm: f64,
    grid: GridView,
    valid_share: f64,
    warnings: &'a [String],
    /// Whether the images are of the configured bench; absent without images.
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
            divergence_per_s: field.divergence_or_nan().map(|d| known(d * rate)).collect(),
        }
    }
}

fn scaled(vectors: impl Iterator<Item = [f32; 3]>, factor: f32) -> Vec<[Option<f32>; 3]> {
    vectors.map(|vector| vector.map(|component| known(component * factor))).collect()
}

/// What is no number is not known.
fn known(number: f32) -> Option<f32> {
    (!number.is_nan()).then_some(number)
}

/// A result: JSON, or bytes with `format=binary` or `Accept: application/octet-stream`; see
/// docs/http.md for the layout.
#[utoipa::path(get, path = "/api/v1/results/{shot}", tag = "results",
    params(
        ("shot" = String, Path, description = "Shot number, from 0, or `latest`."),
        FormatQuery),
    responses(
        (status = 200, description = "The velocity field", content(
            (ResultView<'static> = "application/json"), (Vec<u8> = "application/octet-stream"))),
        (status = 206, description = "The range of bytes that was asked for"),
        (status = 304, description = "The client has it: `If-None-Match`"),
        (status = 404, description = "No such shot, or no result (yet)", body = super::error::ErrorBody),
        (status = 410, description = "It is on disk only", body = super::error::ErrorBody),
        (status = 416, description = "No such range", body = super::error::ErrorBody)))]
pub(super) async fn one(
    State(app): State<App>,
    Params(shot): Params<String>,
    headers: HeaderMap,
    Arguments(query): Arguments<FormatQuery>,
) -> Result<Response, ApiError> {
    let format = requested(&headers, &query);
    let shot = resolved(&app.run, &shot)?;
    let source = app.run.results.clone();
    let looked_up = tokio::task::spawn_blocking(move || source.result(shot)).await;
    let result = match looked_up.map_err(|error| ApiError::internal(error.to_string()))? {
        Lookup::Here(result) => result,
        other => return Err(absent(&app.run, shot, other)),
    };
    let run = app.run.board.events().run();
    let vectors = result.measured.field.grid.len();
    match format {
        Format::Json => {
            let tag = ETag::new(run, &format!("result-{shot}-json"));
            unchanging(&headers, &tag, "application/json", || async {
                let made = move || {
                    serde_json::to_vec(&ResultView::new(shot, &result)).map_err(|error| {
                        ApiError::internal(format!("shot {shot} cannot be put into JSON: {error}"))
                    })
                };
                Ok((app.work.make(vectors * JSON_VECTOR_BYTES, made).await?, HeaderMap::new()))
            })
            .await
        }
        Format::Binary => {
            let tag = ETag::new(run, &format!("result-{shot}-binary"));
            unchanging(&headers, &tag, binary::MEDIA_TYPE, || async {
                let bytes = binary::field_bytes(&result.measured.field);
                let made = move || Ok(binary::encode(shot, &result.measured.field));
                Ok((app.work.make(bytes, made).await?, HeaderMap::new()))
            })
            .await
        }
    }
}

/// The shot that a path names, by number or as `latest`.
pub(super) fn resolved(state: &ApiState, shot: &str) -> Result<u64, ApiError> {
    if shot != "latest" {
        return shot_number(shot);
    }
    let latest = state.board.latest().map(|(shot, _)| shot);
    latest.ok_or_else(|| ApiError::not_found("no shot has a result yet"))
}

/// What there is to say of a result that cannot be fetched.
pub(super) fn absent(state: &ApiState, shot: u64, lookup: Lookup) -> ApiError {
    match lookup {
        Lookup::Here(_) | Lookup::OnDisk => on_disk(state, shot),
        Lookup::NoResult(record) => {
            let reason = record.message.unwrap_or_else(|| "it is being processed".to_owned());
            ApiError::not_found(format!("shot {shot} has no result: {reason}"))
        }
        Lookup::Unknown => not_in_pool(state, shot),
    }
}

/// The query decides; without one, the `Accept` header does.
fn requested(headers: &HeaderMap, query: &FormatQuery) -> Format {
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
        "the result of shot {shot} has left the memory, which holds the last {RESULTS_IN_MEMORY}: \
         read it from disk"
    );
    let gone = ApiError::gone(message)
        .with("results_dir", folder.display().to_string())
        .with("netcdf_files", folder.join("velocity_*.nc").display().to_string());
    if !state.info.paraview {
        return gone;
    }
    let file = folder.join(format!("shot_{shot:06}.vti"));
    gone.with("paraview_file", file.display().to_string())
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
