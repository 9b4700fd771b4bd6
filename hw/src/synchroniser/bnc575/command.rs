//! The command table: typed parameters and values, with encoding and parsing.
//!
//! Source: BNC 575 and Quantum Composers 9520 manuals, remote command summaries. Keywords
//! are sent in their short form.

use std::fmt;

use crate::timing::TriggerEdge;

/// Picoseconds in a microsecond.
const PS_PER_US: f64 = 1e6;
/// Minimum tolerance of a read-back: half a nanosecond, even if the unit shows more digits.
const COARSEST_TOLERANCE_PS: i64 = 500;

/// A channel by its number in commands: 1 is A.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub struct Channel(pub u8);

impl fmt::Display for Channel {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(formatter, "channel {}", char::from(b'A' + self.0.saturating_sub(1)))
    }
}

/// A parameter that can be set or queried.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Parameter {
    /// Whether T0 pulses are generated; gates all outputs.
    Running,
    /// Time between T0 pulses.
    Period,
    /// `NORM`: T0 runs freely; `SING`: one T0 per trigger.
    SystemMode,
    /// `DIS` or `TRIG`: whether the external input is used.
    TriggerMode,
    /// Edge of the external trigger.
    TriggerEdge,
    /// Threshold of the external trigger.
    TriggerLevel,
    /// Number of T0 pulses; query only.
    TriggerCount,
    /// A parameter of a channel.
    Of(Channel, ChannelParameter),
}

/// Parameters of a channel.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum ChannelParameter {
    /// Whether the output is enabled.
    State,
    /// Source of its delay.
    Sync,
    /// `NORM`: active high.
    Polarity,
    /// `TTL` or adjustable.
    OutputMode,
    /// Start of the pulse after its sync source.
    Delay,
    /// Width of the pulse.
    Width,
    /// `NORM`: every period; `BURS`: a limited number of pulses after a start.
    Mode,
    /// Pulses of a burst.
    BurstCount,
    /// Periods skipped before the first pulse.
    WaitCount,
}

/// Value of a parameter.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Value {
    /// `ON` or `OFF`, read back as 1 or 0.
    Switch(bool),
    /// A keyword in short form; the unit may answer in long form.
    Keyword(&'static str),
    /// A time in ps, sent in seconds with this many decimals.
    Time { ps: i64, decimals: usize },
    /// A voltage, sent with two decimals.
    Volts(f64),
    /// A whole number.
    Count(u64),
}

/// A command line.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Command {
    /// `*IDN?`
    Identify,
    /// `:INST:CAT?`: channel names.
    Catalogue,
    /// `*RST`: factory settings.
    Reset,
    /// `*TRG`: software trigger.
    Trigger,
    /// `*ARM`: re-arms for the next burst or trigger.
    Arm,
    /// Sets a parameter.
    Set(Parameter, Value),
    /// Queries a parameter.
    Query(Parameter),
}

impl Value {
    /// A period: nine decimals, as the unit shows it.
    pub fn period(us: f64) -> Self {
        Self::Time { ps: (us * PS_PER_US).round() as i64, decimals: 9 }
    }

    /// A delay or width: eleven decimals, as the unit shows it.
    pub fn time(us: f64) -> Self {
        Self::Time { ps: (us * PS_PER_US).round() as i64, decimals: 11 }
    }

    /// Edge of the external trigger.
    pub fn edge(edge: TriggerEdge) -> Self {
        Self::Keyword(match edge {
            TriggerEdge::Rising => "RIS",
            TriggerEdge::Falling => "FALL",
        })
    }

    /// Whether a read-back has the same value, compared numerically: to half of the last digit
    /// shown, and at least to half a nanosecond.
    pub fn agrees(&self, reply: &str) -> bool {
        match self {
            Self::Switch(on) => switch(reply) == Some(*on),
            Self::Keyword(short) => {
                reply.get(..short.len()).is_some_and(|start| start.eq_ignore_ascii_case(short))
            }
            Self::Time { ps, .. } => match decimal_ps(reply) {
                Some((read_ps, tolerance_ps)) => (read_ps - ps).abs() <= tolerance_ps,
                None => false,
            },
            Self::Volts(volts) => {
                reply.parse::<f64>().is_ok_and(|read| (read - volts).abs() <= 0.005)
            }
            Self::Count(count) => count_of(reply) == Some(*count),
        }
    }
}

/// Parses a boolean.
pub fn switch(reply: &str) -> Option<bool> {
    match reply.to_ascii_uppercase().as_str() {
        "1" | "ON" => Some(true),
        "0" | "OFF" => Some(false),
        _ => None,
    }
}

/// Parses an integer, which some firmware pads with zeros.
pub fn count_of(reply: &str) -> Option<u64> {
    reply.strip_prefix('+').unwrap_or(reply).parse().ok()
}

/// Parses seconds to ps, with the resolution: half of the last digit shown.
fn decimal_ps(reply: &str) -> Option<(i64, i64)> {
    let seconds: f64 = reply.parse().ok().filter(|seconds: &f64| seconds.is_finite())?;
    // Below 9000 s, a double represents whole picoseconds exactly.
    let ps = (seconds * 1e12).round() as i64;
    let plain = !reply.contains(['e', 'E']);
    let decimals = match reply.split_once('.') {
        Some((_, digits)) if plain => digits.len(),
        _ => 0,
    };
    let half_digit_ps = match decimals {
        0..=8 => COARSEST_TOLERANCE_PS,
        9..=11 => 10_i64.pow(12 - decimals as u32) / 2,
        _ => 1,
    };
    Some((ps, half_digit_ps.min(COARSEST_TOLERANCE_PS)))
}

impl Parameter {
    /// Whether a line can be the reply to the query of this parameter.
    pub fn can_be(&self, reply: &str) -> bool {
        match self {
            Self::Running | Self::Of(_, ChannelParameter::State) => switch(reply).is_some(),
            Self::SystemMode | Self::TriggerMode | Self::TriggerEdge => is_keyword(reply),
            Self::Period | Self::TriggerLevel => reply.parse::<f64>().is_ok_and(f64::is_finite),
            Self::TriggerCount => count_of(reply).is_some(),
            Self::Of(_, parameter) => match parameter {
                ChannelParameter::Delay | ChannelParameter::Width => {
                    reply.parse::<f64>().is_ok_and(f64::is_finite)
                }
                ChannelParameter::BurstCount | ChannelParameter::WaitCount => {
                    count_of(reply).is_some()
                }
                _ => is_keyword(reply),
            },
        }
    }
}

/// Keywords in replies, in short form, which is a prefix of the long form.
const KEYWORDS: [&str; 16] = [
    "NORM", "SING", "BURS", "DCYC", "DIS", "TRIG", "RIS", "FALL", "T0", "CH", "TTL", "ADJ", "INV",
    "COMP", "EXT", "GATE",
];

fn is_keyword(reply: &str) -> bool {
    let reply = reply.to_ascii_uppercase();
    KEYWORDS.iter().any(|keyword| reply.starts_with(keyword))
        && reply.chars().all(|c| c.is_ascii_alphanumeric())
}

impl fmt::Display for Parameter {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Running => formatter.write_str(":PULSE0:STATE"),
            Self::Period => formatter.write_str(":PULSE0:PER"),
            Self::SystemMode => formatter.write_str(":PULSE0:MODE"),
            Self::TriggerMode => formatter.write_str(":PULSE0:TRIG:MODE"),
            Self::TriggerEdge => formatter.write_str(":PULSE0:TRIG:EDGE"),
            Self::TriggerLevel => formatter.write_str(":PULSE0:TRIG:LEV"),
            Self::TriggerCount => formatter.write_str(":PULS0:COUN:COUN"),
            Self::Of(Channel(number), parameter) => {
                write!(formatter, ":PULSE{number}:{parameter}")
            }
        }
    }
}

impl fmt::Display for ChannelParameter {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        formatter.write_str(match self {
            Self::State => "STATE",
            Self::Sync => "SYNC",
            Self::Polarity => "POL",
            Self::OutputMode => "OUTP:MODE",
            Self::Delay => "DEL",
            Self::Width => "WIDT",
            Self::Mode => "CMOD",
            Self::BurstCount => "BCO",
            Self::WaitCount => "WCO",
        })
    }
}

impl fmt::Display for Value {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Switch(on) => formatter.write_str(if *on { "ON" } else { "OFF" }),
            Self::Keyword(keyword) => formatter.write_str(keyword),
            Self::Time { ps, decimals } => {
                let sign = if *ps < 0 { "-" } else { "" };
                let (ps, second) = (ps.unsigned_abs(), 1_000_000_000_000);
                let digits = format!("{:012}", ps % second);
                let digits = digits.get(..*decimals).unwrap_or(&digits);
                write!(formatter, "{sign}{}.{digits}", ps / second)
            }
            Self::Volts(volts) => write!(formatter, "{volts:.2}"),
            Self::Count(count) => write!(formatter, "{count}"),
        }
    }
}

impl fmt::Display for Command {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Identify => formatter.write_str("*IDN?"),
            Self::Catalogue => formatter.write_str(":INST:CAT?"),
            Self::Reset => formatter.write_str("*RST"),
            Self::Trigger => formatter.write_str("*TRG"),
            Self::Arm => formatter.write_str("*ARM"),
            Self::Set(parameter, value) => write!(formatter, "{parameter} {value}"),
            Self::Query(Parameter::TriggerCount) => {
                write!(formatter, "{}? TCNTS", Parameter::TriggerCount)
            }
            Self::Query(parameter) => write!(formatter, "{parameter}?"),
        }
    }
}

#[cfg(test)]
#[path = "command_tests.rs"]
mod tests;
