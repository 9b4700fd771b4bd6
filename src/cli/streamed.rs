//! Measured throughput of a bench on real wires.

use serde::{Deserialize, Serialize};

/// Throughput of a bench.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct Streamed {
    /// Shots whose frames were all received completely.
    pub whole_shots: u64,
    /// Time from the first command to the synchroniser to its safe state, in s.
    pub seconds: f64,
    /// Processor time, including that of the simulated instruments, in s.
    pub processor_seconds: f64,
    /// Completely received frames, per second and camera.
    pub frames_per_s: f64,
    /// Pixel data as sent, per second and camera, in MB.
    pub mb_per_s: f64,
    /// Copies of a frame's pixels after the buffer in which the packets are assembled.
    pub copies_per_frame: usize,
}
