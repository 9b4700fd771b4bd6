//! State shared by the handlers: the run, access rules, and resource limits.

use std::{net::SocketAddr, sync::Arc};

use axum::extract::FromRef;
use tokio::sync::Semaphore;
use tokio_util::{sync::CancellationToken, task::TaskTracker};
use utoipa::openapi::OpenApi;

use super::{ApiState, Protection, work::Work};

/// Largest number of open event streams.
pub(super) const EVENT_STREAMS: usize = 512;

/// Handler state. Cheap to clone.
#[derive(Clone)]
pub(super) struct App {
    pub run: ApiState,
    pub protection: Arc<Protection>,
    pub work: Work,
    /// OpenAPI description of the endpoints.
    pub document: Arc<OpenApi>,
    /// One permit per event stream.
    pub streams: Arc<Semaphore>,
    /// Cancelled when the server ends. Event streams then deliver the events so far and end.
    pub stop: CancellationToken,
    /// Control requests in progress. A request is completed even if its client disconnects.
    pub tasks: TaskTracker,
}

impl App {
    pub fn new(
        run: ApiState,
        protection: Protection,
        document: Arc<OpenApi>,
        stop: CancellationToken,
    ) -> Self {
        let work = Work::new(protection.patience / 2);
        let streams = Arc::new(Semaphore::new(EVENT_STREAMS));
        let (protection, tasks) = (Arc::new(protection), TaskTracker::new());
        Self { run, protection, work, document, streams, stop, tasks }
    }
}

impl FromRef<App> for ApiState {
    fn from_ref(app: &App) -> Self {
        app.run.clone()
    }
}

impl FromRef<App> for Work {
    fn from_ref(app: &App) -> Self {
        app.work.clone()
    }
}

/// Both addresses of the connection that a request arrived on.
#[derive(Debug, Clone, Copy)]
pub(super) struct Connection {
    pub peer: SocketAddr,
    pub local: SocketAddr,
}
