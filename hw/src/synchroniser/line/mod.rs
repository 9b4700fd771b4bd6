//! A serial line: bytes in both directions, with timeouts.
//!
//! Drivers use a [`Dialogue`] over a [`Line`]. [`SerialLine`] is a real port. [`RecordedLine`] and
//! fault injectors wrap any other line, so that they see the bytes on the wire.

mod dialogue;
mod serial;
mod transcript;

use std::{
    io, thread,
    time::{Duration, Instant},
};

pub use dialogue::{Dialogue, LineError};
pub use serial::SerialLine;
pub use transcript::{Direction, RecordedLine, Transcript, TranscriptEntry};

/// A bidirectional byte stream.
pub trait Line: Send {
    /// Name of the port, for messages.
    fn name(&self) -> &str;
    /// Sends all bytes.
    fn send(&mut self, bytes: &[u8]) -> io::Result<()>;
    /// Received bytes; waits up to `at_most` for the first one. Empty on timeout.
    fn receive(&mut self, at_most: Duration) -> io::Result<Vec<u8>>;
    /// Sets the baud rate of the port.
    fn set_baud_rate(&mut self, baud_rate: u32) -> io::Result<()>;
    /// The clock for timeouts: the host's, unless a simulated line has its own.
    fn now(&self) -> Instant {
        Instant::now()
    }
    /// Waits on that clock.
    fn pause(&self, time: Duration) {
        thread::sleep(time);
    }
}

impl<L: Line + ?Sized> Line for Box<L> {
    fn name(&self) -> &str {
        (**self).name()
    }

    fn send(&mut self, bytes: &[u8]) -> io::Result<()> {
        (**self).send(bytes)
    }

    fn receive(&mut self, at_most: Duration) -> io::Result<Vec<u8>> {
        (**self).receive(at_most)
    }

    fn set_baud_rate(&mut self, baud_rate: u32) -> io::Result<()> {
        (**self).set_baud_rate(baud_rate)
    }
    fn now(&self) -> Instant {
        (**self).now()
    }

    fn pause(&self, time: Duration) {
        (**self).pause(time);
    }
}
