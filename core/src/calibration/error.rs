//! Errors of the grid calibration.

use thiserror::Error;

/// Reasons for which no grid is found in white images.
#[derive(Debug, Clone, PartialEq, Error)]
pub enum CalibrationError {
    /// No white image was given.
    #[error("no white image was given: record a diffuser that fills the main lens' pupil")]
    NoImage,
    /// Images of different sizes.
    #[error(
        "image {number} has {found_columns} x {found_rows} pixels but the first one has \
         {columns} x {rows}: all white and dark images must be of the same camera"
    )]
    DifferentSizes {
        /// Number of the image from 1, white images first.
        number: usize,
        /// Its pixel columns.
        found_columns: usize,
        /// Its pixel rows.
        found_rows: usize,
        /// Pixel columns of the first image.
        columns: usize,
        /// Pixel rows of the first image.
        rows: usize,
    },
    /// The image is not periodic.
    #[error(
        "the white image does not repeat from microlens to microlens: give an image of a uniform \
         diffuser with the main lens in place, neither black nor saturated"
    )]
    NotPeriodic,
    /// Micro-images have too few pixels.
    #[error(
        "micro-images are {pitch_px:.1} pixels apart, and at least {least_px:.0} are needed to find \
         their rims"
    )]
    PitchTooSmall {
        /// Distance between neighbours, in pixels.
        pitch_px: f64,
        /// Smallest pitch that can be measured, in pixels.
        least_px: f64,
    },
    /// Too few micro-images can be measured.
    #[error(
        "only {found} micro-images can be measured and at least {needed} are needed: look at the white \
         image for uniform light and for micro-images with visible rims"
    )]
    TooFewLenses {
        /// Number of micro-images that could be measured.
        found: usize,
        /// Least number needed.
        needed: usize,
    },
}
