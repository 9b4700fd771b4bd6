//! The synchroniser drivers against simulated units on real pseudo-terminals.

mod bench;
mod command_table;
mod faults;
mod firing;
mod killed;
mod olt_sync;
mod safe_state;
mod trigger_source;
