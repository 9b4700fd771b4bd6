//! The coordinator's HTTP interface. Every request needs `Authorization: Bearer TOKEN` with one of the run's [`Tokens`]; that
//! of scope `work` includes reading.
//!
//! | endpoint | scope | |
//! |---|---|---|
//! | `GET /work/v1/run` | read | [`Assignment`](super::Assignment) |
//! | `GET /work/v1/records/{segment}/{offset}` | read | a record as it is on disk, or a range of it (`Range: bytes=1000-`) |
//! | `POST /work/v1/shots/{n}/begin` | work | [`AttemptRequest`]: whether to measure the shot |
//! | `POST /work/v1/shots/{n}/failure` | work | [`AttemptRequest`] with a reason |
//! | `POST /work/v1/workers` | work | [`SignOfLife`]: a worker is there, or ends |
//! | `POST /work/v1/results` | work | bytes of a [`Delivery`](super::Delivery); the [`Verdict`](super::Verdict) |
//!
//! Errors are JSON, `{"error": "..."}`: 401 without the right token, 410 for records that cannot be read, 422 for
//! results that are refused, 500 when the coordinator is about to end.

use std::sync::Arc;

use axum::{
    Json, Router,
    body::Bytes,
    extract::{DefaultBodyLimit, Path, Request, State},
    http::{HeaderMap, StatusCode, header},
    middleware::{self, Next},
    response::{IntoResponse, Response},
    routing::{get, post},
};
use lfpiv_rawlog::Position;
use ring::digest::{Digest, SHA256, digest};
use serde::{Deserialize, Serialize};
use serde_json::json;
use subtle::ConstantTimeEq;

use super::{Attempt, ClusterError, Coordinator, RangeRequest, Tokens, parse_range};

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

/// A worker is there, or ends.
#[derive(Debug, Serialize, Deserialize)]
pub(super) struct SignOfLife {
    pub worker: String,
    pub is_ending: bool,
}

/// The routes of a coordinator; see the head of this file.
pub fn coordinator_routes(coordinator: Arc<Coordinator>, tokens: &Tokens) -> Router {
    let readers = Router::new()
        .route("/work/v1/run", get(run))
        .route("/work/v1/records/{segment}/{offset}", get(record));
    let workers = Router::new()
        .route("/work/v1/shots/{shot}/begin", post(begin))
        .route("/work/v1/shots/{shot}/failure", post(fail))
        .route("/work/v1/workers", post(hear))
        .route("/work/v1/results", post(deliver).layer(DefaultBodyLimit::max(MOST_BYTES)));
    let readers = guarded(readers, &[&tokens.read, &tokens.work]);
    readers.merge(guarded(workers, &[&tokens.work])).with_state(coordinator)
}

/// Lets requests with one of the tokens pass, before their bodies are read.
fn guarded(routes: Router<Arc<Coordinator>>, tokens: &[&str]) -> Router<Arc<Coordinator>> {
    let expected: Arc<[_]> = tokens.iter().map(|token| digest(&SHA256, token.as_bytes())).collect();
    routes.route_layer(middleware::from_fn(move |request: Request, next: Next| {
        let expected = expected.clone();
        async move {
            let given = request.headers().get(header::AUTHORIZATION);
            let given = given.and_then(|value| value.as_bytes().strip_prefix(b"Bearer "));
            let given = digest(&SHA256, given.unwrap_or_default());
            // Digests are compared, all of them, so that time says nothing of the tokens.
            let equal = |one: &Digest| bool::from(given.as_ref().ct_eq(one.as_ref()));
            if expected.iter().filter(|one| equal(one)).count() > 0 {
                next.run(request).await
            } else {
                failed(
                    StatusCode::UNAUTHORIZED,
                    "this token does not allow that, or is of another run, or of an earlier coordinator",
                )
            }
        }
    }))
}

async fn run(State(coordinator): State<Arc<Coordinator>>) -> Response {
    Json(coordinator.assignment()).into_response()
}

async fn record(
    State(coordinator): State<Arc<Coordinator>>,
    Path((segment, offset)): Path<(u32, u64)>,
    headers: HeaderMap,
) -> Response {
    let range = headers.get(header::RANGE).and_then(|range| range.to_str().ok()).map(str::to_owned);
    blocking(move || match coordinator.packed(Position { segment, offset }) {
        Ok(bytes) => ranged(bytes.into(), range.as_deref()),
        Err(error) => failed(StatusCode::GONE, &error.to_string()),
    })
    .await
}

/// All bytes, or the part that is asked for: a worker goes on where its network has failed.
fn ranged(bytes: Bytes, range: Option<&str>) -> Response {
    match range.map_or(RangeRequest::Whole, |range| parse_range(range, bytes.len())) {
        RangeRequest::Whole => bytes.into_response(),
        RangeRequest::Part(part) => {
            let place = format!("bytes {}-{}/{}", part.start, part.end - 1, bytes.len());
            let place = [(header::CONTENT_RANGE, place)];
            (StatusCode::PARTIAL_CONTENT, place, bytes.slice(part)).into_response()
        }
        RangeRequest::Unsatisfiable => {
            failed(StatusCode::RANGE_NOT_SATISFIABLE, "the range is outside of the record")
        }
    }
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

async fn hear(
    State(coordinator): State<Arc<Coordinator>>,
    Json(SignOfLife { worker, is_ending }): Json<SignOfLife>,
) -> Response {
    blocking(move || {
        coordinator.hear(&worker, is_ending);
        Json(()).into_response()
    })
    .await
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
