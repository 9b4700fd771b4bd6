//! The JSON file of a volume calibration: the calibration itself and its quality.

use lfpiv_core::{
    calibration::{HeldOut, ParameterEstimate, VolumeCalibration},
    lightfield::MicroImageGrid,
};
use lfpiv_hw::{
    CameraName,
    card::{CalibrationCard, Wall},
};
use serde::Serialize;

use super::reference_images::InputFile;
use crate::config::{CalibratedCameraEntry, CalibrationFile, Config, hash_of};

/// The files that the calibration was made from.
#[derive(Debug, Serialize)]
pub struct Inputs {
    /// The card file.
    pub card: InputFile,
    /// The configuration.
    pub configuration: InputFile,
    /// The grids.
    pub grids: Vec<InputFile>,
    /// White, dark and card images.
    pub images: Vec<InputFile>,
}

/// Content of `calibration.json`.
#[derive(Debug, Serialize)]
pub struct VolumeFile {
    #[serde(flatten)]
    calibration: CalibrationFile,
    quality: Vec<Quality>,
    held_out: HeldOut,
    condition_number: f64,
    walls: Vec<Wall>,
    /// Fitted minus stated position of the card at each position, in mm.
    stage_mm: Vec<[f64; 3]>,
    warnings: Vec<String>,
    inputs: Inputs,
}

/// Quality of the calibration of one camera.
#[derive(Debug, Serialize)]
struct Quality {
    camera: String,
    marks: usize,
    rms_microlenses: f64,
    map_residual_lateral_mm: f64,
    map_residual_depth_mm: f64,
    parameters: Vec<ParameterEstimate>,
}

impl VolumeFile {
    /// The file's content for a calibration.
    pub fn new(
        config: &Config,
        serials: &[String],
        card: &CalibrationCard,
        grids: &[MicroImageGrid],
        found: &VolumeCalibration,
        inputs: Inputs,
    ) -> serde_json::Result<Self> {
        let entry = |camera: usize| {
            let devices = config.instruments.as_ref().map(|instruments| &instruments.camera);
            let device = devices.and_then(|devices| devices.get(camera));
            let configured = device.and_then(|device| device.serial.clone());
            CalibratedCameraEntry {
                camera: CameraName(camera).to_string(),
                serial: serials.get(camera).cloned().or(configured),
                offset_px: device.and_then(|device| device.offset_px),
                pose: config.camera[camera].pose(),
                grid: grids[camera].clone(),
                map: found.cameras[camera].map.clone(),
            }
        };
        let cameras = (0..found.cameras.len()).map(entry).collect();
        let quality = found.cameras.iter().enumerate().map(|(camera, calibrated)| Quality {
            camera: CameraName(camera).to_string(),
            marks: calibrated.marks.len(),
            rms_microlenses: calibrated.rms_microlenses,
            map_residual_lateral_mm: calibrated.map_residual.lateral_mm,
            map_residual_depth_mm: calibrated.map_residual.depth_mm,
            parameters: calibrated.parameters.clone(),
        });
        let mut file = Self {
            calibration: CalibrationFile::new(config.optics.clone(), cameras),
            quality: quality.collect(),
            held_out: found.held_out,
            condition_number: found.condition_number,
            walls: card.wall.clone(),
            stage_mm: found.stage_mm.clone(),
            warnings: found.warnings.iter().map(ToString::to_string).collect(),
            inputs,
        };
        file.calibration.sha256 = hash_of(&file)?;
        Ok(file)
    }

    /// The file's hash.
    pub fn sha256(&self) -> &str {
        &self.calibration.sha256
    }
}
