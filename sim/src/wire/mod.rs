//! Simulated instruments behind the wires that real ones have: the daemon's own drivers reach
//! them, and nothing in the daemon knows the difference.
//!
//! [`camera`] is a GigE Vision camera on the network. [`pulse_generator`] and [`olt_sync`] are
//! synchronisers on a pseudo-terminal ([`pty`]). What is programmed in them decides, period by
//! period, which pulses come out ([`PeriodOutputs`]), and [`exposure`] says what laser and cameras
//! make of those. [`bench`] is all of it, wired together.

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

/// The pulses that a synchroniser gives in one period.
#[derive(Debug, Clone, PartialEq)]
pub struct PeriodOutputs {
    /// T0 on the unit's clock, in ns.
    pub t0_ns: u64,
    /// In the order of their channels.
    pub pulses: Vec<OutputPulse>,
}

/// A pulse at one output.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct OutputPulse {
    /// 1 for A.
    pub channel: u8,
    /// Rising edge after T0, in µs.
    pub start_us: f64,
    /// In µs.
    pub width_us: f64,
}
