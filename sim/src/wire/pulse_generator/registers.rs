//! Registers, and the pulses that they produce.

use crate::wire::{OutputPulse, PeriodOutputs};

use super::PulseGeneratorOptions;

const PS_PER_NS: i64 = 1000;
const PS_PER_US: f64 = 1e6;

/// All programmable state.
#[derive(Debug, Clone)]
pub(super) struct Registers {
    pub(super) system: System,
    pub(super) channels: Vec<Channel>,
}

/// T0 and its trigger.
#[derive(Debug, Clone)]
pub(super) struct System {
    pub(super) running: bool,
    pub(super) period_ps: i64,
    pub(super) mode: &'static str,
    pub(super) trigger_mode: &'static str,
    pub(super) trigger_edge: &'static str,
    pub(super) trigger_level_v: f64,
    /// T0 pulses since it was switched on.
    pub(super) count: u64,
    /// Time of the next T0 of the internal clock.
    next_t0_ns: Option<u64>,
}

/// One output.
#[derive(Debug, Clone)]
pub(super) struct Channel {
    pub(super) enabled: bool,
    pub(super) sync: &'static str,
    pub(super) polarity: &'static str,
    pub(super) output_mode: &'static str,
    pub(super) mode: &'static str,
    pub(super) delay_ps: i64,
    pub(super) width_ps: i64,
    pub(super) burst_count: u64,
    pub(super) wait_count: u64,
    /// Pulses given or skipped since the last start.
    given: u64,
    waited: u64,
    /// Pulses since it was switched on.
    pub(super) pulses: u64,
}

impl Channel {
    fn factory(enabled: bool) -> Self {
        Self {
            enabled,
            sync: "T0",
            polarity: "NORM",
            output_mode: "TTL",
            mode: "NORM",
            delay_ps: 0,
            width_ps: 10_000_000,
            burst_count: 1,
            wait_count: 0,
            given: 0,
            waited: 0,
            pulses: 0,
        }
    }

    fn burst_is_over(&self) -> bool {
        self.given >= self.burst_count
    }

    /// Whether this T0 produces a pulse.
    fn follow(&mut self, options: &PulseGeneratorOptions) -> bool {
        let waits = self.mode != "BURS" || options.wait_counter_delays_bursts;
        if !self.enabled || self.sync != "T0" {
            return false;
        }
        if waits && self.waited < self.wait_count {
            self.waited += 1;
            return false;
        }
        if (self.mode == "BURS" && self.burst_is_over()) || (self.mode == "SING" && self.given > 0)
        {
            return false;
        }
        self.given += 1;
        options.gate_open
    }
}

impl Registers {
    pub(super) fn factory(options: &PulseGeneratorOptions) -> Self {
        let system = System {
            running: false,
            period_ps: 1_000_000_000,
            mode: "NORM",
            trigger_mode: "DIS",
            trigger_edge: "RIS",
            trigger_level_v: 2.5,
            count: 0,
            next_t0_ns: None,
        };
        let channel = Channel::factory(options.reset_enables_channels);
        Self { system, channels: vec![channel; usize::from(options.channels)] }
    }

    /// `*RST`; counters are kept.
    pub(super) fn reset(&mut self, options: &PulseGeneratorOptions) {
        let before = std::mem::replace(self, Self::factory(options));
        self.system.count = before.system.count;
        for (channel, old) in self.channels.iter_mut().zip(before.channels) {
            channel.pulses = old.pulses;
        }
    }

    /// `:PULSE0:STATE`. A start restarts bursts and wait counters.
    pub(super) fn run(&mut self, running: bool, now_ns: u64) {
        self.system.running = running;
        self.system.next_t0_ns = None;
        if running {
            self.rearm();
            if self.system.mode == "NORM" && self.system.trigger_mode == "DIS" {
                self.system.next_t0_ns = Some(now_ns);
            }
        }
    }

    /// `*ARM`.
    pub(super) fn rearm(&mut self) {
        for channel in &mut self.channels {
            (channel.given, channel.waited) = (0, 0);
        }
    }

    /// Whether external or software triggers produce a T0.
    pub(super) fn waits_for_trigger(&self) -> bool {
        self.system.running && self.system.mode == "SING" && self.system.trigger_mode == "TRIG"
    }

    /// Time of the next T0 of the internal clock.
    pub(super) fn next_t0_ns(&self) -> Option<u64> {
        self.system.next_t0_ns.filter(|_| self.system.running)
    }

    /// A T0 of the internal clock.
    pub(super) fn clock(&mut self, options: &PulseGeneratorOptions, t0_ns: u64) -> PeriodOutputs {
        let period_ns = (self.system.period_ps / PS_PER_NS).max(1) as u64;
        self.system.next_t0_ns = Some(t0_ns + period_ns);
        self.period(options, t0_ns)
    }

    /// A T0 from any source, with the current registers.
    pub(super) fn period(&mut self, options: &PulseGeneratorOptions, t0_ns: u64) -> PeriodOutputs {
        self.system.count += 1;
        let mut pulses = Vec::new();
        for (index, channel) in self.channels.iter_mut().enumerate() {
            if channel.follow(options) {
                channel.pulses += 1;
                pulses.push(OutputPulse {
                    channel: index as u8 + 1,
                    start_us: channel.delay_ps as f64 / PS_PER_US,
                    width_us: channel.width_ps as f64 / PS_PER_US,
                });
            }
        }
        if options.drops_off_after_burst && self.bursts_are_over() {
            self.system.running = false;
        }
        PeriodOutputs { t0_ns, pulses }
    }

    /// Whether there were bursts and all are complete.
    fn bursts_are_over(&self) -> bool {
        let mut bursts = self.channels.iter().filter(|c| c.enabled && c.mode == "BURS").peekable();
        bursts.peek().is_some() && bursts.all(Channel::burst_is_over)
    }
}
