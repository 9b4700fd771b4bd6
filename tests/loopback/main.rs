//! The daemon's acquisition through the drivers of a real bench (GigE Vision and serial), against
//! simulated instruments at the other ends of the wires.
//!
//! Every test has its own network, with two loopback addresses for two cameras.
#![cfg(feature = "aravis")]

mod bench;
mod faults;
mod first_use;
mod focus;
mod killed;
mod lost;
// The driver's own tests use more of it.
#[allow(dead_code)]
#[path = "../../sim/tests/gige/network.rs"]
mod network;
mod replayed;
mod shots;
// Configuration of recorded runs.
#[allow(dead_code)]
#[path = "../recorded_run/bench.rs"]
mod tiny;
