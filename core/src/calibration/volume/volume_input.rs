//! Input of a volume calibration.

use lfpiv_hw::{
    CameraName, Optics, Pose,
    card::{CalibrationCard, Pattern},
};

use super::{CardLight, VolumeError};

/// Least width of a mark, in microlenses.
const LEAST_MICROLENSES: f64 = 4.0;

/// Least number of positions: two depths, and one to leave out.
const LEAST_POSITIONS: usize = 3;

/// Input of a calibration.
#[derive(Debug, Clone, Copy)]
pub struct VolumeInput<'a> {
    /// The nominal optics of all cameras.
    pub optics: &'a Optics,
    /// Nominal poses of the cameras.
    pub poses: &'a [Pose],
    /// The card, its positions and the walls.
    pub card: &'a CalibrationCard,
    /// Images of the card, by position and then by camera.
    pub light: &'a [Vec<CardLight<'a>>],
    /// Standard deviation of the card's true positions from the stated ones, along each axis, in mm; 0: the stated
    /// ones are exact.
    pub stage_deviation_mm: f64,
    /// Centre and half widths of the box in which the maps are valid, in mm.
    pub box_mm: [[f64; 3]; 2],
}

impl VolumeInput<'_> {
    /// Number of steps of a calibration: marks of each image, twice; two fits; cross-validation; maps.
    pub fn steps(&self) -> usize {
        2 * self.poses.len() * self.card.position.len() + 4
    }

    /// Checks that the numbers match, and that all cameras can see the card.
    pub(super) fn check(&self) -> Result<(), VolumeError> {
        let (cameras, positions) = (self.poses.len(), self.card.position.len());
        let numbers = |what, found, expected, each| {
            if found == expected {
                Ok(())
            } else {
                Err(VolumeError::Numbers { what, found, expected, each })
            }
        };
        numbers("images of positions", self.light.len(), positions, "position of the card")?;
        for lights in self.light {
            numbers("images of one position", lights.len(), cameras, "camera")?;
        }
        if !self.card.wall.is_empty() {
            numbers("[[wall]] tables", self.card.wall.len(), cameras, "camera")?;
        }
        if positions < LEAST_POSITIONS {
            return Err(VolumeError::FewPositions { found: positions });
        }
        let card = &self.card.card;
        let mark_mm = match card.pattern {
            Pattern::Dots => card.dot_diameter_mm,
            Pattern::Checkerboard => card.spacing_mm,
        };
        let microlenses = mark_mm / self.optics.object_pitch_mm();
        if microlenses < LEAST_MICROLENSES {
            return Err(VolumeError::SmallMarks { mark_mm, microlenses });
        }
        for (camera, pose) in self.poses.iter().enumerate() {
            let towards = card.normal().dot(&pose.axis);
            if towards.abs() < 0.1 || (towards < 0.0 && card.two_sided_mm.is_none()) {
                return Err(VolumeError::WrongSide { camera: CameraName(camera) });
            }
        }
        Ok(())
    }
}
