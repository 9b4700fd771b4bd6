//! The `[server]` table: where HTTP is served, and to whom.

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
    /// Address to bind; loopback unless changed. Any other needs `tokens`.
    #[garde(custom(guarded(&self.tokens)))]
    pub address: SocketAddr,
    /// File with bearer tokens, mode 0600. Without it reading is open on loopback, and control is
    /// refused.
    #[garde(skip)]
    pub tokens: Option<PathBuf>,
    /// Names that clients may call this server by, beside loopback and the bound address.
    #[garde(custom(host_names))]
    pub hosts: Vec<String>,
    /// Whether HTTP may arm and start at all; an operator must enable it at the bench for each
    /// run, too.
    #[garde(skip)]
    pub remote_arming: bool,
    /// Requests per second that one client may make on average; eight times as many at once.
    #[garde(custom(finite), range(min = 0.1, max = 1e6))]
    pub requests_per_s: f64,
    /// Connections of clients with a valid token that may be open at the same time; one client may
    /// have half of them.
    #[garde(range(min = 8, max = 100_000))]
    pub connections: usize,
    /// Connections without a valid token that may be open at the same time; one client may have half
    /// of them. Who comes next takes the place of who has been there longest.
    #[garde(range(min = 4, max = 10_000))]
    pub guests: usize,
    /// Seconds that a client has for a request's header, for its body, and for taking some of an
    /// answer.
    #[garde(custom(finite), range(min = 0.1, max = 3600.0))]
    pub client_patience_s: f64,
    /// Certificate and key; HTTP in the clear without them.
    #[garde(skip)]
    pub tls: Option<TlsSettings>,
}

/// What TLS needs, as PEM files.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct TlsSettings {
    /// The certificate and those that lead to its root.
    pub certificate: PathBuf,
    /// Its private key, which others must not be able to read.
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
    /// Where a browser finds the server that listens on `address`.
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
            "it can be reached from the network; allowed: 127.0.0.1 or [::1], or any address \
             together with a file of tokens (server.tokens, see docs/http.md)",
        ))
    }
}

/// Names without scheme, port or path.
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
