//! Errors of a pulse schedule.

use std::fmt;

use thiserror::Error;

/// All broken rules of a schedule; never empty.
#[derive(Debug, Clone, PartialEq, Error)]
pub struct TimingError {
    /// The broken rules.
    pub violations: Vec<Violation>,
}

impl fmt::Display for TimingError {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        formatter.write_str("pulse schedule refused: ")?;
        for (index, violation) in self.violations.iter().enumerate() {
            let separator = if index == 0 { "" } else { "; " };
            write!(formatter, "{separator}{violation}")?;
        }
        Ok(())
    }
}

/// A broken rule, with the value and its limit.
#[derive(Debug, Clone, PartialEq, Error)]
pub enum Violation {
    /// A pulse separation or rate that is not positive.
    #[error("{quantity} = {value}: allowed: a positive, finite number")]
    NotPositive { quantity: &'static str, value: f64 },
    /// Lamps would be driven above the laser's rate.
    #[error("laser rate = {rate_hz} Hz: allowed: at most {limit_hz} Hz")]
    LaserRate { rate_hz: f64, limit_hz: f64 },
    /// The rate of the external trigger is not declared.
    #[error(
        "trigger = external: no external_trigger is declared, allowed: one with max_rate_hz of at \
         most {limit_hz} Hz, because the period setting limits nothing then"
    )]
    ExternalTriggerUndeclared { limit_hz: f64 },
    /// The declared rate exceeds the laser's.
    #[error("external_trigger.max_rate_hz = {max_rate_hz} Hz: allowed: at most {limit_hz} Hz")]
    ExternalTriggerRate { max_rate_hz: f64, limit_hz: f64 },
    /// The requested shot rate exceeds the source's.
    #[error(
        "shot rate = {rate_hz} Hz: allowed: at most external_trigger.max_rate_hz = {max_rate_hz} Hz"
    )]
    RateAboveSource { rate_hz: f64, max_rate_hz: f64 },
    /// The pulse separation is not a multiple of the unit's step.
    #[error("dt = {dt_us} us: allowed: a multiple of {step_us} us, the step of a {unit}")]
    NotAStep { unit: &'static str, dt_us: f64, step_us: f64 },
    /// Outside the unit's range.
    #[error("{quantity} = {value_us} us: allowed: {lowest_us} to {highest_us} us with a {unit}")]
    OutsideUnit {
        unit: &'static str,
        quantity: String,
        value_us: f64,
        lowest_us: f64,
        highest_us: f64,
    },
    /// A light pulse is outside its exposure or too close to its edges.
    #[error(
        "Q{number} = {pulse_us:.3} us: must fall into exposure {number}, allowed: \
         {earliest_us:.3} to {latest_us:.3} us (margins included)"
    )]
    PulseOutsideExposure { number: u8, pulse_us: f64, earliest_us: f64, latest_us: f64 },
    /// The next trigger would arrive during the readout.
    #[error(
        "cameras ready again at {ready_us:.3} us: allowed: before the period, {period_us:.3} us, ends"
    )]
    CameraBusy { ready_us: f64, period_us: f64 },
    /// A trigger pulse starts before T0 or extends into the next period.
    #[error(
        "{signal} lasts from {start_us:.3} to {end_us:.3} us: allowed: inside 0 to {period_us:.3} us"
    )]
    OutsidePeriod { signal: Signal, start_us: f64, end_us: f64, period_us: f64 },
}

/// An output of the synchroniser.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Signal {
    /// Flash lamp of laser head 1.
    Lamp1,
    /// Flash lamp of laser head 2.
    Lamp2,
    /// Q-switch of laser head 1.
    QSwitch1,
    /// Q-switch of laser head 2.
    QSwitch2,
    /// Trigger of all cameras.
    CameraTrigger,
}

impl fmt::Display for Signal {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        formatter.write_str(match self {
            Signal::Lamp1 => "lamp 1",
            Signal::Lamp2 => "lamp 2",
            Signal::QSwitch1 => "Q-switch 1",
            Signal::QSwitch2 => "Q-switch 2",
            Signal::CameraTrigger => "camera trigger",
        })
    }
}
