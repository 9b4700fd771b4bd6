//! Control requests of clients. They are forwarded to acquisition, which decides.
//!
//! `arm` and `start` let the laser fire. They are refused unless the configuration allows them
//! (`server.remote_arming`) and an operator has enabled them at the bench for this run. These
//! conditions and the rate limit do not apply to `stop` and `disarm`.

use std::{fmt, future::Future, net::SocketAddr, pin::Pin, sync::Arc, time::Duration};

use axum::{
    Json,
    extract::{FromRequestParts, State},
    http::{StatusCode, request::Parts},
    response::{IntoResponse, Response},
};
use serde::{Deserialize, Serialize};
use utoipa::ToSchema;

use super::{
    ApiError,
    app::{App, Connection},
    extract::Body,
};
use crate::{
    acquisition::{Command, Control, ControlState, Refusal},
    pipeline::EventKind,
};

/// Largest length of a note, in bytes.
pub(super) const NOTE_BYTES: usize = 4096;
/// How long a client waits for the bench. A slower request continues without the client.
const PATIENCE: Duration = Duration::from_secs(5);

/// Whether the command can lead to laser pulses.
fn can_cause_pulses(command: &Command) -> bool {
    matches!(command, Command::Start | Command::Arm | Command::Resume)
}

/// Interface to the run's control.
pub trait Controls: Send + Sync + 'static {
    /// Executes a command or refuses it with reasons. Completes even if the client disconnects.
    fn request(
        &self,
        command: Command,
    ) -> Pin<Box<dyn Future<Output = Result<ControlState, Refusal>> + Send>>;
    /// The present state.
    fn state(&self) -> ControlState;
}

impl Controls for Control {
    fn request(
        &self,
        command: Command,
    ) -> Pin<Box<dyn Future<Output = Result<ControlState, Refusal>> + Send>> {
        let control = self.clone();
        Box::pin(async move { Self::request(&control, command).await })
    }

    fn state(&self) -> ControlState {
        Self::state(self)
    }
}

/// A run's controls and whether they may be used.
#[derive(Clone, Default)]
pub(super) struct ControlAccess {
    pub controls: Option<Arc<dyn Controls>>,
    /// Whether an operator has enabled arming at the bench for this run.
    pub enabled_at_bench: bool,
}

impl fmt::Debug for ControlAccess {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let state = self.controls.as_ref().map(|controls| controls.state());
        f.debug_struct("ControlAccess")
            .field("state", &state)
            .field("enabled_at_bench", &self.enabled_at_bench)
            .finish()
    }
}

/// What can be controlled, and the present state.
#[derive(Debug, Serialize, ToSchema)]
pub(super) struct ControlView {
    /// Whether this run can be controlled over HTTP.
    controllable: bool,
    /// Whether `arm` and `start` are allowed: both of the next two fields are true.
    may_arm: bool,
    /// Whether the configuration allows `arm` and `start` (`server.remote_arming`).
    allowed_by_configuration: bool,
    /// Whether an operator has enabled them at the bench for this run (`lfpiv run
    /// --remote-arming`).
    enabled_at_bench: bool,
    /// Absent if the run cannot be controlled.
    state: Option<ControlState>,
}

/// A granted request.
#[derive(Debug, Serialize, ToSchema)]
pub(super) struct Granted {
    /// Whether the bench is still executing the request; an event reports its completion.
    pending: bool,
    #[serde(flatten)]
    state: ControlState,
}

/// The event of a granted request.
#[derive(Debug, Serialize)]
struct ControlEvent<'a> {
    #[serde(flatten)]
    command: &'a Command,
    #[serde(flatten)]
    state: ControlState,
}

/// The event of a refused request.
#[derive(Debug, Serialize)]
struct RefusedEvent<'a> {
    #[serde(flatten)]
    command: &'a Command,
    refused: &'a [String],
}

/// What can be controlled, and the present state.
#[utoipa::path(get, path = "/api/v1/control", tag = "control",
    responses((status = 200, body = ControlView)))]
pub(super) async fn show(State(app): State<App>) -> Json<ControlView> {
    let controls = app.run.control_access.controls.as_ref();
    Json(ControlView {
        controllable: controls.is_some(),
        may_arm: may_arm(&app),
        allowed_by_configuration: app.protection.remote_arming,
        enabled_at_bench: app.run.control_access.enabled_at_bench,
        state: controls.map(|controls| controls.state()),
    })
}

/// Whether the configuration and the operator allow arming.
fn may_arm(app: &App) -> bool {
    app.protection.remote_arming && app.run.control_access.enabled_at_bench
}

/// Fire bursts, once armed. Needs permission to arm.
#[utoipa::path(post, path = "/api/v1/control/start", tag = "control", responses(
    (status = 200, body = Granted), (status = 202, body = Granted),
    (status = 409, body = super::error::ErrorBody)))]
pub(super) async fn start(from: ControlRequest) -> Result<Response, ApiError> {
    from.submit(Command::Start).await
}

/// Stop firing. Exempt from the rate limit.
#[utoipa::path(post, path = "/api/v1/control/stop", tag = "control", responses(
    (status = 200, body = Granted), (status = 202, body = Granted),
    (status = 409, body = super::error::ErrorBody)))]
pub(super) async fn stop(from: ControlRequest) -> Result<Response, ApiError> {
    from.submit(Command::Stop).await
}

/// Program the synchroniser and warm up the lamps. Needs permission to arm.
#[utoipa::path(post, path = "/api/v1/control/arm", tag = "control", responses(
    (status = 200, body = Granted), (status = 202, body = Granted),
    (status = 409, body = super::error::ErrorBody)))]
pub(super) async fn arm(from: ControlRequest) -> Result<Response, ApiError> {
    from.submit(Command::Arm).await
}

/// Make the laser safe. Exempt from the rate limit.
#[utoipa::path(post, path = "/api/v1/control/disarm", tag = "control", responses(
    (status = 200, body = Granted), (status = 202, body = Granted),
    (status = 409, body = super::error::ErrorBody)))]
pub(super) async fn disarm(from: ControlRequest) -> Result<Response, ApiError> {
    from.submit(Command::Disarm).await
}

/// The body of `POST /api/v1/control/dt`.
#[derive(Debug, Deserialize, ToSchema)]
#[serde(deny_unknown_fields)]
pub(super) struct DtBody {
    /// Time between the light pulses in µs, 0.1 to 1,000,000.
    #[schema(minimum = 0.1, maximum = 1_000_000.0)]
    dt_us: f64,
}

/// Set the time between the light pulses.
#[utoipa::path(post, path = "/api/v1/control/dt", tag = "control", request_body = DtBody, responses(
    (status = 200, body = Granted), (status = 202, body = Granted),
    (status = 409, body = super::error::ErrorBody)))]
pub(super) async fn dt(
    from: ControlRequest,
    Body(body): Body<DtBody>,
) -> Result<Response, ApiError> {
    if !(0.1..=1e6).contains(&body.dt_us) {
        let error = format!("dt_us = {}: allowed 0.1 to 1000000", body.dt_us);
        return Err(ApiError::new(StatusCode::UNPROCESSABLE_ENTITY, error));
    }
    from.submit(Command::SetDt { dt_us: body.dt_us }).await
}

/// The body of `POST /api/v1/control/note`.
#[derive(Debug, Deserialize, ToSchema)]
#[serde(deny_unknown_fields)]
pub(super) struct NoteBody {
    /// The note, at most 4096 bytes.
    #[schema(min_length = 1, max_length = 4096)]
    text: String,
}

/// Add a note to the run's record.
#[utoipa::path(post, path = "/api/v1/control/note", tag = "control", request_body = NoteBody, responses(
    (status = 200, body = Granted), (status = 202, body = Granted),
    (status = 409, body = super::error::ErrorBody)))]
pub(super) async fn note(
    from: ControlRequest,
    Body(body): Body<NoteBody>,
) -> Result<Response, ApiError> {
    let length = body.text.len();
    if length > NOTE_BYTES {
        let error = format!("the note has {length} bytes; allowed: at most {NOTE_BYTES}");
        return Err(ApiError::new(StatusCode::PAYLOAD_TOO_LARGE, error));
    }
    let printable = |letter: char| !letter.is_control() || matches!(letter, '\n' | '\t');
    if body.text.trim().is_empty() || !body.text.chars().all(printable) {
        let error = "a note must be text without control characters";
        return Err(ApiError::new(StatusCode::UNPROCESSABLE_ENTITY, error));
    }
    from.submit(Command::Note { text: body.text }).await
}

/// A control request and the client's address for the log.
pub(super) struct ControlRequest {
    app: App,
    peer: SocketAddr,
}

impl FromRequestParts<App> for ControlRequest {
    type Rejection = ApiError;

    async fn from_request_parts(parts: &mut Parts, app: &App) -> Result<Self, ApiError> {
        let connection = parts.extensions.get::<Connection>();
        let connection =
            connection.ok_or_else(|| ApiError::internal("the request has no connection"))?;
        Ok(Self { app: app.clone(), peer: connection.peer })
    }
}

impl ControlRequest {
    async fn submit(self, command: Command) -> Result<Response, ApiError> {
        let control_access = &self.app.run.control_access;
        let Some(controls) = control_access.controls.clone() else {
            let reason = "acquisition accepts no requests in this run".to_owned();
            return Err(refused("this run cannot be controlled", vec![reason]));
        };
        if can_cause_pulses(&command) && !may_arm(&self.app) {
            let reason = "set server.remote_arming, and have an operator enable it at the bench \
                          for this run"
                .to_owned();
            return Err(refused("arming over HTTP is not allowed in this run", vec![reason]));
        }
        let peer = self.peer;
        tracing::info!(%peer, ?command, "control request over HTTP");
        let (run, run_controls) = (self.app.run.clone(), controls.clone());
        // A task of its own, so that the request is completed even if the client disconnects.
        let request = self.app.tasks.spawn(async move {
            let answer = run_controls.request(command.clone()).await;
            match &answer {
                Ok(state) => {
                    let event = ControlEvent { command: &command, state: state.clone() };
                    run.board.events().publish(EventKind::Control, &event);
                }
                Err(refusal) => {
                    tracing::warn!(%peer, ?command, ?refusal, "control request refused");
                    let event = RefusedEvent { command: &command, refused: &refusal.reasons };
                    run.board.events().publish(EventKind::Control, &event);
                }
            }
            answer
        });
        let patience = PATIENCE.min(self.app.protection.patience / 2);
        match tokio::time::timeout(patience, request).await {
            Ok(Ok(Ok(state))) => Ok(Json(Granted { pending: false, state }).into_response()),
            Ok(Ok(Err(refusal))) => Err(refused("the run refuses", refusal.reasons)),
            Ok(Err(error)) => Err(ApiError::internal(format!("the request failed: {error}"))),
            Err(_) => {
                let granted = Granted { pending: true, state: controls.state() };
                Ok((StatusCode::ACCEPTED, Json(granted)).into_response())
            }
        }
    }
}

fn refused(what: &str, reasons: Vec<String>) -> ApiError {
    let error = format!("{what}: {}", reasons.join("; "));
    ApiError::new(StatusCode::CONFLICT, error).with("reasons", reasons)
}
