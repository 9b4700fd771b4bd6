//! A serial line with injected faults.

use std::{
    collections::VecDeque,
    io,
    time::{Duration, Instant},
};

use lfpiv_hw::synchroniser::line::Line;
use rand::{RngExt, seq::IndexedRandom};
use rand_pcg::Pcg64Mcg;

use super::{Clock, FaultRecord, FaultSettings, LineFaults, SystemClock, draw};
use crate::stream::{Purpose, random_stream};

/// A fault of a command or its reply.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum LineFault {
    /// The command did not reach the unit.
    Lost,
    /// The unit received it, and its reply was lost.
    Silent,
    /// The reply was delayed.
    Slow,
    /// Random bytes preceded the reply.
    Stray,
    /// One byte of the reply was changed.
    Garbled,
    /// It was answered with `?8` and did not reach the unit.
    Unavailable,
    /// The line was cut before it.
    Cut,
}

/// Most stray bytes before a reply.
const MAX_STRAY_BYTES: usize = 8;

/// Any serial line, with the faults of [`LineFaults`]. One call of `send` is one command; all bytes
/// received until the next one are its reply.
pub struct FaultyLine<L> {
    line: L,
    faults: LineFaults,
    seed: u64,
    clock: Box<dyn Clock>,
    record: FaultRecord<LineFault>,
    commands: u64,
    /// Fault of the pending reply, with its random stream.
    reply: Option<(LineFault, Pcg64Mcg)>,
    /// Bytes for the host, with the time at which each piece becomes available.
    incoming: VecDeque<(Duration, Vec<u8>)>,
}

impl<L> FaultyLine<L> {
    /// The wrapped line.
    pub(crate) fn inner(&self) -> &L {
        &self.line
    }

    /// The wrapped line.
    pub(crate) fn inner_mut(&mut self) -> &mut L {
        &mut self.line
    }
}

impl<L: Line> FaultyLine<L> {
    /// Wraps a line.
    pub fn new(line: L, settings: &FaultSettings) -> Self {
        Self::timed_by(line, settings, SystemClock::default())
    }

    /// As [`Self::new`], with delays on `clock`.
    pub fn timed_by(line: L, settings: &FaultSettings, clock: impl Clock + 'static) -> Self {
        Self {
            line,
            faults: settings.line.clone(),
            seed: settings.seed,
            clock: Box::new(clock),
            record: FaultRecord::default(),
            commands: 0,
            reply: None,
            incoming: VecDeque::new(),
        }
    }

    /// The injected faults so far.
    pub fn record(&self) -> FaultRecord<LineFault> {
        self.record.clone()
    }

    fn check_cable(&self) -> io::Result<()> {
        match self.faults.cut_after.is_some_and(|after| self.commands > after) {
            true => Err(io::Error::new(io::ErrorKind::BrokenPipe, "cut on purpose")),
            false => Ok(()),
        }
    }

    /// Receives bytes from the unit.
    fn take(&mut self, mut bytes: Vec<u8>) {
        let mut due = self.clock.now();
        match &mut self.reply {
            Some((LineFault::Lost | LineFault::Silent | LineFault::Unavailable, _)) => return,
            Some((LineFault::Slow, _)) => due += Duration::from_millis(self.faults.slow_ms),
            Some((LineFault::Stray, rng)) => {
                let count = rng.random_range(1..=MAX_STRAY_BYTES);
                let stray: Vec<u8> = (0..count).map(|_| rng.random()).collect();
                bytes.splice(0..0, stray);
                // Once per reply, however many pieces it has.
                self.reply = None;
            }
            Some((LineFault::Garbled, rng)) => {
                let place = rng.random_range(0..bytes.len());
                let others: Vec<u8> = (0..=u8::MAX).filter(|byte| *byte != bytes[place]).collect();
                bytes[place] = others.choose(rng).copied().unwrap_or_default();
                self.reply = None;
            }
            Some((LineFault::Cut, _)) | None => {}
        }
        // Bytes are never reordered.
        let last_due = self.incoming.back().map_or(due, |(last, _)| due.max(*last));
        self.incoming.push_back((last_due, bytes));
    }

    /// The next available bytes.
    fn release(&mut self) -> Option<Vec<u8>> {
        let now = self.clock.now();
        let due = self.incoming.front().is_some_and(|(due, _)| *due <= now);
        if due { self.incoming.pop_front().map(|(_, bytes)| bytes) } else { None }
    }
}

impl<L: Line> Line for FaultyLine<L> {
    fn name(&self) -> &str {
        self.line.name()
    }

    fn send(&mut self, bytes: &[u8]) -> io::Result<()> {
        let number = self.commands;
        self.commands += 1;
        self.record.take();
        if let Err(cut) = self.check_cable() {
            self.record.note(number, LineFault::Cut);
            return Err(cut);
        }
        let mut rng = random_stream(Purpose::LineFaults, &[self.seed, number]);
        let fault = draw(&self.faults.shares.by_fault(), &mut rng);
        if let Some(fault) = fault {
            self.record.note(number, fault);
        }
        self.reply = fault.map(|fault| (fault, rng));
        match fault {
            Some(LineFault::Lost) => return Ok(()),
            Some(LineFault::Unavailable) => {
                self.incoming.push_back((self.clock.now(), b"?8\r\n".to_vec()));
                return Ok(());
            }
            _ => {}
        }
        self.record.give();
        self.line.send(bytes)
    }

    fn receive(&mut self, at_most: Duration) -> io::Result<Vec<u8>> {
        let deadline = self.clock.now() + at_most;
        loop {
            self.check_cable()?;
            if let Some(bytes) = self.release() {
                return Ok(bytes);
            }
            let due = self.incoming.front().map_or(deadline, |(due, _)| deadline.min(*due));
            let bytes = self.line.receive(due.saturating_sub(self.clock.now()))?;
            match bytes.is_empty() {
                false => self.take(bytes),
                true => self.clock.sleep(due.saturating_sub(self.clock.now())),
            }
            if self.clock.now() >= deadline {
                return Ok(self.release().unwrap_or_default());
            }
        }
    }

    fn set_baud_rate(&mut self, baud_rate: u32) -> io::Result<()> {
        self.check_cable()?;
        self.line.set_baud_rate(baud_rate)
    }

    fn now(&self) -> Instant {
        self.line.now()
    }

    fn pause(&self, time: Duration) {
        self.line.pause(time);
    }
}
