//! `/api/v1/events`: live events as server-sent events.

use std::{
    collections::VecDeque,
    convert::Infallible,
    time::{Duration, Instant},
};

use axum::{
    extract::State,
    http::{HeaderMap, HeaderName, HeaderValue},
    response::{
        IntoResponse, Response, Sse,
        sse::{self, KeepAlive},
    },
};
use futures_util::{Stream, stream};
use tokio::{
    sync::{OwnedSemaphorePermit, watch},
    time::{Interval, MissedTickBehavior},
};

use super::{ApiError, ApiState, app::App};
use crate::pipeline::EventKind;

/// Events read from the log at a time.
const BATCH: usize = 64;
/// Silence after which a comment keeps the connection alive.
const KEEP_ALIVE: Duration = Duration::from_secs(5);
/// Interval of the heartbeat of a stream.
const HEARTBEAT: Duration = Duration::from_millis(500);
/// Heartbeats stop when the run loop has been silent for longer than this. Programming a
/// synchroniser takes some seconds.
const RUN_LOOP_PATIENCE: Duration = Duration::from_secs(5);
/// Interval at which the run's state is checked for changes.
const STATUS_INTERVAL: Duration = Duration::from_millis(250);

/// Publishes changes of the run's state, a few times per second at most, until it is dropped.
pub(super) async fn announce_changes(run: ApiState) {
    let mut ticks = tokio::time::interval(STATUS_INTERVAL);
    ticks.set_missed_tick_behavior(MissedTickBehavior::Delay);
    loop {
        ticks.tick().await;
        run.announce();
    }
}

/// Live events, server-sent.
///
/// Named `status` (summary of the run), `shot` (a shot's record when it ends), `result` (a result
/// can be fetched), `watermarks` (how many shots are safe), `control` (a granted request) and
/// `missed`. Without `Last-Event-ID` the stream begins with the present `status`; with it, with the
/// events after that id. `missed` gives the number of events that are no longer in the server's
/// log; `null` if the id belongs to another run. While the run is alive, the comment `heartbeat` is
/// sent twice a second.
#[utoipa::path(get, path = "/api/v1/events", tag = "live",
    params(("Last-Event-ID" = Option<String>, Header,
        description = "The id of the last event received.")),
    responses(
        (status = 200, description = "Events, without end while the run lasts",
            content_type = "text/event-stream", body = String),
        (status = 503, description = "Too many streams", body = super::error::ErrorBody)))]
pub(super) async fn events(
    State(app): State<App>,
    headers: HeaderMap,
) -> Result<Response, ApiError> {
    let permit = app.streams.clone().try_acquire_owned();
    let permit = permit.map_err(|_| ApiError::busy("there are too many event streams"))?;
    let reader = Reader::new(app, headers.get("last-event-id"), permit);
    let events = Sse::new(reader.into_stream()).keep_alive(KeepAlive::new().interval(KEEP_ALIVE));
    let unbuffered = (HeaderName::from_static("x-accel-buffering"), HeaderValue::from_static("no"));
    Ok(([unbuffered], events).into_response())
}

/// Position of one stream in the event log.
struct Reader {
    app: App,
    run: u64,
    /// Id of the last event read.
    place: u64,
    changes: watch::Receiver<u64>,
    heartbeat: Interval,
    pending: VecDeque<sse::Event>,
    _permit: OwnedSemaphorePermit,
}

impl Reader {
    fn new(app: App, last: Option<&HeaderValue>, permit: OwnedSemaphorePermit) -> Self {
        let log = app.run.board.events();
        let (run, changes, now) = (log.run(), log.watch(), log.last_id());
        let pending = VecDeque::new();
        let mut heartbeat = tokio::time::interval(HEARTBEAT);
        heartbeat.set_missed_tick_behavior(MissedTickBehavior::Delay);
        let mut reader =
            Self { app, run, place: now, changes, heartbeat, pending, _permit: permit };
        match last.map(|id| resumed(id, run)) {
            Some(Some(place)) => reader.place = place.min(now),
            other => {
                if other.is_some() {
                    reader.push_missed(None);
                }
                let brief = serde_json::to_string(&reader.app.run.brief()).unwrap_or_default();
                reader.push(EventKind::Status.name(), now, &brief);
            }
        }
        reader
    }

    fn push(&mut self, name: &str, id: u64, data: &str) {
        let id = format!("{:x}-{id}", self.run);
        self.pending.push_back(sse::Event::default().event(name).id(id).data(data));
    }

    fn push_missed(&mut self, count: Option<u64>) {
        let data = serde_json::json!({ "missed": count }).to_string();
        self.pending.push_back(sse::Event::default().event("missed").data(data));
    }

    /// Sends a heartbeat if the run is alive.
    fn push_heartbeat(&mut self) {
        if self.app.run.run_loop.silent_for(Instant::now()) < RUN_LOOP_PATIENCE {
            self.pending.push_back(sse::Event::default().comment("heartbeat"));
        }
    }

    /// Reads new events from the log.
    fn read(&mut self) {
        let batch = self.app.run.board.events().after(self.place, BATCH);
        if batch.missed > 0 {
            self.push_missed(Some(batch.missed));
        }
        for event in batch.events {
            self.push(event.kind.name(), event.id, &event.data);
            self.place = event.id;
        }
    }

    /// The next event; `None` once the server ends and all events are delivered.
    async fn next(&mut self) -> Option<sse::Event> {
        loop {
            let ending = self.app.stop.is_cancelled();
            if self.pending.is_empty() {
                self.read();
            }
            if let Some(event) = self.pending.pop_front() {
                return Some(event);
            }
            if ending {
                return None;
            }
            tokio::select! {
                _ = self.changes.changed() => {}
                _ = self.heartbeat.tick() => self.push_heartbeat(),
                () = self.app.stop.cancelled() => {}
            }
        }
    }

    fn into_stream(self) -> impl Stream<Item = Result<sse::Event, Infallible>> {
        stream::unfold(self, |mut reader| async move {
            reader.next().await.map(|event| (Ok(event), reader))
        })
    }
}

/// The position of an event id in this run; `None` for an id of another run or an invalid id.
fn resumed(id: &HeaderValue, run: u64) -> Option<u64> {
    let (of_run, place) = id.to_str().ok()?.split_once('-')?;
    let of_run = u64::from_str_radix(of_run, 16).ok()?;
    (of_run == run).then(|| place.parse().ok())?
}
