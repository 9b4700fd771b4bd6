//! Simulated instruments on real wires, used through the daemon's own drivers.
//!
//! [`camera`] is a GigE Vision camera on the network. [`pulse_generator`] and [`olt_sync`] are
//! synchronisers on a pseudo-terminal ([`pty`]). Their programming determines the pulses of each period
//! ([`PeriodOutputs`]), and [`exposure`] converts pulses to light in exposures. [`bench`] connects
//! everything.

#[cfg(feature = "aravis")]
pub mod bench;
#[cfg(feature = "aravis")]
pub mod camera;
pub mod exposure;
mod faulty_unit;
#[cfg(feature = "aravis")]
mod frame_faults;
pub mod olt_sync;
mod pictures;
pub mod pty;
pub mod pulse_generator;
mod settings;

pub use faulty_unit::FaultyUnit;
pub use pictures::{Delivery, Pictures, ScenePictures};
pub use settings::WireSettings;

/// The pulses of a synchroniser in one period.
#[derive(Debug, Clone, PartialEq)]
pub struct PeriodOutputs {
    /// T0 on the unit's clock, in ns.
    pub t0_ns: u64,
    /// In the order of the channels.
    pub pulses: Vec<OutputPulse>,
}

/// A pulse at one output.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct OutputPulse {
    /// 1 for A.
    pub channel: u8,
    /// Rising edge relative to T0, in µs.
    pub start_us: f64,
    /// In µs.
    pub width_us: f64,
}
