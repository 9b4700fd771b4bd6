//! The clock that decides when frames are due or late.
//!
//! Every time-dependent decision uses the time of an event, such as a frame's arrival or a burst's
//! start. These times are recorded, so that a replay at any speed decides as the run did.

use std::time::{Duration, Instant, SystemTime, UNIX_EPOCH};

use super::{ClockPair, kernel_clock};

/// A clock that starts with a run.
pub trait RunClock: Send + Sync {
    /// Time since the start of the run.
    fn now(&self) -> Duration;
    /// This clock and UTC at the same moment; `None` if this clock is not the host's.
    fn pair(&self) -> Option<ClockPair> {
        None
    }
}

/// The host's monotonic clock.
#[derive(Debug)]
pub struct HostClock(Instant);

impl HostClock {
    /// A clock that starts at zero now.
    pub fn start() -> Self {
        Self(Instant::now())
    }
}

impl RunClock for HostClock {
    fn now(&self) -> Duration {
        self.0.elapsed()
    }

    /// Reads UTC between two readings of this clock, three times, and takes the closest pair.
    fn pair(&self) -> Option<ClockPair> {
        let read = || {
            let before = self.now();
            let utc = SystemTime::now().duration_since(UNIX_EPOCH).ok()?;
            Some((before, utc, self.now() - before))
        };
        let readings = (0..3).filter_map(|_| read());
        let (before, utc, width) = readings.min_by_key(|(_, _, width)| *width)?;
        let kernel = kernel_clock().ok().filter(|kernel| kernel.synchronised);
        let nanoseconds = |time: Duration| u64::try_from(time.as_nanos()).ok();
        Some(ClockPair {
            at_ns: nanoseconds(before + width / 2)?,
            utc_ns: nanoseconds(utc)?,
            clock_error_ns: kernel.and_then(|kernel| {
                let max_error = Duration::from_micros(u64::try_from(kernel.max_error_us).ok()?);
                nanoseconds(max_error)
            }),
        })
    }
}
