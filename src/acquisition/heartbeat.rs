//! Liveness of a loop, for a watchdog.

use std::{
    sync::Arc,
    time::{Duration, Instant},
};

use parking_lot::Mutex;

/// How long an idle loop may wait before it beats again.
const IDLE_TURN: Duration = Duration::from_millis(200);

/// A loop beats in every iteration and rests while nothing is expected of it. Clones share the state.
#[derive(Debug, Clone, Default)]
pub struct Heartbeat(Arc<Mutex<State>>);

#[derive(Debug, Clone, Copy, Default, PartialEq)]
enum State {
    #[default]
    NotBegun,
    Beat(Instant),
    Resting,
}

impl Heartbeat {
    /// Records an iteration of the loop.
    pub fn beat(&self) {
        *self.0.lock() = State::Beat(Instant::now());
    }

    /// Suspends the expectation of beats until the next one.
    pub fn rest(&self) {
        *self.0.lock() = State::Resting;
    }

    /// Beats now and completes a little later: a `select!` branch that keeps a waiting loop alive.
    pub async fn keep_alive(&self) {
        self.beat();
        tokio::time::sleep(IDLE_TURN).await;
    }

    /// Whether the loop has ever beaten.
    pub fn has_begun(&self) -> bool {
        *self.0.lock() != State::NotBegun
    }

    /// Time since the last beat; zero while none is expected.
    pub fn silent_for(&self, now: Instant) -> Duration {
        match *self.0.lock() {
            State::Beat(last) => now.saturating_duration_since(last),
            State::NotBegun | State::Resting => Duration::ZERO,
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
        heartbeat.keep_alive().await;
        let silent = heartbeat.silent_for(Instant::now());
        assert!(silent >= IDLE_TURN && silent < 10 * IDLE_TURN, "{silent:?}");
    }
}
