//! Calibration of the grid from a white image, with its quality measures and warnings.

use lfpiv_hw::Optics;
use serde::{Deserialize, Serialize};

use super::{
    Agreement, CalibrationError, FNumberMatch, GridWarning, Lens, LensState, SecondAperture,
    WhiteImage, affine_fit, cell_light::CellLight, edge_arcs, lens_states, numbering,
    rendered_discs, second_aperture::Field, start,
};
use crate::lightfield::MicroImageGrid;

/// Least number of usable lenses.
const LEAST_LENSES: usize = 12;

/// Largest residual of held-out lenses along an axis without a warning, rms in pixels.
const MOST_HELDOUT_PX: f64 = 0.05;

/// Largest share of saturated pixels without a warning.
const MOST_SATURATED: f64 = 0.005;

/// Least share of valid among lit lenses without a warning.
const LEAST_VALID: f64 = 0.8;

/// Largest relative deviation of the pitch from the configured one without a warning.
const PITCH_TOLERANCE: f64 = 0.02;

/// How microlenses are packed.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum ArrayKind {
    /// Rows and columns at right angles.
    Square,
    /// Six neighbours at equal distances.
    Hexagonal,
}

/// Residuals of lenses that are held out of a fit.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct Residual {
    /// Root-mean-square residual along columns and along rows, in pixels.
    pub rms_px: [f64; 2],
    /// The same after subtracting a smooth displacement, a third-order polynomial over the field. A much smaller
    /// value means that the optics displace micro-images, not that they are badly measured.
    pub smooth_rms_px: [f64; 2],
    /// Number of held-out lenses.
    pub lenses: usize,
}

/// Result of a grid calibration.
#[derive(Debug, Clone)]
pub struct GridCalibration {
    /// The grid of the centres of the stop's images.
    pub grid: MicroImageGrid,
    /// How the lenses are packed.
    pub array: ArrayKind,
    /// Residuals of held-out lenses.
    pub heldout: Residual,
    /// Distance between the grids of both estimators; `None` if only one could be fitted.
    pub agreement: Option<Agreement>,
    /// Radius of the stop's disc, in pixels.
    pub radius_px: f64,
    /// Gaussian blur of its rim, standard deviation in pixels.
    pub blur_px: f64,
    /// The aperture that cuts micro-images, if there is one.
    pub second_aperture: Option<SecondAperture>,
    /// Diameter of micro-images relative to their pitch.
    pub f_number: FNumberMatch,
    /// All lenses, row by row from lens (0, 0): lens (i, j) at j · columns + i.
    pub lenses: Vec<Lens>,
    /// Reasons to doubt the result.
    pub warnings: Vec<GridWarning>,
    field: Field,
}

impl GridCalibration {
    /// Number of lenses in a state.
    pub fn count(&self, state: LensState) -> usize {
        self.lenses.iter().filter(|lens| lens.state == state).count()
    }

    /// Circle of the second aperture in the micro-image with the stop's centre at `stop_px`: column, row and
    /// radius, in pixels.
    pub fn second_circle_px(&self, stop_px: [f64; 2]) -> Option<[f64; 3]> {
        let second = self.second_aperture.as_ref()?;
        let [column, row] = second.centre_px(stop_px, &self.field);
        Some([column, row, second.radius_px])
    }

    /// Least share that the second aperture leaves open, over the valid micro-images.
    pub fn least_open_share(&self) -> f64 {
        let valid = self.lenses.iter().filter(|lens| lens.state == LensState::Valid);
        valid.map(|lens| lens.open_share).fold(1.0, f64::min)
    }
}

/// Finds the micro-images of a white image. `optics` are optional. They give the number of lenses, and thus which
/// lens is (0, 0), and the pitch to compare with in a warning.
///
/// # Errors
/// The image is not periodic, micro-images are too small, or too few of them can be measured.
pub fn calibrate_grid(
    image: &WhiteImage,
    optics: Option<&Optics>,
) -> Result<GridCalibration, CalibrationError> {
    calibrate_grid_watched(image, optics, |_| ())
}

/// Number of steps of a calibration: initial grid, Gauss-Newton steps, centres, fit to rims.
pub const GRID_STEPS: usize = rendered_discs::ROUNDS + 3;

/// As [`calibrate_grid`]; calls `steps_done` with the number of completed steps out of [`GRID_STEPS`]. It skips
/// numbers if the fit converges early.
///
/// # Errors
/// As [`calibrate_grid`].
pub fn calibrate_grid_watched(
    image: &WhiteImage,
    optics: Option<&Optics>,
    mut steps_done: impl FnMut(usize),
) -> Result<GridCalibration, CalibrationError> {
    let start = start::find(image)?;
    let light = CellLight::of_image(image, &start.grid);
    let lenses = lens_states::usable(image, &start.grid, &light);
    let too_few = |found: usize| CalibrationError::TooFewLenses { found, needed: LEAST_LENSES };
    if lenses.len() < LEAST_LENSES {
        return Err(too_few(lenses.len()));
    }
    steps_done(1);
    let mut rounds = 0;
    let round_ended = || {
        rounds += 1;
        steps_done(1 + rounds);
    };
    let discs =
        rendered_discs::fit(image, &start, &light, &lenses, round_ended).ok_or(too_few(0))?;
    steps_done(GRID_STEPS - 1);
    let fit = affine_fit::fit(&discs.grid, &discs.centres).ok_or(too_few(discs.centres.len()))?;
    let agreement = edge_arcs::fit(image, start.circles(), &lenses)
        .and_then(|arcs| affine_fit::fit(&arcs.circles.grid, &arcs.centres))
        .map(|arcs| Agreement::of(&fit.grid, &arcs.grid, &lenses));
    steps_done(GRID_STEPS);
    let lit = numbering::lit_range(&fit.grid, &light).ok_or(too_few(0))?;
    let size = [image.columns(), image.rows()];
    let (grid, first) = numbering::number(&fit.grid, lit, optics, size);
    let lenses = lens_states::states(image, &grid, first, &light, &discs, &fit);
    let mut calibration = GridCalibration {
        array: if grid.is_square() { ArrayKind::Square } else { ArrayKind::Hexagonal },
        heldout: Residual {
            rms_px: fit.heldout_px,
            smooth_rms_px: fit.smooth_heldout_px,
            lenses: fit.heldout_lenses,
        },
        agreement,
        radius_px: discs.radius_px,
        blur_px: discs.blur_px,
        second_aperture: discs.second,
        f_number: FNumberMatch::of(discs.radius_px, super::pitch_px(&grid)),
        grid,
        lenses,
        warnings: Vec::new(),
        field: Field::of(image.columns(), image.rows()),
    };
    calibration.warnings = warnings(&calibration, image, optics, lit);
    Ok(calibration)
}

fn warnings(
    found: &GridCalibration,
    image: &WhiteImage,
    optics: Option<&Optics>,
    lit: numbering::Range,
) -> Vec<GridWarning> {
    let mut warnings = Vec::new();
    match found.agreement {
        None => warnings.push(GridWarning::OneEstimator { missing: "arcs of rims" }),
        Some(agreement) if !agreement.is_good() => {
            warnings.push(GridWarning::Disagreement { agreement });
        }
        Some(_) => {}
    }
    let Residual { rms_px, smooth_rms_px, .. } = found.heldout;
    if rms_px.iter().any(|rms| *rms > MOST_HELDOUT_PX) {
        let (heldout_px, smooth_heldout_px) = (rms_px, smooth_rms_px);
        warnings.push(GridWarning::Irregular { heldout_px, smooth_heldout_px });
    }
    if image.saturated_share() > MOST_SATURATED {
        warnings.push(GridWarning::Saturated { share: image.saturated_share() });
    }
    let valid = found.count(LensState::Valid);
    let lit_lenses = valid + found.count(LensState::Disturbed);
    if (valid as f64) < LEAST_VALID * lit_lenses as f64 {
        warnings.push(GridWarning::FewValid { valid, lit: lit_lenses });
    }
    if let Some(optics) = optics {
        let configured_px = optics.micro_image_pitch_mm() / optics.pixel_pitch_mm();
        let found_px = super::pitch_px(&found.grid);
        if (found_px / configured_px - 1.0).abs() > PITCH_TOLERANCE {
            warnings.push(GridWarning::OtherPitch { configured_px, found_px });
        }
        let lit = lit.map(|[first, last]| last - first + 1);
        let configured = [optics.microlens.columns, optics.microlens.rows];
        if (0..2).any(|axis| lit[axis] > configured[axis]) {
            warnings.push(GridWarning::MoreLenses { lit, configured });
        }
    }
    warnings
}
