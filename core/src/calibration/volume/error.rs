//! Why a volume could not be calibrated.

use lfpiv_hw::CameraName;
use thiserror::Error;

/// Why a card's images tell nothing of the cameras.
#[derive(Debug, Clone, PartialEq, Error)]
pub enum VolumeError {
    /// Numbers of cameras, images or positions do not belong together.
    #[error("{what}: {found} given, {expected} needed, one for each {each}")]
    Numbers {
        /// What was given.
        what: &'static str,
        /// How many.
        found: usize,
        /// How many are needed.
        expected: usize,
        /// What each belongs to.
        each: &'static str,
    },
    /// Too few positions to tell depths and to leave one out.
    #[error(
        "the card stood at {found} positions: at least 3 at different depths are needed, 5 to 9 are better"
    )]
    FewPositions {
        /// How many there were.
        found: usize,
    },
    /// Marks too small for microlenses.
    #[error(
        "a mark of {mark_mm} mm is {microlenses:.1} microlenses wide: at least 4 are needed; take a card \
         with larger marks"
    )]
    SmallMarks {
        /// Diameter or spacing, in mm.
        mark_mm: f64,
        /// In microlenses, in the plane in focus.
        microlenses: f64,
    },
    /// A camera looks at the side that shows nothing.
    #[error(
        "{camera} looks at the card's unprinted side, or along it: turn card.right and card.up, or give \
         card.two_sided_mm"
    )]
    WrongSide {
        /// Which camera.
        camera: CameraName,
    },
    /// The card is not in the image.
    #[error(
        "{camera} does not show the card of position {position} (correlation {correlation:.2}): compare \
         spacing, diameters, directions and origin_mm in the card file with the image"
    )]
    CardNotFound {
        /// Which camera.
        camera: CameraName,
        /// Which position, from 1.
        position: usize,
        /// With the best place.
        correlation: f64,
    },
    /// Not enough marks.
    #[error(
        "{camera} shows {found} whole marks at all positions together: at least {needed} are needed; take a \
         card with smaller spacing, or move it into the field"
    )]
    FewMarks {
        /// Which camera.
        camera: CameraName,
        /// Marks found.
        found: usize,
        /// Least number.
        needed: usize,
    },
    /// The bench that the files describe cannot see the card.
    #[error(
        "rays from a camera miss the wall or the card: the walls' distances or the card's positions are \
         wrong, or a camera is far from its pose"
    )]
    RaysMiss,
    /// The normal matrix is singular.
    #[error("no camera fits what was seen: compare the card file with the images")]
    NothingFits,
    /// No map follows the rays.
    #[error("the volume has no map: a camera does not see all of [volume] through its wall")]
    NoMap,
}
