//! The clock that times the stages.

use std::{
    sync::LazyLock,
    time::{Duration, Instant},
};

/// Monotonic time since the first call: a [`lfpiv_core::Clock`].
pub fn monotonic() -> Duration {
    static START: LazyLock<Instant> = LazyLock::new(Instant::now);
    START.elapsed()
}
