//! The JSON file of a grid.

use lfpiv_core::{
    calibration::{
        Agreement, ArrayKind, FNumberMatch, GridCalibration, Lens, LensState, SecondAperture,
    },
    lightfield::MicroImageGrid,
};
use serde::Serialize;

use super::reference_images::InputFile;
use crate::{
    archive::sha256,
    config::{CALIBRATION_VERSION, GRID_FORMAT},
};

/// Explanation of the numbers, written into the file.
const MEANING: &str = "the micro-image of microlens (i, j) is centred at column a0 + a1 i + a2 j \
                       and row b0 + b1 i + b2 j, with column_px = [a0, a1, a2] and row_px = [b0, \
                       b1, b2]; i runs to the right and j upwards, from (0, 0); pixel centres are \
                       whole numbers from 0, rows count downwards; the centre is the stop's, \
                       whatever vignetting cuts off; lists over lenses have one entry per j, and \
                       in it one per i; states are V valid, P partly imaged, D dark, X disturbed; \
                       open_share is what the second aperture leaves of the stop's disc, light the \
                       mean light relative to the brightest lenses";

/// The files that the grid was made from.
#[derive(Debug, Serialize)]
pub struct Inputs {
    /// White images.
    pub white: Vec<InputFile>,
    /// Dark images.
    pub dark: Vec<InputFile>,
    /// The configuration.
    pub configuration: Option<InputFile>,
}

/// Content of `grid.json`.
#[derive(Debug, Serialize)]
pub struct GridFile {
    format: &'static str,
    version: u32,
    /// SHA-256 of the file's content as JSON without white space, computed with this field empty.
    pub sha256: String,
    program: &'static str,
    camera: Option<String>,
    #[serde(flatten)]
    grid: MicroImageGrid,
    meaning: &'static str,
    array: ArrayKind,
    pitch_px: [f64; 2],
    turned_deg: [f64; 2],
    heldout_residual_px: [f64; 2],
    heldout_lenses: usize,
    heldout_residual_beside_smooth_displacement_px: [f64; 2],
    estimators_agree: Option<bool>,
    agreement: Option<Agreement>,
    micro_image: MicroImage,
    f_number: FNumber,
    lens_counts: LensCounts,
    warnings: Vec<String>,
    /// The files that the grid was made from.
    pub inputs: Inputs,
    states: Vec<String>,
    open_share: Vec<Vec<f64>>,
    light: Vec<Vec<f64>>,
}

#[derive(Debug, Serialize)]
struct MicroImage {
    radius_px: f64,
    blur_px: f64,
    second_aperture: Option<SecondAperture>,
}

#[derive(Debug, Serialize)]
struct FNumber {
    #[serde(flatten)]
    numbers: FNumberMatch,
    words: String,
}

#[derive(Debug, Serialize)]
struct LensCounts {
    valid: usize,
    partly_imaged: usize,
    dark: usize,
    disturbed: usize,
}

impl GridFile {
    /// The file's content for a calibration.
    pub fn new(
        camera: Option<String>,
        found: &GridCalibration,
        inputs: Inputs,
    ) -> serde_json::Result<Self> {
        let rows = || found.lenses.chunks(found.grid.microlenses[0].max(1));
        let map = |value: fn(&Lens) -> f64| {
            rows().map(|row| row.iter().map(|lens| thousandths(value(lens))).collect()).collect()
        };
        let mut file = Self {
            format: GRID_FORMAT,
            version: CALIBRATION_VERSION,
            sha256: String::new(),
            program: concat!("lfpiv ", env!("CARGO_PKG_VERSION")),
            camera,
            grid: found.grid.clone(),
            meaning: MEANING,
            array: found.array,
            pitch_px: found.grid.pitch_px(),
            turned_deg: found.grid.turned_deg(),
            heldout_residual_px: found.heldout.rms_px,
            heldout_lenses: found.heldout.lenses,
            heldout_residual_beside_smooth_displacement_px: found.heldout.smooth_rms_px,
            estimators_agree: found.agreement.map(|agreement| agreement.is_good()),
            agreement: found.agreement,
            micro_image: MicroImage {
                radius_px: found.radius_px,
                blur_px: found.blur_px,
                second_aperture: found.second_aperture,
            },
            f_number: FNumber { numbers: found.f_number, words: found.f_number.to_string() },
            lens_counts: LensCounts {
                valid: found.count(LensState::Valid),
                partly_imaged: found.count(LensState::PartlyImaged),
                dark: found.count(LensState::Dark),
                disturbed: found.count(LensState::Disturbed),
            },
            warnings: found.warnings.iter().map(ToString::to_string).collect(),
            inputs,
            states: rows().map(|row| row.iter().map(letter).collect()).collect(),
            open_share: map(|lens| lens.open_share),
            light: map(|lens| lens.light),
        };
        file.sha256 = sha256(&serde_json::to_vec(&file)?);
        Ok(file)
    }
}

fn letter(lens: &Lens) -> char {
    match lens.state {
        LensState::Valid => 'V',
        LensState::PartlyImaged => 'P',
        LensState::Dark => 'D',
        LensState::Disturbed => 'X',
    }
}

fn thousandths(value: f64) -> f64 {
    (value * 1000.0).round() / 1000.0
}
