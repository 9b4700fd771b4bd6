//! The arm gate: whether a burst may be fired, and why not.
//!
//! The programmed schedule is not checked here: programming compares it with the read-back, and
//! without that there is no burst at all.

use std::time::Duration;

use super::{AcquisitionError, controller::Run};

/// Interval between checks while the gate is closed.
const RETRY_INTERVAL: Duration = Duration::from_millis(250);
/// A shot has two exposures.
const FRAMES_PER_SHOT: u64 = 2;

impl Run {
    /// All reasons against firing a burst of `shots` now.
    fn reasons_against(&self, shots: u64) -> Vec<String> {
        let mut reasons = Vec::new();
        if let Some(log) = self.journal.log() {
            let frames = shots * FRAMES_PER_SHOT * self.presence.len() as u64;
            if let Err(error) = log.reserve(frames * self.settings.frame_bytes) {
                reasons.push(error.to_string());
            }
        }
        if self.events.len() == self.events.max_capacity() {
            reasons.push("frames of the last burst have not been received yet".to_owned());
        }
        reasons
    }

    /// Whether the burst may be fired; if not, logs the reasons and waits a little.
    pub(super) async fn may_fire(&mut self, shots: u64) -> Result<bool, AcquisitionError> {
        let reasons = self.reasons_against(shots);
        let previous = std::mem::replace(&mut self.control.state.lock().held, reasons.clone());
        if reasons.is_empty() {
            return Ok(true);
        }
        if previous != reasons {
            tracing::warn!("firing is on hold: {}", reasons.join("; "));
        }
        self.handle_next_event(RETRY_INTERVAL).await?;
        Ok(false)
    }
}
