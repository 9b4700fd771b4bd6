//! HTTP: what the daemon does and what it measured. Read-only; nothing here can fire a laser.
//!
//! | endpoint | answer |
//! |---|---|
//! | `GET /api/v1/status` | state of the run, shot counts, ledger, configuration in brief |
//! | `GET /api/v1/shots?limit=N` | the last N shots (default 100, at most 1000), newest first |
//! | `GET /api/v1/shots/{n}` | one shot |
//! | `GET /api/v1/results/latest` | the result with the highest shot number |
//! | `GET /api/v1/results/{n}` | the result of shot n |
//! | `GET /healthz` | `ok`, or 503 when the run has failed |
//! | `GET /metrics` | counters and gauges in OpenMetrics text |
//!
//! Results are JSON, or binary with `?format=binary` or `Accept: application/octet-stream`; see
//! [`binary`] for the layout. Names carry units. Errors are JSON, `{"error": "..."}`: 400 for
//! what is no number, 404 for what is not there, 410 for a result that has left the memory, with
//! the files it is in.

pub mod binary;
mod error;
mod metrics;
mod results;
mod shots;
mod state;
mod status;

use axum::{Router, routing::get};
use tokio::net::TcpListener;
use tokio_util::sync::CancellationToken;

use error::ApiError;
pub use state::{ApiState, ConfigurationSummary, Phase, RunInfo};

/// Serves `state` on `listener` until `stop` is cancelled and the requests in hand are answered.
///
/// # Errors
///
/// What the listener's socket reports.
pub async fn serve(
    listener: TcpListener,
    state: ApiState,
    stop: CancellationToken,
) -> std::io::Result<()> {
    axum::serve(listener, router(state)).with_graceful_shutdown(stop.cancelled_owned()).await
}

fn router(state: ApiState) -> Router {
    Router::new()
        .route("/api/v1/status", get(status::status))
        .route("/api/v1/shots", get(shots::list))
        .route("/api/v1/shots/{n}", get(shots::one))
        .route("/api/v1/results/latest", get(results::latest))
        .route("/api/v1/results/{n}", get(results::one))
        .route("/healthz", get(status::health))
        .route("/metrics", get(metrics::metrics))
        .fallback(|| async { ApiError::not_found("no such endpoint; see docs/http.md") })
        .with_state(state)
}

/// A shot number from a path.
fn shot_number(text: &str) -> Result<u64, ApiError> {
    text.parse().map_err(|_| {
        ApiError::bad_request(format!("'{text}' is no shot number: give an integer from 0"))
    })
}
