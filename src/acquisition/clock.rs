//! The time by which frames are due, late and given up.
//!
//! Every decision that depends on time is made by the times of events: of a frame's arrival, of a
//! burst's beginning. They are recorded, so that a replay decides as the run did, however fast it
//! goes.

use std::time::{Duration, Instant, SystemTime, UNIX_EPOCH};

use super::{ClockPair, kernel_clock};

/// A clock that begins with a run.
pub trait RunClock: Send + Sync {
    /// Time since the run began.
    fn now(&self) -> Duration;
    /// This clock and UTC at one moment; `None` where this clock is not that of the host.
    fn pair(&self) -> Option<ClockPair> {
        None
    }
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

    /// UTC is read between two looks at this clock, three times; the closest two count.
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
