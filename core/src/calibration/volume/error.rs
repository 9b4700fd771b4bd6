//! Errors of the volume calibration.

use lfpiv_hw::CameraName;
use thiserror::Error;

/// Reasons for which cameras cannot be calibrated from images of a card.
#[derive(Debug, Clone, PartialEq, Error)]
pub enum VolumeError {
    /// Numbers of cameras, images and positions do not match.
    #[error("{what}: {found} given, {expected} needed, one for each {each}")]
    Numbers {
        /// The counted items.
        what: &'static str,
        /// Number given.
        found: usize,
        /// Number needed.
        expected: usize,
        /// The item to which each belongs.
        each: &'static str,
    },
    /// Too few positions for different depths and for cross-validation.
    #[error(
        "the card stood at {found} positions: at least 3 at different depths are needed, 5 to 9 are better"
    )]
    FewPositions {
        /// Number of positions.
        found: usize,
    },
    /// Marks are too small for the microlenses.
    #[error(
        "a mark of {mark_mm} mm is {microlenses:.1} microlenses wide: at least 4 are needed; take a card \
         with larger marks"
    )]
    SmallMarks {
        /// Diameter or spacing, in mm.
        mark_mm: f64,
        /// The same in microlenses, in the plane in focus.
        microlenses: f64,
    },
    /// A camera looks at the unprinted side of the card, or along it.
    #[error(
        "{camera} looks at the card's unprinted side, or along it: turn card.right and card.up, or give \
         card.two_sided_mm"
    )]
    WrongSide {
        /// The camera.
        camera: CameraName,
    },
    /// The card is not in the image.
    #[error(
        "{camera} does not show the card of position {position} (correlation {correlation:.2}): compare \
         spacing, diameters, directions and origin_mm in the card file with the image"
    )]
    CardNotFound {
        /// The camera.
        camera: CameraName,
        /// Number of the position, from 1.
        position: usize,
        /// Highest correlation coefficient.
        correlation: f64,
    },
    /// Too few marks.
    #[error(
        "{camera} shows {found} whole marks at all positions together: at least {needed} are needed; take a \
         card with smaller spacing, or move it into the field"
    )]
    FewMarks {
        /// The camera.
        camera: CameraName,
        /// Number of marks found.
        found: usize,
        /// Least number needed.
        needed: usize,
    },
    /// In the described bench, rays from a camera do not reach the card.
    #[error(
        "rays from a camera miss the wall or the card: the walls' distances or the card's positions are \
         wrong, or a camera is far from its pose"
    )]
    RaysMiss,
    /// The normal matrix is singular.
    #[error("no camera fits what was seen: compare the card file with the images")]
    NothingFits,
    /// A camera does not see the whole volume.
    #[error("the volume has no map: a camera does not see all of [volume] through its wall")]
    NoMap,
}
