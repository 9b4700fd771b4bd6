//! The `[instruments]` table: cameras on the network and a synchroniser on a serial line.

use std::path::PathBuf;

use garde::Validate;
use lfpiv_hw::{check::finite, gige::CameraSettings, synchroniser::SynchroniserSettings};
use serde::{Deserialize, Serialize};

/// Instruments behind wires. Without this table a run needs a simulated bench.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, Validate)]
#[serde(deny_unknown_fields)]
pub struct InstrumentSettings {
    /// In the order of the `[[camera]]` tables.
    #[garde(length(min = 1, max = 2), dive)]
    pub camera: Vec<CameraSettings>,
    /// The unit that times laser and cameras.
    #[garde(dive)]
    pub synchroniser: SynchroniserSettings,
    /// How long a frame that is due is waited for, in s: a few periods and readouts.
    #[serde(default = "one_second")]
    #[garde(custom(finite), range(min = 0.01, max = 600.0))]
    pub frame_patience_s: f64,
    /// Folder in which every frame that arrives is listed, with a checksum of its pixels: one
    /// file per camera.
    #[serde(default)]
    #[garde(skip)]
    pub frame_record: Option<PathBuf>,
}

fn one_second() -> f64 {
    1.0
}
