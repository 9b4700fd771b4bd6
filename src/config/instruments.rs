//! The `[instruments]` table: cameras on the network and a synchroniser on a serial line.

use std::path::PathBuf;

use garde::Validate;
use lfpiv_hw::{check::finite, gige::CameraSettings, synchroniser::SynchroniserSettings};
use serde::{Deserialize, Serialize};

use crate::acquisition::AfterBenchLoss;

/// Connected instruments. Without this table a run needs a simulated bench.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, Validate)]
#[serde(deny_unknown_fields)]
pub struct InstrumentSettings {
    /// In the order of the `[[camera]]` tables.
    #[garde(length(min = 1, max = 2), dive)]
    pub camera: Vec<CameraSettings>,
    /// The unit that triggers laser and cameras.
    #[garde(dive)]
    pub synchroniser: SynchroniserSettings,
    /// How long to wait for a frame after it is due, in s: a few periods and readouts.
    #[serde(default = "one_second")]
    #[garde(custom(finite), range(min = 0.01, max = 600.0))]
    pub frame_patience_s: f64,
    /// What a run does when the synchroniser stops answering: `wait_for_arm`, `go_on` or `end`.
    #[serde(default)]
    #[garde(skip)]
    pub after_bench_loss: AfterBenchLoss,
    /// Folder of the frame records, one file per camera. They list every received frame with a
    /// checksum of its pixels.
    #[serde(default)]
    #[garde(skip)]
    pub frame_record: Option<PathBuf>,
}

fn one_second() -> f64 {
    1.0
}

#[cfg(test)]
mod tests {
    use super::*;

    fn after_bench_loss(line: &str) -> Result<AfterBenchLoss, String> {
        let text = format!(
            "{line}\n[[camera]]\nip = '10.0.0.1'\n\
             [synchroniser]\ndriver = 'bnc-575'\nport = '/dev/ttyUSB0'\n"
        );
        let read: Result<InstrumentSettings, _> = toml::from_str(&text);
        read.map(|instruments| instruments.after_bench_loss).map_err(|error| error.to_string())
    }

    #[test]
    fn the_laser_fires_again_by_itself_only_if_configured() {
        assert_eq!(after_bench_loss(""), Ok(AfterBenchLoss::WaitForArm));
        assert_eq!(after_bench_loss("after_bench_loss = 'go_on'"), Ok(AfterBenchLoss::GoOn));
        assert_eq!(after_bench_loss("after_bench_loss = 'end'"), Ok(AfterBenchLoss::End));
        assert!(after_bench_loss("after_bench_loss = 'fire'").unwrap_err().contains("go_on"));
    }
}
