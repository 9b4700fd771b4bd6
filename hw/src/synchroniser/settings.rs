//! The `[synchroniser]` table: how the unit is connected.

use std::{fmt, path::PathBuf};

use garde::Validate;
use serde::{Deserialize, Serialize};

use crate::check::finite;

/// The unit, its port, and the assignment of its outputs.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, Validate)]
#[serde(deny_unknown_fields)]
pub struct SynchroniserSettings {
    /// The unit's family.
    #[garde(skip)]
    pub driver: SynchroniserDriver,
    /// Serial port, such as `/dev/ttyUSB0` or, better, a link in `/dev/serial/by-id`.
    #[garde(length(min = 1))]
    pub port: String,
    /// Baud rate; the family's default when absent.
    #[serde(default)]
    #[garde(inner(custom(known_speed)))]
    pub baud_rate: Option<u32>,
    /// Whether other baud rates are tried if the unit does not answer.
    #[serde(default)]
    #[garde(skip)]
    pub probe_baud_rates: bool,
    /// Minimum time between a reply and the next command, in ms. Units need 50 to 100.
    #[serde(default = "default_pacing_ms")]
    #[garde(range(min = 0, max = 1000))]
    pub pacing_ms: u64,
    /// Timeout of a reply, in ms.
    #[serde(default = "default_reply_timeout_ms")]
    #[garde(range(min = 10, max = 10_000))]
    pub reply_timeout_ms: u64,
    /// Assignment of the outputs.
    #[serde(default)]
    #[garde(custom(every_output_once))]
    pub channels: ChannelMap,
    /// For units that cannot count a burst: whether the host may end bursts by its own clock. Then
    /// only the hardware interlock ends firing if the host dies or the line is cut.
    #[serde(default)]
    #[garde(skip)]
    pub host_timed_bursts: bool,
    /// How long to search for a lost unit, in s, before the run ends; without limit when absent.
    #[serde(default)]
    #[garde(inner(custom(finite), range(min = 0.0, max = 86_400.0)))]
    pub reconnect_patience_s: Option<f64>,
    /// File to which every byte on the line is appended, with the host's time.
    #[serde(default)]
    #[garde(skip)]
    pub transcript: Option<PathBuf>,
}

/// A family of synchronisers.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum SynchroniserDriver {
    /// BNC 575 and 577.
    #[serde(rename = "bnc-575")]
    Bnc575,
    /// Quantum Composers 952x and 953x; the same dialect.
    QuantumComposers,
    /// OPTOLUTION oltSync.
    #[serde(rename = "oltsync")]
    OltSync,
}

/// An output of the unit, as labelled on it.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Serialize, Deserialize)]
pub enum ChannelName {
    A,
    B,
    C,
    D,
    E,
    F,
    G,
    H,
}

impl ChannelName {
    /// 1 for A.
    pub fn number(self) -> u8 {
        self as u8 + 1
    }
}

impl fmt::Display for ChannelName {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        fmt::Debug::fmt(self, formatter)
    }
}

/// Assignment of the outputs.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct ChannelMap {
    /// Flash lamp of laser head 1.
    pub lamp_1: ChannelName,
    /// Q-switch of laser head 1.
    pub q_switch_1: ChannelName,
    /// Flash lamp of laser head 2.
    pub lamp_2: ChannelName,
    /// Q-switch of laser head 2.
    pub q_switch_2: ChannelName,
    /// Cameras: one output for all of them, or several.
    pub cameras: Vec<ChannelName>,
}

impl Default for ChannelMap {
    fn default() -> Self {
        Self {
            lamp_1: ChannelName::A,
            q_switch_1: ChannelName::B,
            lamp_2: ChannelName::C,
            q_switch_2: ChannelName::D,
            cameras: vec![ChannelName::E],
        }
    }
}

impl ChannelMap {
    /// Outputs that emit light.
    pub fn q_switches(&self) -> [ChannelName; 2] {
        [self.q_switch_1, self.q_switch_2]
    }

    /// Outputs that charge the laser.
    pub fn lamps(&self) -> [ChannelName; 2] {
        [self.lamp_1, self.lamp_2]
    }

    /// All outputs in use, most dangerous first.
    pub fn all(&self) -> Vec<ChannelName> {
        let lasers = self.q_switches().into_iter().chain(self.lamps());
        lasers.chain(self.cameras.iter().copied()).collect()
    }
}

fn every_output_once(channels: &ChannelMap, _: &()) -> garde::Result {
    if channels.cameras.is_empty() {
        return Err(garde::Error::new("cameras names no output; allowed: at least one"));
    }
    let mut outputs = channels.all();
    outputs.sort();
    match outputs.windows(2).find(|pair| pair[0] == pair[1]) {
        None => Ok(()),
        Some(pair) => Err(garde::Error::new(format!(
            "output {} is used twice; allowed: each output once",
            pair[0]
        ))),
    }
}

fn known_speed(baud_rate: &u32, _: &()) -> garde::Result {
    match baud_rate {
        9600 | 19_200 | 38_400 | 57_600 | 115_200 => Ok(()),
        _ => Err(garde::Error::new("allowed: 9600, 19200, 38400, 57600 or 115200")),
    }
}

fn default_pacing_ms() -> u64 {
    60
}

fn default_reply_timeout_ms() -> u64 {
    500
}

impl SynchroniserSettings {
    /// Settings for a unit at `port`, with the family's defaults.
    pub fn at(driver: SynchroniserDriver, port: impl Into<String>) -> Self {
        Self {
            driver,
            port: port.into(),
            baud_rate: None,
            probe_baud_rates: false,
            pacing_ms: default_pacing_ms(),
            reply_timeout_ms: default_reply_timeout_ms(),
            channels: ChannelMap::default(),
            host_timed_bursts: false,
            reconnect_patience_s: None,
            transcript: None,
        }
    }

    /// Baud rates to try, in order.
    pub fn baud_rates(&self) -> Vec<u32> {
        let usual: &[u32] = match self.driver {
            SynchroniserDriver::OltSync => &[9600],
            _ => &[115_200, 38_400, 9600],
        };
        let first = self.baud_rate.unwrap_or(usual[0]);
        let others = usual.iter().copied().filter(|rate| *rate != first && self.probe_baud_rates);
        std::iter::once(first).chain(others).collect()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn read(text: &str) -> Result<SynchroniserSettings, String> {
        let text = format!("driver = 'bnc-575'\nport = '/dev/ttyUSB0'\n{text}");
        let settings: SynchroniserSettings =
            toml::from_str(&text).map_err(|error| error.to_string())?;
        settings.validate().map_err(|report| report.to_string())?;
        Ok(settings)
    }

    #[test]
    fn the_table_has_defaults_and_says_what_is_wrong() {
        let usual = SynchroniserSettings::at(SynchroniserDriver::Bnc575, "/dev/ttyUSB0");
        assert_eq!(read("").unwrap(), usual);
        assert_eq!(usual.baud_rates(), [115_200]);
        let probing = read("baud_rate = 38400\nprobe_baud_rates = true").unwrap();
        assert_eq!(probing.baud_rates(), [38_400, 115_200, 9600]);
        let cases = [
            ("baud_rate = 1234", "allowed: 9600"),
            ("pacing_ms = 5000", "pacing_ms"),
            ("reconnect_patience_s = -1.0", "reconnect_patience_s"),
            ("reply_timeout = 5", "unknown field"),
            (
                "channels = { lamp_1 = 'A', q_switch_1 = 'A', lamp_2 = 'C', q_switch_2 = 'D', \
              cameras = ['E'] }",
                "output A is used twice",
            ),
            (
                "channels = { lamp_1 = 'A', q_switch_1 = 'B', lamp_2 = 'C', q_switch_2 = 'D', \
              cameras = [] }",
                "cameras names no output",
            ),
            (
                "channels = { lamp_1 = 'A', q_switch_1 = 'B', lamp_2 = 'C', q_switch_2 = 'D', \
              cameras = ['J'] }",
                "unknown variant",
            ),
        ];
        for (text, expected) in cases {
            let message = read(text).unwrap_err();
            assert!(message.contains(expected), "{message}");
        }
    }

    #[test]
    fn q_switches_come_first() {
        use ChannelName::{A, B, C, D, E};
        assert_eq!(ChannelMap::default().all(), [B, D, A, C, E]);
        assert_eq!(E.number(), 5);
    }
}
