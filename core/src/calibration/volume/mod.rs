//! Calibration of all cameras from images of a card at known positions in the volume.
//!
//! A [`camera_model`] traces rays from a point on the microlens array and a point on the pupil back to the card,
//! through a lens with distortion and through a tilted wall. Its parameters are fitted to marks on the card.
//! `coarse_shift` locates the card in an image, `fiducial` resolves its ambiguity by whole mark spacings,
//! `mark_fit` fits each rendered mark to the pixels of all micro-images that show it, and `adjustment` fits the
//! parameters of all cameras to the measured marks. The result is a [`VolumeMap`](crate::model::VolumeMap) for each
//! camera; other modules need no model of lenses and walls.
//!
//! In names, a `place` is a point on the microlens plane, and a `position` is the index of a position of the card.

mod adjustment;
mod calibrated_camera;
mod camera_model;
mod card_light;
mod checks;
mod coarse_shift;
mod error;
mod fiducial;
mod held_out;
mod mark_fit;
mod mark_map;
mod parameters;
mod volume_calibration;
mod volume_input;
mod warnings;

#[cfg(test)]
mod tests;

pub use calibrated_camera::{CalibratedCamera, MarkResidual};
pub use card_light::CardLight;
pub use error::VolumeError;
pub use held_out::HeldOut;
pub use parameters::{PARAMETERS, ParameterEstimate};
pub use volume_calibration::{VolumeCalibration, calibrate_volume};
pub use volume_input::VolumeInput;
pub use warnings::VolumeWarning;
