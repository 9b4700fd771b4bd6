//! The arm gate: whether a burst may be fired, and why not.
//!
//! That the unit has taken the schedule is checked where it is programmed: what it reads back is
//! compared there, and without it there is no burst at all.

use std::time::Duration;

use super::{AcquisitionError, controller::Run};

/// How long the gate stays shut before it is tried again.
const LOOK_AGAIN: Duration = Duration::from_millis(250);
/// A shot has two exposures.
const FRAMES_PER_SHOT: u64 = 2;

impl Run {
    /// Every reason why a burst of `shots` must not be fired now.
    fn reasons_against(&self, shots: u64) -> Vec<String> {
        let mut reasons = Vec::new();
        if let Some(log) = self.journal.log() {
            let frames = shots * FRAMES_PER_SHOT * self.presence.len() as u64;
            if let Err(error) = log.reserve(frames * self.settings.frame_bytes) {
                reasons.push(error.to_string());
            }
        }
        if self.events.len() == self.events.max_capacity() {
            reasons.push("frames of the last burst still wait to be taken".to_owned());
        }
        reasons
    }

    /// Whether the burst may be fired; where not, says why and lets some time pass.
    pub(super) async fn may_fire(&mut self, shots: u64) -> Result<bool, AcquisitionError> {
        let reasons = self.reasons_against(shots);
        let told = std::mem::replace(&mut self.control.state.lock().held, reasons.clone());
        if reasons.is_empty() {
            return Ok(true);
        }
        if told != reasons {
            tracing::warn!("nothing is fired: {}", reasons.join("; "));
        }
        self.attend(LOOK_AGAIN).await?;
        Ok(false)
    }
}
