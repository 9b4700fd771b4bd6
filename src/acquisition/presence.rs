//! Connection state of a camera.

use std::time::{Duration, Instant};

/// Connection state of a camera, as far as is known.
#[derive(Debug, Clone, Default)]
pub(super) struct Presence {
    /// Triggers given since its last frame.
    pub silent: u64,
    /// Time within which its driver detects a lost connection.
    pub loss_detection_time: Duration,
    /// Its driver reports a lost connection.
    pub away: bool,
    /// The camera may have been lost with the synchroniser; by this time its driver would have noticed.
    unconfirmed_until: Option<Instant>,
    /// It was away, and pairing has not been told yet.
    pub returned: bool,
}

impl Presence {
    /// Updates the state with the driver's report.
    pub fn set_connected(&mut self, connected: bool) {
        self.returned |= self.away && connected;
        self.away = !connected;
        self.unconfirmed_until = None;
    }

    /// Records that a frame arrived.
    pub fn delivered(&mut self) {
        self.silent = 0;
        self.unconfirmed_until = None;
    }

    /// Records that the synchroniser was lost at `now`, and the camera perhaps with it.
    pub fn suspect_loss(&mut self, now: Instant) {
        if !self.away {
            self.unconfirmed_until = Some(now + self.loss_detection_time);
        }
    }

    /// Whether its driver may still detect a loss.
    pub fn is_unconfirmed(&self) -> bool {
        self.unconfirmed_until.is_some_and(|until| Instant::now() < until)
    }
}
