//! The pulse schedule: when lamps, Q-switches and cameras fire, in µs after T0.

/// A validated schedule of one period.
#[derive(Debug, Clone, PartialEq)]
pub struct PulseSchedule {
    /// Time between T0 pulses, in µs.
    pub period_us: f64,
    /// Time between the two laser pulses, in µs.
    pub dt_us: f64,
}
