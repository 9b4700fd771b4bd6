//! Signs of life of a loop, for whoever watches over it.

use std::{
    sync::Arc,
    time::{Duration, Instant},
};

use parking_lot::Mutex;

/// How long a loop that has nothing to do may wait before it shows that it still turns.
const IDLE_TURN: Duration = Duration::from_millis(200);

/// A loop beats at every turn, and rests where nothing is expected of it; clones are the same one.
#[derive(Debug, Clone, Default)]
pub struct Heartbeat(Arc<Mutex<Pulse>>);

#[derive(Debug, Clone, Copy, Default, PartialEq)]
enum Pulse {
    #[default]
    NotBegun,
    Beat(Instant),
    Resting,
}

impl Heartbeat {
    /// The loop has turned.
    pub fn beat(&self) {
        *self.0.lock() = Pulse::Beat(Instant::now());
    }

    /// Nothing is expected of the loop until it beats again.
    pub fn rest(&self) {
        *self.0.lock() = Pulse::Resting;
    }

    /// Beats now and completes a little later: a branch for loops that wait for something else,
    /// so that they turn meanwhile.
    pub async fn turn(&self) {
        self.beat();
        tokio::time::sleep(IDLE_TURN).await;
    }

    /// Whether the loop has ever turned.
    pub fn has_begun(&self) -> bool {
        *self.0.lock() != Pulse::NotBegun
    }

    /// How long ago the last beat was; zero where none is expected.
    pub fn silent_for(&self, now: Instant) -> Duration {
        match *self.0.lock() {
            Pulse::Beat(last) => now.saturating_duration_since(last),
            Pulse::NotBegun | Pulse::Resting => Duration::ZERO,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn only_a_loop_that_has_begun_and_does_not_rest_can_fall_silent() {
        let heartbeat = Heartbeat::default();
        let later = Instant::now() + Duration::from_secs(60);
        assert!(!heartbeat.has_begun() && heartbeat.silent_for(later).is_zero());
        heartbeat.clone().beat();
        assert!(heartbeat.has_begun() && heartbeat.silent_for(later) > Duration::from_secs(59));
        heartbeat.rest();
        assert!(heartbeat.has_begun() && heartbeat.silent_for(later).is_zero());
    }

    #[tokio::test]
    async fn waiting_beats_too() {
        let heartbeat = Heartbeat::default();
        heartbeat.turn().await;
        let silent = heartbeat.silent_for(Instant::now());
        assert!(silent >= IDLE_TURN && silent < 10 * IDLE_TURN, "{silent:?}");
    }
}
