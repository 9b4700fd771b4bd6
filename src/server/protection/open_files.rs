//! Limits connections so that enough open files remain for the run.
//!
//! A connection is an open file, like a segment of the raw log or a camera's socket. The process's
//! limit of open files is shared between them.

use rustix::process::{Resource, Rlimit, getrlimit, setrlimit};

use crate::config::ServerSettings;

/// Files reserved for the run: segments, results, devices, libraries and previewed frames.
const RUN_FILES: usize = 256;
/// Slots for connections that are making the laser safe.
pub(in crate::server) const SAFETY_SLOTS: usize = 16;
/// Connections that were ended and whose sockets are still being closed.
const CLOSING_CONNECTIONS: usize = 16;
/// Smallest number of slots of each kind under any limit.
const MIN_SLOTS: usize = 4;

/// Largest numbers of open connections, by kind of client.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(in crate::server) struct ConnectionLimits {
    /// Clients without a valid token so far.
    pub guests: usize,
    /// Admitted clients: with a valid token, or reading on loopback if no tokens are configured.
    pub admitted: usize,
}

impl ConnectionLimits {
    /// The limits by the settings.
    fn configured(settings: &ServerSettings) -> Self {
        // Without tokens every client is alike, so the few guest slots apply.
        let admitted =
            if settings.tokens.is_some() { settings.connections } else { settings.guests };
        Self { guests: settings.guests, admitted }
    }

    /// The limits by the settings, reduced to fit a limit of open files.
    pub fn within(settings: &ServerSettings, limit: Option<u64>) -> Self {
        let configured = Self::configured(settings);
        let limit = limit.and_then(|limit| usize::try_from(limit).ok()).unwrap_or(usize::MAX);
        // Under a very low limit the run gets three quarters of the files.
        let available = limit.saturating_sub(RUN_FILES).max(limit / 4);
        let available = available.saturating_sub(SAFETY_SLOTS + CLOSING_CONNECTIONS);
        let remaining = available.saturating_sub(configured.admitted);
        let guests = configured.guests.min(remaining.max(available / 4)).max(MIN_SLOTS);
        let admitted = configured.admitted.min(available.saturating_sub(guests)).max(MIN_SLOTS);
        Self { guests, admitted }
    }

    /// Largest number of open sockets, including those being closed.
    pub fn sockets(self) -> usize {
        self.guests + self.admitted + SAFETY_SLOTS + CLOSING_CONNECTIONS
    }
}

/// Open files that a run needs with these settings when all connections are in use.
pub fn open_files_needed(settings: &ServerSettings) -> u64 {
    (RUN_FILES + ConnectionLimits::configured(settings).sockets()) as u64
}

/// Raises this process's limit of open files to the need of a run with these settings, within the
/// hard limit.
pub fn raise_open_files(settings: &ServerSettings) {
    let Rlimit { current, maximum } = getrlimit(Resource::Nofile);
    let needed = open_files_needed(settings).min(maximum.unwrap_or(u64::MAX));
    if current.is_none_or(|current| current >= needed) {
        return;
    }
    if let Err(error) = setrlimit(Resource::Nofile, Rlimit { current: Some(needed), maximum }) {
        tracing::warn!(%error, "the limit of open files cannot be raised");
    }
}

/// The connection limits under this process's limit of open files; logs a warning if they are below
/// the settings.
pub(super) fn connection_limits(settings: &ServerSettings) -> ConnectionLimits {
    let limit = getrlimit(Resource::Nofile).current;
    let limits = ConnectionLimits::within(settings, limit);
    if limits != ConnectionLimits::configured(settings) {
        tracing::warn!(
            limit,
            needed = open_files_needed(settings),
            connections = limits.admitted,
            guests = limits.guests,
            "the limit of open files allows fewer connections than are configured: raise \
             it (LimitNOFILE, ulimit -n) or lower server.connections"
        );
    }
    limits
}

#[cfg(test)]
mod tests {
    use std::path::PathBuf;

    use super::*;

    #[test]
    fn files_for_the_run_are_reserved_with_any_settings() {
        for (tokens, connections, guests) in
            [(true, 1024, 64), (false, 1024, 64), (true, 100_000, 10_000), (true, 8, 8)]
        {
            let tokens = tokens.then(|| PathBuf::from("tokens"));
            let settings =
                ServerSettings { tokens, connections, guests, ..ServerSettings::default() };
            let needed = open_files_needed(&settings);
            assert_eq!(
                ConnectionLimits::within(&settings, Some(needed)),
                ConnectionLimits::configured(&settings)
            );
            assert_eq!(
                ConnectionLimits::within(&settings, None),
                ConnectionLimits::configured(&settings)
            );
            for limit in [512, 1024, 4096, 65_536] {
                let limits = ConnectionLimits::within(&settings, Some(limit));
                assert!(limits.sockets() + RUN_FILES <= limit as usize, "{limit}: {limits:?}");
                assert!(limits.guests >= MIN_SLOTS && limits.admitted >= MIN_SLOTS);
            }
        }
    }

    #[test]
    fn a_very_low_limit_leaves_most_files_to_the_run() {
        let limits = ConnectionLimits::within(&ServerSettings::default(), Some(200));
        assert!(limits.sockets() <= 60, "{limits:?}");
    }
}
