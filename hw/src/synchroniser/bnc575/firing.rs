//! Lamp warm-up and bounded bursts.

use std::time::Duration;

use super::{
    Bnc575, LampRun, RunningBurst,
    command::{ChannelParameter, Command, Parameter, Value},
    link::LinkError,
    of,
    source::SourceRate,
};
use crate::{
    PulseSchedule,
    device::{DeviceError, SynchroniserState},
    synchroniser::{ChannelName, LONGEST_BURST_S},
};

/// How long lamps may pause without cooling down: T0 is stopped while a burst is prepared.
const LAMPS_STAY_WARM: Duration = Duration::from_secs(3);

impl Bnc575 {
    /// Lamps on, Q-switches and cameras off, T0 running; returns the remaining warm-up time.
    pub(super) fn warm_lamps(&mut self) -> Result<Duration, DeviceError> {
        let schedule = self.schedule()?;
        let state = self.read_state().map_err(|error| self.failed(error))?;
        if state != SynchroniserState::Firing {
            let running = self.run_lamps(&schedule);
            running.map_err(|error| self.failed(error))?;
        }
        let now = self.link.now();
        let source_left = self.source.as_ref().map_or(Duration::ZERO, |source| source.wait(now));
        Ok(self.warm_up_left().max(source_left))
    }

    fn run_lamps(&mut self, schedule: &PulseSchedule) -> Result<(), LinkError> {
        let on = self.link.query_switch(Parameter::Running)?;
        if !(on && self.lamps.is_some()) {
            self.link.set(Parameter::Running, Value::Switch(false))?;
            for output in self.bounded_outputs() {
                self.link.ensure(of(output, ChannelParameter::State), Value::Switch(false))?;
            }
            for lamp in self.channels.lamps() {
                self.link.ensure(of(lamp, ChannelParameter::State), Value::Switch(true))?;
            }
            self.link.set(Parameter::Running, Value::Switch(true))?;
            self.lamps_started();
        }
        self.lamps_seen();
        if let (Some(source), None) = (&schedule.external_trigger, &self.source) {
            let first = self.link.read_triggers()?;
            self.source = Some(SourceRate::new(source.max_rate_hz, first));
        }
        Ok(())
    }

    /// Records the start of the lamps. After too long a pause their warm-up restarts.
    fn lamps_started(&mut self) {
        let now = self.link.now();
        let since = match self.lamps {
            Some(run) if now.saturating_duration_since(run.last_seen) <= LAMPS_STAY_WARM => {
                run.since
            }
            _ => now,
        };
        self.lamps = Some(LampRun { since, last_seen: now });
    }

    /// Records that T0 is running. Only this driver starts it, so it has been running since.
    fn lamps_seen(&mut self) {
        let now = self.link.now();
        if let Some(run) = &mut self.lamps {
            run.last_seen = now;
        }
    }

    fn warm_up_left(&self) -> Duration {
        let now = self.link.now();
        let since = |moment| now.saturating_duration_since(moment);
        let warm = self.lamps.filter(|run| since(run.last_seen) <= LAMPS_STAY_WARM);
        self.warm_up.saturating_sub(warm.map_or(Duration::ZERO, |run| since(run.since)))
    }

    pub(super) fn start_burst(&mut self, shots: u64) -> Result<(), DeviceError> {
        let schedule = self.schedule()?;
        let most = max_shots(&schedule, self.unit.limits.longest_burst);
        if !(1..=most).contains(&shots) {
            return Err(self.refused(format!(
                "burst of {shots} shots: allowed: 1 to {most}, which take {LONGEST_BURST_S} s"
            )));
        }
        let state = self.read_state().map_err(|error| self.failed(error))?;
        if state == SynchroniserState::Firing {
            return Err(self.refused("a burst is running"));
        }
        let left = self.warm_up_left();
        if !left.is_zero() {
            return Err(self.refused(format!(
                "the lamps are not warm: {:.1} s of {:.1} s are left; arm, wait, then fire",
                left.as_secs_f64(),
                self.warm_up.as_secs_f64()
            )));
        }
        self.confirm_source()?;
        self.run_burst(shots).map_err(|error| self.failed(error))
    }

    fn run_burst(&mut self, shots: u64) -> Result<(), LinkError> {
        // T0 is stopped before a Q-switch is enabled.
        self.link.set(Parameter::Running, Value::Switch(false))?;
        for output in self.bounded_outputs() {
            self.link.ensure(of(output, ChannelParameter::Mode), Value::Keyword("BURS"))?;
            self.link.ensure(of(output, ChannelParameter::BurstCount), Value::Count(shots))?;
        }
        for lamp in self.channels.lamps() {
            self.link.ensure(of(lamp, ChannelParameter::State), Value::Switch(true))?;
        }
        for output in self.bounded_outputs() {
            self.link.ensure(of(output, ChannelParameter::State), Value::Switch(true))?;
        }
        let count_before = self.link.query_count(Parameter::TriggerCount)?;
        // Recorded before the start: if the reply is lost, the burst may be running.
        self.burst = Some(RunningBurst { shots, count_before, started: self.link.now() });
        self.link.command(Command::Set(Parameter::Running, Value::Switch(true)))?;
        self.lamps_started();
        Ok(())
    }

    /// Outputs that must not follow every T0.
    fn bounded_outputs(&self) -> Vec<ChannelName> {
        let q_switches = self.channels.q_switches().into_iter();
        self.channels.cameras.iter().copied().chain(q_switches).collect()
    }

    /// The state, read from the unit only.
    pub(super) fn read_state(&mut self) -> Result<SynchroniserState, LinkError> {
        if self.link.query_switch(Parameter::Running)? {
            return self.read_running_state();
        }
        // T0 may have stopped by itself: the unit's counter has the number of shots.
        let given = self.shots_of_burst()?;
        self.end_burst(given);
        let mut all_off = true;
        for output in self.channels.all() {
            all_off &= !self.link.query_switch(of(output, ChannelParameter::State))?;
        }
        Ok(match all_off && self.programmed.is_none() {
            true => SynchroniserState::Safe,
            false => SynchroniserState::Armed,
        })
    }

    fn read_running_state(&mut self) -> Result<SynchroniserState, LinkError> {
        let given = self.shots_of_burst()?;
        self.lamps_seen();
        match self.burst {
            Some(burst) if given < burst.shots => Ok(SynchroniserState::Firing),
            Some(_) => {
                self.end_burst(given);
                Ok(SynchroniserState::Armed)
            }
            None if self.lamps.is_some() => Ok(SynchroniserState::Armed),
            // A burst that was started elsewhere, perhaps by an earlier run.
            None => Ok(match self.any_q_switch_enabled()? {
                true => SynchroniserState::Firing,
                false => SynchroniserState::Armed,
            }),
        }
    }

    fn any_q_switch_enabled(&mut self) -> Result<bool, LinkError> {
        for output in self.channels.q_switches() {
            if self.link.query_switch(of(output, ChannelParameter::State))? {
                return Ok(true);
            }
        }
        Ok(false)
    }

    /// Shots of the current burst so far; zero without one.
    pub(super) fn shots_of_burst(&mut self) -> Result<u64, LinkError> {
        let Some(burst) = self.burst else { return Ok(0) };
        let count = self.link.query_count(Parameter::TriggerCount)?;
        // A counter below its initial value was reset at the start of the burst.
        Ok(count.checked_sub(burst.count_before).unwrap_or(count).min(burst.shots))
    }

    /// Closes the burst. Lamps fired at least until its last shot.
    fn end_burst(&mut self, given: u64) {
        let Some(burst) = self.burst.take() else { return };
        self.given += given;
        let now = self.link.now();
        if let (Some(run), Some(schedule)) = (&mut self.lamps, &self.programmed) {
            let lasted_s = given as f64 * schedule.period_us * 1e-6;
            let last_shot = burst.started + Duration::from_secs_f64(lasted_s);
            run.last_seen = run.last_seen.max(last_shot.min(now));
        }
    }

    fn schedule(&self) -> Result<PulseSchedule, DeviceError> {
        self.programmed.clone().ok_or_else(|| self.refused("no schedule is programmed"))
    }
}

/// Shots in the longest allowed burst: those within [`LONGEST_BURST_S`], at least one.
fn max_shots(schedule: &PulseSchedule, longest_burst: u64) -> u64 {
    let fit = LONGEST_BURST_S * 1e6 / schedule.shortest_period_us();
    ((fit + 1e-9) as u64).clamp(1, longest_burst)
}
