//! Driver for the OPTOLUTION oltSync.
//!
//! Limitations of this unit, and their consequences:
//!
//! * **No read-back.** It acknowledges commands (`Sequence:OK`, `Laser:enable`, `Laser:disable`), and
//!   [`Synchroniser::reads_back`] is false. *Safe* is reported only if the unit has answered
//!   `Laser:disable` to a stop sent in that very call. A burst counts as *firing* until a stop is
//!   acknowledged.
//! * **No burst count.** It fires until it is stopped. The host ends bursts by its own clock, on a
//!   thread that outlives the caller but not the process: if the host dies or the line is cut, only
//!   the hardware interlock ends the firing. This breaks the rule that the unit bounds every burst,
//!   so firing is refused unless `host_timed_bursts` accepts the risk.
//! * **No trigger count**: [`Synchroniser::trigger_count`] is `None`, and an external trigger is
//!   refused because its rate cannot be confirmed.

pub mod message;

use std::{
    sync::{Arc, Mutex, MutexGuard, PoisonError},
    thread,
    time::{Duration, Instant},
};

use self::message::{Answer, Outputs, WHO_ARE_YOU};
use super::{
    ChannelMap, LONGEST_BURST_S, SynchroniserSettings, USE_INTERLOCK,
    line::{Dialogue, Line, LineError},
};
use crate::{
    PulseSchedule,
    device::{DeviceError, Synchroniser, SynchroniserState},
    timing::{TimingSettings, UnitLimits},
};

/// Stop commands sent before the unit counts as out of control.
const STOP_ATTEMPTS: usize = 3;
/// How long lamps may pause without cooling down.
const LAMPS_STAY_WARM: Duration = Duration::from_secs(3);

/// A connected unit.
pub struct OltSync {
    unit: Arc<Mutex<Unit>>,
    channels: ChannelMap,
    warm_up: Duration,
    host_timed_bursts: bool,
    programmed: Option<PulseSchedule>,
    lamps_since: Option<Instant>,
    /// Time just before the start of the last burst.
    started_after: Option<Instant>,
}

/// The connection, shared with the thread that ends a burst.
struct Unit {
    /// Identity and port, for messages.
    name: String,
    id: String,
    dialogue: Dialogue,
    running: Running,
    /// Number of the last burst, so that an old thread does not end a new burst.
    burst: u64,
    /// When the lamps were last stopped.
    stopped: Option<Instant>,
}

/// Last acknowledged state.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Running {
    Stopped,
    Lamps,
    Burst,
}

impl OltSync {
    /// Connects over `line` and stops the unit.
    ///
    /// # Errors
    ///
    /// [`DeviceError::Lost`] if no oltSync answers.
    pub fn connect(
        line: Box<dyn Line>,
        settings: &SynchroniserSettings,
        timing: &TimingSettings,
    ) -> Result<Self, DeviceError> {
        let pacing = Duration::from_millis(settings.pacing_ms);
        let reply_timeout = Duration::from_millis(settings.reply_timeout_ms);
        let name = line.name().to_owned();
        let dialogue = Dialogue::new(line, pacing, reply_timeout);
        let (id, running) = (String::new(), Running::Burst);
        let mut unit = Unit { name, id, dialogue, running, burst: 0, stopped: None };
        unit.id = unit.identify()?;
        unit.name = format!("oltSync {} on {}", unit.id, unit.name);
        unit.stop()?;
        Ok(Self {
            unit: Arc::new(Mutex::new(unit)),
            channels: settings.channels.clone(),
            warm_up: Duration::try_from_secs_f64(timing.lamp_warm_up_s).unwrap_or(Duration::MAX),
            host_timed_bursts: settings.host_timed_bursts,
            programmed: None,
            lamps_since: None,
            started_after: None,
        })
    }

    /// Locks the unit. Every change is one call, so a poisoned lock is consistent.
    fn unit(&self) -> MutexGuard<'_, Unit> {
        self.unit.lock().unwrap_or_else(PoisonError::into_inner)
    }

    fn refused(&self, detail: impl Into<String>) -> DeviceError {
        DeviceError::Refused { device: self.unit().name.clone(), detail: detail.into() }
    }

    fn schedule(&self) -> Result<PulseSchedule, DeviceError> {
        self.programmed.clone().ok_or_else(|| self.refused("no schedule is programmed"))
    }

    fn warm_up_left(&self) -> Duration {
        let pause = self.unit().stopped.map_or(Duration::ZERO, |stopped| stopped.elapsed());
        match self.lamps_since {
            Some(since) if pause <= LAMPS_STAY_WARM => self.warm_up.saturating_sub(since.elapsed()),
            _ => self.warm_up,
        }
    }

    fn check_burst(&self, schedule: &PulseSchedule, shots: u64) -> Result<(), DeviceError> {
        if !self.host_timed_bursts {
            return Err(self.refused(
                "this unit cannot count a burst: if the host dies it continues to fire. It fires only with \
                 synchroniser.host_timed_bursts = true and a hardware interlock in reach",
            ));
        }
        let most = (LONGEST_BURST_S * 1e6 / schedule.period_us).max(1.0) as u64;
        if !(1..=most).contains(&shots) {
            return Err(self.refused(format!("burst of {shots} shots: allowed: 1 to {most}")));
        }
        if self.unit().running == Running::Burst {
            return Err(self.refused("a burst is running"));
        }
        let left = self.warm_up_left();
        if !left.is_zero() {
            let left_s = left.as_secs_f64();
            return Err(self.refused(format!(
                "the lamps are not warm: {left_s:.1} s are left; arm, wait, then fire"
            )));
        }
        Ok(())
    }

    /// Ends the burst after its last pulse, on a thread that outlives the caller. The thread is started
    /// before the burst.
    fn end_later(&self, burst: u64, after: Duration) -> Result<(), DeviceError> {
        let unit = Arc::clone(&self.unit);
        let end = Instant::now() + after;
        let run = move || {
            thread::sleep(end.saturating_duration_since(Instant::now()));
            let mut unit = unit.lock().unwrap_or_else(PoisonError::into_inner);
            if unit.burst == burst
                && unit.running == Running::Burst
                && let Err(error) = unit.stop()
            {
                tracing::error!(%error, "cannot stop the burst: {USE_INTERLOCK}");
            }
        };
        match thread::Builder::new().name("oltSync burst".into()).spawn(run) {
            Ok(_) => Ok(()),
            Err(error) => {
                Err(self.refused(format!("cannot start the thread that ends the burst: {error}")))
            }
        }
    }
}

impl Synchroniser for OltSync {
    fn identify(&mut self) -> Result<String, DeviceError> {
        let id = self.unit().identify()?;
        Ok(format!("oltSync:{id}"))
    }

    fn program(&mut self, schedule: &PulseSchedule) -> Result<(), DeviceError> {
        if self.unit().running == Running::Burst {
            return Err(self.refused("timing cannot be changed while a burst is running"));
        }
        if schedule.external_trigger.is_some() {
            return Err(self.refused(
                "external trigger: this unit does not count triggers, so the declared rate \
                 cannot be confirmed; use its own clock",
            ));
        }
        let fitted = schedule.for_unit(&UnitLimits::OLT_SYNC);
        let fitted = fitted.map_err(|error| self.refused(error.to_string()))?;
        for rounding in &fitted.roundings {
            tracing::info!(%rounding, "schedule");
        }
        self.make_safe()?;
        let schedule = fitted.schedule;
        // The unit checks both sequences; the harmless one stays loaded.
        for outputs in [Outputs::All, Outputs::LampsOnly] {
            self.unit().load(&schedule, &self.channels, outputs)?;
        }
        self.programmed = Some(schedule);
        Ok(())
    }

    fn arm(&mut self) -> Result<Duration, DeviceError> {
        let schedule = self.schedule()?;
        let left = self.warm_up_left();
        let mut unit = self.unit.lock().unwrap_or_else(PoisonError::into_inner);
        if unit.running == Running::Stopped {
            unit.load(&schedule, &self.channels, Outputs::LampsOnly)?;
            unit.start(Running::Lamps)?;
            if left == self.warm_up {
                self.lamps_since = Some(Instant::now());
            }
        }
        drop(unit);
        Ok(self.warm_up_left())
    }

    fn fire(&mut self, shots: u64) -> Result<(), DeviceError> {
        let schedule = self.schedule()?;
        self.check_burst(&schedule, shots)?;
        let burst = {
            let mut unit = self.unit();
            unit.stop()?;
            unit.load(&schedule, &self.channels, Outputs::All)?;
            unit.burst += 1;
            unit.burst
        };
        let period = Duration::from_secs_f64(schedule.period_us * 1e-6);
        let shots = u32::try_from(shots).unwrap_or(u32::MAX);
        // Half a period after the last shot's T0.
        self.end_later(burst, period * shots - period / 2)?;
        if self.warm_up.is_zero() {
            self.lamps_since = Some(Instant::now());
        }
        self.started_after = Some(Instant::now());
        self.unit().start(Running::Burst)
    }

    fn started_after(&self) -> Option<Instant> {
        self.started_after
    }

    fn trigger_count(&mut self) -> Result<Option<u64>, DeviceError> {
        Ok(None)
    }

    fn state(&mut self) -> Result<SynchroniserState, DeviceError> {
        let mut unit = self.unit();
        // The identity query shows whether the line still answers.
        let reply = match unit.running {
            Running::Stopped => unit.stop(),
            Running::Lamps | Running::Burst => unit.identify().map(drop),
        };
        let running = unit.running;
        drop(unit);
        Ok(match (reply, running) {
            (Err(error), _) => {
                tracing::error!(%error, "{USE_INTERLOCK}");
                self.programmed = None;
                SynchroniserState::Unknown
            }
            (Ok(()), Running::Burst) => SynchroniserState::Firing,
            (Ok(()), Running::Lamps) => SynchroniserState::Armed,
            (Ok(()), Running::Stopped) if self.programmed.is_some() => SynchroniserState::Armed,
            (Ok(()), Running::Stopped) => SynchroniserState::Safe,
        })
    }

    /// One command switches everything off: this unit has no command for a single output.
    fn make_safe(&mut self) -> Result<(), DeviceError> {
        self.programmed = None;
        self.lamps_since = None;
        self.unit().stop()
    }

    fn reads_back(&self) -> bool {
        false
    }
}

impl Unit {
    fn ask(&mut self, command: &str, accept: &[Answer]) -> Result<Answer, DeviceError> {
        let taken = |line: &str| Answer::parse(line).is_some_and(|answer| accept.contains(&answer));
        let reply = self.dialogue.ask(command, taken).map_err(|error| self.lost(error))?;
        Answer::parse(&reply).ok_or_else(|| self.refused(command))
    }

    fn identify(&mut self) -> Result<String, DeviceError> {
        let taken = |line: &str| matches!(Answer::parse(line), Some(Answer::Identity(_)));
        let reply = self.dialogue.resynchronise(WHO_ARE_YOU, taken);
        match Answer::parse(&reply.map_err(|error| self.lost(error))?) {
            Some(Answer::Identity(id)) => Ok(id),
            _ => Err(self.refused(WHO_ARE_YOU)),
        }
    }

    fn load(
        &mut self,
        schedule: &PulseSchedule,
        channels: &ChannelMap,
        outputs: Outputs,
    ) -> Result<(), DeviceError> {
        let command = message::sequence(&self.id, schedule, channels, outputs);
        match self.ask(&command, &[Answer::SequenceTaken, Answer::SequenceRefused])? {
            Answer::SequenceTaken => Ok(()),
            _ => Err(self.refused(&command)),
        }
    }

    fn start(&mut self, what: Running) -> Result<(), DeviceError> {
        // From here on it may be running, whatever the reply.
        (self.running, self.stopped) = (what, None);
        self.ask(&message::start(&self.id), &[Answer::Enabled]).map(drop)
    }

    fn stop(&mut self) -> Result<(), DeviceError> {
        let command = message::stop(&self.id);
        let mut stopped = self.ask(&command, &[Answer::Disabled]);
        for _ in 1..STOP_ATTEMPTS {
            if stopped.is_ok() {
                break;
            }
            stopped = self.ask(&command, &[Answer::Disabled]);
        }
        stopped?;
        if self.running != Running::Stopped {
            (self.running, self.stopped) = (Running::Stopped, Some(Instant::now()));
        }
        Ok(())
    }

    fn refused(&self, command: &str) -> DeviceError {
        let detail = format!("the unit answered {command:?} with an error");
        DeviceError::Refused { device: self.name.clone(), detail }
    }

    fn lost(&self, error: LineError) -> DeviceError {
        let detail = format!("{error}; {USE_INTERLOCK}");
        DeviceError::Lost { device: self.name.clone(), detail }
    }
}
