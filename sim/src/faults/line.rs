//! A serial line that loses, delays and garbles.

use std::{
    collections::VecDeque,
    io,
    time::{Duration, Instant},
};

use lfpiv_hw::synchroniser::line::Line;
use rand::{RngExt, seq::IndexedRandom};
use rand_pcg::Pcg64Mcg;

use super::{Clock, FaultRecord, FaultSettings, HostClock, LineFaults, draw};
use crate::stream::{Purpose, random_stream};

/// What happens to a command or its reply.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum LineFault {
    /// The command did not reach the unit.
    Lost,
    /// The unit heard it, and its reply was lost.
    Silent,
    /// The reply came late.
    Slow,
    /// Random bytes came before the reply.
    Stray,
    /// One byte of the reply was another one.
    Garbled,
    /// It was answered `?8` and did not reach the unit.
    Unavailable,
    /// The line was cut before it.
    Cut,
}

/// Most stray bytes before a reply.
const MOST_STRAY_BYTES: usize = 8;

/// Any serial line, disturbed as [`LineFaults`] says. What is sent at once counts as one command;
/// what comes until the next one is its reply.
pub struct FaultyLine<L> {
    line: L,
    faults: LineFaults,
    seed: u64,
    clock: Box<dyn Clock>,
    record: FaultRecord<LineFault>,
    commands: u64,
    /// What happens to the reply that is waited for, and the random stream that it draws from.
    reply: Option<(LineFault, Pcg64Mcg)>,
    /// Bytes for the host, each piece with the time from which it may be heard.
    incoming: VecDeque<(Duration, Vec<u8>)>,
}

impl<L> FaultyLine<L> {
    /// The line that is disturbed.
    pub(crate) fn inner(&self) -> &L {
        &self.line
    }

    /// The line that is disturbed.
    pub(crate) fn inner_mut(&mut self) -> &mut L {
        &mut self.line
    }
}

impl<L: Line> FaultyLine<L> {
    /// Wraps a line.
    pub fn new(line: L, settings: &FaultSettings) -> Self {
        Self::timed_by(line, settings, HostClock::default())
    }

    /// As [`Self::new`], with delays measured by `clock`.
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

    /// What is done to this line, as it happens.
    pub fn record(&self) -> FaultRecord<LineFault> {
        self.record.clone()
    }

    fn check_cable(&self) -> io::Result<()> {
        match self.faults.cut_after.is_some_and(|after| self.commands > after) {
            true => Err(io::Error::new(io::ErrorKind::BrokenPipe, "cut on purpose")),
            false => Ok(()),
        }
    }

    /// Bytes have come from the unit.
    fn take(&mut self, mut bytes: Vec<u8>) {
        let mut due = self.clock.now();
        match &mut self.reply {
            Some((LineFault::Lost | LineFault::Silent | LineFault::Unavailable, _)) => return,
            Some((LineFault::Slow, _)) => due += Duration::from_millis(self.faults.slow_ms),
            Some((LineFault::Stray, rng)) => {
                let count = rng.random_range(1..=MOST_STRAY_BYTES);
                let stray: Vec<u8> = (0..count).map(|_| rng.random()).collect();
                bytes.splice(0..0, stray);
                // Once for each reply, however many pieces it comes in.
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
        // Bytes never overtake each other.
        let last_due = self.incoming.back().map_or(due, |(last, _)| due.max(*last));
        self.incoming.push_back((last_due, bytes));
    }

    /// The next bytes that may be heard.
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
