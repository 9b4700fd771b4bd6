//! What starts a period: the synchroniser's own clock or an external signal.

use garde::Validate;
use serde::{Deserialize, Serialize};

use crate::check::finite;

/// What starts a period.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum TriggerSource {
    /// The synchroniser's own clock.
    #[default]
    Internal,
    /// A signal at the synchroniser's trigger input.
    External,
}

/// A signal at the synchroniser's trigger input.
///
/// The unit follows it whatever period is set, so its rate must be declared; the driver counts
/// triggers to confirm it before a Q-switch is enabled.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, Validate)]
#[serde(deny_unknown_fields)]
pub struct ExternalTrigger {
    /// Highest rate of the source, in Hz.
    #[garde(custom(finite), range(min = 0.001, max = 1000.0))]
    pub max_rate_hz: f64,
    /// The triggering edge.
    #[serde(default)]
    #[garde(skip)]
    pub edge: TriggerEdge,
    /// Threshold of the trigger input, in V (BNC 575: 0.2 to 15).
    #[serde(default = "half_of_ttl")]
    #[garde(custom(finite), range(min = 0.2, max = 15.0))]
    pub level_v: f64,
}

/// An edge of the trigger signal.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum TriggerEdge {
    /// From low to high.
    #[default]
    Rising,
    /// From high to low.
    Falling,
}

fn half_of_ttl() -> f64 {
    2.5
}
