//! Limits of a synchroniser, and schedules rounded to its steps.

use std::{fmt, ops::RangeInclusive};

use super::{PulseSchedule, ROUNDING_US, TimingError, Violation};

/// Limits of a family of synchronisers.
#[derive(Debug, Clone, PartialEq)]
pub struct UnitLimits {
    /// The family, for messages.
    pub unit: &'static str,
    /// Period of the unit's own clock, in µs.
    pub period_us: RangeInclusive<f64>,
    /// Step of the period, in µs.
    pub period_step_us: f64,
    /// Delay of a channel after T0, in µs.
    pub delay_us: RangeInclusive<f64>,
    /// Width of a pulse, in µs.
    pub width_us: RangeInclusive<f64>,
    /// Step of delay and width, in µs.
    pub step_us: f64,
    /// Longest burst, in shots.
    pub longest_burst: u64,
}

impl UnitLimits {
    /// BNC 575 and 577, Quantum Composers 952x (period in steps of 10 ns, delay and width in steps of
    /// 250 ps: BNC 575 manual, specifications).
    pub const BNC_575: Self = Self {
        unit: "BNC 575",
        period_us: 0.1..=5e9,
        period_step_us: 0.01,
        delay_us: -999_999_999.999_75..=999_999_999.999_75,
        width_us: 0.01..=999_900_000.0,
        step_us: 0.000_25,
        longest_burst: 9_999_999,
    };

    /// Quantum Composers 9530: as [`Self::BNC_575`], with shorter bursts.
    pub const QUANTUM_COMPOSERS_9530: Self =
        Self { unit: "Quantum Composers 9530", longest_burst: 1_000_000, ..Self::BNC_575 };

    /// OPTOLUTION oltSync: whole microseconds; edges within the frame time; no burst count.
    pub const OLT_SYNC: Self = Self {
        unit: "oltSync",
        period_us: 2.0..=4_294_967_295.0,
        period_step_us: 1.0,
        delay_us: 0.0..=4_294_967_295.0,
        width_us: 1.0..=4_294_967_295.0,
        step_us: 1.0,
        longest_burst: u64::MAX,
    };
}

/// A value that the unit cannot represent.
#[derive(Debug, Clone, PartialEq)]
pub struct Rounding {
    /// Which value.
    pub quantity: &'static str,
    /// Planned value, in µs.
    pub planned_us: f64,
    /// Rounded value, in µs.
    pub set_us: f64,
}

impl fmt::Display for Rounding {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { quantity, planned_us, set_us } = self;
        write!(formatter, "{quantity}: {planned_us:.6} us is set as {set_us:.6} us")
    }
}

/// A schedule in the unit's steps.
#[derive(Debug, Clone, PartialEq)]
pub struct UnitSchedule {
    /// Every value is a multiple of the unit's step.
    pub schedule: PulseSchedule,
    /// The changes, by at most half a step (the period by less than one step).
    pub roundings: Vec<Rounding>,
}

impl PulseSchedule {
    /// This schedule in the unit's steps, checked against its limits and again against the rules of the
    /// schedule.
    ///
    /// The pulse separation is never rounded, because velocities are computed from it. The period
    /// is rounded up, so that lamps are not driven faster than planned.
    ///
    /// # Errors
    ///
    /// All broken rules and limits, with value and limit.
    pub fn for_unit(&self, limits: &UnitLimits) -> Result<UnitSchedule, TimingError> {
        let step_us = limits.step_us;
        let dt_us = nearest(self.dt_us, step_us);
        if (dt_us - self.dt_us).abs() > ROUNDING_US {
            let violation = Violation::NotAStep { unit: limits.unit, dt_us: self.dt_us, step_us };
            return Err(TimingError { violations: vec![violation] });
        }
        let schedule = self.rounded(limits);
        let violations: Vec<_> =
            schedule.outside_unit(limits).into_iter().chain(schedule.broken_rules()).collect();
        if !violations.is_empty() {
            return Err(TimingError { violations });
        }
        let roundings = self.roundings(&schedule);
        Ok(UnitSchedule { schedule, roundings })
    }

    fn rounded(&self, limits: &UnitLimits) -> Self {
        let round = |value_us: f64| nearest(value_us, limits.step_us);
        let q1_us = round(self.q_switch_us[0]);
        let camera_trigger_us = round(self.camera_trigger_us);
        // Exposures shift with their trigger.
        let later_us = camera_trigger_us - self.camera_trigger_us;
        let period_us = match self.external_trigger {
            None => next(self.period_us, limits.period_step_us),
            Some(_) => self.period_us,
        };
        Self {
            period_us,
            lamp_us: self.lamp_us.map(round),
            q_switch_us: [q1_us, round(q1_us + self.dt_us)],
            camera_trigger_us,
            exposure_1_us: self.exposure_1_us.map(|edge_us| edge_us + later_us),
            exposure_2_us: self.exposure_2_us.map(|edge_us| edge_us + later_us),
            camera_ready_us: self.camera_ready_us + later_us,
            pulse_width_us: round(self.pulse_width_us),
            ..self.clone()
        }
    }

    fn outside_unit(&self, limits: &UnitLimits) -> Vec<Violation> {
        let outside = |quantity: String, value_us: f64, range_us: &RangeInclusive<f64>| {
            (!range_us.contains(&value_us)).then(|| Violation::OutsideUnit {
                unit: limits.unit,
                quantity,
                value_us,
                lowest_us: *range_us.start(),
                highest_us: *range_us.end(),
            })
        };
        let period = match self.external_trigger {
            None => outside("period".into(), self.period_us, &limits.period_us),
            Some(_) => None,
        };
        let width = outside("pulse width".into(), self.pulse_width_us, &limits.width_us);
        let delays = self.signals().into_iter().filter_map(|(signal, delay_us)| {
            outside(format!("delay of {signal}"), delay_us, &limits.delay_us)
        });
        period.into_iter().chain(width).chain(delays).collect()
    }

    fn roundings(&self, set: &Self) -> Vec<Rounding> {
        let values = |schedule: &Self| {
            [
                ("period", schedule.period_us),
                ("pulse width", schedule.pulse_width_us),
                ("lamp 1", schedule.lamp_us[0]),
                ("lamp 2", schedule.lamp_us[1]),
                ("Q-switch 1", schedule.q_switch_us[0]),
                ("Q-switch 2", schedule.q_switch_us[1]),
                ("camera trigger", schedule.camera_trigger_us),
            ]
        };
        let changes = values(self).into_iter().zip(values(set)).filter_map(
            |((quantity, planned_us), (_, set_us))| {
                let changed = (planned_us - set_us).abs() > ROUNDING_US;
                changed.then_some(Rounding { quantity, planned_us, set_us })
            },
        );
        changes.collect()
    }
}

fn nearest(value_us: f64, step_us: f64) -> f64 {
    (value_us / step_us).round() * step_us
}

/// The smallest multiple that is not below the value, within rounding.
fn next(value_us: f64, step_us: f64) -> f64 {
    ((value_us - ROUNDING_US) / step_us).ceil() * step_us
}
