//! Transcript of a line: every byte with the host's time.

use std::{
    fmt,
    io::{self, Write},
    sync::{Arc, Mutex, PoisonError},
    time::{Duration, Instant, SystemTime, UNIX_EPOCH},
};

use serde::{Deserialize, Serialize};

use super::Line;

/// Direction of bytes.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Direction {
    /// From the host to the unit.
    ToUnit,
    /// From the unit to the host.
    ToHost,
}

/// Bytes sent or received in one piece.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct TranscriptEntry {
    /// Host clock, in ns since the Unix epoch.
    pub host_time_ns: u64,
    /// Their direction.
    pub direction: Direction,
    /// The bytes.
    pub bytes: Vec<u8>,
}

/// A line of a transcript file: seconds since the Unix epoch, `>` to the unit or `<` to the host, and
/// the bytes with everything but printable ASCII escaped.
impl fmt::Display for TranscriptEntry {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        let (seconds, ns) = (self.host_time_ns / 1_000_000_000, self.host_time_ns % 1_000_000_000);
        let arrow = match self.direction {
            Direction::ToUnit => '>',
            Direction::ToHost => '<',
        };
        write!(formatter, "{seconds}.{ns:09} {arrow} {}", self.bytes.escape_ascii())
    }
}

/// Destination of entries. Clones share it.
#[derive(Clone)]
pub struct Transcript {
    sink: Arc<Mutex<Sink>>,
}

enum Sink {
    Kept(Vec<TranscriptEntry>),
    Written(Box<dyn Write + Send>),
    Told(Box<dyn FnMut(TranscriptEntry) + Send>),
}

impl Transcript {
    /// Keeps every entry in memory.
    pub fn in_memory() -> Self {
        Self { sink: Arc::new(Mutex::new(Sink::Kept(Vec::new()))) }
    }

    /// Writes every entry as a line and flushes it, so that it survives a crash.
    pub fn to_writer(writer: impl Write + Send + 'static) -> Self {
        Self { sink: Arc::new(Mutex::new(Sink::Written(Box::new(writer)))) }
    }

    /// Passes every entry to `listener`, on the thread that uses the line.
    pub fn to_listener(listener: impl FnMut(TranscriptEntry) + Send + 'static) -> Self {
        Self { sink: Arc::new(Mutex::new(Sink::Told(Box::new(listener)))) }
    }

    /// The entries so far; empty unless they are kept in memory.
    pub fn entries(&self) -> Vec<TranscriptEntry> {
        match &*self.sink.lock().unwrap_or_else(PoisonError::into_inner) {
            Sink::Kept(entries) => entries.clone(),
            Sink::Written(_) | Sink::Told(_) => Vec::new(),
        }
    }

    /// The lines sent to the unit, without line endings.
    pub fn sent_lines(&self) -> Vec<String> {
        let entries = self.entries();
        let sent = entries.iter().filter(|entry| entry.direction == Direction::ToUnit);
        let bytes: Vec<u8> = sent.flat_map(|entry| entry.bytes.clone()).collect();
        String::from_utf8_lossy(&bytes).lines().map(str::to_owned).collect()
    }

    fn note(&self, direction: Direction, bytes: &[u8]) -> io::Result<()> {
        let now = SystemTime::now().duration_since(UNIX_EPOCH).unwrap_or_default();
        let host_time_ns = u64::try_from(now.as_nanos()).unwrap_or(u64::MAX);
        let entry = TranscriptEntry { host_time_ns, direction, bytes: bytes.to_vec() };
        match &mut *self.sink.lock().unwrap_or_else(PoisonError::into_inner) {
            Sink::Kept(entries) => entries.push(entry),
            Sink::Told(listener) => listener(entry),
            Sink::Written(writer) => {
                writeln!(writer, "{entry}")?;
                writer.flush()?;
            }
        }
        Ok(())
    }
}

/// A line with a transcript. If the transcript cannot be written, it ends with a warning; the line to
/// the laser matters more.
pub struct RecordedLine<L> {
    line: L,
    transcript: Option<Transcript>,
}

impl<L: Line> RecordedLine<L> {
    /// Records the bytes of `line`.
    pub fn new(line: L, transcript: Transcript) -> Self {
        Self { line, transcript: Some(transcript) }
    }

    fn note(&mut self, direction: Direction, bytes: &[u8]) {
        let Some(transcript) = &self.transcript else { return };
        if let Err(error) = transcript.note(direction, bytes) {
            tracing::warn!(port = self.line.name(), %error, "the serial transcript ends here");
            self.transcript = None;
        }
    }
}

impl<L: Line> Line for RecordedLine<L> {
    fn name(&self) -> &str {
        self.line.name()
    }

    fn send(&mut self, bytes: &[u8]) -> io::Result<()> {
        // Before sending, so that a reply never precedes its command.
        self.note(Direction::ToUnit, bytes);
        self.line.send(bytes)
    }

    fn receive(&mut self, at_most: Duration) -> io::Result<Vec<u8>> {
        let bytes = self.line.receive(at_most)?;
        if !bytes.is_empty() {
            self.note(Direction::ToHost, &bytes);
        }
        Ok(bytes)
    }

    fn set_baud_rate(&mut self, baud_rate: u32) -> io::Result<()> {
        self.line.set_baud_rate(baud_rate)
    }

    fn now(&self) -> Instant {
        self.line.now()
    }

    fn pause(&self, time: Duration) {
        self.line.pause(time);
    }
}
