//! The `[wire]` table: addresses and behaviour of the simulated instruments.

use std::{net::Ipv4Addr, path::PathBuf};

use garde::Validate;
use lfpiv_hw::check::finite;
use serde::{Deserialize, Serialize};

use super::exposure::CameraFacts;
#[cfg(feature = "aravis")]
use super::{
    exposure::LaserFacts,
    pulse_generator::{Pacing, PulseGeneratorOptions, TooSoon},
};

/// Simulated instruments on real wires.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, Validate)]
#[serde(deny_unknown_fields, default)]
pub struct WireSettings {
    /// Address of each camera, in the order of the `[[camera]]` tables; must be local.
    #[garde(length(min = 1, max = 2))]
    pub camera_ips: Vec<Ipv4Addr>,
    /// Link to the synchroniser's pseudo-terminal.
    #[garde(skip)]
    pub port: PathBuf,
    /// Whether the synchroniser echoes commands.
    #[garde(skip)]
    pub echo: bool,
    /// Whether stray bytes precede its replies.
    #[garde(skip)]
    pub stray_bytes: bool,
    /// Commands that come sooner than this after a reply are answered with `?8`, in ms.
    #[garde(range(max = 1000))]
    pub least_gap_ms: u64,
    /// Time from command to reply, in ms.
    #[garde(range(max = 10_000))]
    pub reply_delay_ms: u64,
    /// Whether T0 stops once a burst is complete.
    #[garde(skip)]
    pub drops_off_after_burst: bool,
    /// Warm-up of the lamps before the laser lases, in s.
    #[garde(custom(finite), range(min = 0.0, max = 3600.0))]
    pub lamp_warm_up_s: f64,
    /// Camera trigger to start of exposure 1, in µs.
    #[garde(custom(finite), range(min = 0.0, max = 10_000.0))]
    pub camera_latency_us: f64,
    /// Length of exposure 1, in µs.
    #[garde(custom(finite), range(min = 1.0, max = 1e6))]
    pub exposure_1_us: f64,
    /// Readout of one frame, in µs; exposure 2 lasts as long.
    #[garde(custom(finite), range(min = 1.0, max = 1e7))]
    pub readout_us: f64,
    /// Rate of each camera's line, in Mbit/s.
    #[garde(custom(finite), range(min = 10.0, max = 1e6))]
    pub line_mbit_s: f64,
    /// Share of lost stream packets, 0 to 1.
    #[garde(custom(finite), range(min = 0.0, max = 1.0))]
    pub lost_packets: f64,
}

impl Default for WireSettings {
    fn default() -> Self {
        let camera = CameraFacts::default();
        Self {
            camera_ips: vec![Ipv4Addr::new(127, 0, 0, 1), Ipv4Addr::new(127, 0, 0, 2)],
            port: PathBuf::from("results/synchroniser"),
            echo: false,
            stray_bytes: false,
            least_gap_ms: 0,
            reply_delay_ms: 0,
            drops_off_after_burst: true,
            lamp_warm_up_s: 0.0,
            camera_latency_us: camera.latency_us,
            exposure_1_us: camera.exposure_1_us,
            readout_us: camera.readout_us,
            line_mbit_s: 2500.0,
            lost_packets: 0.0,
        }
    }
}

#[cfg(feature = "aravis")]
impl WireSettings {
    pub(super) fn unit(&self) -> PulseGeneratorOptions {
        let pacing =
            Pacing { least_gap_ns: self.least_gap_ms * 1_000_000, too_soon: TooSoon::Unavailable };
        PulseGeneratorOptions {
            echo: self.echo,
            stray: if self.stray_bytes { b"\xff\0".to_vec() } else { Vec::new() },
            pacing: (self.least_gap_ms > 0).then_some(pacing),
            reply_delay_ns: self.reply_delay_ms * 1_000_000,
            drops_off_after_burst: self.drops_off_after_burst,
            ..PulseGeneratorOptions::default()
        }
    }

    pub(super) fn laser(&self) -> LaserFacts {
        LaserFacts { warm_up_s: self.lamp_warm_up_s, ..LaserFacts::default() }
    }

    pub(super) fn camera(&self) -> CameraFacts {
        CameraFacts {
            latency_us: self.camera_latency_us,
            exposure_1_us: self.exposure_1_us,
            readout_us: self.readout_us,
            ..CameraFacts::default()
        }
    }
}
