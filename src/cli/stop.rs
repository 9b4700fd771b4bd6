//! How a program that runs without end is told to end.

use std::time::Duration;

use anyhow::Context;
use tokio::signal::unix::{SignalKind, signal};
use tokio_util::sync::CancellationToken;

use crate::acquisition::SynchroniserThread;

/// How long a program that is told to end at once waits for the laser's read-back.
const SAFE_WITHIN: Duration = Duration::from_secs(5);

/// A token that is cancelled by the first Ctrl-C or SIGTERM. The second one ends the process
/// where it stands, with the words `at_once`, as soon as `synchroniser` has been made safe and read
/// back, or after [`SAFE_WITHIN`].
pub(super) fn stop_on_signals(
    synchroniser: &SynchroniserThread,
    at_once: &'static str,
) -> anyhow::Result<CancellationToken> {
    let mut interrupt = signal(SignalKind::interrupt()).context("cannot listen for Ctrl-C")?;
    let mut terminate = signal(SignalKind::terminate()).context("cannot listen for SIGTERM")?;
    let stop = CancellationToken::new();
    let (told, synchroniser) = (stop.clone(), synchroniser.clone());
    tokio::spawn(async move {
        loop {
            tokio::select! {
                _ = interrupt.recv() => {}
                _ = terminate.recv() => {}
            }
            if told.is_cancelled() {
                break;
            }
            tracing::info!("stopping: what is in hand is finished first");
            told.cancel();
        }
        // A thread of its own: the runtime's may be what hangs.
        std::thread::spawn(move || end_at_once(&synchroniser, at_once));
    });
    Ok(stop)
}

fn end_at_once(synchroniser: &SynchroniserThread, at_once: &str) {
    if let Err(error) = synchroniser.make_safe_within(SAFE_WITHIN) {
        eprintln!("{error}");
    }
    eprintln!("stopped at once; {at_once}");
    std::process::exit(130);
}
