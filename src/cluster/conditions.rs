//! What results depend on besides the images and the forward model.

use std::fmt;

use serde::{Deserialize, Serialize};

/// Results of several machines are those of one if these are equal.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize)]
pub struct Conditions {
    /// Version of the program that measured.
    pub code_version: String,
    /// Of the configuration's text, which holds the hashes of calibrations.
    pub configuration_sha256: String,
    /// Tells runs of one configuration apart: the hash of a run's shots with their times, where it is over
    /// (parts), and of its reference with its frames, where it may go on (workers).
    pub shots_sha256: String,
    /// Of the background images, where there are some.
    pub background_crc32: Vec<u32>,
}

/// Something that results depend on and that differs.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Difference {
    Version,
    Configuration,
    Background,
    Shots,
}

impl Conditions {
    /// The first of these that is not as in `other`, if any.
    pub fn first_difference(&self, other: &Self) -> Option<Difference> {
        let parts = [
            (self.code_version == other.code_version, Difference::Version),
            (self.configuration_sha256 == other.configuration_sha256, Difference::Configuration),
            (self.background_crc32 == other.background_crc32, Difference::Background),
            (self.shots_sha256 == other.shots_sha256, Difference::Shots),
        ];
        parts.into_iter().find(|(same, _)| !same).map(|(_, difference)| difference)
    }

    /// Why results made under these are not those of a run under `run`, if so.
    pub fn difference(&self, run: &Self) -> Option<String> {
        self.first_difference(run).map(|difference| match difference {
            Difference::Version => format!(
                "was measured by lfpiv {}, and this is {}: measure and merge with one version",
                self.code_version, run.code_version
            ),
            Difference::Configuration => {
                "was measured with another configuration than the run's".to_owned()
            }
            Difference::Background => {
                "was measured with other background images than the run's".to_owned()
            }
            Difference::Shots => "is of another run".to_owned(),
        })
    }
}

impl fmt::Display for Difference {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Self::Version => "version of lfpiv",
            Self::Configuration => "configuration",
            Self::Background => "set of background images",
            Self::Shots => "list of shots",
        })
    }
}
