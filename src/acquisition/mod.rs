//! From triggers to shots: owns cameras and synchroniser, fires bounded bursts, pairs the frames,
//! and keeps the ledger.
//!
//! Blocking device calls run on one thread per device. The run loop ([`acquire`]) is a task that
//! fires and handles events. [`pairing`] is a state machine without clocks or devices that decides
//! which frames belong together. The [`Ledger`] accounts for every trigger.
//!
//! On every exit, including errors and panics, the synchroniser is made safe first. Its thread is
//! owned outside the run loop's task ([`SynchroniserThread`]), which waits for it.

mod absence;
mod bench;
mod bench_loss;
mod burst;
mod clock;
mod control;
mod controller;
mod decisions;
mod devices;
mod error;
mod gate;
mod heartbeat;
pub mod journal;
mod kernel_clock;
mod ledger;
mod loss;
mod outcome;
pub mod pairing;
mod presence;
mod queue;
mod record;
pub mod replay;
mod requests;
mod settings;
mod shot;
mod synchroniser;
mod trigger_times;

pub use bench::{Bench, Reconnection, Reopen};
pub use clock::{HostClock, RunClock};
pub use control::{Command, Control, ControlInbox, ControlState, Mode, Planner, Refusal, control};
pub use controller::{AcquisitionLinks, AcquisitionReport, acquire};
pub use devices::panic_message;
pub use error::AcquisitionError;
pub use heartbeat::Heartbeat;
pub use journal::Journal;
pub use kernel_clock::{KernelClock, kernel_clock};
pub use ledger::{Ledger, LedgerError, TriggerEntry};
pub use outcome::{Account, Outcome, OutcomeCounts};
pub use queue::{Closed, ShotReceiver, ShotSender, shot_queue};
pub use settings::{
    AcquisitionSettings, AfterBenchLoss, BurstScript, OverloadPolicy, ScriptedBurst,
};
pub use shot::Shot;
pub use synchroniser::{SynchroniserThread, secure};
pub use trigger_times::{BurstStart, ClockPair};
