//! The HTTP server: state and results of the run, live events, and the run's controls.
//!
//! | endpoint | scope | answer |
//! |---|---|---|
//! | `GET /api/v1/status` | read | state of the run, shot counts, ledger, configuration in brief |
//! | `GET /api/v1/events` | read | the same as it changes: server-sent events |
//! | `GET /api/v1/shots?limit=N` | read | the last N shots (default 100, at most 1000), newest first |
//! | `GET /api/v1/shots/{n}` | read | one shot |
//! | `GET /api/v1/shots/{n}/frames/{camera}/{a,b}.png?width=` | read | a raw frame to look at |
//! | `GET /api/v1/shots/{n}/frames/{camera}/statistics` | read | both frames in numbers |
//! | `GET /api/v1/configuration` | read | the settings of the run |
//! | `GET /api/v1/mask` | read | which voxels are flow, as bytes |
//! | `GET /api/v1/results/{n}` | read | the result of shot n, or of `latest` |
//! | `GET /api/v1/results/{n}/particles` | read | the particles placed in its images |
//! | `GET /api/v1/results/{n}/volumes/{a,b}` | read | a frame's volume, as bytes |
//! | `GET /api/v1/results/{n}/projections/{a,b}/{xy,xz,yz}.png` | read | its maximum projections |
//! | `GET /api/v1/statistics` | read | ensemble statistics of the shots so far |
//! | `GET /api/v1/control` | read | what can be controlled |
//! | `GET /api/v1/control/timing?dt_us=` | read | the pulse schedule |
//! | `POST /api/v1/control/{start,stop,arm,disarm,dt,note}` | control | see [`control`] |
//! | `GET /metrics` | read | counters and gauges in OpenMetrics text |
//! | `GET /healthz` | – | `ok`, or 503 when the run has failed |
//! | `GET /api/v1/openapi.json`, `/docs` | – | the OpenAPI description, and a page that shows it |
//! | `GET /` | – | the bench in a browser |
//!
//! A request passes [`listener`] (connections, TLS, slow clients) and [`guard`] (rate, host and
//! origin, deadline, scope) before its handler. [`protection`] is set up before the address is
//! bound. Results are JSON or bytes in the layout of [`binary`]. Errors are JSON, `{"error":
//! "..."}`, with the status codes listed in docs/http.md.

mod app;
pub mod binary;
mod brief;
mod bytes;
mod cluster_metrics;
mod cluster_status;
mod configuration;
mod connection_slots;
mod control;
mod error;
mod events;
mod extract;
mod frame_statistics;
mod frames;
mod guard;
mod light;
mod listener;
mod metrics;
mod openapi;
mod page;
mod particles;
mod preview;
mod protection;
mod result_source;
mod results;
mod schemas;
mod seeding;
mod shots;
mod state;
mod statistics;
mod status;
mod work;

use std::sync::Arc;

use axum::{Router, extract::DefaultBodyLimit, http::StatusCode, middleware};
use tokio::net::TcpListener;
use tokio_util::sync::CancellationToken;
use utoipa::OpenApi;
use utoipa_axum::{router::OpenApiRouter, routes};

use app::App;
pub use cluster_status::serve_cluster;
pub use configuration::BenchSettings;
pub use control::Controls;
use error::ApiError;
pub use frames::FrameSource;
pub use protection::{Protection, ProtectionError, open_files_needed, raise_open_files};
pub use result_source::ResultSource;
pub use seeding::VolumeViews;
pub use state::{
    ApiState, CalibrationSummary, ConfigurationSummary, MaskFileSummary, MaskSummary, Phase,
    RunInfo,
};

/// Largest size of a request's body.
const BODY_BYTES: usize = 64 << 10;

/// Serves `state` on `listener` until `stop` is cancelled, all requests are answered and event
/// streams have delivered the events until then.
pub async fn serve(
    listener: TcpListener,
    state: ApiState,
    protection: Protection,
    stop: CancellationToken,
) {
    let (routes, document) = routes();
    let app = App::new(state.clone(), protection, Arc::new(document), stop.clone());
    let (tasks, protection) = (app.tasks.clone(), app.protection.clone());
    let router = guarded(routes, app);
    tokio::select! {
        () = listener::listen(listener, router, protection, stop) => {}
        () = events::announce_changes(state) => {}
    }
    tasks.close();
    tasks.wait().await;
}

/// The endpoints by required access.
struct Routes {
    open: Router<App>,
    read: Router<App>,
    control: Router<App>,
}

fn routes() -> (Routes, utoipa::openapi::OpenApi) {
    let (open, mut document) = OpenApiRouter::with_openapi(openapi::Document::openapi())
        .routes(routes!(status::health))
        .routes(routes!(page::page))
        .routes(routes!(page::script))
        .routes(routes!(page::style))
        .routes(routes!(page::icon))
        .routes(routes!(openapi::document))
        .routes(routes!(openapi::page))
        .routes(routes!(openapi::script))
        .routes(routes!(openapi::style))
        .split_for_parts();
    let (read, read_document) = OpenApiRouter::new()
        .routes(routes!(status::status))
        .routes(routes!(events::events))
        .routes(routes!(shots::list))
        .routes(routes!(shots::one))
        .routes(routes!(configuration::configuration))
        .routes(routes!(configuration::mask))
        .routes(routes!(frames::preview))
        .routes(routes!(frame_statistics::statistics))
        .routes(routes!(results::one))
        .routes(routes!(particles::particles))
        .routes(routes!(statistics::statistics))
        .routes(routes!(light::volume))
        .routes(routes!(light::projection))
        .routes(routes!(control::show))
        .routes(routes!(configuration::timing))
        .routes(routes!(metrics::metrics))
        .split_for_parts();
    let (control, control_document) = OpenApiRouter::new()
        .routes(routes!(control::start))
        .routes(routes!(control::stop))
        .routes(routes!(control::arm))
        .routes(routes!(control::disarm))
        .routes(routes!(control::dt))
        .routes(routes!(control::note))
        .split_for_parts();
    document.merge(read_document);
    document.merge(control_document);
    (Routes { open, read, control }, openapi::with_common_errors(document))
}

/// Adds the guards to the routes; the last layer sees a request first.
fn guarded(routes: Routes, app: App) -> Router {
    let read =
        routes.read.route_layer(middleware::from_fn_with_state(app.clone(), guard::may_read));
    let control =
        routes.control.route_layer(middleware::from_fn_with_state(app.clone(), guard::may_control));
    Router::new()
        .merge(routes.open)
        .merge(read)
        .merge(control)
        .fallback(|| async { ApiError::not_found("no such endpoint; see /docs") })
        .method_not_allowed_fallback(|| async {
            ApiError::new(
                StatusCode::METHOD_NOT_ALLOWED,
                "this method is not allowed here; see /docs",
            )
        })
        .layer(DefaultBodyLimit::max(BODY_BYTES))
        .layer(middleware::from_fn_with_state(app.clone(), guard::deadline))
        .layer(middleware::from_fn(guard::size))
        .layer(middleware::from_fn_with_state(app.clone(), guard::origin))
        .layer(middleware::from_fn_with_state(app.clone(), guard::rate))
        .layer(middleware::from_fn(guard::headers))
        .with_state(app)
}
