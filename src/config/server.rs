//! The `[server]` table: address and access of the HTTP server.

use std::{
    net::{IpAddr, SocketAddr},
    path::PathBuf,
};

use garde::Validate;
use lfpiv_hw::check::finite;
use serde::{Deserialize, Serialize};

/// The HTTP server.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, Validate)]
#[serde(deny_unknown_fields, default)]
pub struct ServerSettings {
    /// Address to bind, loopback by default. Any other address needs `tokens`.
    #[garde(custom(guarded(&self.tokens)))]
    pub address: SocketAddr,
    /// File with bearer tokens, mode 0600. Without it, reading is open to loopback clients and
    /// control is refused.
    #[garde(skip)]
    pub tokens: Option<PathBuf>,
    /// Host names that clients may use for this server, besides loopback and the bound address.
    #[garde(custom(host_names))]
    pub hosts: Vec<String>,
    /// Whether HTTP clients may arm and start the bench. An operator must also enable it at the
    /// bench for each run.
    #[garde(skip)]
    pub remote_arming: bool,
    /// Mean rate of requests per second and client; bursts may have eight times as many.
    #[garde(custom(finite), range(min = 0.1, max = 1e6))]
    pub requests_per_s: f64,
    /// Largest number of open connections of clients with a valid token; one client may hold half
    /// of them.
    #[garde(range(min = 8, max = 100_000))]
    pub connections: usize,
    /// Largest number of open connections without a valid token; one client may hold half of them.
    /// When all are taken, a new connection replaces the oldest.
    #[garde(range(min = 4, max = 10_000))]
    pub guests: usize,
    /// Seconds that a client may take to send a request's header or its body, or to accept the next
    /// part of a response.
    #[garde(custom(finite), range(min = 0.1, max = 3600.0))]
    pub client_patience_s: f64,
    /// Certificate and key for HTTPS; without them the server speaks plain HTTP.
    #[garde(skip)]
    pub tls: Option<TlsSettings>,
}

/// Certificate and key as PEM files.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct TlsSettings {
    /// The certificate, followed by its chain up to the root.
    pub certificate: PathBuf,
    /// The private key; its file must not be readable by other users.
    pub key: PathBuf,
}

impl Default for ServerSettings {
    fn default() -> Self {
        Self {
            address: SocketAddr::from(([127, 0, 0, 1], 8640)),
            tokens: None,
            hosts: Vec::new(),
            remote_arming: false,
            requests_per_s: 50.0,
            connections: 1024,
            guests: 64,
            client_patience_s: 10.0,
            tls: None,
        }
    }
}

impl ServerSettings {
    /// The URL of the server that listens on `address`.
    pub fn url(&self, address: SocketAddr) -> String {
        format!("{}://{address}", if self.tls.is_some() { "https" } else { "http" })
    }
}

fn guarded(tokens: &Option<PathBuf>) -> impl FnOnce(&SocketAddr, &()) -> garde::Result + '_ {
    move |address, _| {
        if address.ip().is_loopback() || tokens.is_some() {
            return Ok(());
        }
        Err(garde::Error::new(
            "the address can be reached from the network; allowed: 127.0.0.1 or [::1], or any \
             address together with a file of tokens (server.tokens, see docs/http.md)",
        ))
    }
}

/// Checks that hosts are names or addresses without scheme, port or path.
fn host_names(hosts: &[String], _: &()) -> garde::Result {
    let letter = |byte: u8| byte.is_ascii_alphanumeric() || matches!(byte, b'-' | b'.' | b'_');
    let is_name = |host: &String| !host.is_empty() && host.bytes().all(letter);
    let is_address = |host: &String| host.parse::<IpAddr>().is_ok();
    match hosts.iter().find(|host| !is_name(host) && !is_address(host)) {
        None => Ok(()),
        Some(host) => Err(garde::Error::new(format!(
            "\"{host}\"; allowed: host names or addresses, without scheme, port or path"
        ))),
    }
}
