//! What results depend on besides the images and the forward model.

use serde::{Deserialize, Serialize};

/// See the module. Results of several machines are those of one if these are equal.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize)]
pub struct Conditions {
    /// Version of the program that measured.
    pub code_version: String,
    /// Of the configuration's text, which holds the hashes of calibrations.
    pub configuration_sha256: String,
    /// Of the run's shots with their times: tells runs of one configuration apart.
    pub shots_sha256: String,
    /// Of the background images, where there are some.
    pub background_crc32: Vec<u32>,
}

impl Conditions {
    /// What of these is not as in `other`, if so.
    pub fn first_difference(&self, other: &Self) -> Option<&'static str> {
        let parts = [
            (self.code_version == other.code_version, "version of lfpiv"),
            (self.configuration_sha256 == other.configuration_sha256, "configuration"),
            (self.background_crc32 == other.background_crc32, "background images"),
            (self.shots_sha256 == other.shots_sha256, "shots"),
        ];
        parts.into_iter().find(|(same, _)| !same).map(|(_, what)| what)
    }

    /// In which way results made under these are not those of a run under `run`, if so.
    pub fn difference(&self, run: &Self) -> Option<String> {
        let what = self.first_difference(run)?;
        Some(match what {
            "version of lfpiv" => format!(
                "was measured by lfpiv {}, and this is {}: measure and merge with one version",
                self.code_version, run.code_version
            ),
            "shots" => "is of another run".to_owned(),
            "background images" => {
                "was measured with other background images than the run's".to_owned()
            }
            _ => format!("was measured with another {what} than the run's"),
        })
    }
}
