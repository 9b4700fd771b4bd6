//! An HTTP client that sends arbitrary requests, valid or not.

use std::{net::SocketAddr, time::Duration};

use serde_json::Value;
use tokio::{
    io::{AsyncRead, AsyncReadExt, AsyncWrite, AsyncWriteExt},
    net::TcpStream,
};

/// Only a hang takes this long.
const PATIENCE: Duration = Duration::from_secs(900);

/// A request being built.
#[derive(Debug, Clone)]
pub struct Ask {
    method: String,
    path: String,
    headers: Vec<(String, String)>,
    body: Vec<u8>,
    unsized_body: bool,
}

/// A received response.
#[derive(Debug)]
pub struct Answer {
    pub status: u16,
    pub media_type: String,
    pub headers: Vec<(String, String)>,
    pub body: Vec<u8>,
}

impl Ask {
    pub fn new(method: &str, path: &str) -> Self {
        let (method, path) = (method.to_owned(), path.to_owned());
        Self { method, path, headers: Vec::new(), body: Vec::new(), unsized_body: false }
    }

    pub fn get(path: &str) -> Self {
        Self::new("GET", path)
    }

    pub fn post(path: &str) -> Self {
        Self::new("POST", path)
    }

    pub fn with(mut self, name: &str, value: &str) -> Self {
        self.headers.push((name.to_owned(), value.to_owned()));
        self
    }

    pub fn token(self, token: &str) -> Self {
        self.with("Authorization", &format!("Bearer {token}"))
    }

    pub fn json(self, body: &str) -> Self {
        self.with("Content-Type", "application/json").body(body.as_bytes())
    }

    pub fn body(mut self, body: &[u8]) -> Self {
        self.body = body.to_vec();
        self
    }

    /// A body without a stated length.
    pub fn unsized_body(mut self, body: &[u8]) -> Self {
        self.unsized_body = true;
        self.body(body)
    }

    /// The bytes of the request; `Host` is the address unless one was given.
    pub fn bytes(&self, address: SocketAddr) -> Vec<u8> {
        let mut head = format!("{} {} HTTP/1.1\r\nConnection: close\r\n", self.method, self.path);
        let has = |name: &str| self.headers.iter().any(|(n, _)| n.eq_ignore_ascii_case(name));
        if !has("host") {
            head += &format!("Host: {address}\r\n");
        }
        if !self.body.is_empty() && !self.unsized_body && !has("content-length") {
            head += &format!("Content-Length: {}\r\n", self.body.len());
        }
        for (name, value) in &self.headers {
            head += &format!("{name}: {value}\r\n");
        }
        [head.as_bytes(), b"\r\n", &self.body].concat()
    }

    /// Sends it to `address`.
    pub async fn of(&self, address: SocketAddr) -> Answer {
        self.over(TcpStream::connect(address).await.unwrap(), address).await
    }

    /// Sends it over an open stream.
    pub async fn over(
        &self,
        stream: impl AsyncRead + AsyncWrite + Unpin,
        address: SocketAddr,
    ) -> Answer {
        exchange(stream, &self.bytes(address)).await
    }
}

/// Sends bytes and reads until the other side closes.
pub async fn exchange(mut stream: impl AsyncRead + AsyncWrite + Unpin, bytes: &[u8]) -> Answer {
    let mut received = Vec::new();
    let talk = async {
        // A server that refuses closes before reading everything; its response still counts.
        let _ = stream.write_all(bytes).await;
        let _ = stream.flush().await;
        let _ = stream.read_to_end(&mut received).await;
    };
    tokio::time::timeout(PATIENCE, talk).await.expect("the server hangs");
    Answer::read(&received)
}

impl Answer {
    /// Parses a response; status 0 if there is none.
    pub fn read(bytes: &[u8]) -> Self {
        let Some(end) = bytes.windows(4).position(|four| four == b"\r\n\r\n") else {
            let (media_type, headers) = (String::new(), Vec::new());
            return Self { status: 0, media_type, headers, body: bytes.to_vec() };
        };
        let head = String::from_utf8(bytes[..end].to_vec()).unwrap();
        let mut lines = head.split("\r\n");
        let status = lines.next().unwrap().split(' ').nth(1).unwrap().parse().unwrap();
        let headers: Vec<(String, String)> = lines
            .map(|line| line.split_once(": ").unwrap())
            .map(|(name, value)| (name.to_ascii_lowercase(), value.to_owned()))
            .collect();
        let mut answer =
            Self { status, media_type: String::new(), headers, body: bytes[end + 4..].to_vec() };
        // Another response may follow.
        let length = answer.header("content-length").and_then(|length| length.parse().ok());
        answer.body.truncate(length.unwrap_or(usize::MAX));
        answer.media_type = answer.header("content-type").unwrap_or_default().to_owned();
        answer
    }

    pub fn header(&self, name: &str) -> Option<&str> {
        self.headers.iter().find(|(n, _)| n == name).map(|(_, value)| value.as_str())
    }

    pub fn json(&self) -> Value {
        assert_eq!(self.media_type, "application/json", "{self:?}");
        serde_json::from_slice(&self.body).unwrap()
    }

    /// The message of an error with this status.
    pub fn error(&self, status: u16) -> String {
        assert_eq!(self.status, status, "{self:?}");
        self.json()["error"].as_str().unwrap().to_owned()
    }
}

pub async fn get(address: SocketAddr, path: &str) -> Answer {
    Ask::get(path).of(address).await
}
