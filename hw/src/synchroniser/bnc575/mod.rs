//! Driver for BNC 575 and 577 and for Quantum Composers 952x and 953x, which share one dialect.
//!
//! Firing:
//!
//! * Lamps follow every T0. Q-switches and cameras are always in burst mode with a count, never in
//!   normal mode. The unit ends the burst, whatever happens to the host.
//! * The host measures the warm-up: T0 runs with lamps only, and `fire` is refused until they have
//!   fired long enough. The unit's wait counter is set to zero: how it combines with bursts is not
//!   verified, and it would delay every burst.
//! * T0 is stopped before Q-switch outputs are enabled, and started after everything is read back:
//!   writes are not atomic, so nothing is changed while a Q-switch may fire.
//! * No assumption is made about the unit after a burst: the lamps may continue, or T0 may stop.

pub mod command;
mod firing;
mod link;
mod program;
pub mod reply;
mod safety;
mod source;
mod unit;

use std::time::{Duration, Instant};

pub use unit::UnitDescription;

use self::{
    command::{Channel, ChannelParameter, Command, Parameter, Value},
    link::{Link, LinkError},
    source::SourceRate,
    unit::is_catalogue,
};
use super::{ChannelMap, ChannelName, SynchroniserSettings, line::Dialogue, line::Line};
use crate::{
    PulseSchedule,
    device::{DeviceError, Synchroniser, SynchroniserState},
    timing::TimingSettings,
};

/// A connected unit.
pub struct Bnc575 {
    /// Identity and port, for messages.
    name: String,
    unit: UnitDescription,
    link: Link,
    channels: ChannelMap,
    warm_up: Duration,
    programmed: Option<PulseSchedule>,
    lamps: Option<LampRun>,
    source: Option<SourceRate>,
    /// Shots of completed bursts since `program`.
    given: u64,
    /// The last burst, until its end is observed.
    burst: Option<RunningBurst>,
}

/// A period of lamp firing.
#[derive(Debug, Clone, Copy)]
struct LampRun {
    since: Instant,
    /// When they were last known to fire.
    last_seen: Instant,
}

/// A running burst.
#[derive(Debug, Clone, Copy)]
struct RunningBurst {
    shots: u64,
    /// The unit's T0 count before it.
    count_before: u64,
    started: Instant,
}

impl Bnc575 {
    /// Connects over `line` and disables all outputs before anything else.
    ///
    /// # Errors
    ///
    /// [`DeviceError::Lost`] if nothing answers at any of the configured baud rates,
    /// [`DeviceError::Refused`] if the unit is of another kind or has too few channels.
    pub fn connect(
        line: Box<dyn Line>,
        settings: &SynchroniserSettings,
        timing: &TimingSettings,
    ) -> Result<Self, DeviceError> {
        let pacing = Duration::from_millis(settings.pacing_ms);
        let reply_timeout = Duration::from_millis(settings.reply_timeout_ms);
        let port = line.name().to_owned();
        let mut link = Link::new(Dialogue::new(line, pacing, reply_timeout));
        let failed = |error: LinkError| error.into_device_error(&port);
        let identity = contact(&mut link, &settings.baud_rates()).map_err(failed)?;
        let catalogue = link.ask(Command::Catalogue, is_catalogue).map_err(failed)?;
        let refused = |detail| DeviceError::Refused { device: port.clone(), detail };
        let unit = UnitDescription::recognise(&identity, &catalogue).ok_or_else(|| {
            refused(format!(
                "{identity:?} with channels {catalogue:?} answers: a BNC 575 or 577 or a Quantum \
                 Composers 952x or 953x is needed; check synchroniser.driver and .port"
            ))
        })?;
        check_channels(&settings.channels, &unit).map_err(refused)?;
        let mut driver = Self {
            name: format!("{identity} on {port}"),
            unit,
            link,
            channels: settings.channels.clone(),
            warm_up: Duration::try_from_secs_f64(timing.lamp_warm_up_s).unwrap_or(Duration::MAX),
            programmed: None,
            lamps: None,
            source: None,
            given: 0,
            burst: None,
        };
        driver.make_safe()?;
        Ok(driver)
    }

    /// Identity and limits of the unit.
    pub fn unit(&self) -> &UnitDescription {
        &self.unit
    }

    fn refused(&self, detail: impl Into<String>) -> DeviceError {
        DeviceError::Refused { device: self.name.clone(), detail: detail.into() }
    }

    /// Converts an error. After a lost line, all knowledge about the unit is discarded.
    fn failed(&mut self, error: LinkError) -> DeviceError {
        if matches!(error, LinkError::Line(_)) {
            self.forget();
        }
        error.into_device_error(&self.name)
    }

    /// Discards what is known about a unit that may have been switched off or made safe.
    fn forget(&mut self) {
        self.programmed = None;
        self.lamps = None;
        self.source = None;
    }
}

impl Synchroniser for Bnc575 {
    fn identify(&mut self) -> Result<String, DeviceError> {
        self.link.identify().map_err(|error| self.failed(error))
    }

    fn program(&mut self, schedule: &PulseSchedule) -> Result<(), DeviceError> {
        self.write_schedule(schedule)
    }

    fn arm(&mut self) -> Result<Duration, DeviceError> {
        self.warm_lamps()
    }

    fn fire(&mut self, shots: u64) -> Result<(), DeviceError> {
        self.start_burst(shots)
    }

    fn started_after(&self) -> Option<Instant> {
        self.burst.map(|burst| burst.started)
    }

    fn trigger_count(&mut self) -> Result<Option<u64>, DeviceError> {
        let running = self.shots_of_burst().map_err(|error| self.failed(error))?;
        Ok(Some(self.given + running))
    }

    fn state(&mut self) -> Result<SynchroniserState, DeviceError> {
        match self.read_state() {
            Ok(state) => Ok(state),
            Err(error @ LinkError::Line(_)) => {
                tracing::error!(unit = self.name, %error, "{}", super::USE_INTERLOCK);
                self.forget();
                Ok(SynchroniserState::Unknown)
            }
            Err(error) => Err(self.failed(error)),
        }
        .and_then(|state| self.watch_source().map(|()| state))
    }

    fn watch(&mut self) -> Result<(), DeviceError> {
        self.watch_source()
    }

    fn make_safe(&mut self) -> Result<(), DeviceError> {
        self.reach_safe_state()
    }
}

/// Finds the baud rate at which the unit answers. Outputs are disabled before the identity query, which
/// resynchronises the dialogue.
fn contact(link: &mut Link, baud_rates: &[u32]) -> Result<String, LinkError> {
    let mut silence = None;
    for baud_rate in baud_rates {
        link.dialogue().set_baud_rate(*baud_rate)?;
        let off = Command::Set(Parameter::Running, Value::Switch(false));
        link.dialogue().send(&off.to_string())?;
        match link.identify() {
            Ok(identity) => {
                let echo = link.dialogue().echo();
                tracing::info!(identity, baud_rate, ?echo, "synchroniser");
                return Ok(identity);
            }
            Err(error) => silence = Some(error),
        }
    }
    match silence {
        Some(error) => Err(error),
        None => link.identify(),
    }
}

fn check_channels(channels: &ChannelMap, unit: &UnitDescription) -> Result<(), String> {
    match channels.all().into_iter().find(|name| name.number() > unit.channels) {
        None => Ok(()),
        Some(name) => Err(format!(
            "synchroniser.channels names output {name}: the unit has {} outputs",
            unit.channels
        )),
    }
}

fn of(name: ChannelName, parameter: ChannelParameter) -> Parameter {
    Parameter::Of(Channel(name.number()), parameter)
}
