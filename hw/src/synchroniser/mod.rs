//! Drivers for units that time laser and cameras, over a serial line.
//!
//! [`open`] finds the driver that the configuration names. All of them keep the rules of
//! [`Synchroniser`]: the unit is disabled before anything else, timing is validated before it is
//! sent, every firing is a bounded burst.
//!
//! Safety that is software only is not safety: the laser's own interlock has to work without any
//! of this.

pub mod bnc575;
pub mod line;
pub mod oltsync;
mod settings;

use std::fs::OpenOptions;

use crate::{
    device::{DeviceError, Synchroniser},
    timing::TimingSettings,
};
use bnc575::Bnc575;
use line::{Line, Recorded, SerialLine, Transcript};
use oltsync::OltSync;

pub use settings::{ChannelMap, ChannelName, SynchroniserDriver, SynchroniserSettings};

/// Longest burst, in s: a dead host or a cut line ends the firing within this time by itself.
pub const LONGEST_BURST_S: f64 = 5.0;

/// What to tell the operator when the unit's state cannot be read.
pub const USE_INTERLOCK: &str = "state unknown: use the hardware interlock";

/// Opens the port and makes contact; outputs are disabled before anything else. Every byte on the
/// line goes to `transcript`, too.
///
/// # Errors
///
/// The port cannot be opened, the transcript cannot be written, nothing answers, or what answers
/// is another unit.
pub fn open(
    settings: &SynchroniserSettings,
    timing: &TimingSettings,
    transcript: Transcript,
) -> Result<Box<dyn Synchroniser>, DeviceError> {
    let lost = |detail: String| DeviceError::Lost { device: settings.port.clone(), detail };
    let baud_rate = settings.baud_rates()[0];
    let line = SerialLine::open(&settings.port, baud_rate).map_err(|error| {
        lost(format!(
            "cannot open the serial port: {error}; check instruments.synchroniser.port, that the user may use \
             it (group dialout) and that no other program does"
        ))
    })?;
    let line = Recorded::new(line, transcript);
    let Some(path) = &settings.transcript else {
        return open_on(Box::new(line), settings, timing);
    };
    let file = OpenOptions::new().create(true).append(true).open(path).map_err(|error| {
        lost(format!(
            "cannot write instruments.synchroniser.transcript {}: {error}",
            path.display()
        ))
    })?;
    open_on(Box::new(Recorded::new(line, Transcript::written(file))), settings, timing)
}

/// As [`open`], on a line that is open already: a recorded one, or one with faults injected.
pub fn open_on(
    line: Box<dyn Line>,
    settings: &SynchroniserSettings,
    timing: &TimingSettings,
) -> Result<Box<dyn Synchroniser>, DeviceError> {
    Ok(match settings.driver {
        SynchroniserDriver::Bnc575 | SynchroniserDriver::QuantumComposers => {
            Box::new(Bnc575::connect(line, settings, timing)?)
        }
        SynchroniserDriver::OltSync => Box::new(OltSync::connect(line, settings, timing)?),
    })
}
