//! The raw images of one shot.

use lfpiv_hw::RawImage;

/// The four (or two) raw images of one shot.
#[derive(Debug, Clone)]
pub struct ImagePair {
    /// Frames a and b of each camera, in the order of the configuration's cameras.
    pub cameras: Vec<[RawImage; 2]>,
}
