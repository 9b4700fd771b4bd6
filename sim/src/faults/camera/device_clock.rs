//! A camera's clock with a rate error and jumps.

/// Converts correct timestamps to those of a faulty clock.
#[derive(Debug, Clone)]
pub(super) struct DeviceClock {
    drift_ppm: f64,
    /// The first timestamp: drift is relative to it.
    first_ns: Option<u64>,
    jumped_ns: i128,
}

impl DeviceClock {
    pub fn new(drift_ppm: f64) -> Self {
        Self { drift_ppm, first_ns: None, jumped_ns: 0 }
    }

    pub fn jump(&mut self, jump_ns: i64) {
        self.jumped_ns += i128::from(jump_ns);
    }

    pub fn read(&mut self, true_ns: u64) -> u64 {
        let first_ns = i128::from(*self.first_ns.get_or_insert(true_ns));
        let elapsed_ns = i128::from(true_ns) - first_ns;
        let drift_ns = (elapsed_ns as f64 * self.drift_ppm * 1e-6).round() as i128;
        let shown_ns = i128::from(true_ns) + drift_ns + self.jumped_ns;
        u64::try_from(shown_ns.max(0)).unwrap_or(u64::MAX)
    }
}
