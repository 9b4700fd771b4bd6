//! The time by which frames are due, late and given up.
//!
//! Every decision that depends on time is made by the times of events: of a frame's arrival, of a
//! burst's beginning. They are recorded, so that a replay decides as the run did, however fast it
//! goes.

use std::time::{Duration, Instant};

/// A clock that begins with a run.
pub trait RunClock: Send + Sync {
    /// Time since the run began.
    fn now(&self) -> Duration;
}

/// The host's monotonic clock.
#[derive(Debug)]
pub struct HostClock(Instant);

impl HostClock {
    /// A clock that shows zero now.
    pub fn start() -> Self {
        Self(Instant::now())
    }
}

impl RunClock for HostClock {
    fn now(&self) -> Duration {
        self.0.elapsed()
    }
}
