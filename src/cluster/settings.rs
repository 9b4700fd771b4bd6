//! The `[cluster]` table: a run whose shots are measured by workers.

use std::{
    net::{Ipv4Addr, SocketAddr},
    path::PathBuf,
    time::Duration,
};

use async_nats::ServerAddr;
use garde::Validate;
use lfpiv_hw::check::finite;
use serde::{Deserialize, Serialize};

use super::Broker;

/// How a run is shared out.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, Validate)]
#[serde(deny_unknown_fields)]
pub struct ClusterSettings {
    /// The NATS server: `nats://HOST:PORT`, or `tls://HOST:PORT`.
    #[garde(custom(broker_address))]
    pub url: String,
    /// Address of this machine at which workers read frames and deliver results; without it, a free
    /// port that only this machine reaches.
    #[serde(default = "this_machine")]
    #[garde(custom(told_address))]
    pub serve: SocketAddr,
    /// Seconds without a heartbeat of its worker after which a shot goes to another one.
    #[serde(default = "thirty")]
    #[garde(custom(finite), range(min = 0.1, max = 1e6))]
    pub heartbeat_timeout_s: f64,
    /// Seconds a worker may take over one shot.
    #[serde(default = "six_hundred")]
    #[garde(custom(finite), range(min = 0.1, max = 1e6))]
    pub deadline_s: f64,
    /// File of credentials as NATS makes them (`.creds`).
    #[serde(default)]
    #[garde(skip)]
    pub credentials: Option<PathBuf>,
    /// Certificate of the authority behind a `tls://` address, if the system does not know it.
    #[serde(default)]
    #[garde(skip)]
    pub authority: Option<PathBuf>,
}

impl ClusterSettings {
    /// How the broker is reached.
    pub fn broker(&self) -> Broker {
        Broker {
            url: self.url.clone(),
            credentials: self.credentials.clone(),
            authority: self.authority.clone(),
        }
    }

    /// A worker without a heartbeat for so long is lost.
    pub fn heartbeat_timeout(&self) -> Duration {
        Duration::from_secs_f64(self.heartbeat_timeout_s)
    }

    /// Longest time for a shot.
    pub fn deadline(&self) -> Duration {
        Duration::from_secs_f64(self.deadline_s)
    }
}

fn this_machine() -> SocketAddr {
    SocketAddr::from((Ipv4Addr::LOCALHOST, 0))
}

fn thirty() -> f64 {
    30.0
}

fn six_hundred() -> f64 {
    600.0
}

/// The configuration is stored with every result, and served: it must not have a password.
fn broker_address(url: &str, _: &()) -> garde::Result {
    let known = url.parse::<ServerAddr>().map_err(|reason| {
        garde::Error::new(format!(
            "no address ({reason}); allowed: nats://HOST:PORT or tls://HOST:PORT"
        ))
    })?;
    match known.username().is_some() || known.password().is_some() {
        true => Err(garde::Error::new(
            "a user or a password, which would be stored with every result; allowed: nats://HOST:PORT or \
             tls://HOST:PORT, with a file of credentials (cluster.credentials)",
        )),
        false => Ok(()),
    }
}

/// Workers are told this address.
fn told_address(address: &SocketAddr, _: &()) -> garde::Result {
    match address.ip().is_unspecified() {
        true => Err(garde::Error::new(
            "no address that workers can be told; allowed: one of this machine's that they can reach",
        )),
        false => Ok(()),
    }
}
