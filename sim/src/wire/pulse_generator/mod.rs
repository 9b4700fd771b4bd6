//! A simulated BNC 575: serial dialect, registers, pulses.
//!
//! The state machine is pure: bytes and time in, bytes and pulses out. On a pseudo-terminal it runs in
//! real time:
//!
//! ```no_run
//! use lfpiv_sim::wire::{pty::Served, pulse_generator::PulseGenerator};
//!
//! let unit = PulseGenerator::new(Default::default());
//! let served = Served::start(unit, Box::new(|period| println!("{period:?}")))?;
//! println!("open {}", served.path());
//! # Ok::<(), std::io::Error>(())
//! ```
//!
//! Writes take effect at once, one by one, as in the real unit: a change of several values while it
//! runs is visible half done.

mod dialect;
mod options;
mod registers;

use std::collections::VecDeque;

use super::{
    PeriodOutputs,
    pty::{SerialUnit, Step},
};
use dialect::{Answer, UNAVAILABLE, execute, is_software_trigger};
use registers::Registers;

pub use options::{Pacing, PulseGeneratorOptions, TooSoon};

/// A simulated BNC 575.
#[derive(Debug, Clone)]
pub struct PulseGenerator {
    options: PulseGeneratorOptions,
    registers: Registers,
    /// Bytes of an incomplete line.
    partial: Vec<u8>,
    /// Pending replies, with the time at which they are sent.
    replies: VecDeque<(u64, Vec<u8>)>,
    last_reply_ns: Option<u64>,
    commands: u64,
    /// Command count from which the unit ignores commands and sends no replies.
    silent_from: Option<u64>,
    /// A signal at the trigger input: its period, and the time of its next pulse.
    source: Option<(u64, u64)>,
    /// Periods started by software triggers.
    triggered: Vec<PeriodOutputs>,
}

impl PulseGenerator {
    /// A unit with factory settings, switched on now.
    pub fn new(options: PulseGeneratorOptions) -> Self {
        Self {
            registers: Registers::factory(&options),
            options,
            partial: Vec::new(),
            replies: VecDeque::new(),
            last_reply_ns: None,
            commands: 0,
            silent_from: None,
            source: None,
            triggered: Vec::new(),
        }
    }

    /// Options; may be changed at any time.
    pub fn options(&mut self) -> &mut PulseGeneratorOptions {
        &mut self.options
    }

    /// Pulses of a channel (1 is A) since it was switched on.
    pub fn pulses(&self, channel: u8) -> u64 {
        let index = usize::from(channel).checked_sub(1);
        index.and_then(|index| self.registers.channels.get(index)).map_or(0, |c| c.pulses)
    }

    /// T0 pulses since it was switched on.
    pub fn periods(&self) -> u64 {
        self.registers.system.count
    }

    /// Whether T0 pulses are generated.
    pub fn is_running(&self) -> bool {
        self.registers.system.running
    }

    /// Whether an output (1 is A) is enabled.
    pub fn is_enabled(&self, channel: u8) -> bool {
        let index = usize::from(channel).checked_sub(1);
        index.and_then(|index| self.registers.channels.get(index)).is_some_and(|c| c.enabled)
    }

    /// Commands received since it was switched on.
    pub fn commands(&self) -> u64 {
        self.commands
    }

    /// After `commands` more commands it becomes silent: it ignores commands and sends no replies,
    /// while its outputs continue.
    pub fn silence_after(&mut self, commands: u64) {
        self.silent_from = Some(self.commands + commands);
    }

    /// Ends the silence.
    pub fn end_silence(&mut self) {
        self.silent_from = None;
    }

    /// Connects a signal to the trigger input, or disconnects it.
    pub fn trigger_input(&mut self, rate_hz: Option<f64>) {
        self.source = rate_hz.map(|rate_hz| ((1e9 / rate_hz) as u64, 0));
    }

    fn line(&mut self, line: &str, now_ns: u64) {
        if line.is_empty() {
            return;
        }
        self.commands += 1;
        if self.silent_from.is_some_and(|from| self.commands > from) {
            return;
        }
        let too_soon = self.too_soon(now_ns);
        let answer = match too_soon {
            Some(TooSoon::Unavailable) => Err(UNAVAILABLE),
            Some(TooSoon::Garbled) => self.execute(line.get(1..).unwrap_or_default(), now_ns),
            None => self.execute(line, now_ns),
        };
        let mut reply = Vec::new();
        if self.options.echo {
            reply.extend_from_slice(format!("{line}\r\n").as_bytes());
        }
        reply.extend_from_slice(&self.options.stray);
        let text = answer.unwrap_or_else(|code| format!("?{}", code.0));
        reply.extend_from_slice(format!("{text}\r\n").as_bytes());
        self.replies.push_back((now_ns + self.options.reply_delay_ns, reply));
    }

    fn too_soon(&self, now_ns: u64) -> Option<TooSoon> {
        let pacing = self.options.pacing?;
        let last_ns = self.last_reply_ns?;
        let waiting = !self.replies.is_empty();
        (waiting || now_ns < last_ns + pacing.least_gap_ns).then_some(pacing.too_soon)
    }

    fn execute(&mut self, line: &str, now_ns: u64) -> Answer {
        if is_software_trigger(line) && self.registers.waits_for_trigger() {
            let period = self.registers.period(&self.options, now_ns);
            self.triggered.push(period);
            return Ok("ok".into());
        }
        execute(&mut self.registers, &mut self.options, line, now_ns)
    }

    /// The periods that have started.
    fn periods_until(&mut self, now_ns: u64) -> Vec<PeriodOutputs> {
        let mut periods = std::mem::take(&mut self.triggered);
        while let Some(t0_ns) = self.registers.next_t0_ns().filter(|t0_ns| *t0_ns <= now_ns) {
            periods.push(self.registers.clock(&self.options, t0_ns));
        }
        if let Some((period_ns, mut next_ns)) = self.source {
            if next_ns == 0 {
                next_ns = now_ns;
            }
            while next_ns <= now_ns {
                if self.registers.waits_for_trigger() {
                    periods.push(self.registers.period(&self.options, next_ns));
                }
                next_ns += period_ns.max(1);
            }
            self.source = Some((period_ns, next_ns));
        }
        periods
    }
}

impl SerialUnit for PulseGenerator {
    fn baud_rate(&self) -> u32 {
        self.options.baud_rate
    }

    fn receive(&mut self, bytes: &[u8], now_ns: u64) {
        // Pulses due before the command use the old registers.
        let before = self.periods_until(now_ns);
        self.triggered.extend(before);
        for byte in bytes {
            match byte {
                b'\r' => {}
                b'\n' => {
                    let line = std::mem::take(&mut self.partial);
                    self.line(String::from_utf8_lossy(&line).trim(), now_ns);
                }
                byte => self.partial.push(*byte),
            }
        }
    }

    fn advance(&mut self, now_ns: u64) -> Step {
        let periods = self.periods_until(now_ns);
        let mut bytes = Vec::new();
        while self.replies.front().is_some_and(|(due_ns, _)| *due_ns <= now_ns) {
            bytes.extend(self.replies.pop_front().map(|(_, reply)| reply).unwrap_or_default());
            self.last_reply_ns = Some(now_ns);
        }
        let due = [
            self.registers.next_t0_ns(),
            self.source.map(|(_, next_ns)| next_ns),
            self.replies.front().map(|(due_ns, _)| *due_ns),
        ];
        Step { bytes, periods, wake_ns: due.into_iter().flatten().min() }
    }
}

#[cfg(test)]
mod tests;
