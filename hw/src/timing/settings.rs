//! The `[timing]` table: timing properties of laser and cameras.

use garde::Validate;
use serde::{Deserialize, Serialize};

use super::trigger::{ExternalTrigger, TriggerSource};
use crate::check::finite;

/// Properties of laser and cameras that determine the pulse schedule. Defaults: a flash-lamp laser at
/// 10 Hz.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, Validate)]
#[serde(deny_unknown_fields, default)]
pub struct TimingSettings {
    /// Highest rate at which lamps may be driven, in Hz.
    #[garde(custom(finite), range(min = 0.01, max = 1000.0))]
    pub laser_rate_limit_hz: f64,
    /// Lamp trigger of head 1 after T0, in µs.
    #[garde(custom(finite), range(min = 0.0, max = 1e6))]
    pub lamp_1_us: f64,
    /// Lamp trigger to Q-switch trigger, for heads 1 and 2, in µs.
    #[garde(inner(custom(finite), range(min = 1.0, max = 10_000.0)))]
    pub lamp_to_q_switch_us: [f64; 2],
    /// Camera trigger to start of exposure 1, in µs.
    #[garde(custom(finite), range(min = 0.0, max = 10_000.0))]
    pub camera_latency_us: f64,
    /// Length of exposure 1, in µs.
    #[garde(custom(finite), range(min = 1.0, max = 1e6))]
    pub exposure_1_us: f64,
    /// Dead time between exposures 1 and 2, in µs.
    #[garde(custom(finite), range(min = 0.0, max = 10_000.0))]
    pub gap_us: f64,
    /// Readout time of one frame, in µs; exposure 2 lasts as long as the readout of frame 1.
    #[garde(custom(finite), range(min = 1.0, max = 1e7))]
    pub readout_us: f64,
    /// Minimum time between a light pulse and the edges of its exposure, in µs: covers Q-switch
    /// build-up and camera jitter.
    #[garde(custom(finite), range(min = 0.0, max = 1000.0))]
    pub margin_us: f64,
    /// Width of every trigger pulse, in µs.
    #[garde(custom(finite), range(min = 0.01, max = 10_000.0))]
    pub pulse_width_us: f64,
    /// Warm-up of the lamps before a Q-switch is enabled, in s; measured by the host.
    #[garde(custom(finite), range(min = 0.0, max = 3600.0))]
    pub lamp_warm_up_s: f64,
    /// What starts a period.
    #[garde(skip)]
    pub trigger: TriggerSource,
    /// The external source; required if `trigger` is `external`.
    #[garde(dive)]
    pub external_trigger: Option<ExternalTrigger>,
}

impl Default for TimingSettings {
    fn default() -> Self {
        Self {
            laser_rate_limit_hz: 10.0,
            lamp_1_us: 100.0,
            lamp_to_q_switch_us: [180.0, 180.0],
            camera_latency_us: 3.0,
            exposure_1_us: 200.0,
            gap_us: 2.0,
            readout_us: 40_000.0,
            margin_us: 1.0,
            pulse_width_us: 50.0,
            lamp_warm_up_s: 10.0,
            trigger: TriggerSource::Internal,
            external_trigger: None,
        }
    }
}
