//! What a camera is, from images made for it: where its micro-images are, from white images; and how
//! it sees the volume, from images of a card (`volume`).
//!
//! [`calibrate_grid`] needs nothing but the image of a uniform diffuser: pitch and angle come from its
//! autocorrelation (`lattice`), phase and radius from its mean cell (`unit_cell`), both followed outwards
//! (`start`). From there two estimators go their own ways: arcs through points on rims
//! (`rim_points`, `rim_model`, `edge_arcs`), and rendered micro-images against all pixels
//! (`rendered_discs`). Both know that a second aperture may cut micro-images (`second_aperture`): the middle
//! of what is lit is not the middle of the stop. Where they disagree, the calibration says so.

mod affine_fit;
mod agreement;
mod cell_light;
mod edge_arcs;
mod error;
mod f_number;
mod focus;
mod fourier;
mod geometry;
mod grid_calibration;
mod lattice;
mod lens_states;
mod numbering;
mod rendered_discs;
mod rendering;
mod rim_model;
mod rim_points;
mod second_aperture;
mod start;
mod unit_cell;
mod volume;
mod warnings;
mod white_image;

pub use agreement::Agreement;
pub use error::CalibrationError;
pub use f_number::FNumberMatch;
pub use focus::{Focus, focus};
pub use grid_calibration::{
    ArrayKind, GRID_STEPS, GridCalibration, Residual, calibrate_grid, calibrate_grid_watched,
};
pub use lens_states::{Lens, LensState};
pub use second_aperture::SecondAperture;
pub use volume::{
    CalibratedCamera, CardLight, HeldOut, MarkResidual, PARAMETERS, ParameterEstimate,
    VolumeCalibration, VolumeError, VolumeInput, VolumeWarning, calibrate_volume,
};
pub use warnings::GridWarning;
pub use white_image::WhiteImage;

use geometry::{cell_pixels, median, neighbour_numbers, neighbours, pitch_px};

#[cfg(test)]
mod tests;
