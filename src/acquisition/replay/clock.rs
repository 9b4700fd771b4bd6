//! A clock that shows recorded times.

use std::{
    sync::atomic::{AtomicU64, Ordering},
    time::Duration,
};

use crate::acquisition::RunClock;

#[derive(Debug, Default)]
pub(super) struct ReplayClock(AtomicU64);

impl ReplayClock {
    /// Advances the clock to at least `at_ns`.
    pub fn advance(&self, at_ns: u64) {
        self.0.fetch_max(at_ns, Ordering::SeqCst);
    }

    pub fn now_ns(&self) -> u64 {
        self.0.load(Ordering::SeqCst)
    }
}

impl RunClock for ReplayClock {
    fn now(&self) -> Duration {
        Duration::from_nanos(self.now_ns())
    }
}
