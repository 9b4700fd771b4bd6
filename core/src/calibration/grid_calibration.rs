//! From a white image to a grid, and how far it can be trusted.

use lfpiv_hw::Optics;
use serde::{Deserialize, Serialize};

use super::{
    Agreement, CalibrationError, FNumberMatch, GridWarning, Lens, LensState, SecondAperture,
    WhiteImage, affine_fit, cell_light::CellLight, edge_arcs, lens_states, numbering,
    rendered_discs, second_aperture::Field, start,
};
use crate::lightfield::MicroImageGrid;

/// Fewer valid lenses than this do not make a grid.
const LEAST_LENSES: usize = 12;

/// Held-out lenses further beside the grid than this, in pixels rms on an axis, are worth a word.
const REGULAR_PX: f64 = 0.05;

/// More saturated pixels than this share are worth a word.
const SATURATED: f64 = 0.005;

/// Fewer valid lenses than this share of the lit ones are worth a word.
const VALID: f64 = 0.8;

/// A pitch that differs from the configured one by more than this is worth a word.
const PITCH_WITHIN: f64 = 0.02;

/// How microlenses are packed.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum ArrayKind {
    /// Rows and columns at right angles.
    Square,
    /// Six neighbours.
    Hexagonal,
}

/// How far lenses that took no part in a fit are beside it.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct Residual {
    /// Root mean square over columns and over rows, in pixels.
    pub rms_px: [f64; 2],
    /// The same beside a grid that is displaced smoothly over the field, by a polynomial of third order: far
    /// less means that the optics displace micro-images, not that they are badly measured.
    pub smooth_rms_px: [f64; 2],
    /// Lenses that this is of.
    pub lenses: usize,
}

/// Where a camera's micro-images are.
#[derive(Debug, Clone)]
pub struct GridCalibration {
    /// The grid of the stop's centres.
    pub grid: MicroImageGrid,
    /// How the lenses are packed.
    pub array: ArrayKind,
    /// Of lenses that took no part in the fit.
    pub heldout: Residual,
    /// How far two estimators' grids are apart; `None` where only one could be fitted.
    pub agreement: Option<Agreement>,
    /// Radius of the stop's disc, in pixels.
    pub radius_px: f64,
    /// Blur of its rim, a Gaussian's standard deviation in pixels.
    pub blur_px: f64,
    /// The aperture that cuts micro-images, if one does.
    pub second_aperture: Option<SecondAperture>,
    /// Whether micro-images fill their pitch.
    pub f_number: FNumberMatch,
    /// All lenses, row by row from lens (0, 0): lens (i, j) at j · columns + i.
    pub lenses: Vec<Lens>,
    /// Doubts.
    pub warnings: Vec<GridWarning>,
    field: Field,
}

impl GridCalibration {
    /// Lenses in a state.
    pub fn count(&self, state: LensState) -> usize {
        self.lenses.iter().filter(|lens| lens.state == state).count()
    }

    /// The circle of the second aperture for the lens whose stop is centred at a place: its centre's column and
    /// row, and its radius, in pixels.
    pub fn second_circle_px(&self, stop_px: [f64; 2]) -> Option<[f64; 3]> {
        let second = self.second_aperture.as_ref()?;
        let [column, row] = second.centre_px(stop_px, &self.field);
        Some([column, row, second.radius_px])
    }

    /// The smallest share of a valid micro-image that a second aperture leaves.
    pub fn least_open_share(&self) -> f64 {
        let valid = self.lenses.iter().filter(|lens| lens.state == LensState::Valid);
        valid.map(|lens| lens.open_share).fold(1.0, f64::min)
    }
}

/// Finds the micro-images of a white image. `optics`, where they are known, say how many lenses there are
/// and which one is the first; nothing else is taken from them.
///
/// # Errors
/// The image is not periodic, micro-images are too small, or too few of them can be measured.
pub fn calibrate_grid(
    image: &WhiteImage,
    optics: Option<&Optics>,
) -> Result<GridCalibration, CalibrationError> {
    calibrate_grid_watched(image, optics, |_| ())
}

/// Steps of a calibration: the start, rounds of fitted discs, the centres, arcs of rims.
pub const GRID_STEPS: usize = rendered_discs::ROUNDS + 3;

/// As [`calibrate_grid`]; tells how many of the [`GRID_STEPS`] are behind it. Fits that need fewer rounds skip some.
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
    if rms_px.iter().any(|rms| *rms > REGULAR_PX) {
        let (heldout_px, smooth_heldout_px) = (rms_px, smooth_rms_px);
        warnings.push(GridWarning::Irregular { heldout_px, smooth_heldout_px });
    }
    if image.saturated_share() > SATURATED {
        warnings.push(GridWarning::Saturated { share: image.saturated_share() });
    }
    let valid = found.count(LensState::Valid);
    let lit_lenses = valid + found.count(LensState::Disturbed);
    if (valid as f64) < VALID * lit_lenses as f64 {
        warnings.push(GridWarning::FewValid { valid, lit: lit_lenses });
    }
    if let Some(optics) = optics {
        let configured_px = optics.micro_image_pitch_mm() / optics.pixel_pitch_mm();
        let found_px = super::pitch_px(&found.grid);
        if (found_px / configured_px - 1.0).abs() > PITCH_WITHIN {
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
