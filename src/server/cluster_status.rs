//! Workers, rates and backlog of a coordinator that has no bench: `lfpiv process RUN --cluster`. The same paths and names
//! as of a run's server; for readers on this machine only, without tokens.

use std::{fmt, net::IpAddr, sync::Arc};

use axum::{
    Json, Router,
    extract::{Request, State},
    http::{StatusCode, header},
    middleware::{self, Next},
    response::{IntoResponse, Response},
    routing::get,
};
use prometheus_client::{collector::Collector, encoding::DescriptorEncoder, registry::Registry};
use serde_json::json;
use tokio::net::TcpListener;
use tokio_util::sync::CancellationToken;

use super::{cluster_metrics, metrics::written};
use crate::cluster::ClusterProgress;

/// Serves `/api/v1/status` and `/metrics` on `listener`, which is one of this machine alone, until `stop` is cancelled.
pub async fn serve_cluster(
    listener: TcpListener,
    progress: Arc<ClusterProgress>,
    stop: CancellationToken,
) {
    let routes = Router::new()
        .route("/api/v1/status", get(status))
        .route("/metrics", get(metrics))
        .layer(middleware::from_fn(from_this_machine))
        .with_state(progress);
    let served = axum::serve(listener, routes).with_graceful_shutdown(stop.cancelled_owned());
    if let Err(error) = served.await {
        tracing::warn!("the state of the workers is not shown any more: {error}");
    }
}

async fn status(State(progress): State<Arc<ClusterProgress>>) -> Response {
    Json(json!({ "state": "running", "cluster": progress.view() })).into_response()
}

async fn metrics(State(progress): State<Arc<ClusterProgress>>) -> Response {
    let mut registry = Registry::with_prefix("lfpiv");
    registry.register_collector(Box::new(Reader(progress)));
    written(&registry)
}

/// A page of another server must not read it by a name that it has made to mean this machine.
async fn from_this_machine(request: Request, next: Next) -> Response {
    let host = request.headers().get(header::HOST).and_then(|host| host.to_str().ok());
    match host.is_some_and(is_this_machine) {
        true => next.run(request).await,
        false => StatusCode::MISDIRECTED_REQUEST.into_response(),
    }
}

fn is_this_machine(host: &str) -> bool {
    let name = match host.rsplit_once(':') {
        Some((name, port)) if port.bytes().all(|byte| byte.is_ascii_digit()) => name,
        _ => host,
    };
    let address = name.trim_start_matches('[').trim_end_matches(']').parse::<IpAddr>();
    name == "localhost" || address.is_ok_and(|address| address.is_loopback())
}

struct Reader(Arc<ClusterProgress>);

impl fmt::Debug for Reader {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        formatter.write_str("Reader")
    }
}

impl Collector for Reader {
    fn encode(&self, mut encoder: DescriptorEncoder) -> Result<(), fmt::Error> {
        cluster_metrics::encode(&self.0.view(), &mut encoder)
    }
}

#[cfg(test)]
mod tests {
    use super::is_this_machine;

    #[test]
    fn names_of_this_machine_are_told_from_others() {
        for host in
            ["localhost", "localhost:80", "127.0.0.1:8641", "[::1]:80", "[::1]", "127.8.0.1"]
        {
            assert!(is_this_machine(host), "{host}");
        }
        for host in [
            "",
            "example.org",
            "example.org:80",
            "localhost.example.org",
            "10.0.0.1:80",
            "127.0.0.1.nip.io",
        ] {
            assert!(!is_this_machine(host), "{host}");
        }
    }
}
