//! Signals of an operator to a run that has lost its synchroniser.

use anyhow::Context;
use tokio::signal::unix::{SignalKind, signal};

use crate::acquisition::{Command, Control};

/// Makes SIGUSR1 resume a run that waits for an operator after losing its synchroniser. At any
/// other time the signal has no effect; it never arms a laser that was not armed before.
pub(super) fn resume_on_signal(control: Control) -> anyhow::Result<()> {
    let mut signals = signal(SignalKind::user_defined1()).context("cannot listen for SIGUSR1")?;
    tokio::spawn(async move {
        while signals.recv().await.is_some() {
            if let Err(refusal) = control.request(Command::Resume).await {
                tracing::warn!("SIGUSR1 has no effect: {}", refusal.reasons.join("; "));
            }
        }
    });
    Ok(())
}
