//! A serial line: bytes out, bytes in, with time-outs.
//!
//! Drivers speak through a [`Dialogue`] over a [`Line`]. [`SerialLine`] is a real port;
//! [`Recorded`] and fault injectors wrap any other line, so that what is recorded or disturbed is
//! what went over the wire.

mod dialogue;
mod serial;
mod transcript;

use std::{
    io, thread,
    time::{Duration, Instant},
};

pub use dialogue::{Dialogue, LineError};
pub use serial::SerialLine;
pub use transcript::{Direction, Entry, Recorded, Transcript};

/// Bytes both ways.
pub trait Line: Send {
    /// The port, for messages.
    fn name(&self) -> &str;
    /// Sends all bytes.
    fn send(&mut self, bytes: &[u8]) -> io::Result<()>;
    /// What has come, waiting for the first byte at most `at_most`; empty when nothing came.
    fn receive(&mut self, at_most: Duration) -> io::Result<Vec<u8>>;
    /// Changes the speed of the port, in baud.
    fn set_baud_rate(&mut self, baud_rate: u32) -> io::Result<()>;
    /// The time by which replies are late: the host's. A simulated line may have a clock of its own.
    fn now(&self) -> Instant {
        Instant::now()
    }
    /// Lets time pass.
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
