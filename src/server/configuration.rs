//! `/api/v1/configuration`, `/api/v1/mask` and `/api/v1/control/timing`: the run's settings, what of the
//! volume is flow, and the pulse schedule.

use std::sync::Arc;

use axum::{
    Json,
    extract::State,
    http::{HeaderMap, StatusCode},
    response::Response,
};
use lfpiv_core::model::VolumeMask;
use lfpiv_hw::{
    Optics,
    timing::{PulseSchedule, TimingSettings},
};
use serde::{Deserialize, Serialize};
use utoipa::{IntoParams, ToSchema};

use super::{
    ApiError,
    app::App,
    binary,
    bytes::{ETag, cacheable},
    extract::Arguments,
    seeding::VolumeViews,
};

/// The configured bench.
#[derive(Debug, Clone)]
pub struct BenchSettings {
    /// The configuration's TOML text.
    pub configuration: String,
    /// The optics of all cameras.
    pub optics: Optics,
    /// Timing limits for pulse schedules.
    pub timing: TimingSettings,
    /// What of the volume is flow; absent if all of it is.
    pub mask: Option<Arc<VolumeMask>>,
    /// Where each camera sees the volume.
    pub views: VolumeViews,
}

#[derive(Debug, Serialize, ToSchema)]
#[schema(as = Configuration)]
pub(super) struct ConfigurationView {
    file: String,
    /// The file's text, TOML.
    text: String,
}

/// The configuration of the run.
#[utoipa::path(get, path = "/api/v1/configuration", tag = "live", responses(
    (status = 200, body = ConfigurationView),
    (status = 404, description = "The server has no configuration", body = super::error::ErrorBody)))]
pub(super) async fn configuration(
    State(app): State<App>,
) -> Result<Json<ConfigurationView>, ApiError> {
    let bench = app.run.bench.as_ref().ok_or_else(unknown)?;
    let file = app.run.info.configuration.file.display().to_string();
    Ok(Json(ConfigurationView { file, text: bench.configuration.clone() }))
}

/// Which voxels of the volume are flow: a bit for each, after a header of 80 bytes; see docs/http.md.
#[utoipa::path(get, path = "/api/v1/mask", tag = "live", responses(
    (status = 200, description = "The mask", content_type = "application/octet-stream", body = Vec<u8>),
    (status = 304, description = "The client already has it (`If-None-Match`)"),
    (status = 404, description = "All of the volume is flow", body = super::error::ErrorBody)))]
pub(super) async fn mask(State(app): State<App>, headers: HeaderMap) -> Result<Response, ApiError> {
    let mask = app.run.bench.as_ref().and_then(|bench| bench.mask.clone());
    let mask =
        mask.ok_or_else(|| ApiError::not_found("the volume has no mask: all of it is flow"))?;
    let tag = ETag::new(app.run.board.events().run(), "mask");
    cacheable(&headers, &tag, binary::MEDIA_TYPE, || async {
        let bytes = binary::mask_bytes(&mask);
        let made = move || Ok(binary::encode_mask(&mask));
        Ok((app.work.make(bytes, made).await?, HeaderMap::new()))
    })
    .await
}

#[derive(Debug, Deserialize, IntoParams)]
#[serde(deny_unknown_fields)]
#[into_params(parameter_in = Query)]
pub(super) struct TimingQuery {
    /// Time between the light pulses, in µs; default: that of the run.
    #[param(minimum = 0.1, maximum = 1_000_000.0)]
    dt_us: Option<f64>,
}

/// A pulse schedule, in µs after T0.
#[derive(Debug, Serialize, ToSchema)]
#[schema(as = Timing)]
pub(super) struct TimingView {
    period_us: f64,
    dt_us: f64,
    /// Flash lamps of laser heads 1 and 2.
    lamp_us: [f64; 2],
    /// Q-switches of laser heads 1 and 2: the light pulses.
    q_switch_us: [f64; 2],
    camera_trigger_us: f64,
    /// Start and end of exposure 1.
    exposure_1_us: [f64; 2],
    exposure_2_us: [f64; 2],
    /// Time from which the cameras can be triggered again.
    camera_ready_us: f64,
    pulse_width_us: f64,
}

impl From<PulseSchedule> for TimingView {
    fn from(schedule: PulseSchedule) -> Self {
        let PulseSchedule {
            period_us,
            dt_us,
            lamp_us,
            q_switch_us,
            camera_trigger_us,
            exposure_1_us,
            exposure_2_us,
            camera_ready_us,
            pulse_width_us,
            ..
        } = schedule;
        Self {
            period_us,
            dt_us,
            lamp_us,
            q_switch_us,
            camera_trigger_us,
            exposure_1_us,
            exposure_2_us,
            camera_ready_us,
            pulse_width_us,
        }
    }
}

/// Times of lamps, Q-switches and cameras for a dt, or why no schedule is possible. Changes
/// nothing.
#[utoipa::path(get, path = "/api/v1/control/timing", tag = "control", params(TimingQuery), responses(
    (status = 200, body = TimingView),
    (status = 404, description = "No bench is configured", body = super::error::ErrorBody),
    (status = 409, description = "No schedule is possible with this dt", body = super::error::ErrorBody)))]
pub(super) async fn timing(
    State(app): State<App>,
    Arguments(query): Arguments<TimingQuery>,
) -> Result<Json<TimingView>, ApiError> {
    let bench = app.run.bench.as_ref().ok_or_else(unknown)?;
    let configured = &app.run.info.configuration;
    let now_us = app.run.control().map_or(configured.dt_us, |control| control.dt_us);
    let dt_us = query.dt_us.unwrap_or(now_us);
    match PulseSchedule::plan(&bench.timing, dt_us, configured.rate_hz) {
        Ok(schedule) => Ok(Json(schedule.into())),
        Err(error) => Err(ApiError::new(StatusCode::CONFLICT, error.to_string())),
    }
}

fn unknown() -> ApiError {
    ApiError::not_found("this server has no configuration of a bench")
}
