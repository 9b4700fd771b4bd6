//! How the broker is reached, for the commands that use it.

use std::path::PathBuf;

use crate::cluster::Broker;

/// Credentials of the broker.
#[derive(Debug, Clone, clap::Args)]
pub struct BrokerArgs {
    /// File of credentials for the broker, as NATS makes them (.creds).
    #[arg(long, value_name = "FILE")]
    pub credentials: Option<PathBuf>,
    /// Certificate (PEM) of the authority behind the broker's certificate, for a tls:// address, if this
    /// system does not know it.
    #[arg(long, value_name = "FILE")]
    pub authority: Option<PathBuf>,
}

impl BrokerArgs {
    pub(super) fn broker(&self, url: &str) -> Broker {
        let Self { credentials, authority } = self.clone();
        Broker { url: url.to_owned(), credentials, authority }
    }
}
