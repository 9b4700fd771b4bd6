//! A unit behind a faulty line: the faults of [`FaultyLine`], applied at the unit's end of a
//! pseudo-terminal.

use std::{
    io,
    ops::{Deref, DerefMut},
    sync::{
        Arc,
        atomic::{AtomicU64, Ordering},
    },
    time::Duration,
};

use lfpiv_hw::synchroniser::line::Line;

use super::{
    PeriodOutputs,
    pty::{SerialUnit, Step},
};
use crate::faults::{Clock, FaultRecord, FaultSettings, FaultyLine, LineFault};

/// A unit behind a line with the faults of the `[line]` table of [`FaultSettings`]. One command is one
/// line of text.
pub struct FaultyUnit<U> {
    line: FaultyLine<UnitLine<U>>,
    clock: UnitClock,
    /// Bytes of an incomplete command.
    partial: Vec<u8>,
    is_cut: bool,
}

impl<U: SerialUnit> FaultyUnit<U> {
    /// Puts `unit` behind a faulty line.
    pub fn new(unit: U, settings: &FaultSettings) -> Self {
        let clock = UnitClock::default();
        let line = UnitLine { unit, clock: clock.clone(), periods: Vec::new(), wake_ns: None };
        let line = FaultyLine::timed_by(line, settings, clock.clone());
        Self { line, clock, partial: Vec::new(), is_cut: false }
    }

    /// The injected faults so far.
    pub fn record(&self) -> FaultRecord<LineFault> {
        self.line.record()
    }
}

impl<U> Deref for FaultyUnit<U> {
    type Target = U;

    fn deref(&self) -> &U {
        &self.line.inner().unit
    }
}

impl<U> DerefMut for FaultyUnit<U> {
    fn deref_mut(&mut self) -> &mut U {
        &mut self.line.inner_mut().unit
    }
}

impl<U: SerialUnit> SerialUnit for FaultyUnit<U> {
    fn baud_rate(&self) -> u32 {
        (**self).baud_rate()
    }

    fn receive(&mut self, bytes: &[u8], now_ns: u64) {
        self.clock.show(now_ns);
        for byte in bytes {
            self.partial.push(*byte);
            if *byte == b'\n' {
                let command = std::mem::take(&mut self.partial);
                // The only possible failure is the injected cut.
                self.is_cut |= self.line.send(&command).is_err();
            }
        }
    }

    fn is_cut(&self) -> bool {
        self.is_cut
    }

    fn advance(&mut self, now_ns: u64) -> Step {
        self.clock.show(now_ns);
        let mut bytes = Vec::new();
        loop {
            match self.line.receive(Duration::ZERO) {
                Ok(output) if output.is_empty() => break,
                Ok(output) => bytes.extend(output),
                // The unit continues, unheard.
                Err(_) => {
                    self.line.inner_mut().take_output();
                    break;
                }
            }
        }
        let inner = self.line.inner_mut();
        Step { bytes, periods: std::mem::take(&mut inner.periods), wake_ns: inner.wake_ns }
    }
}

/// The unit, as the far end of the line.
struct UnitLine<U> {
    unit: U,
    clock: UnitClock,
    /// Periods not collected yet.
    periods: Vec<PeriodOutputs>,
    wake_ns: Option<u64>,
}

impl<U: SerialUnit> UnitLine<U> {
    /// Output of the unit up to now.
    fn take_output(&mut self) -> Vec<u8> {
        let Step { bytes, periods, wake_ns } = self.unit.advance(self.clock.now_ns());
        self.periods.extend(periods);
        self.wake_ns = wake_ns;
        bytes
    }
}

impl<U: SerialUnit> Line for UnitLine<U> {
    fn name(&self) -> &str {
        "simulated unit"
    }

    fn send(&mut self, bytes: &[u8]) -> io::Result<()> {
        self.unit.receive(bytes, self.clock.now_ns());
        Ok(())
    }

    fn receive(&mut self, _: Duration) -> io::Result<Vec<u8>> {
        Ok(self.take_output())
    }

    fn set_baud_rate(&mut self, _: u32) -> io::Result<()> {
        Ok(())
    }
}

/// A clock that shows the time passed in; sleeping returns at once.
#[derive(Debug, Clone, Default)]
struct UnitClock(Arc<AtomicU64>);

impl UnitClock {
    fn show(&self, now_ns: u64) {
        self.0.store(now_ns, Ordering::Relaxed);
    }

    fn now_ns(&self) -> u64 {
        self.0.load(Ordering::Relaxed)
    }
}

impl Clock for UnitClock {
    fn now(&self) -> Duration {
        Duration::from_nanos(self.now_ns())
    }

    fn sleep(&self, _: Duration) {}
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{faults::CommandShares, wire::pulse_generator::PulseGenerator};

    const IDENTIFY: &[u8] = b"*IDN?\r\n";

    fn unit(shares: CommandShares) -> FaultyUnit<PulseGenerator> {
        let mut settings = FaultSettings { seed: 1, ..FaultSettings::default() };
        settings.line.shares = shares;
        settings.line.slow_ms = 50;
        FaultyUnit::new(PulseGenerator::new(Default::default()), &settings)
    }

    /// The reply to a command, 1 ms later.
    fn reply(unit: &mut FaultyUnit<PulseGenerator>, command: &[u8]) -> Vec<u8> {
        unit.receive(command, 1_000_000);
        unit.advance(2_000_000).bytes
    }

    #[test]
    fn without_faults_it_is_the_unit() {
        let mut plain = PulseGenerator::new(Default::default());
        let mut faulty = unit(CommandShares::default());
        // A burst of three at 10 kHz, so that periods and wake-up times are compared, too.
        let commands = [
            "*IDN?\r\n",
            ":PULSE0:PER 0.0001\r\n:PULSE5:STA",
            "TE ON\r\n",
            ":PULSE5:CMOD BURS\r\n",
            ":PULSE5:BCO 3\r\n",
            ":PULSE0:STATE ON\r\n",
            ":PULSE0:STATE?\r\n",
            "nonsense\r\n",
        ];
        for (number, command) in commands.into_iter().enumerate() {
            let now_ns = number as u64 * 1_000_000;
            plain.receive(command.as_bytes(), now_ns);
            faulty.receive(command.as_bytes(), now_ns);
            assert_eq!(plain.advance(now_ns + 1), faulty.advance(now_ns + 1), "{command}");
        }
        assert!(faulty.periods() > 0 && faulty.pulses(5) == 3);
        assert_eq!(faulty.record().count(|_| true), 0);
    }

    #[test]
    fn each_fault_matches_its_name_and_is_recorded() {
        let all = |set: fn(&mut CommandShares)| {
            let mut shares = CommandShares::default();
            set(&mut shares);
            unit(shares)
        };
        let identity = reply(&mut unit(CommandShares::default()), IDENTIFY);
        assert!(identity.starts_with(b"BNC,575"));

        let mut lost = all(|shares| shares.lost = 1.0);
        assert_eq!((reply(&mut lost, IDENTIFY), lost.commands()), (Vec::new(), 0));
        let mut silent = all(|shares| shares.silent = 1.0);
        assert_eq!((reply(&mut silent, IDENTIFY), silent.commands()), (Vec::new(), 1));
        assert_eq!(silent.record().count(|fault| *fault == LineFault::Silent), 1);
        let mut busy = all(|shares| shares.unavailable = 1.0);
        assert_eq!((reply(&mut busy, IDENTIFY), busy.commands()), (b"?8\r\n".to_vec(), 0));
        let garbled = reply(&mut all(|shares| shares.garbled = 1.0), IDENTIFY);
        assert_eq!(garbled.iter().zip(&identity).filter(|(a, b)| a != b).count(), 1);
        let stray = reply(&mut all(|shares| shares.stray = 1.0), IDENTIFY);
        assert!(stray.len() > identity.len() && stray.ends_with(&identity));
        let mut slow = all(|shares| shares.slow = 1.0);
        assert_eq!(reply(&mut slow, IDENTIFY), Vec::<u8>::new());
        assert_eq!(slow.advance(51_000_000).bytes, Vec::<u8>::new());
        assert_eq!(slow.advance(52_000_001).bytes, identity);
    }

    #[test]
    fn a_cut_line_leaves_the_unit_to_its_burst() {
        let mut settings = FaultSettings::default();
        settings.line.cut_after = Some(2);
        let mut unit = FaultyUnit::new(PulseGenerator::new(Default::default()), &settings);
        unit.receive(b":PULSE0:PER 0.001\r\n:PULSE0:STATE ON\r\n", 0);
        unit.advance(0);
        assert!(!unit.is_cut());
        unit.receive(b":PULSE0:STATE OFF\r\n", 1_000_000);
        assert!(unit.is_cut() && unit.is_running());
        let step = unit.advance(5_000_000);
        assert!(step.bytes.is_empty() && step.periods.len() >= 4, "{step:?}");
    }
}
