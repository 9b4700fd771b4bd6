//! A serial port of the operating system.

use std::{
    io::{self, ErrorKind, Read, Write},
    time::Duration,
};

use serialport::{ClearBuffer, DataBits, FlowControl, Parity, SerialPort, StopBits, TTYPort};

use super::Line;

/// Timeout of a blocked write.
const WRITE_TIMEOUT: Duration = Duration::from_secs(1);

/// A serial port: 8 data bits, no parity, 1 stop bit, no flow control, opened exclusively.
#[derive(Debug)]
pub struct SerialLine {
    name: String,
    port: TTYPort,
}

impl SerialLine {
    /// Opens the port at `path`.
    ///
    /// # Errors
    ///
    /// The port does not exist, cannot be opened, or is in use by another process.
    pub fn open(path: &str, baud_rate: u32) -> io::Result<Self> {
        let builder = serialport::new(path, baud_rate)
            .data_bits(DataBits::Eight)
            .parity(Parity::None)
            .stop_bits(StopBits::One)
            .flow_control(FlowControl::None)
            .timeout(WRITE_TIMEOUT);
        let port = TTYPort::open(&builder)?;
        // Input from before is no reply to our commands.
        port.clear(ClearBuffer::Input)?;
        Ok(Self { name: path.to_owned(), port })
    }
}

impl Line for SerialLine {
    fn name(&self) -> &str {
        &self.name
    }

    fn send(&mut self, bytes: &[u8]) -> io::Result<()> {
        self.port.set_timeout(WRITE_TIMEOUT)?;
        self.port.write_all(bytes)
    }

    fn receive(&mut self, at_most: Duration) -> io::Result<Vec<u8>> {
        self.port.set_timeout(at_most)?;
        let mut buffer = [0; 256];
        match self.port.read(&mut buffer) {
            // A port that is readable but returns no bytes was removed.
            Ok(0) => Err(ErrorKind::BrokenPipe.into()),
            Ok(count) => Ok(buffer[..count].to_vec()),
            Err(error) if matches!(error.kind(), ErrorKind::TimedOut | ErrorKind::Interrupted) => {
                Ok(Vec::new())
            }
            Err(error) => Err(error),
        }
    }

    fn set_baud_rate(&mut self, baud_rate: u32) -> io::Result<()> {
        self.port.set_baud_rate(baud_rate)?;
        Ok(self.port.clear(ClearBuffer::Input)?)
    }
}
