//! `/api/v1/shots/{shot}/frames`: previews of raw frames.

use axum::{extract::State, http::HeaderMap, response::Response};
use lfpiv_hw::{CameraName, RawImage};
use serde::Deserialize;
use utoipa::IntoParams;

use super::{
    ApiError,
    app::App,
    bytes::{ETag, cacheable},
    extract::{Arguments, Params, frame_index, shot_number},
    preview::{Grey, PNG, encode_preview},
};
use crate::pipeline::Board;

/// Default width of a preview, in pixels.
const DEFAULT_WIDTH: usize = 640;
/// Allowed widths, in pixels.
const WIDTHS: std::ops::RangeInclusive<usize> = 16..=8192;

/// Source of raw frames.
pub trait FrameSource: Send + Sync + 'static {
    /// Frame a (0) or b (1) of a camera, counted from 0; `None` if it is not available. May read
    /// from disk, so it is not called on the runtime's threads.
    fn frame(&self, shot: u64, camera: usize, half: usize) -> Option<RawImage>;
    /// The last shot with frames. Does not read from disk.
    fn latest(&self) -> Option<u64>;
}

/// The frames of the latest shot.
impl FrameSource for Board {
    fn frame(&self, shot: u64, camera: usize, half: usize) -> Option<RawImage> {
        self.gallery().frame(shot, camera, half)
    }

    fn latest(&self) -> Option<u64> {
        self.gallery().latest_frames()
    }
}

#[derive(Debug, Deserialize, IntoParams)]
#[serde(deny_unknown_fields)]
#[into_params(parameter_in = Query)]
pub(super) struct WidthQuery {
    /// Width in pixels, at most that of the image; default 640.
    #[param(minimum = 16, maximum = 8192)]
    width: Option<usize>,
}

/// A raw frame as PNG, reduced by area averaging. Black is zero, white is the 99.9th percentile;
/// the header `lfpiv-white` gives it in counts.
#[utoipa::path(get, path = "/api/v1/shots/{shot}/frames/{camera}/{image}", tag = "shots",
    params(
        ("shot" = String, Path, description = "Shot number, from 0, or `latest`."),
        ("camera" = usize, Path, minimum = 1, description = "Camera: 1 or cam1 for the first."),
        ("image" = inline(FrameImage), Path, description = "Frame a or b."),
        WidthQuery),
    responses(
        (status = 200, content_type = "image/png", description = "The image", body = Vec<u8>),
        (status = 404, description = "No such shot or camera", body = super::error::ErrorBody),
        (status = 410, description = "The frame is no longer available", body = super::error::ErrorBody)))]
pub(super) async fn preview(
    State(app): State<App>,
    Params((shot, camera, image)): Params<(String, String, String)>,
    Arguments(query): Arguments<WidthQuery>,
    headers: HeaderMap,
) -> Result<Response, ApiError> {
    let shot = frame_shot(&app, &shot)?;
    let camera = camera_index(&camera, app.run.info.configuration.cameras.len())?;
    let half = image.strip_suffix(".png").unwrap_or(&image);
    let half = frame_index(half)?;
    let width = query.width.unwrap_or(DEFAULT_WIDTH);
    if !WIDTHS.contains(&width) {
        let error = format!("width = {width}: allowed {} to {}", WIDTHS.start(), WIDTHS.end());
        return Err(ApiError::bad_request(error));
    }
    let run = app.run.board.events().run();
    let tag = ETag::new(run, &format!("frame-{shot}-{camera}-{half}-{width}"));
    cacheable(&headers, &tag, PNG, || async {
        let frames = app.run.frames.clone();
        let known = app.run.ledger.lock().entry(shot).is_some();
        let preview = move || {
            let image = frames.frame(shot, camera, half).ok_or_else(|| unavailable(shot, known))?;
            Grey::of(&image, width).preview()
        };
        encode_preview(&app.work, width * width * 4, preview).await
    })
    .await
}

/// File names of a shot's previews.
#[derive(utoipa::ToSchema)]
#[allow(dead_code)] // Used only for names in the OpenAPI document.
pub(super) enum FrameImage {
    #[serde(rename = "a.png")]
    A,
    #[serde(rename = "b.png")]
    B,
}

/// The shot whose frames a path requests, by number or as `latest`.
pub(super) fn frame_shot(app: &App, shot: &str) -> Result<u64, ApiError> {
    match shot {
        "latest" => app.run.frames.latest().ok_or_else(none_yet),
        number => shot_number(number),
    }
}

pub(super) fn camera_index(text: &str, cameras: usize) -> Result<usize, ApiError> {
    let name: CameraName = text.parse().map_err(ApiError::bad_request)?;
    if name.0 < cameras {
        return Ok(name.0);
    }
    let last = CameraName(cameras.saturating_sub(1));
    Err(ApiError::not_found(format!(
        "there is no {name}; the cameras are {} to {last}",
        CameraName(0)
    )))
}

fn none_yet() -> ApiError {
    ApiError::not_found("no shot has reached a worker yet")
}

pub(super) fn unavailable(shot: u64, known: bool) -> ApiError {
    if known {
        ApiError::gone(format!(
            "the frames of shot {shot} are not available: they have not arrived yet, or later \
             shots have replaced them"
        ))
    } else {
        ApiError::not_found(format!("there is no shot {shot}"))
    }
}
