//! How a program that runs without end is told to end.

use anyhow::Context;
use tokio::signal::unix::{SignalKind, signal};
use tokio_util::sync::CancellationToken;

/// A token that is cancelled by the first Ctrl-C or SIGTERM. The second one ends the process
/// where it stands, with the words `at_once`, even before the synchroniser has been made safe; what
/// it fires then is the rest of one burst.
pub(super) fn stop_on_signals(at_once: &'static str) -> anyhow::Result<CancellationToken> {
    let mut interrupt = signal(SignalKind::interrupt()).context("cannot listen for Ctrl-C")?;
    let mut terminate = signal(SignalKind::terminate()).context("cannot listen for SIGTERM")?;
    let stop = CancellationToken::new();
    let told = stop.clone();
    tokio::spawn(async move {
        loop {
            tokio::select! {
                _ = interrupt.recv() => {}
                _ = terminate.recv() => {}
            }
            if told.is_cancelled() {
                eprintln!("stopped at once; {at_once}");
                std::process::exit(130);
            }
            tracing::info!("stopping: what is in hand is finished first");
            told.cancel();
        }
    });
    Ok(stop)
}
