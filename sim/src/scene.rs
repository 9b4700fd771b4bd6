//! What is in front of the simulated cameras: the `[simulation]` table of the configuration.

use garde::Validate;
use serde::{Deserialize, Serialize};

/// Flow, particles, light and sensor of a simulated run.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, Validate)]
#[serde(deny_unknown_fields)]
pub struct Scene {
    /// Particles per microlens (ppm).
    #[garde(range(min = 0.0, max = 20.0))]
    pub ppm: f64,
}
