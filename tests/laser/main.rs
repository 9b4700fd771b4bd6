//! The laser is made safe, and read back, whatever becomes of the run: a run loop that panics, a
//! process that is told to end at once, a source of triggers that becomes too fast.
//!
//! The real run loop and the real driver, a simulated pulse generator at a pseudo-terminal, and
//! cameras that answer its triggers.

// All of this crate is test; clippy's exception covers only the functions marked as such.
#![allow(clippy::unwrap_used)]

mod bench;
mod lost;
mod panics;
mod told_to_end;
mod trigger_source;
