//! The worker's end of the interface to the coordinator.

use std::{io::Read, time::Duration};

use lfpiv_hw::RawImage;
use lfpiv_rawlog::{Position, unpack};
use serde::{Serialize, de::DeserializeOwned};
use serde_json::Value;
use thiserror::Error;
use ureq::{Agent, Body, http::Response};

use super::{
    Assignment, Attempt, Begin, Frame, Tokens, Verdict,
    routes::{AttemptRequest, SignOfLife},
};

/// Longest time for a request: coordinators wait for their disks.
const REQUEST_TIMEOUT: Duration = Duration::from_secs(60);
/// Longest time until a connection is made.
const CONNECT_TIMEOUT: Duration = Duration::from_secs(5);
/// Most bytes of an answer: the largest image, stored as it is.
const MOST_BYTES: u64 = 600 << 20;

/// Connections that may break while a record is read.
const MOST_READS: u32 = 5;
/// Status of an answer with a range.
const PARTIAL_CONTENT: u16 = 206;

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
    tokens: Tokens,
}

impl CoordinatorClient {
    /// For the coordinator at `http://ADDRESS`.
    pub fn new(address: &str, tokens: &Tokens) -> Self {
        let agent = Agent::config_builder()
            .http_status_as_error(false)
            .timeout_connect(Some(CONNECT_TIMEOUT))
            .timeout_global(Some(REQUEST_TIMEOUT))
            .build();
        Self { agent: agent.into(), address: address.to_owned(), tokens: tokens.clone() }
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
        let record =
            unpack(&self.packed(frame)?).map_err(|what| ClientError::Frame(what.to_owned()))?;
        record
            .image
            .filter(|image| image.crc32() == frame.crc32)
            .ok_or_else(|| ClientError::Frame("its image is not that of the job".into()))
    }

    /// A frame's record as it is on disk; for [`unpack`]. If the connection breaks, another one goes on with the rest.
    ///
    /// # Errors
    /// [`ClientError`].
    pub fn packed(&self, frame: &Frame) -> Result<Vec<u8>, ClientError> {
        let Position { segment, offset } = frame.position();
        let url = self.url(&format!("records/{segment}/{offset}"));
        let mut bytes = Vec::new();
        let mut tries = 0;
        loop {
            tries += 1;
            let mut request =
                self.agent.get(&url).header("Authorization", &bearer(&self.tokens.read));
            if !bytes.is_empty() {
                request = request.header("Range", format!("bytes={}-", bytes.len()));
            }
            let mut answer = checked(request.call())?;
            if answer.status() != PARTIAL_CONTENT {
                bytes.clear();
            }
            let body = answer.body_mut().with_config().limit(MOST_BYTES);
            match body.reader().read_to_end(&mut bytes) {
                Ok(_) => return Ok(bytes),
                Err(error) if tries >= MOST_READS => {
                    return Err(ClientError::Unreachable(error.to_string()));
                }
                Err(error) => tracing::debug!("{error}: the rest is asked for"),
            }
        }
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

    /// Says that a worker is there, or that it ends.
    ///
    /// # Errors
    /// [`ClientError`].
    pub fn tell_of(&self, worker: &str, is_ending: bool) -> Result<(), ClientError> {
        let sign = SignOfLife { worker: worker.to_owned(), is_ending };
        self.post("workers", &sign).map(|_| ())
    }

    /// Delivers a result, as [`super::Delivery::encode`] made it.
    ///
    /// # Errors
    /// [`ClientError`].
    pub fn deliver(&self, bytes: &[u8]) -> Result<Verdict, ClientError> {
        let request = self.agent.post(self.url("results"));
        let request = request.header("Authorization", &bearer(&self.tokens.work));
        read(checked(request.send(bytes))?)
    }

    fn get(&self, path: &str) -> Result<Response<Body>, ClientError> {
        let request = self.agent.get(self.url(path));
        checked(request.header("Authorization", &bearer(&self.tokens.read)).call())
    }

    fn post(&self, path: &str, body: &impl Serialize) -> Result<Response<Body>, ClientError> {
        let request = self.agent.post(self.url(path));
        checked(request.header("Authorization", &bearer(&self.tokens.work)).send_json(body))
    }

    fn url(&self, path: &str) -> String {
        format!("{}/work/v1/{path}", self.address)
    }
}

fn bearer(token: &str) -> String {
    format!("Bearer {token}")
}

/// An answer with what was asked for.
fn checked(answer: Result<Response<Body>, ureq::Error>) -> Result<Response<Body>, ClientError> {
    let mut answer = answer.map_err(|error| ClientError::Unreachable(error.to_string()))?;
    let status = answer.status().as_u16();
    if status == 200 || status == PARTIAL_CONTENT {
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

#[cfg(test)]
mod tests {
    use std::{
        io::{BufRead, BufReader, Write},
        net::TcpListener,
    };

    use super::*;

    /// A coordinator whose connections break in the middle of an answer, twice.
    #[test]
    fn a_record_is_read_on_where_the_connection_has_broken() {
        let record: Vec<u8> = (0..100_000_u32).map(|n| n.wrapping_mul(n) as u8).collect();
        let listener = TcpListener::bind("127.0.0.1:0").unwrap();
        let address = format!("http://{}", listener.local_addr().unwrap());
        let served = record.clone();
        let serving = std::thread::spawn(move || {
            let mut ranges = Vec::new();
            for end in [30_000, 70_000, served.len()] {
                let (stream, _) = listener.accept().unwrap();
                let head = BufReader::new(&stream).lines().map(Result::unwrap);
                let head: Vec<String> = head.take_while(|line| !line.is_empty()).collect();
                let range = head.iter().find_map(|line| {
                    let line = line.to_ascii_lowercase();
                    line.strip_prefix("range: bytes=")?.strip_suffix('-')?.parse::<usize>().ok()
                });
                ranges.push(range);
                let first = range.unwrap_or(0);
                let status = if range.is_some() { "206 Partial Content" } else { "200 OK" };
                let length = served.len() - first;
                write!(&stream, "HTTP/1.1 {status}\r\nContent-Length: {length}\r\n\r\n").unwrap();
                (&stream).write_all(&served[first..end]).unwrap();
            }
            ranges
        });
        let tokens = Tokens { read: "r".into(), work: "w".into() };
        let frame = Frame { segment: 0, offset: 0, crc32: 0 };
        let read = CoordinatorClient::new(&address, &tokens).packed(&frame);
        assert_eq!(read.unwrap(), record);
        assert_eq!(serving.join().unwrap(), [None, Some(30_000), Some(70_000)]);
    }
}
