//! Warnings of a grid calibration.

use thiserror::Error;

use super::Agreement;

/// Reasons to doubt a grid; the messages say what to do.
#[derive(Debug, Clone, PartialEq, Error)]
pub enum GridWarning {
    /// The estimators' grids differ.
    #[error(
        "the two estimators disagree: their grids are {:.2} px apart at 95 % of the lenses and {:.2} px at \
         the worst (0.10 and 0.20 are good): the grid is no better known than that; micro-images are not \
         round, not evenly lit or cut by more than one further aperture", agreement.at_95_percent_px,
        agreement.worst_px
    )]
    Disagreement {
        /// Distance between the grids.
        agreement: Agreement,
    },
    /// One estimator failed.
    #[error(
        "only one of two estimators worked, and nothing checks it: {missing} could not be fitted; look \
         whether micro-images have visible rims"
    )]
    OneEstimator {
        /// The estimator that failed.
        missing: &'static str,
    },
    /// Centres are not on a lattice.
    #[error(
        "micro-images are not on a regular grid: lenses left out of the fit are {:.3} and {:.3} px (rms, \
         columns and rows) beside it; a smooth displacement over the field leaves {:.3} and {:.3} px: {}",
        heldout_px[0], heldout_px[1], smooth_heldout_px[0], smooth_heldout_px[1], cause(*heldout_px, *smooth_heldout_px)
    )]
    Irregular {
        /// Residual of held-out lenses along columns and rows, rms in pixels.
        heldout_px: [f64; 2],
        /// The same after subtracting a smooth displacement of the grid, in pixels.
        smooth_heldout_px: [f64; 2],
    },
    /// Saturated pixels.
    #[error(
        "{:.1} % of the white images' pixels are saturated, which moves rims: expose to 70 % of the \
         range", 100.0 * share
    )]
    Saturated {
        /// Share of the pixels.
        share: f64,
    },
    /// Few lenses can be used.
    #[error("only {valid} of {lit} lit micro-images are valid: look for dust, or uneven light")]
    FewValid {
        /// Valid lenses.
        valid: usize,
        /// Lenses with light.
        lit: usize,
    },
    /// The configured pitch differs.
    #[error(
        "the configuration has a micro-image pitch of {configured_px:.3} px and the image {found_px:.3} \
         px: check optics.microlens.pitch_mm and optics.sensor.pixel_pitch_um"
    )]
    OtherPitch {
        /// Configured pitch, in pixels.
        configured_px: f64,
        /// Pitch found, in pixels.
        found_px: f64,
    },
    /// More micro-images than configured lenses.
    #[error(
        "{} x {} micro-images are lit, more than the {} x {} of the configuration: check \
         optics.microlens.columns and rows", lit[0], lit[1], configured[0], configured[1]
    )]
    MoreLenses {
        /// Lit columns and rows.
        lit: [usize; 2],
        /// Configured ones.
        configured: [usize; 2],
    },
}

/// Likely cause of the residual: a smooth displacement is not due to noise.
fn cause(heldout_px: [f64; 2], smooth_px: [f64; 2]) -> &'static str {
    let length = |[x, y]: [f64; 2]| x.hypot(y);
    if length(smooth_px) < 0.8 * length(heldout_px) {
        "aberrations of the pupil, distortion of a relay lens, or apertures that cut micro-images"
    } else {
        "noise, dust, or a damaged array"
    }
}
