//! The laser is made safe and read back, whatever happens to the run: a panic of the run loop, a
//! process that is told to exit at once, a trigger source that becomes too fast.
//!
//! Uses the real run loop and driver, a simulated pulse generator on a pseudo-terminal, and cameras
//! that respond to its triggers.

// This whole crate is a test; clippy's exception covers only functions marked as tests.
#![allow(clippy::unwrap_used)]

mod bench;
mod lost;
mod panics;
mod told_to_end;
mod trigger_source;
