//! Processor time of this program.

use rustix::time::{ClockId, clock_gettime};

/// User and system time used so far by all threads, in s.
pub(super) fn processor_s() -> f64 {
    let time = clock_gettime(ClockId::ProcessCPUTime);
    time.tv_sec as f64 + time.tv_nsec as f64 * 1e-9
}
