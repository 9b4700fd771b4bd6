//! What an operator at this machine may tell a run that has lost its bench.

use anyhow::Context;
use tokio::signal::unix::{SignalKind, signal};

use crate::acquisition::{Command, Control};

/// SIGUSR1 lets a run go on that waits for an operator after a loss of its bench. At any other time
/// it does nothing: it arms no laser that nobody had armed.
pub(super) fn go_on_on_signal(control: Control) -> anyhow::Result<()> {
    let mut told = signal(SignalKind::user_defined1()).context("cannot listen for SIGUSR1")?;
    tokio::spawn(async move {
        while told.recv().await.is_some() {
            if let Err(refusal) = control.request(Command::Resume).await {
                tracing::warn!("SIGUSR1 is for nothing: {}", refusal.reasons.join("; "));
            }
        }
    });
    Ok(())
}
