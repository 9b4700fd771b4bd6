//! Programs a schedule: disable, reset, disable, write, read back.

use super::{
    Bnc575,
    command::{ChannelParameter, Command, Parameter, Value},
    link::LinkError,
    of,
};
use crate::{
    PulseSchedule,
    device::{DeviceError, Synchroniser, SynchroniserState},
    synchroniser::ChannelName,
    timing::UnitSchedule,
};

/// A parameter and its value.
type Setting = (Parameter, Value);

impl Bnc575 {
    pub(super) fn write_schedule(&mut self, schedule: &PulseSchedule) -> Result<(), DeviceError> {
        if self.state()? == SynchroniserState::Firing {
            return Err(self.refused("timing cannot be changed while a burst is running"));
        }
        let fitted = schedule.for_unit(&self.unit.limits);
        let UnitSchedule { schedule, roundings } =
            fitted.map_err(|error| self.refused(error.to_string()))?;
        for rounding in &roundings {
            tracing::info!(unit = self.name, %rounding, "schedule");
        }
        self.reach_safe_state()?;
        self.link.command(Command::Reset).map_err(|error| self.failed(error))?;
        // Units differ in what a reset leaves enabled.
        self.reach_safe_state()?;
        self.write_settings(&self.settings_of(&schedule)).map_err(|error| self.failed(error))?;
        self.programmed = Some(schedule);
        self.given = 0;
        self.burst = None;
        Ok(())
    }

    /// Each value is checked as it is written, and all once more at the end: setting one may
    /// change another.
    fn write_settings(&mut self, settings: &[Setting]) -> Result<(), LinkError> {
        for (parameter, value) in settings {
            self.link.set(*parameter, *value)?;
        }
        for (parameter, value) in settings {
            self.link.verify(*parameter, *value)?;
        }
        Ok(())
    }

    fn settings_of(&self, schedule: &PulseSchedule) -> Vec<Setting> {
        let mut settings = system_settings(schedule);
        let map = &self.channels;
        for (lamp, delay_us) in map.lamps().into_iter().zip(schedule.lamp_us) {
            settings.extend(pulse_settings(lamp, delay_us, schedule.pulse_width_us));
            settings.push((of(lamp, ChannelParameter::Mode), Value::Keyword("NORM")));
            settings.push((of(lamp, ChannelParameter::WaitCount), Value::Count(0)));
        }
        let q_switches = map.q_switches().into_iter().zip(schedule.q_switch_us);
        let cameras = map.cameras.iter().map(|camera| (*camera, schedule.camera_trigger_us));
        for (output, delay_us) in q_switches.chain(cameras) {
            // Limited to bursts before anything else is set.
            settings.push((of(output, ChannelParameter::Mode), Value::Keyword("BURS")));
            settings.push((of(output, ChannelParameter::BurstCount), Value::Count(1)));
            settings.push((of(output, ChannelParameter::WaitCount), Value::Count(0)));
            settings.extend(pulse_settings(output, delay_us, schedule.pulse_width_us));
        }
        settings
    }
}

fn system_settings(schedule: &PulseSchedule) -> Vec<Setting> {
    let keyword = Value::Keyword;
    match &schedule.external_trigger {
        None => vec![
            (Parameter::TriggerMode, keyword("DIS")),
            (Parameter::SystemMode, keyword("NORM")),
            (Parameter::Period, Value::period(schedule.period_us)),
        ],
        Some(source) => vec![
            (Parameter::TriggerMode, keyword("TRIG")),
            (Parameter::TriggerEdge, Value::edge(source.edge)),
            (Parameter::TriggerLevel, Value::Volts(source.level_v)),
            (Parameter::SystemMode, keyword("SING")),
        ],
    }
}

fn pulse_settings(output: ChannelName, delay_us: f64, width_us: f64) -> [Setting; 5] {
    [
        (of(output, ChannelParameter::Sync), Value::Keyword("T0")),
        (of(output, ChannelParameter::Polarity), Value::Keyword("NORM")),
        (of(output, ChannelParameter::OutputMode), Value::Keyword("TTL")),
        (of(output, ChannelParameter::Delay), Value::time(delay_us)),
        (of(output, ChannelParameter::Width), Value::time(width_us)),
    ]
}
