//! The thread that writes results: the only one that does.

use std::{
    io,
    sync::mpsc::{Receiver, RecvTimeoutError, SyncSender, sync_channel},
    thread::JoinHandle,
    time::Duration,
};

use anyhow::Context;

use crate::archive::{ArchiveError, ResultStore, ShotResult};

/// Results that may wait for the disk.
const QUEUE: usize = 16;
/// Pause after which a segment is sealed if it is due.
const IDLE: Duration = Duration::from_secs(1);

/// See the module.
pub(super) struct ResultThread(JoinHandle<Result<(), ArchiveError>>);

impl ResultThread {
    /// Starts the thread, which ends when all senders are gone, or it fails.
    pub fn start(store: ResultStore) -> io::Result<(SyncSender<(u64, ShotResult)>, Self)> {
        let (sink, results) = sync_channel(QUEUE);
        let thread = std::thread::Builder::new().name("results".into());
        Ok((sink, Self(thread.spawn(move || store_all(store, &results))?)))
    }

    /// Waits for its end.
    ///
    /// # Errors
    /// A result could not be stored.
    pub fn join(self) -> anyhow::Result<()> {
        match self.0.join() {
            Ok(stored) => stored.context("the results cannot be stored"),
            Err(_) => anyhow::bail!(
                "the thread that stores results has panicked; this is an error of lfpiv"
            ),
        }
    }
}

fn store_all(
    mut store: ResultStore,
    results: &Receiver<(u64, ShotResult)>,
) -> Result<(), ArchiveError> {
    loop {
        match results.recv_timeout(IDLE) {
            Ok((shot, result)) => store.append(shot, &result)?,
            Err(RecvTimeoutError::Timeout) => drop(store.seal_if_due()?),
            Err(RecvTimeoutError::Disconnected) => return store.close(),
        }
    }
}
