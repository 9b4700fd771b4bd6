//! A unit and its driver in simulated time: hours pass at once, and how long something takes does
//! not depend on how busy the machine is.

use std::{
    io,
    sync::{Arc, Mutex, MutexGuard},
    time::{Duration, Instant},
};

use lfpiv_hw::{
    TimingSettings,
    device::Synchroniser,
    synchroniser::{SynchroniserSettings, line::Line, open_on},
};
use lfpiv_sim::wire::{
    pty::SerialUnit,
    pulse_generator::{PulseGenerator, PulseGeneratorOptions},
};

/// Bits on the line for each byte.
const BITS_PER_BYTE: u32 = 10;

struct State {
    unit: PulseGenerator,
    now: Duration,
    baud_rate: u32,
}

impl State {
    fn now_ns(&self) -> u64 {
        self.now.as_nanos() as u64
    }

    fn transmit(&mut self, bytes: usize) {
        self.now += Duration::from_secs(1) * BITS_PER_BYTE * bytes as u32 / self.baud_rate;
    }

    /// The unit goes on until `end`, or until it says something.
    fn go_on(&mut self, end: Duration) -> Vec<u8> {
        loop {
            let now_ns = self.now_ns();
            let step = self.unit.advance(now_ns);
            if !step.bytes.is_empty() || self.now >= end {
                return step.bytes;
            }
            let wake = Duration::from_nanos(step.wake_ns.unwrap_or(u64::MAX).max(now_ns + 1));
            self.now = end.min(wake);
        }
    }
}

/// Unit and clock. Clones are the same ones.
#[derive(Clone)]
pub struct SimulatedTime {
    state: Arc<Mutex<State>>,
    begun: Instant,
}

impl SimulatedTime {
    pub fn start(options: PulseGeneratorOptions) -> Self {
        let baud_rate = options.baud_rate;
        let unit = PulseGenerator::new(options);
        let state = State { unit, now: Duration::ZERO, baud_rate };
        Self { state: Arc::new(Mutex::new(state)), begun: Instant::now() }
    }

    fn state(&self) -> MutexGuard<'_, State> {
        self.state.lock().unwrap()
    }

    pub fn connect(
        &self,
        settings: &SynchroniserSettings,
        timing: &TimingSettings,
    ) -> Box<dyn Synchroniser> {
        open_on(Box::new(self.clone()), settings, timing).unwrap()
    }

    pub fn now(&self) -> Duration {
        self.state().now
    }

    /// Nothing goes over the line for a while.
    pub fn pass(&self, time: Duration) {
        let mut state = self.state();
        let end = state.now + time;
        while state.now < end {
            state.go_on(end);
        }
    }

    pub fn trigger_input(&self, rate_hz: f64) {
        let mut state = self.state();
        // What is due comes by the old signal.
        let now = state.now;
        state.go_on(now);
        state.unit.trigger_input(Some(rate_hz));
    }

    /// Pulses of lamp 1 and of Q-switch 1.
    pub fn pulses(&self) -> [u64; 2] {
        let state = self.state();
        [state.unit.pulses(1), state.unit.pulses(2)]
    }

    pub fn all_is_off(&self) -> bool {
        let unit = &self.state().unit;
        !unit.is_running() && (1..=8).all(|channel| !unit.is_enabled(channel))
    }
}

impl Line for SimulatedTime {
    fn name(&self) -> &str {
        "simulated time"
    }

    fn send(&mut self, bytes: &[u8]) -> io::Result<()> {
        let mut state = self.state();
        state.transmit(bytes.len());
        let now_ns = state.now_ns();
        state.unit.receive(bytes, now_ns);
        Ok(())
    }

    fn receive(&mut self, at_most: Duration) -> io::Result<Vec<u8>> {
        let mut state = self.state();
        let end = state.now + at_most;
        let bytes = state.go_on(end);
        state.transmit(bytes.len());
        Ok(bytes)
    }

    fn set_baud_rate(&mut self, _: u32) -> io::Result<()> {
        Ok(())
    }

    fn now(&self) -> Instant {
        self.begun + self.state().now
    }

    fn pause(&self, time: Duration) {
        self.pass(time);
    }
}
