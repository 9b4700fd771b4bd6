//! Simulated instruments behind the wires that real ones have: the daemon's own drivers reach
//! them, and nothing in the daemon knows the difference.

#[cfg(feature = "aravis")]
pub mod camera;
