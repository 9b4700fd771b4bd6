//! The clock that measurements are timed by.

use std::{
    sync::LazyLock,
    time::{Duration, Instant},
};

/// Monotonic time since this was first asked for: a [`lfpiv_core::Clock`].
pub fn monotonic() -> Duration {
    static START: LazyLock<Instant> = LazyLock::new(Instant::now);
    START.elapsed()
}
