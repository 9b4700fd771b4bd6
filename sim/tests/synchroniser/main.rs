//! The synchroniser drivers against simulated units on real pseudo-terminals.

// All of this crate is test; clippy's exception covers only the functions marked as such.
#![allow(clippy::unwrap_used)]

mod bench;
mod command_table;
mod faults;
mod faulty_line;
mod firing;
mod killed;
mod olt_sync;
mod safe_state;
mod simulated_time;
mod trigger_source;
mod watched_source;
