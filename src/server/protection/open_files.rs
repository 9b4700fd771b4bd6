//! What connections may take of the files that this process may have open.
//!
//! A connection is an open file like a segment of the raw log or a camera's socket. However many
//! clients come, enough files stay free for the run.

use rustix::process::{Resource, Rlimit, getrlimit, setrlimit};

use crate::config::ServerSettings;

/// Kept free of connections: segments, results, devices, libraries, and frames that are shown.
const FOR_THE_RUN: usize = 256;
/// Connections by which the laser is being made safe. They have seats of their own.
pub(in crate::server) const SAFETY: usize = 16;
/// Connections that were ended and whose files are still being closed.
const CLOSING: usize = 16;
/// Seats of each kind that there are under any limit.
const LEAST: usize = 4;

/// How many connections may be open, by what is known of the client.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(in crate::server) struct Places {
    /// Clients that have shown no valid token.
    pub guests: usize,
    /// Clients that were let in: by a token, or to read on loopback where there are none.
    pub admitted: usize,
}

impl Places {
    /// What the settings ask for.
    fn asked(settings: &ServerSettings) -> Self {
        // Where there are no tokens, nobody can show one: few seats again.
        let admitted =
            if settings.tokens.is_some() { settings.connections } else { settings.guests };
        Self { guests: settings.guests, admitted }
    }

    /// What the settings ask for, as far as `limit` open files leave room for it.
    pub fn within(settings: &ServerSettings, limit: Option<u64>) -> Self {
        let asked = Self::asked(settings);
        let limit = limit.and_then(|limit| usize::try_from(limit).ok()).unwrap_or(usize::MAX);
        // Under a limit that is too low for any run, the run gets the larger part.
        let room = limit.saturating_sub(FOR_THE_RUN).max(limit / 4);
        let room = room.saturating_sub(SAFETY + CLOSING);
        let spared = room.saturating_sub(asked.admitted);
        let guests = asked.guests.min(spared.max(room / 4)).max(LEAST);
        let admitted = asked.admitted.min(room.saturating_sub(guests)).max(LEAST);
        Self { guests, admitted }
    }

    /// Connections that are open at the same time at most, those that are closing included.
    pub fn sockets(self) -> usize {
        self.guests + self.admitted + SAFETY + CLOSING
    }
}

/// Open files that a run with these settings needs for all connections that they allow.
pub fn open_files_needed(settings: &ServerSettings) -> u64 {
    (FOR_THE_RUN + Places::asked(settings).sockets()) as u64
}

/// Raises this process's limit of open files to what a run with these settings needs, as far as the
/// hard limit allows.
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

/// The seats that there are under this process's limit; said where they are fewer than asked for.
pub(super) fn places(settings: &ServerSettings) -> Places {
    let limit = getrlimit(Resource::Nofile).current;
    let places = Places::within(settings, limit);
    if places != Places::asked(settings) {
        tracing::warn!(
            limit,
            needed = open_files_needed(settings),
            connections = places.admitted,
            guests = places.guests,
            "the limit of open files leaves room for fewer connections than are configured: raise \
             it (LimitNOFILE, ulimit -n) or lower server.connections"
        );
    }
    places
}

#[cfg(test)]
mod tests {
    use std::path::PathBuf;

    use super::*;

    #[test]
    fn the_run_keeps_its_files_whatever_is_configured() {
        for (tokens, connections, guests) in
            [(true, 1024, 64), (false, 1024, 64), (true, 100_000, 10_000), (true, 8, 8)]
        {
            let tokens = tokens.then(|| PathBuf::from("tokens"));
            let settings =
                ServerSettings { tokens, connections, guests, ..ServerSettings::default() };
            let needed = open_files_needed(&settings);
            assert_eq!(Places::within(&settings, Some(needed)), Places::asked(&settings));
            assert_eq!(Places::within(&settings, None), Places::asked(&settings));
            for limit in [512, 1024, 4096, 65_536] {
                let places = Places::within(&settings, Some(limit));
                assert!(places.sockets() + FOR_THE_RUN <= limit as usize, "{limit}: {places:?}");
                assert!(places.guests >= LEAST && places.admitted >= LEAST);
            }
        }
    }

    #[test]
    fn a_limit_below_any_use_leaves_the_larger_part_to_the_run() {
        let places = Places::within(&ServerSettings::default(), Some(200));
        assert!(places.sockets() <= 60, "{places:?}");
    }
}
