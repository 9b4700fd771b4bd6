//! Stops a running program on signals.

use std::time::Duration;

use anyhow::Context;
use tokio::signal::unix::{SignalKind, signal};
use tokio_util::sync::CancellationToken;

use crate::acquisition::SynchroniserThread;

/// How long an immediate stop waits for the laser's read-back.
const SAFE_WITHIN: Duration = Duration::from_secs(5);

/// Returns a token that is cancelled by the first Ctrl-C or SIGTERM. The second signal ends the
/// process immediately with the message `at_once`, after `synchroniser` has been made safe and read
/// back, or after [`SAFE_WITHIN`].
pub(super) fn stop_on_signals(
    synchroniser: &SynchroniserThread,
    at_once: &'static str,
) -> anyhow::Result<CancellationToken> {
    let mut interrupt = signal(SignalKind::interrupt()).context("cannot listen for Ctrl-C")?;
    let mut terminate = signal(SignalKind::terminate()).context("cannot listen for SIGTERM")?;
    let stop = CancellationToken::new();
    let (cancelled, synchroniser) = (stop.clone(), synchroniser.clone());
    tokio::spawn(async move {
        loop {
            tokio::select! {
                _ = interrupt.recv() => {}
                _ = terminate.recv() => {}
            }
            if cancelled.is_cancelled() {
                break;
            }
            tracing::info!("stopping: work in progress is finished first");
            cancelled.cancel();
        }
        // On a thread of its own, because the runtime's threads may hang.
        std::thread::spawn(move || end_at_once(&synchroniser, at_once));
    });
    Ok(stop)
}

fn end_at_once(synchroniser: &SynchroniserThread, at_once: &str) {
    if let Err(error) = synchroniser.make_safe_within(SAFE_WITHIN) {
        eprintln!("{error}");
    }
    eprintln!("stopped immediately; {at_once}");
    std::process::exit(130);
}
