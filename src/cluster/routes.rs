//! The coordinator's HTTP interface. Every request needs `Authorization: Bearer TOKEN` with the run's token of scope `work`.
//!
//! | endpoint | |
//! |---|---|
//! | `GET /work/v1/run` | [`Assignment`](super::Assignment) |
//! | `GET /work/v1/records/{segment}/{offset}` | a record as it is on disk |
//! | `POST /work/v1/shots/{n}/begin` | [`AttemptRequest`]: whether to measure the shot |
//! | `POST /work/v1/shots/{n}/failure` | [`AttemptRequest`] with a reason |
//! | `POST /work/v1/results` | bytes of a [`Delivery`](super::Delivery); the [`Verdict`](super::Verdict) |
//!
//! Errors are JSON, `{"error": "..."}`: 401 without the token, 410 for records that cannot be read, 422 for
//! results that are refused, 500 when the coordinator is about to end.

use std::sync::Arc;

use axum::{
    Json, Router,
    body::Bytes,
    extract::{DefaultBodyLimit, Path, Request, State},
    http::{StatusCode, header},
    middleware::{self, Next},
    response::{IntoResponse, Response},
    routing::{get, post},
};
use lfpiv_rawlog::Position;
use ring::digest::{SHA256, digest};
use serde::{Deserialize, Serialize};
use serde_json::json;
use subtle::ConstantTimeEq;

use super::{Attempt, ClusterError, Coordinator};

/// Largest result: a field of four million vectors.
const MOST_BYTES: usize = 256 << 20;

/// A worker's try at a shot.
#[derive(Debug, Serialize, Deserialize)]
pub(super) struct AttemptRequest {
    pub attempt: Attempt,
    pub worker: String,
    #[serde(default)]
    pub reason: String,
}

/// The routes of a coordinator; see the head of this file.
pub fn coordinator_routes(coordinator: Arc<Coordinator>, token: &str) -> Router {
    let expected = digest(&SHA256, token.as_bytes());
    let allowed = middleware::from_fn(move |request: Request, next: Next| async move {
        let given = request.headers().get(header::AUTHORIZATION);
        let given = given.and_then(|value| value.as_bytes().strip_prefix(b"Bearer "));
        let given = digest(&SHA256, given.unwrap_or_default());
        // Digests are compared, so that time says nothing of the token.
        if bool::from(given.as_ref().ct_eq(expected.as_ref())) {
            next.run(request).await
        } else {
            failed(
                StatusCode::UNAUTHORIZED,
                "this token is not that of the run, or is of an earlier coordinator",
            )
        }
    });
    Router::new()
        .route("/work/v1/run", get(run))
        .route("/work/v1/records/{segment}/{offset}", get(record))
        .route("/work/v1/shots/{shot}/begin", post(begin))
        .route("/work/v1/shots/{shot}/failure", post(fail))
        .route("/work/v1/results", post(deliver).layer(DefaultBodyLimit::max(MOST_BYTES)))
        // Before the body is read.
        .layer(allowed)
        .with_state(coordinator)
}

async fn run(State(coordinator): State<Arc<Coordinator>>) -> Response {
    Json(coordinator.assignment()).into_response()
}

async fn record(
    State(coordinator): State<Arc<Coordinator>>,
    Path((segment, offset)): Path<(u32, u64)>,
) -> Response {
    blocking(move || match coordinator.packed(Position { segment, offset }) {
        Ok(bytes) => bytes.into_response(),
        Err(error) => failed(StatusCode::GONE, &error.to_string()),
    })
    .await
}

async fn begin(
    State(coordinator): State<Arc<Coordinator>>,
    Path(shot): Path<u64>,
    Json(AttemptRequest { attempt, worker, .. }): Json<AttemptRequest>,
) -> Response {
    blocking(move || answer(coordinator.begin(shot, attempt, &worker))).await
}

async fn fail(
    State(coordinator): State<Arc<Coordinator>>,
    Path(shot): Path<u64>,
    Json(AttemptRequest { attempt, worker, reason }): Json<AttemptRequest>,
) -> Response {
    blocking(move || answer(coordinator.fail(shot, attempt, &worker, &reason))).await
}

async fn deliver(State(coordinator): State<Arc<Coordinator>>, bytes: Bytes) -> Response {
    blocking(move || answer(coordinator.deliver(&bytes))).await
}

/// Runs what waits for a disk where waiting holds up nobody.
async fn blocking(work: impl FnOnce() -> Response + Send + 'static) -> Response {
    match tokio::task::spawn_blocking(work).await {
        Ok(response) => response,
        Err(error) => failed(StatusCode::INTERNAL_SERVER_ERROR, &error.to_string()),
    }
}

fn answer<T: Serialize>(done: Result<T, ClusterError>) -> Response {
    match done {
        Ok(answer) => Json(answer).into_response(),
        Err(error @ ClusterError::Refused(_)) => {
            failed(StatusCode::UNPROCESSABLE_ENTITY, &error.to_string())
        }
        Err(error) => failed(StatusCode::INTERNAL_SERVER_ERROR, &error.to_string()),
    }
}

fn failed(status: StatusCode, error: &str) -> Response {
    (status, Json(json!({ "error": error }))).into_response()
}
