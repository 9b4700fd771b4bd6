//! Access control: hosts, tokens, rates and connection limits. It is set up before an address is
//! bound, so that a server that would be open by mistake never listens.

mod error;
mod hosts;
mod leaks;
mod open_files;
mod rate;
mod strength;
mod tls;
mod tokens;

use std::{net::SocketAddr, time::Duration};

use tokio_rustls::TlsAcceptor;

use crate::config::ServerSettings;
pub use error::ProtectionError;
pub(super) use hosts::{Hosts, Origin};
pub(super) use leaks::contains_token;
pub(super) use open_files::{ConnectionLimits, SAFETY_SLOTS};
pub use open_files::{open_files_needed, raise_open_files};
pub(super) use rate::{RateLimits, network};
pub(super) use tokens::{Scope, Tokens};

/// Burst size of a client, in seconds of its mean rate.
const BURST_S: f64 = 8.0;

/// The server's access control.
pub struct Protection {
    pub(super) tokens: Option<Tokens>,
    pub(super) hosts: Hosts,
    pub(super) rates: RateLimits,
    pub(super) tls: Option<TlsAcceptor>,
    /// How long a client may take to send or accept data.
    pub(super) patience: Duration,
    /// Largest numbers of open connections.
    pub(super) connection_limits: ConnectionLimits,
    /// Whether the configuration allows arming over HTTP.
    pub(super) remote_arming: bool,
}

impl Protection {
    /// Reads tokens and certificates.
    ///
    /// # Errors
    /// [`ProtectionError`]: the network can reach the address but there are no tokens, or a file
    /// cannot be used or can be read by others.
    pub fn open(settings: &ServerSettings) -> Result<Self, ProtectionError> {
        let tokens = settings.tokens.as_deref().map(Tokens::load).transpose()?;
        if tokens.is_none() && !settings.address.ip().is_loopback() {
            return Err(ProtectionError::Exposed { address: settings.address });
        }
        let tls = settings.tls.as_ref().map(tls::acceptor).transpose()?;
        if tls.is_none() {
            warn_in_the_clear(settings.address);
        }
        Ok(Self {
            tokens,
            hosts: Hosts::new(&settings.hosts, settings.tls.is_some()),
            rates: RateLimits::new(settings.requests_per_s, BURST_S * settings.requests_per_s),
            tls,
            patience: Duration::from_secs_f64(settings.client_patience_s),
            connection_limits: open_files::connection_limits(settings),
            remote_arming: settings.remote_arming,
        })
    }
}

fn warn_in_the_clear(address: SocketAddr) {
    if !address.ip().is_loopback() {
        tracing::warn!(
            %address,
            "tokens and results are sent unencrypted: set a certificate in [server.tls]"
        );
    }
}
