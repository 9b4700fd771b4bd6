//! Time as the caller tells it: nothing in this crate reads a clock.

use std::time::Duration;

/// Monotonic time since a start that stays the same. Durations are differences of two readings; no
/// result depends on them.
pub type Clock = fn() -> Duration;

/// The clock of callers that time nothing: every duration is 0.
pub fn untimed() -> Duration {
    Duration::ZERO
}

/// Seconds by `clock` since it read `start`.
pub(crate) fn seconds_since(clock: Clock, start: Duration) -> f64 {
    clock().saturating_sub(start).as_secs_f64()
}
