//! From triggers to shots: owns cameras and synchroniser, fires bounded bursts, pairs what comes
//! back, and keeps the ledger.
//!
//! A thread per device makes the blocking calls; the run loop ([`acquire`]) is a task that fires,
//! listens and waits; [`pairing`] decides, as a state machine without clocks or devices, which
//! frames belong together; the [`Ledger`] accounts for every trigger.
//!
//! On every way out, errors and panics included, the synchroniser is made safe first. Its thread is
//! owned outside the task of the run loop ([`SynchroniserThread`]), and waited for.

mod absence;
mod bench_loss;
mod burst;
mod clock;
mod control;
mod controller;
mod devices;
mod error;
mod gate;
mod heartbeat;
pub mod journal;
mod kernel_clock;
mod ledger;
mod outcome;
pub mod pairing;
mod presence;
mod queue;
mod record;
pub mod replay;
mod requests;
mod rulings;
mod settings;
mod shot;
mod synchroniser;
mod trigger_times;

pub use bench_loss::Reconnection;
pub use clock::{HostClock, RunClock};
pub use control::{Command, Control, ControlInbox, ControlState, Mode, Planner, Refusal, control};
pub use controller::{AcquisitionLinks, AcquisitionReport, Bench, acquire};
pub use devices::panic_message;
pub use error::AcquisitionError;
pub use heartbeat::Heartbeat;
pub use journal::Journal;
pub use kernel_clock::{KernelClock, kernel_clock};
pub use ledger::{Ledger, LedgerError, TriggerEntry};
pub use outcome::{Account, Outcome, OutcomeCounts};
pub use queue::{Closed, ShotReceiver, ShotSender, shot_queue};
pub use settings::{
    AcquisitionSettings, AfterBenchLoss, BurstScript, MAX_BURST, OverloadPolicy, ScriptedBurst,
};
pub use shot::Shot;
pub use synchroniser::{Reopen, SynchroniserThread, secure};
pub use trigger_times::{BurstStart, ClockPair};
