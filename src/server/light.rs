//! `/api/v1/results/{shot}/volumes` and `/projections`: reconstructed volumes and their maximum
//! projections.

use axum::{extract::State, http::HeaderMap, response::Response};
use lfpiv_core::reconstruction::MaximumProjection;

use super::{
    ApiError,
    app::App,
    binary,
    bytes::{ETag, cacheable},
    extract::{Params, frame_index},
    preview::{Grey, PNG, encode_preview},
    results::{self, resolved},
};
use crate::pipeline::{Lookup, PROJECTION_MEMORY_BYTES, VOLUME_MEMORY_BYTES};

/// Names of the planes, in the order of the projections.
const PLANES: [&str; 3] = ["xy", "xz", "yz"];

/// A frame's volume: light intensity per voxel as float32, little-endian, after a header of 80
/// bytes; see docs/http.md. The volumes of the last shots are kept in memory, up to 64 MB of lit
/// voxels.
#[utoipa::path(get, path = "/api/v1/results/{shot}/volumes/{frame}", tag = "results",
    params(
        ("shot" = String, Path, description = "Shot number, from 0, or `latest`."),
        ("frame" = inline(Half), Path, description = "Frame a or b.")),
    responses(
        (status = 200, description = "The volume", content_type = "application/octet-stream", body = Vec<u8>),
        (status = 404, description = "No such shot or result", body = super::error::ErrorBody),
        (status = 410, description = "It is no longer in memory", body = super::error::ErrorBody)))]
pub(super) async fn volume(
    State(app): State<App>,
    Params((shot, frame)): Params<(String, String)>,
    headers: HeaderMap,
) -> Result<Response, ApiError> {
    let frame = frame_index(&frame)?;
    let shot = resolved(&app.run, &shot)?;
    let tag = ETag::new(app.run.board.events().run(), &format!("volume-{shot}-{frame}"));
    let Some(volumes) = app.run.board.gallery().volumes(shot) else {
        return Err(gone(&app, shot, "volumes", VOLUME_MEMORY_BYTES));
    };
    cacheable(&headers, &tag, binary::MEDIA_TYPE, || async {
        let bytes = binary::volume_bytes(&volumes[frame]);
        let made = move || Ok(binary::encode_volume(shot, frame, &volumes[frame]));
        Ok((app.work.make(bytes, made).await?, HeaderMap::new()))
    })
    .await
}

/// Maximum projection along the third axis, as PNG: x or y to the right, y or z upwards. Black is
/// zero, white is the 99.9th percentile, given in the header `lfpiv-white`.
#[utoipa::path(get, path = "/api/v1/results/{shot}/projections/{frame}/{image}", tag = "results",
    params(
        ("shot" = String, Path, description = "Shot number, from 0, or `latest`."),
        ("frame" = inline(Half), Path, description = "Frame a or b."),
        ("image" = inline(PlaneImage), Path, description = "Plane.")),
    responses(
        (status = 200, description = "The image", content_type = "image/png", body = Vec<u8>),
        (status = 404, description = "No such shot or result", body = super::error::ErrorBody),
        (status = 410, description = "It is no longer in memory", body = super::error::ErrorBody)))]
pub(super) async fn projection(
    State(app): State<App>,
    Params((shot, frame, image)): Params<(String, String, String)>,
    headers: HeaderMap,
) -> Result<Response, ApiError> {
    let frame = frame_index(&frame)?;
    let name = image.strip_suffix(".png").unwrap_or(&image);
    let plane = PLANES.iter().position(|plane| *plane == name).ok_or_else(|| {
        ApiError::bad_request(format!("'{image}' is not a plane: give xy.png, xz.png or yz.png"))
    })?;
    let shot = resolved(&app.run, &shot)?;
    let run = app.run.board.events().run();
    let tag = ETag::new(run, &format!("projection-{shot}-{frame}-{name}"));
    let Some(projections) = app.run.board.gallery().projections(shot) else {
        return Err(gone(&app, shot, "projections", PROJECTION_MEMORY_BYTES));
    };
    cacheable(&headers, &tag, PNG, || async {
        let pixels = projections[frame][plane].intensity.len();
        let preview = move || upright(&projections[frame][plane]).preview();
        encode_preview(&app.work, pixels * size_of::<f32>(), preview).await
    })
    .await
}

/// Names of the frames in paths.
#[derive(utoipa::ToSchema)]
#[allow(dead_code)] // Used only for names in the OpenAPI document.
pub(super) enum Half {
    #[serde(rename = "a")]
    A,
    #[serde(rename = "b")]
    B,
}

/// File names of a frame's projections.
#[derive(utoipa::ToSchema)]
#[allow(dead_code)] // Used only for names in the OpenAPI document.
pub(super) enum PlaneImage {
    #[serde(rename = "xy.png")]
    Xy,
    #[serde(rename = "xz.png")]
    Xz,
    #[serde(rename = "yz.png")]
    Yz,
}

/// Converts a projection, whose second axis points up, into an image, whose rows go down.
fn upright(projection: &MaximumProjection) -> Grey {
    let [columns, rows] = projection.size;
    let values = projection.intensity.chunks(columns.max(1)).rev().flatten().copied().collect();
    Grey { columns, rows, values }
}

/// The error for light that is not in memory, or for a shot without a result.
fn gone(app: &App, shot: u64, what: &str, memory_bytes: usize) -> ApiError {
    let board = &app.run.board;
    match board.result(shot) {
        Lookup::Here(_)
            if app.run.cluster.is_some() && board.gallery().projections(shot).is_some() =>
        {
            ApiError::gone(format!(
                "the {what} of shot {shot} are not available: the worker that measured it delivers \
                 projections only; process its raw data again and request volumes"
            ))
        }
        Lookup::Here(_) | Lookup::OnDisk => ApiError::gone(format!(
            "the {what} of shot {shot} are not in memory, which keeps those of the last shots in \
             {} MB: process its raw data again and request volumes",
            memory_bytes >> 20
        )),
        other => results::unavailable(&app.run, shot, other),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_second_axis_goes_up() {
        let projection = MaximumProjection { size: [2, 2], intensity: vec![1.0, 2.0, 3.0, 4.0] };
        let grey = upright(&projection);
        assert_eq!((grey.columns, grey.rows, grey.values), (2, 2, vec![3.0, 4.0, 1.0, 2.0]));
    }
}
