//! The worker's end of the interface to the coordinator.

use std::time::Duration;

use lfpiv_hw::RawImage;
use lfpiv_rawlog::{Position, unpack};
use serde::{Serialize, de::DeserializeOwned};
use serde_json::Value;
use thiserror::Error;
use ureq::{Agent, Body, http::Response};

use super::{Assignment, Attempt, Begin, Frame, Verdict, routes::AttemptRequest};

/// Longest time for a request: coordinators wait for their disks.
const REQUEST_TIMEOUT: Duration = Duration::from_secs(60);
/// Longest time until a connection is made.
const CONNECT_TIMEOUT: Duration = Duration::from_secs(5);
/// Most bytes of an answer: the largest image, stored as it is.
const MOST_BYTES: u64 = 600 << 20;

/// Why the coordinator was of no help.
#[derive(Debug, Error)]
pub enum ClientError {
    /// It does not answer, or is about to end: perhaps it will later.
    #[error("the coordinator does not answer: {0}")]
    Unreachable(String),
    /// The token is not its: it has been started anew, or another program has its address.
    #[error("the coordinator does not know this job: {0}")]
    Stale(String),
    /// It does not take what it was sent.
    #[error("the coordinator refuses: {0}")]
    Refused(String),
    /// A record cannot be read, there or here.
    #[error("a frame cannot be read: {0}")]
    Frame(String),
}

/// Blocking requests to one coordinator.
#[derive(Debug, Clone)]
pub struct CoordinatorClient {
    agent: Agent,
    address: String,
    authorization: String,
}

impl CoordinatorClient {
    /// For the coordinator at `http://ADDRESS`.
    pub fn new(address: &str, token: &str) -> Self {
        let agent = Agent::config_builder()
            .http_status_as_error(false)
            .timeout_connect(Some(CONNECT_TIMEOUT))
            .timeout_global(Some(REQUEST_TIMEOUT))
            .build();
        Self {
            agent: agent.into(),
            address: address.to_owned(),
            authorization: format!("Bearer {token}"),
        }
    }

    /// What is to be known of the run.
    ///
    /// # Errors
    /// [`ClientError`].
    pub fn assignment(&self) -> Result<Assignment, ClientError> {
        read(self.get("run")?)
    }

    /// A frame's image, checked.
    ///
    /// # Errors
    /// [`ClientError`].
    pub fn frame(&self, frame: &Frame) -> Result<RawImage, ClientError> {
        let Position { segment, offset } = frame.position();
        let mut answer = self.get(&format!("records/{segment}/{offset}"))?;
        let bytes = answer.body_mut().with_config().limit(MOST_BYTES).read_to_vec();
        let bytes = bytes.map_err(|error| ClientError::Unreachable(error.to_string()))?;
        let record = unpack(&bytes).map_err(|what| ClientError::Frame(what.to_owned()))?;
        record
            .image
            .filter(|image| image.crc32() == frame.crc32)
            .ok_or_else(|| ClientError::Frame("its image is not that of the job".into()))
    }

    /// Whether a shot is to be measured.
    ///
    /// # Errors
    /// [`ClientError`].
    pub fn begin(&self, shot: u64, attempt: Attempt, worker: &str) -> Result<Begin, ClientError> {
        let request = AttemptRequest { attempt, worker: worker.to_owned(), reason: String::new() };
        read(self.post(&format!("shots/{shot}/begin"), &request)?)
    }

    /// Says that a shot could not be measured.
    ///
    /// # Errors
    /// [`ClientError`].
    pub fn fail(
        &self,
        shot: u64,
        attempt: Attempt,
        worker: &str,
        reason: &str,
    ) -> Result<(), ClientError> {
        let request =
            AttemptRequest { attempt, worker: worker.to_owned(), reason: reason.to_owned() };
        self.post(&format!("shots/{shot}/failure"), &request).map(|_| ())
    }

    /// Delivers a result, as [`super::Delivery::encode`] made it.
    ///
    /// # Errors
    /// [`ClientError`].
    pub fn deliver(&self, bytes: &[u8]) -> Result<Verdict, ClientError> {
        let request = self.agent.post(self.url("results"));
        let request = request.header("Authorization", &self.authorization);
        read(checked(request.send(bytes))?)
    }

    fn get(&self, path: &str) -> Result<Response<Body>, ClientError> {
        let request = self.agent.get(self.url(path));
        checked(request.header("Authorization", &self.authorization).call())
    }

    fn post(&self, path: &str, body: &impl Serialize) -> Result<Response<Body>, ClientError> {
        let request = self.agent.post(self.url(path));
        checked(request.header("Authorization", &self.authorization).send_json(body))
    }

    fn url(&self, path: &str) -> String {
        format!("{}/work/v1/{path}", self.address)
    }
}

/// An answer with what was asked for.
fn checked(answer: Result<Response<Body>, ureq::Error>) -> Result<Response<Body>, ClientError> {
    let mut answer = answer.map_err(|error| ClientError::Unreachable(error.to_string()))?;
    let status = answer.status().as_u16();
    if status == 200 {
        return Ok(answer);
    }
    let body: Option<Value> = answer.body_mut().read_json().ok();
    let words = body.and_then(|body| body["error"].as_str().map(str::to_owned));
    let words = words.unwrap_or_else(|| format!("status {status}"));
    Err(match status {
        401 | 404 => ClientError::Stale(words),
        410 => ClientError::Frame(words),
        400..500 => ClientError::Refused(words),
        _ => ClientError::Unreachable(words),
    })
}

fn read<T: DeserializeOwned>(mut answer: Response<Body>) -> Result<T, ClientError> {
    let body = answer.body_mut().with_config().limit(MOST_BYTES);
    body.read_json().map_err(|error| ClientError::Unreachable(error.to_string()))
}
