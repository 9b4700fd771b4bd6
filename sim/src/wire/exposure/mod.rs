//! Converts the synchroniser's pulses to light in exposures, as laser and cameras do.
//!
//! A pure function from the outputs of a period to exposures. The module knows the wiring and the
//! properties of the instruments, but not the intended schedule: a wrong delay gives a wrong or dark
//! image.
//!
//! Light that a later period sends into an exposure 2 that extends beyond its own period is ignored.

use super::{OutputPulse, PeriodOutputs};
use crate::LightPulse;

/// Assignment of outputs (1 is A).
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Wiring {
    /// Flash lamps of laser heads 1 and 2.
    pub lamps: [u8; 2],
    /// Q-switches of laser heads 1 and 2.
    pub q_switches: [u8; 2],
    /// Trigger input of each camera.
    pub cameras: Vec<u8>,
}

/// Properties of the laser.
#[derive(Debug, Clone, PartialEq)]
pub struct LaserFacts {
    /// Lamp-to-Q-switch delay with full pulse energy, per head, in µs.
    pub best_delay_us: [f64; 2],
    /// Deviation from it at which the energy has fallen to exp(−1/2), in µs: the rod is not pumped
    /// yet, or has lost its inversion.
    pub delay_width_us: f64,
    /// Warm-up of a head's lamps before it lases, in s.
    pub warm_up_s: f64,
    /// Longest pause that keeps it warm, in s.
    pub stays_warm_s: f64,
}

impl Default for LaserFacts {
    fn default() -> Self {
        Self { best_delay_us: [180.0; 2], delay_width_us: 40.0, warm_up_s: 0.0, stays_warm_s: 5.0 }
    }
}

impl LaserFacts {
    /// Energy of a pulse of `head` (0 or 1) for a lamp-to-Q-switch delay `delay_us`, relative to
    /// the full one.
    pub fn energy(&self, head: usize, delay_us: f64) -> f64 {
        if delay_us <= 0.0 {
            return 0.0;
        }
        let off = (delay_us - self.best_delay_us[head]) / self.delay_width_us;
        (-off * off / 2.0).exp()
    }
}

/// Properties of a double-frame camera.
#[derive(Debug, Clone, PartialEq)]
pub struct CameraFacts {
    /// Trigger to start of exposure 1, in µs.
    pub latency_us: f64,
    /// Length of exposure 1, in µs.
    pub exposure_1_us: f64,
    /// Dead time between the exposures, in µs.
    pub gap_us: f64,
    /// Readout of one frame, in µs; exposure 2 lasts as long.
    pub readout_us: f64,
}

impl Default for CameraFacts {
    fn default() -> Self {
        Self { latency_us: 3.0, exposure_1_us: 200.0, gap_us: 2.0, readout_us: 40_000.0 }
    }
}

/// Both exposures of one camera for one trigger.
#[derive(Debug, Clone, PartialEq)]
pub struct CameraExposures {
    /// Index in [`Wiring::cameras`].
    pub camera: usize,
    /// T0 on the synchroniser's clock, in ns.
    pub t0_ns: u64,
    /// Start and end of exposures 1 and 2, in µs after T0.
    pub exposures_us: [[f64; 2]; 2],
    /// Light in exposures 1 and 2.
    pub light: [Vec<LightPulse>; 2],
    /// Separation of the light pulses, in s; `None` unless both heads were triggered.
    pub separation_s: Option<f64>,
}

/// Laser and cameras connected to a synchroniser.
#[derive(Debug, Clone)]
pub struct OpticalBench {
    wiring: Wiring,
    laser: LaserFacts,
    camera: CameraFacts,
    lamps: [Option<LampRun>; 2],
    /// When each camera can be triggered again, on the synchroniser's clock, in ns.
    ready_ns: Vec<u64>,
}

/// Lamps of one head firing without a long pause.
#[derive(Debug, Clone, Copy)]
struct LampRun {
    since_ns: u64,
    last_ns: u64,
}

/// A flash, in µs after T0.
#[derive(Debug, Clone, Copy)]
struct Flash {
    at_us: f64,
    energy: f64,
}

impl OpticalBench {
    /// A bench with cold lamps.
    pub fn new(wiring: Wiring, laser: LaserFacts, camera: CameraFacts) -> Self {
        let ready_ns = vec![0; wiring.cameras.len()];
        Self { wiring, laser, camera, lamps: [None; 2], ready_ns }
    }

    /// Converts one period's pulses to the exposures of the triggered cameras. A camera ignores
    /// triggers during its readout.
    pub fn period(&mut self, outputs: &PeriodOutputs) -> Vec<CameraExposures> {
        let flashes: Vec<Flash> = (0..2).filter_map(|head| self.flash(head, outputs)).collect();
        let pair_us = self.triggered_pair_us(outputs);
        (0..self.wiring.cameras.len())
            .filter_map(|camera| self.expose(camera, outputs, &flashes, pair_us))
            .collect()
    }

    /// The flash of one laser head; `None` if no lamp fired before its Q-switch.
    fn flash(&mut self, head: usize, outputs: &PeriodOutputs) -> Option<Flash> {
        let lamp = pulse_at(outputs, self.wiring.lamps[head])?;
        let lamp_ns = at_ns(outputs.t0_ns, lamp.start_us);
        let stays_warm_ns = (self.laser.stays_warm_s * 1e9) as u64;
        let run = match self.lamps[head] {
            Some(run) if lamp_ns.saturating_sub(run.last_ns) <= stays_warm_ns => {
                LampRun { last_ns: lamp_ns, ..run }
            }
            _ => LampRun { since_ns: lamp_ns, last_ns: lamp_ns },
        };
        self.lamps[head] = Some(run);
        let q_switch = pulse_at(outputs, self.wiring.q_switches[head])?;
        let delay_us = q_switch.start_us - lamp.start_us;
        let warm = (lamp_ns - run.since_ns) as f64 * 1e-9 >= self.laser.warm_up_s;
        if delay_us <= 0.0 || !warm {
            return None;
        }
        Some(Flash { at_us: q_switch.start_us, energy: self.laser.energy(head, delay_us) })
    }

    /// Times of both Q-switch triggers, with or without light.
    fn triggered_pair_us(&self, outputs: &PeriodOutputs) -> Option<[f64; 2]> {
        let [first, second] = self.wiring.q_switches;
        Some([pulse_at(outputs, first)?.start_us, pulse_at(outputs, second)?.start_us])
    }

    fn expose(
        &mut self,
        camera: usize,
        outputs: &PeriodOutputs,
        flashes: &[Flash],
        pair_us: Option<[f64; 2]>,
    ) -> Option<CameraExposures> {
        let trigger = pulse_at(outputs, self.wiring.cameras[camera])?;
        if at_ns(outputs.t0_ns, trigger.start_us) < self.ready_ns[camera] {
            return None;
        }
        let facts = &self.camera;
        let start_us = trigger.start_us + facts.latency_us;
        let gap_start_us = start_us + facts.exposure_1_us;
        let gap_end_us = gap_start_us + facts.gap_us;
        let end_us = gap_end_us + facts.readout_us;
        self.ready_ns[camera] = at_ns(outputs.t0_ns, end_us + facts.readout_us);
        let exposures_us = [[start_us, gap_start_us], [gap_end_us, end_us]];
        // Without a pair, time is relative to the middle of the gap.
        let pair_us = pair_us.unwrap_or([gap_start_us, gap_end_us]);
        let light = exposures_us.map(|[from_us, to_us]| {
            let inside = flashes.iter().filter(|f| (from_us..to_us).contains(&f.at_us));
            let pulses = inside.map(|flash| LightPulse {
                at_s: after_middle_s(flash.at_us, pair_us),
                energy: flash.energy,
            });
            pulses.collect()
        });
        let separation_s = self
            .triggered_pair_us(outputs)
            .map(|[first_us, second_us]| 2.0 * after_middle_s(second_us, [first_us, second_us]));
        Some(CameraExposures { camera, t0_ns: outputs.t0_ns, exposures_us, light, separation_s })
    }
}

fn pulse_at(outputs: &PeriodOutputs, channel: u8) -> Option<OutputPulse> {
    outputs.pulses.iter().copied().find(|pulse| pulse.channel == channel)
}

fn at_ns(t0_ns: u64, after_us: f64) -> u64 {
    t0_ns.saturating_add_signed((after_us * 1000.0).round() as i64)
}

/// Time relative to the middle of a pair, in s. Times are whole picoseconds, so that the pulses are at
/// exactly plus and minus half of the separation.
fn after_middle_s(at_us: f64, [first_us, second_us]: [f64; 2]) -> f64 {
    let ps = |us: f64| (us * 1e6).round() as i64;
    let twice_ps = 2 * ps(at_us) - ps(first_us) - ps(second_us);
    twice_ps as f64 / 1e6 * 1e-6 / 2.0
}

#[cfg(test)]
mod tests;
