//! The file that `lfpiv calibrate volume` writes: what the cameras of a bench are.

use std::path::Path;

use lfpiv_core::{lightfield::MicroImageGrid, model::VolumeMap};
use lfpiv_hw::{Optics, Pose};
use lfpiv_rawlog::regular_file::read_text;
use serde::{Deserialize, Serialize};

use crate::archive::{sha256, stated_and_true_hash};

/// What tells the file of cameras from others.
const CAMERAS: &str = "lfpiv camera calibration";

/// What tells the file of one camera's grid from others.
pub const GRID: &str = "lfpiv micro-image grid";

/// Raised when what is in one of the files changes its meaning.
pub const VERSION: u32 = 1;

/// How the numbers are meant.
const MEANING: &str = "grid: as in a grid file; map: what an ideal camera as drawn (optics, right, up, \
                       axis, origin_mm) would see in place of a world point: with x, y, z = (world - \
                       centre_mm) / half_mm, the sums of terms times x^a y^b z^c, a + b + c up to degree, \
                       by rising a, then b, then c; of each term the factors of both lateral coordinates \
                       along right and up and of both depths along axis, for columns and for rows, in mm";

/// What is known of the cameras of a bench.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct CalibrationFile {
    /// What kind of file it is.
    format: String,
    /// [`VERSION`].
    version: u32,
    /// SHA-256 of this file's content as JSON without white space, with this one empty.
    pub sha256: String,
    /// The program that wrote it.
    program: String,
    meaning: String,
    /// The optics as drawn.
    pub optics: Optics,
    /// One entry per camera.
    pub cameras: Vec<CalibratedCameraEntry>,
}

/// One camera.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct CalibratedCameraEntry {
    /// Its name, as `cam1`.
    pub camera: String,
    /// The device's serial number, where it was told.
    pub serial: Option<String>,
    /// Column and row of the sensor where its images begin, where it was told.
    pub offset_px: Option<[u32; 2]>,
    /// Where it stands, as drawn.
    pub pose: Pose,
    /// Where its micro-images are centred.
    pub grid: MicroImageGrid,
    /// How it sees the volume.
    pub map: VolumeMap,
}

impl CalibrationFile {
    /// The file of these cameras; its hash is still to be set by [`hashed`].
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

/// The hash for a file whose own is still empty.
///
/// # Errors
/// It cannot be written as JSON.
pub fn hash_of(file: &impl Serialize) -> serde_json::Result<String> {
    Ok(sha256(&serde_json::to_vec(file)?))
}

/// The grid of one camera, as far as a configuration reads it.
#[derive(Debug, Clone, PartialEq, Deserialize)]
pub struct GridContent {
    /// The camera that its images were said to be of.
    pub camera: Option<String>,
    /// Where micro-images are centred.
    #[serde(flatten)]
    pub grid: MicroImageGrid,
}

/// A file that a calibration is read from.
#[derive(Debug, Clone, PartialEq)]
pub enum Content {
    /// Of `lfpiv calibrate grid`.
    Grid(GridContent),
    /// Of `lfpiv calibrate volume`.
    Cameras(Box<CalibrationFile>),
}

#[derive(Deserialize)]
struct Head {
    format: String,
    version: u32,
}

/// Reads a file of either kind, and its hash.
///
/// # Errors
/// In words for its owner: it cannot be read, is another kind of file or of a later version, or was
/// changed after it was written.
pub fn read_calibration(path: &Path) -> Result<(Content, String), String> {
    let text = read_text(path).map_err(|error| format!("it cannot be read: {error}"))?;
    let other = |error: serde_json::Error| {
        format!("it is no file of `lfpiv calibrate grid` or `lfpiv calibrate volume`: {error}")
    };
    let head: Head = serde_json::from_str(&text).map_err(other)?;
    if ![GRID, CAMERAS].contains(&head.format.as_str()) {
        return Err(format!(
            "its format is {:?}; allowed: {GRID:?} or {CAMERAS:?}, which `lfpiv calibrate grid` and \
             `lfpiv calibrate volume` write",
            head.format
        ));
    }
    if head.version > VERSION {
        return Err(format!(
            "its version is {}, and this program reads up to {VERSION}: use the program that wrote it, or a \
             later one",
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
        _ => Err("its content is not what was written: its hash differs; take a whole copy, or \
                  calibrate again"
            .into()),
    }
}
