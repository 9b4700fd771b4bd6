//! Errors of working with others.

use std::{net::SocketAddr, path::PathBuf};

use lfpiv_rawlog::RawLogError;
use thiserror::Error;

/// Why shots cannot be measured together.
#[derive(Debug, Error)]
pub enum ClusterError {
    /// The broker's address or its credentials cannot be used.
    #[error("cannot connect to the broker at {url}: {reason}")]
    Connect { url: String, reason: String },
    /// The system has no random numbers for a token.
    #[error("the system has no random numbers, which the token of the run needs")]
    NoRandom,
    /// The address at which workers are served cannot be used.
    #[error("workers cannot be served at {address}: {reason}")]
    Listen { address: SocketAddr, reason: std::io::Error },
    /// The broker does not do what it is asked.
    #[error("the broker does not {what}: {reason}")]
    Broker { what: &'static str, reason: String },
    /// The log of delivered results cannot be written or read.
    #[error(transparent)]
    Log(#[from] RawLogError),
    /// A folder of delivered results cannot be created, listed or removed.
    #[error("cannot {what} {}: {reason}", path.display())]
    Folder { what: &'static str, path: PathBuf, reason: std::io::Error },
    /// A delivered result is not what its sender made.
    #[error("a delivered result is refused: {0}")]
    Refused(String),
    /// Results cannot be kept any more.
    #[error("results cannot be taken in any more: {0}")]
    Broken(String),
}

impl ClusterError {
    /// For `map_err`.
    pub(super) fn broker<E: std::fmt::Display>(what: &'static str) -> impl FnOnce(E) -> Self {
        move |reason| Self::Broker { what, reason: reason.to_string() }
    }
}
