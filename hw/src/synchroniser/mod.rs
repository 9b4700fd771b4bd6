//! Serial drivers for the unit that triggers laser and cameras.
//!
//! [`open`] selects the configured driver. All drivers follow the rules of [`Synchroniser`]: the
//! unit is disabled before anything else, timing is validated before it is sent, and every firing
//! is a bounded burst.
//!
//! Software alone is not safe: the laser's own interlock must work without it.

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
use line::{Line, RecordedLine, SerialLine, Transcript};
use oltsync::OltSync;

pub use settings::{ChannelMap, ChannelName, SynchroniserDriver, SynchroniserSettings};

/// Longest burst, in s: if the host dies or the line is cut, firing ends within this time.
pub const LONGEST_BURST_S: f64 = 5.0;

/// Advice to the operator when the unit's state cannot be read.
pub const USE_INTERLOCK: &str = "state unknown: use the hardware interlock";

/// Opens the port and connects; outputs are disabled before anything else. Every byte on the line
/// is also written to `transcript`.
///
/// # Errors
///
/// The port cannot be opened, the transcript cannot be written, nothing answers, or another kind of
/// unit answers.
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
    let line = RecordedLine::new(line, transcript);
    let Some(path) = &settings.transcript else {
        return open_on(Box::new(line), settings, timing);
    };
    let file = OpenOptions::new().create(true).append(true).open(path).map_err(|error| {
        lost(format!(
            "cannot write instruments.synchroniser.transcript {}: {error}",
            path.display()
        ))
    })?;
    open_on(Box::new(RecordedLine::new(line, Transcript::to_writer(file))), settings, timing)
}

/// As [`open`], on an open line, for example one with a transcript or injected faults.
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
