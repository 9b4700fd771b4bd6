//! The raw images of one shot.

use lfpiv_hw::RawImage;
use serde::{Deserialize, Serialize};

/// The four (or two) raw images of one shot.
#[derive(Debug, Clone)]
pub struct ImagePair {
    /// Frames a and b of each camera, in the order of the configuration's cameras.
    pub cameras: Vec<[RawImage; 2]>,
}

/// How safe the raw images behind a result are.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq, PartialOrd, Ord, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum RawLevel {
    /// They are in no raw log: imported images, or a run without one.
    #[default]
    NotKept,
    /// They should have been kept, and could not be written.
    Lost,
    /// In memory, on their way to the disk.
    Acquired,
    /// With the operating system: they survive the end of this process.
    Written,
    /// On the disk: they survive a power cut.
    Synced,
}
