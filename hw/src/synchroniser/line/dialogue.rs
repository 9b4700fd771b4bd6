//! Command–reply dialogue over a line that may echo, garble or fall silent.

use std::{
    io,
    time::{Duration, Instant},
};

use thiserror::Error;

use super::Line;

/// Why there is no reply.
#[derive(Debug, Error)]
pub enum LineError {
    /// The port was removed.
    #[error("the serial line {port} is lost: {source}")]
    Lost { port: String, source: io::Error },
    /// No reply in time, or none that fits the command.
    #[error(
        "no reply to {command:?} within {waited_ms} ms on {port}{}",
        received_instead(received)
    )]
    Silent { port: String, command: String, waited_ms: u128, received: String },
}

fn received_instead(received: &str) -> String {
    if received.is_empty() { String::new() } else { format!(", but {received:?}") }
}

/// Sends command lines and finds their replies.
///
/// A line that repeats the command is its echo. Empty lines and lines that cannot be a reply are logged
/// and skipped. After a command without a reply the dialogue is *out of step*: the next line may be the
/// late reply. The driver must then resynchronise with a command whose reply is unambiguous before it
/// trusts any other.
pub struct Dialogue {
    line: Box<dyn Line>,
    pacing: Duration,
    reply_timeout: Duration,
    /// Earliest time of the next command.
    free_from: Instant,
    /// Bytes of an incomplete line.
    partial: Vec<u8>,
    /// Whether the unit echoes commands; unknown before the first reply.
    echo: Option<bool>,
    out_of_step: bool,
    /// When the last command was sent.
    sent: Instant,
}

impl Dialogue {
    /// Waits `pacing` between a reply and the next command, and up to `reply_timeout` for replies.
    pub fn new(line: Box<dyn Line>, pacing: Duration, reply_timeout: Duration) -> Self {
        let now = line.now();
        Self {
            line,
            pacing,
            reply_timeout,
            free_from: now,
            partial: Vec::new(),
            echo: None,
            out_of_step: false,
            sent: now,
        }
    }

    /// The time on the line's clock.
    pub fn now(&self) -> Instant {
        self.line.now()
    }

    /// When the last command was sent, after its pacing.
    pub fn last_sent(&self) -> Instant {
        self.sent
    }

    /// Name of the port, for messages.
    pub fn port(&self) -> &str {
        self.line.name()
    }

    /// Whether the unit echoes commands; `None` before the first reply.
    pub fn echo(&self) -> Option<bool> {
        self.echo
    }

    /// Whether a late reply may still arrive.
    pub fn is_out_of_step(&self) -> bool {
        self.out_of_step
    }

    /// Sets the baud rate of the port.
    pub fn set_baud_rate(&mut self, baud_rate: u32) -> Result<(), LineError> {
        self.partial.clear();
        self.line.set_baud_rate(baud_rate).map_err(|source| self.lost(source))
    }

    /// Sends a command without waiting for its reply, which leaves the dialogue out of step.
    pub fn send(&mut self, command: &str) -> Result<(), LineError> {
        self.line.pause(self.free_from.saturating_duration_since(self.now()));
        self.discard_stale()?;
        self.sent = self.now();
        let sent = self.line.send(format!("{command}\r\n").as_bytes());
        self.free_from = self.now() + self.pacing;
        self.out_of_step = true;
        sent.map_err(|source| self.lost(source))
    }

    /// Sends a command and returns the first line that `accept` recognises as its reply.
    ///
    /// # Errors
    ///
    /// The port is lost, or no such reply arrived in time.
    pub fn ask(
        &mut self,
        command: &str,
        accept: impl Fn(&str) -> bool,
    ) -> Result<String, LineError> {
        let was_out_of_step = self.out_of_step;
        self.send(command)?;
        let deadline = self.now() + self.reply_timeout;
        let mut echoed = false;
        let mut received = Vec::new();
        while let Some(text) = self.next_line(deadline)? {
            if text.eq_ignore_ascii_case(command) {
                echoed = true;
            } else if accept(&text) {
                self.note_echo(echoed);
                self.out_of_step = was_out_of_step;
                self.free_from = self.now() + self.pacing;
                return Ok(text);
            } else {
                tracing::warn!(port = self.port(), command, stray = text, "stray line");
                received.push(text);
            }
        }
        if !self.partial.is_empty() {
            received.push(self.partial.escape_ascii().to_string());
        }
        self.partial.clear();
        Err(LineError::Silent {
            port: self.port().to_owned(),
            command: command.to_owned(),
            waited_ms: self.reply_timeout.as_millis(),
            received: received.join(" | "),
        })
    }

    /// Resynchronises with a command whose reply is unambiguous; skips everything before it.
    pub fn resynchronise(
        &mut self,
        command: &str,
        accept: impl Fn(&str) -> bool,
    ) -> Result<String, LineError> {
        let reply = self.ask(command, accept)?;
        self.out_of_step = false;
        Ok(reply)
    }

    fn note_echo(&mut self, echoed: bool) {
        if self.echo != Some(echoed) {
            tracing::debug!(port = self.port(), echo = echoed, "echo");
            self.echo = Some(echoed);
        }
    }

    /// Discards input that arrived before a command.
    fn discard_stale(&mut self) -> Result<(), LineError> {
        let mut stale = std::mem::take(&mut self.partial);
        loop {
            let bytes = self.line.receive(Duration::ZERO).map_err(|source| self.lost(source))?;
            if bytes.is_empty() {
                break;
            }
            stale.extend(bytes);
        }
        // The rest of a line ending is not worth a warning.
        if stale.iter().any(|byte| !matches!(byte, b'\r' | b'\n')) {
            let bytes = stale.escape_ascii().to_string();
            tracing::warn!(port = self.port(), bytes, "stray bytes between commands");
        }
        Ok(())
    }

    /// The next non-empty line; `None` at the deadline.
    fn next_line(&mut self, deadline: Instant) -> Result<Option<String>, LineError> {
        loop {
            if let Some(end) = self.partial.iter().position(|byte| matches!(byte, b'\r' | b'\n')) {
                let line: Vec<u8> = self.partial.drain(..=end).collect();
                let text = printable(&line);
                if !text.is_empty() {
                    return Ok(Some(text));
                }
                continue;
            }
            let left = deadline.saturating_duration_since(self.now());
            let bytes = self.line.receive(left).map_err(|source| self.lost(source))?;
            if bytes.is_empty() && left.is_zero() {
                return Ok(None);
            }
            self.partial.extend(bytes);
        }
    }

    fn lost(&self, source: io::Error) -> LineError {
        LineError::Lost { port: self.port().to_owned(), source }
    }
}

/// The line without control characters.
fn printable(line: &[u8]) -> String {
    let kept = line.iter().filter(|byte| matches!(byte, b' '..=b'~'));
    let text: String = kept.map(|byte| char::from(*byte)).collect();
    text.trim().to_owned()
}

#[cfg(test)]
#[path = "dialogue_tests.rs"]
mod tests;
