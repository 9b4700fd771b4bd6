//! From triggers to shots: owns cameras and synchroniser, fires bounded bursts, pairs what comes
//! back, and keeps the ledger.
//!
//! A thread per device makes the blocking calls; the run loop ([`acquire`]) is a task that fires,
//! listens and waits; [`pairing`] decides, as a state machine without clocks or devices, which
//! frames belong together; the [`Ledger`] accounts for every trigger.
//!
//! On every way out, errors and panics included, the synchroniser is made safe first.

mod absence;
mod burst;
mod controller;
mod devices;
mod error;
mod heartbeat;
mod ledger;
mod outcome;
pub mod pairing;
mod rulings;
mod settings;
mod shot;

pub use controller::{AcquisitionReport, Bench, acquire, secure};
pub use devices::panic_message;
pub use error::AcquisitionError;
pub use heartbeat::Heartbeat;
pub use ledger::{Ledger, LedgerError, TriggerEntry};
pub use outcome::{Account, Outcome, OutcomeCounts};
pub use settings::{AcquisitionSettings, MAX_BURST, OverloadPolicy};
pub use shot::Shot;
