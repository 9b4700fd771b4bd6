//! The pulse schedule: when lamps, Q-switches and cameras fire, in µs after T0.
//!
//! One period of a double-frame shot (docs/theory.md, section 7):
//!
//! ```text
//! T0 |--lamp 1--------Q1          Q2
//!    |       lamp 2----+-----------^
//!    |   [latency][  exposure 1  ]gap[  exposure 2 = readout of 1  ][readout of 2] | T0
//! ```
//!
//! Q1 must fall into exposure 1 and Q2 into exposure 2. The gap between the exposures is centred
//! between the pulses while they are close; for slow flows it starts half an exposure after Q1.

pub mod diagram;
mod error;
mod limits;
mod settings;
mod trigger;

use serde::{Deserialize, Serialize};

pub use error::{Signal, TimingError, Violation};
pub use limits::{Rounding, UnitLimits, UnitSchedule};
pub use settings::TimingSettings;
pub use trigger::{ExternalTrigger, TriggerEdge, TriggerSource};

/// Tolerance for rounding, in µs: a picosecond, finer than any synchroniser resolves.
const ROUNDING_US: f64 = 1e-6;

/// A validated schedule of one period. All times are in µs after T0.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct PulseSchedule {
    /// Time between T0 pulses, in µs; with an external trigger, the expected one.
    pub period_us: f64,
    /// Time between the two laser pulses, in µs.
    pub dt_us: f64,
    /// Flash lamp triggers of laser heads 1 and 2.
    pub lamp_us: [f64; 2],
    /// Q-switch triggers of laser heads 1 and 2: the light pulses.
    pub q_switch_us: [f64; 2],
    /// Trigger of all cameras.
    pub camera_trigger_us: f64,
    /// Start and end of exposure 1.
    pub exposure_1_us: [f64; 2],
    /// Start and end of exposure 2.
    pub exposure_2_us: [f64; 2],
    /// When the cameras have read out both frames and can be triggered again.
    pub camera_ready_us: f64,
    /// Width of every trigger pulse, in µs.
    pub pulse_width_us: f64,
    /// Minimum time between a light pulse and the edges of its exposure, in µs.
    pub margin_us: f64,
    /// The source of triggers; `None` for the synchroniser's own clock.
    pub external_trigger: Option<ExternalTrigger>,
}

impl PulseSchedule {
    /// The schedule for two pulses `dt_us` apart, `rate_hz` times a second.
    ///
    /// Errors name every broken rule of docs/theory.md, section 7, with value and limit.
    pub fn plan(settings: &TimingSettings, dt_us: f64, rate_hz: f64) -> Result<Self, TimingError> {
        positive("dt_us", dt_us)?;
        positive("rate_hz", rate_hz)?;
        let schedule = Self::place(settings, dt_us, rate_hz);
        let violations: Vec<Violation> = laser_rate(settings, rate_hz)
            .into_iter()
            .chain(external_rate(settings, rate_hz))
            .chain(schedule.broken_rules())
            .collect();
        if violations.is_empty() { Ok(schedule) } else { Err(TimingError { violations }) }
    }

    /// Laser rate in Hz.
    pub fn rate_hz(&self) -> f64 {
        1e6 / self.period_us
    }

    /// Shortest time between two T0 pulses, in µs: that of an external source at its declared rate.
    pub fn shortest_period_us(&self) -> f64 {
        match &self.external_trigger {
            Some(source) => 1e6 / source.max_rate_hz,
            None => self.period_us,
        }
    }

    /// Outputs of the synchroniser and the start of their pulses, in µs.
    pub fn signals(&self) -> [(Signal, f64); 5] {
        [
            (Signal::Lamp1, self.lamp_us[0]),
            (Signal::Lamp2, self.lamp_us[1]),
            (Signal::QSwitch1, self.q_switch_us[0]),
            (Signal::QSwitch2, self.q_switch_us[1]),
            (Signal::CameraTrigger, self.camera_trigger_us),
        ]
    }

    fn place(settings: &TimingSettings, dt_us: f64, rate_hz: f64) -> Self {
        let q1_us = settings.lamp_1_us + settings.lamp_to_q_switch_us[0];
        let q2_us = q1_us + dt_us;
        // docs/theory.md, section 7: the gap starts at Q1 + min((dt − gap)/2, exposure 1/2).
        let gap_start_us =
            q1_us + ((dt_us - settings.gap_us) / 2.0).min(settings.exposure_1_us / 2.0);
        let gap_end_us = gap_start_us + settings.gap_us;
        let exposure_1_start_us = gap_start_us - settings.exposure_1_us;
        // Exposure 2 lasts for the readout of frame 1; then frame 2 is read out.
        let exposure_2_end_us = gap_end_us + settings.readout_us;
        Self {
            period_us: 1e6 / rate_hz,
            dt_us,
            lamp_us: [settings.lamp_1_us, q2_us - settings.lamp_to_q_switch_us[1]],
            q_switch_us: [q1_us, q2_us],
            camera_trigger_us: exposure_1_start_us - settings.camera_latency_us,
            exposure_1_us: [exposure_1_start_us, gap_start_us],
            exposure_2_us: [gap_end_us, exposure_2_end_us],
            camera_ready_us: exposure_2_end_us + settings.readout_us,
            pulse_width_us: settings.pulse_width_us,
            margin_us: settings.margin_us,
            external_trigger: match settings.trigger {
                TriggerSource::Internal => None,
                TriggerSource::External => settings.external_trigger.clone(),
            },
        }
    }

    /// Broken rules within one period.
    fn broken_rules(&self) -> Vec<Violation> {
        [self.pulse_in_exposure(1), self.pulse_in_exposure(2), self.camera_ready()]
            .into_iter()
            .flatten()
            .chain(self.signals_outside_period())
            .collect()
    }

    /// Checks light pulse `number` (1 or 2) against the exposure of the same number.
    fn pulse_in_exposure(&self, number: u8) -> Option<Violation> {
        let (pulse_us, [start_us, end_us]) = match number {
            1 => (self.q_switch_us[0], self.exposure_1_us),
            _ => (self.q_switch_us[1], self.exposure_2_us),
        };
        let (earliest_us, latest_us) = (start_us + self.margin_us, end_us - self.margin_us);
        let inside = earliest_us - ROUNDING_US <= pulse_us && pulse_us <= latest_us + ROUNDING_US;
        (!inside).then_some(Violation::PulseOutsideExposure {
            number,
            pulse_us,
            earliest_us,
            latest_us,
        })
    }

    fn camera_ready(&self) -> Option<Violation> {
        let (ready_us, period_us) = (self.camera_ready_us, self.shortest_period_us());
        (ready_us >= period_us - ROUNDING_US)
            .then_some(Violation::CameraBusy { ready_us, period_us })
    }

    fn signals_outside_period(&self) -> impl Iterator<Item = Violation> {
        let (width_us, period_us) = (self.pulse_width_us, self.shortest_period_us());
        self.signals().into_iter().filter_map(move |(signal, start_us)| {
            let end_us = start_us + width_us;
            let inside = start_us >= -ROUNDING_US && end_us <= period_us + ROUNDING_US;
            (!inside).then_some(Violation::OutsidePeriod { signal, start_us, end_us, period_us })
        })
    }
}

/// Lamps are never driven above the laser's rate.
fn laser_rate(settings: &TimingSettings, rate_hz: f64) -> Option<Violation> {
    let limit_hz = settings.laser_rate_limit_hz;
    (rate_hz > limit_hz).then_some(Violation::LaserRate { rate_hz, limit_hz })
}

/// With an external trigger the period setting limits nothing, so the source's declared rate must
/// be low enough.
fn external_rate(settings: &TimingSettings, rate_hz: f64) -> Option<Violation> {
    let limit_hz = settings.laser_rate_limit_hz;
    match (settings.trigger, &settings.external_trigger) {
        (TriggerSource::Internal, _) => None,
        (TriggerSource::External, None) => Some(Violation::ExternalTriggerUndeclared { limit_hz }),
        (TriggerSource::External, Some(source)) => {
            let max_rate_hz = source.max_rate_hz;
            // Written so that NaN is refused, too.
            if !(max_rate_hz > 0.0 && max_rate_hz <= limit_hz) {
                Some(Violation::ExternalTriggerRate { max_rate_hz, limit_hz })
            } else if rate_hz > max_rate_hz {
                Some(Violation::RateAboveSource { rate_hz, max_rate_hz })
            } else {
                None
            }
        }
    }
}

fn positive(quantity: &'static str, value: f64) -> Result<(), TimingError> {
    if value.is_finite() && value > 0.0 {
        Ok(())
    } else {
        Err(TimingError { violations: vec![Violation::NotPositive { quantity, value }] })
    }
}

#[cfg(test)]
mod tests;
#[cfg(test)]
mod unit_tests;
