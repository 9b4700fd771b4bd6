//! Camera calibration: the grid of micro-images from white images, and the map of the volume from images of
//! a calibration card (`volume`).
//!
//! [`calibrate_grid`] needs only the image of a uniform diffuser. Pitch and angle come from its
//! autocorrelation (`lattice`), phase and radius from its mean unit cell (`unit_cell`). `start` refines both
//! from the centre of the image outwards. Two independent estimators follow: circles fitted to points on rims
//! (`rim_points`, `rim_model`, `edge_arcs`), and rendered micro-images fitted to all pixels
//! (`rendered_discs`). Both model a second aperture that may cut micro-images (`second_aperture`), because the
//! centroid of the light is then not the centre of the stop. A disagreement of the estimators is a warning.

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
