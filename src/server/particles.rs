//! `/api/v1/results/{shot}/particles`: the particles placed in a shot's images.

use axum::{
    extract::State,
    http::{HeaderMap, StatusCode},
    response::{IntoResponse, Response},
};
use serde::Serialize;
use utoipa::ToSchema;

use super::{
    ApiError,
    app::App,
    binary,
    bytes::{ETag, cacheable},
    extract::{Arguments, Params},
    results::{Format, FormatQuery, looked_up, requested, resolved},
    schemas::ShotTimeSchema,
};
use crate::archive::{ShotResult, ShotTime};

/// Upper bound for the JSON size of a particle.
const JSON_PARTICLE_BYTES: usize = 320;

/// Particles as JSON: every array has one element per particle.
#[derive(Debug, Serialize, ToSchema)]
#[schema(as = Particles)]
pub(super) struct ParticlesView {
    shot: u64,
    /// Time of the trigger; `null` if unknown.
    #[schema(value_type = Option<ShotTimeSchema>)]
    time: Option<ShotTime>,
    dt_s: f64,
    voxel_mm: f64,
    /// Where they are in the middle of the pair.
    place_mm: Vec<[f64; 3]>,
    place_uncertainty_mm: Vec<[f64; 3]>,
    velocity_m_s: Vec<[f64; 3]>,
    velocity_uncertainty_m_s: Vec<[f64; 3]>,
    /// Counts of an open pixel that gets all of a particle's light in a camera, mean of both frames.
    light: Vec<Vec<f32>>,
    /// Whether its displacement agrees with that of the particles about it.
    valid: Vec<bool>,
}

impl ParticlesView {
    /// `None`: none were placed.
    fn new(shot: u64, result: &ShotResult) -> Option<Self> {
        let (field, cameras) = (&result.measured.field, result.cameras());
        let particles = result.measured.particles.as_ref()?;
        let speed = field.metres_per_second_per_voxel();
        let scaled = |vector: [f32; 3], factor: f64| vector.map(|part| f64::from(part) * factor);
        Some(Self {
            shot,
            time: result.time,
            dt_s: field.dt_s,
            voxel_mm: field.voxel_mm,
            place_mm: particles.iter().map(|p| p.at_mm).collect(),
            place_uncertainty_mm: particles
                .iter()
                .map(|p| scaled(p.place_uncertainty_vox, field.voxel_mm))
                .collect(),
            velocity_m_s: particles.iter().map(|p| scaled(p.displacement_vox, speed)).collect(),
            velocity_uncertainty_m_s: particles
                .iter()
                .map(|p| scaled(p.uncertainty_vox, speed))
                .collect(),
            light: particles.iter().map(|p| p.light[..cameras].to_vec()).collect(),
            valid: particles.iter().map(|p| p.agrees).collect(),
        })
    }
}

/// The particles placed in a shot's images, as JSON, or as bytes with `format=binary` or `Accept:
/// application/octet-stream`; docs/http.md describes the layout.
#[utoipa::path(get, path = "/api/v1/results/{shot}/particles", tag = "results",
    params(
        ("shot" = String, Path, description = "Shot number, from 0, or `latest`."),
        FormatQuery),
    responses(
        (status = 200, description = "The particles", content(
            (ParticlesView = "application/json"), (Vec<u8> = "application/octet-stream"))),
        (status = 204, description = "The shot has a result, but its vectors are by correlation alone"),
        (status = 206, description = "The requested range of bytes"),
        (status = 304, description = "The client already has them (`If-None-Match`)"),
        (status = 404, description = "No such shot, or it has no result", body = super::error::ErrorBody),
        (status = 410, description = "The result is on disk only", body = super::error::ErrorBody),
        (status = 416, description = "The range is outside of the result", body = super::error::ErrorBody)))]
pub(super) async fn particles(
    State(app): State<App>,
    Params(shot): Params<String>,
    headers: HeaderMap,
    Arguments(query): Arguments<FormatQuery>,
) -> Result<Response, ApiError> {
    let format = requested(&headers, &query);
    let shot = resolved(&app.run, &shot)?;
    let result = looked_up(&app, shot).await?;
    let Some(count) = result.measured.particles.as_ref().map(Vec::len) else {
        return Ok(StatusCode::NO_CONTENT.into_response());
    };
    let run = app.run.board.events().run();
    let (name, media_type, bytes) = match format {
        Format::Json => ("json", "application/json", count * JSON_PARTICLE_BYTES),
        Format::Binary => {
            ("binary", binary::MEDIA_TYPE, binary::particle_bytes(count, result.cameras()))
        }
    };
    let tag = ETag::new(run, &format!("particles-{shot}-{name}"));
    cacheable(&headers, &tag, media_type, || async {
        let made = move || match format {
            Format::Json => {
                serde_json::to_vec(&ParticlesView::new(shot, &result)).map_err(|error| {
                    ApiError::internal(format!(
                        "the particles of shot {shot} cannot be encoded as JSON: {error}"
                    ))
                })
            }
            Format::Binary => Ok(binary::encode_particles(shot, &result)),
        };
        Ok((app.work.make(bytes, made).await?, HeaderMap::new()))
    })
    .await
}
