//! The JSON files of `lfpiv calibrate grid` and `lfpiv calibrate volume`.

use std::path::Path;

use lfpiv_core::{lightfield::MicroImageGrid, model::VolumeMap};
use lfpiv_hw::{Optics, Pose};
use lfpiv_rawlog::regular_file::read_text;
use serde::{Deserialize, Serialize};

use crate::archive::{sha256, stated_and_true_hash};

/// `format` of a file that calibrates the cameras of a bench.
const CAMERAS: &str = "lfpiv camera calibration";

/// `format` of a file with one camera's micro-image grid.
pub const GRID: &str = "lfpiv micro-image grid";

/// Version of both formats; raised when the meaning of a field changes.
pub const VERSION: u32 = 1;

/// Explanation of the numbers, written into the file.
const MEANING: &str = "grid: as in a grid file; map: what an ideal camera as drawn (optics, right, \
                       up, axis, origin_mm) would see in place of a world point: with x, y, z = \
                       (world - centre_mm) / half_mm, the sums of terms times x^a y^b z^c, a + b + \
                       c up to degree, by rising a, then b, then c; of each term the factors of \
                       both lateral coordinates along right and up and of both depths along axis, \
                       for columns and for rows, in mm";

/// The calibration of a bench's cameras.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct CalibrationFile {
    /// [`CAMERAS`].
    format: String,
    /// [`VERSION`].
    version: u32,
    /// SHA-256 of the file's content as JSON without white space, computed with this field empty.
    pub sha256: String,
    /// The program that wrote it.
    program: String,
    meaning: String,
    /// The nominal optics.
    pub optics: Optics,
    /// One entry per camera.
    pub cameras: Vec<CalibratedCameraEntry>,
}

/// The calibration of one camera.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct CalibratedCameraEntry {
    /// The camera's name, such as `cam1`.
    pub camera: String,
    /// The device's serial number, if it was given.
    pub serial: Option<String>,
    /// First column and row of the sensor region that was calibrated, if given.
    pub offset_px: Option<[u32; 2]>,
    /// The camera's nominal pose.
    pub pose: Pose,
    /// The centres of its micro-images.
    pub grid: MicroImageGrid,
    /// The map from world points to what the nominal camera would see.
    pub map: VolumeMap,
}

impl CalibrationFile {
    /// A file with these cameras. Its hash is empty; [`hash_of`] computes it.
    pub fn new(optics: Optics, cameras: Vec<CalibratedCameraEntry>) -> Self {
        Self {
            format: CAMERAS.into(),
            version: VERSION,
            sha256: String::new(),
            program: concat!("lfpiv ", env!("CARGO_PKG_VERSION")).into(),
            meaning: MEANING.into(),
            optics,
            cameras,
        }
    }
}

/// The SHA-256 hash of a file whose `sha256` field is empty.
///
/// # Errors
/// The file cannot be serialized as JSON.
pub fn hash_of(file: &impl Serialize) -> serde_json::Result<String> {
    Ok(sha256(&serde_json::to_vec(file)?))
}

/// A camera's grid file, as far as a configuration needs it.
#[derive(Debug, Clone, PartialEq, Deserialize)]
pub struct GridContent {
    /// The camera that the images were stated to be from.
    pub camera: Option<String>,
    /// The centres of the micro-images.
    #[serde(flatten)]
    pub grid: MicroImageGrid,
}

/// Content of a calibration file.
#[derive(Debug, Clone, PartialEq)]
pub enum Content {
    /// From `lfpiv calibrate grid`.
    Grid(GridContent),
    /// From `lfpiv calibrate volume`.
    Cameras(Box<CalibrationFile>),
}

#[derive(Deserialize)]
struct Head {
    format: String,
    version: u32,
}

/// Reads a calibration file of either kind; returns its content and hash.
///
/// # Errors
/// A message for the user: the file cannot be read, is of another kind or a later version, or was
/// changed after it was written.
pub fn read_calibration(path: &Path) -> Result<(Content, String), String> {
    let text = read_text(path).map_err(|error| format!("it cannot be read: {error}"))?;
    let other = |error: serde_json::Error| {
        format!("it is not a file of `lfpiv calibrate grid` or `lfpiv calibrate volume`: {error}")
    };
    let head: Head = serde_json::from_str(&text).map_err(other)?;
    if ![GRID, CAMERAS].contains(&head.format.as_str()) {
        return Err(format!(
            "its format is {:?}; allowed: {GRID:?} or {CAMERAS:?}, which `lfpiv calibrate grid` \
             and `lfpiv calibrate volume` write",
            head.format
        ));
    }
    if head.version > VERSION {
        return Err(format!(
            "its version is {}, and this program reads up to {VERSION}: use the program that wrote \
             it, or a later one",
            head.version
        ));
    }
    match stated_and_true_hash(&text) {
        Some([stated, found]) if stated == found => {
            let content = match head.format.as_str() {
                GRID => Content::Grid(serde_json::from_str(&text).map_err(other)?),
                _ => Content::Cameras(serde_json::from_str(&text).map_err(other)?),
            };
            Ok((content, stated))
        }
        _ => Err("its content is not what was written, because its hash differs; use an intact \
                  copy, or calibrate again"
            .into()),
    }
}
