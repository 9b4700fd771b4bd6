//! How a camera sees the volume, from images of a card that stood at known places in it.
//!
//! A [`camera_model`] traces rays from a place on the microlens array and a place on the pupil back to
//! the card, through a lens with distortion and through a tilted wall. Its parameters come from marks:
//! `coarse_shift` finds the card in an image, `fiducial` tells its place from those a few spacings away,
//! `mark_fit` renders each mark against the pixels of all micro-images that show it, and `adjustment` fits
//! the parameters of both cameras to where the marks were seen. What is handed on is a
//! [`VolumeMap`](crate::model::VolumeMap) for each camera, so that nothing else needs to know of lenses
//! and walls.

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
