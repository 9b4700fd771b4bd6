//! What a bench at the ends of wires delivers.

use serde::{Deserialize, Serialize};

/// What came over the wires.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct Streamed {
    /// Shots whose frames all arrived whole.
    pub whole_shots: u64,
    /// From the first command to the synchroniser to its safe state, in s.
    pub seconds: f64,
    /// Processor time, that of the simulated instruments included, in s.
    pub processor_seconds: f64,
    /// Frames that arrived whole, per second and camera.
    pub frames_per_s: f64,
    /// Pixel data as sent, per second and camera, in MB.
    pub mb_per_s: f64,
    /// Copies of a frame's pixels from the buffer that the network's packets are put together in.
    pub copies_per_frame: usize,
}
