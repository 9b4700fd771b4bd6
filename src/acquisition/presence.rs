//! Whether a camera answers.

use std::time::{Duration, Instant};

/// Whether a camera is there, as far as is known.
#[derive(Debug, Clone, Default)]
pub(super) struct Presence {
    /// Triggers given since its last frame.
    pub silent: u64,
    /// How long it may be away before its driver notices.
    pub notices_absence_within: Duration,
    /// Its driver says that it does not answer.
    pub away: bool,
    /// It may have gone with the synchroniser; by then its driver has noticed.
    unsure_until: Option<Instant>,
    /// It was away and pairing does not know yet.
    pub returned: bool,
}

impl Presence {
    /// What its driver says.
    pub fn tell(&mut self, connected: bool) {
        self.returned |= self.away && connected;
        self.away = !connected;
        self.unsure_until = None;
    }

    /// A frame has come from it.
    pub fn delivered(&mut self) {
        self.silent = 0;
        self.unsure_until = None;
    }

    /// The synchroniser was lost at `now`, and the camera perhaps with it.
    pub fn may_have_gone(&mut self, now: Instant) {
        if !self.away {
            self.unsure_until = Some(now + self.notices_absence_within);
        }
    }

    /// Whether its driver has yet to notice whether it has gone.
    pub fn is_unsure(&self) -> bool {
        self.unsure_until.is_some_and(|until| Instant::now() < until)
    }
}
