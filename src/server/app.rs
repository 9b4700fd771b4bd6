//! What the handlers share: the run, who may ask, and the limits of what is made for them.

use std::{net::SocketAddr, sync::Arc};

use axum::extract::FromRef;
use tokio::sync::Semaphore;
use tokio_util::{sync::CancellationToken, task::TaskTracker};
use utoipa::openapi::OpenApi;

use super::{ApiState, Protection, work::Work};

/// Event streams that may be open at the same time.
pub(super) const EVENT_STREAMS: usize = 512;

/// Cheap to clone.
#[derive(Clone)]
pub(super) struct App {
    pub run: ApiState,
    pub protection: Arc<Protection>,
    pub work: Work,
    /// What is served, in OpenAPI.
    pub document: Arc<OpenApi>,
    /// A permit per event stream.
    pub streams: Arc<Semaphore>,
    /// Cancelled when the server ends: event streams end with what has happened until then.
    pub stop: CancellationToken,
    /// Control requests under way: a client that goes away does not take its request with it.
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

/// Both ends of the connection that a request came by.
#[derive(Debug, Clone, Copy)]
pub(super) struct Connection {
    pub peer: SocketAddr,
    pub local: SocketAddr,
}
