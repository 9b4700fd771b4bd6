//! From triggers to shots.

mod ledger;
pub mod pairing;
mod shot;

pub use ledger::{Account, Ledger, LedgerError, Outcome, OutcomeCounts, TriggerEntry};
pub use shot::Shot;
