//! The configuration: one TOML file describes bench, volume, method and, for simulated runs, the
//! scene. Most modules define the settings of their own tables; this module combines them and reports
//! errors with line and key.

mod calibration;
mod calibration_file;
mod camera;
mod consistency;
mod instruments;
mod location;
mod mask;
mod overlong;
mod problem;
mod range;
mod server;
mod shipped;
mod stl;
mod volume;

use std::path::{Path, PathBuf};

use garde::Validate;
use lfpiv_core::{
    lightfield::ImageSettings,
    measurement::Measurement,
    model::{CameraCalibration, ModelSettings, mode_or_table},
    reconstruction::ReconstructionSettings,
    velocimetry::VelocimetrySettings,
};
use lfpiv_hw::{Optics, Pose, TimingSettings, check::finite};
use lfpiv_rawlog::RawLogSettings;
use lfpiv_sim::{BenchGeometry, EmptySpace, Scene, Volume, wire::WireSettings};
use serde::{Deserialize, Serialize};

use crate::cluster::ClusterSettings;
pub use calibration::StoredCalibration;
pub use calibration_file::{
    CalibratedCameraEntry, CalibrationFile, Content as CalibrationContent, GRID as GRID_FORMAT,
    VERSION as CALIBRATION_VERSION, hash_of, read_calibration,
};
pub use camera::CameraTable;
pub use consistency::Purpose;
pub use instruments::InstrumentSettings;
pub use mask::{MaskFile, StoredMask};
pub use problem::{ConfigError, Problem};
pub use server::{ServerSettings, TlsSettings};
pub use shipped::read_or_shipped;
pub use volume::{MaskTable, RegionTable, VolumeTable};

/// A configuration and its text, which is stored with the results. The text includes the content of
/// the calibration files that the configuration names, and the mask of its volume.
#[derive(Debug, Clone, PartialEq)]
pub struct ConfigFile {
    /// The configuration file.
    pub path: PathBuf,
    /// The file's text, with calibrations and mask appended.
    pub text: String,
    /// The parsed and checked configuration.
    pub config: Config,
}

impl ConfigFile {
    /// Reads a configuration file for measuring images.
    ///
    /// # Errors
    /// [`ConfigError`]: the file cannot be read or is invalid; every problem is listed.
    pub fn load(path: &Path) -> Result<Self, ConfigError> {
        Self::load_for(Purpose::Images, path)
    }

    /// Reads a configuration file and checks that its tables are consistent for `purpose`.
    ///
    /// # Errors
    /// As [`Self::load`].
    pub fn load_for(purpose: Purpose, path: &Path) -> Result<Self, ConfigError> {
        let text = read_or_shipped(path)
            .map_err(|reason| ConfigError::Unreadable { path: path.into(), reason })?;
        let folder = path.parent().unwrap_or(Path::new(""));
        let config = problem::read(&path.display().to_string(), &text, Some((purpose, folder)))
            .map_err(|problems| ConfigError::Invalid { problems })?;
        Ok(Self { path: path.into(), text: with_files(text, &config)?, config })
    }
}

/// Appends calibrations and mask to the configuration's text, unless it contains them already.
fn with_files(mut text: String, config: &Config) -> Result<String, ConfigError> {
    let table = text.parse::<toml::Table>().unwrap_or_default();
    if !table.contains_key("calibration") {
        text += &calibration::stored_text(&config.calibration)?;
    }
    if let Some(mask) = config.mask.as_ref().filter(|_| !table.contains_key("mask")) {
        text += &mask::stored_text(mask)?;
    }
    Ok(text)
}

/// A whole configuration file.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, Validate)]
#[serde(deny_unknown_fields)]
pub struct Config {
    /// The optics, shared by all cameras.
    #[garde(dive)]
    pub optics: Optics,
    /// One or two cameras.
    #[garde(custom(one_or_two), dive)]
    pub camera: Vec<CameraTable>,
    /// The measurement volume.
    #[garde(dive)]
    pub volume: VolumeTable,
    /// Laser and shot timing.
    #[garde(dive)]
    pub shot: ShotSettings,
    /// Timing limits of laser and cameras.
    #[serde(default)]
    #[garde(dive)]
    pub timing: TimingSettings,
    /// Known properties of the images.
    #[serde(default)]
    #[garde(dive)]
    pub image: ImageSettings,
    /// The effects that the forward model includes; `model = "auto"` is short for a table with that
    /// mode.
    #[serde(default, deserialize_with = "mode_or_table")]
    #[garde(dive)]
    pub model: ModelSettings,
    /// Reconstruction of volumes.
    #[serde(default)]
    #[garde(dive)]
    pub reconstruction: ReconstructionSettings,
    /// Correlation of volumes.
    #[serde(default)]
    #[garde(dive)]
    pub velocimetry: VelocimetrySettings,
    /// Worker pool and queue.
    #[serde(default)]
    #[garde(dive)]
    pub pipeline: PipelineSettings,
    /// Storage of raw data.
    #[serde(default)]
    #[garde(dive)]
    pub raw_log: RawLogSettings,
    /// The HTTP server.
    #[serde(default)]
    #[garde(dive)]
    pub server: ServerSettings,
    /// Workers on other machines; without it, a run measures its shots itself.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    #[garde(dive)]
    pub cluster: Option<ClusterSettings>,
    /// Location of the results.
    #[serde(default)]
    #[garde(dive)]
    pub output: OutputSettings,
    /// The bench's instruments.
    #[serde(default)]
    #[garde(custom(one_per_camera(&self.camera)), dive)]
    pub instruments: Option<InstrumentSettings>,
    /// The simulated bench; without it a run needs instruments.
    #[serde(default)]
    #[garde(
        custom(simulation_or_instruments(&self.instruments)),
        custom(no_more_than_cameras(&self.camera)),
        dive
    )]
    pub simulation: Option<Scene>,
    /// The wires that `lfpiv sim-bench` connects simulated instruments to.
    #[serde(default)]
    #[garde(dive)]
    pub wire: Option<WireSettings>,
    /// The content of the cameras' calibration files.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    #[garde(dive)]
    pub calibration: Vec<StoredCalibration>,
    /// The mask that `[volume.mask]` describes.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    #[garde(custom(mask::fits(&self.volume)))]
    pub mask: Option<StoredMask>,
}

/// Timing of a shot.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, Validate)]
#[serde(deny_unknown_fields)]
pub struct ShotSettings {
    /// Time between the two laser pulses, in µs.
    #[garde(range(min = 0.1, max = 1e6))]
    pub dt_us: f64,
    /// Shots per second.
    #[garde(range(min = 0.001, max = 1000.0))]
    pub rate_hz: f64,
}

/// Worker pool and its queue.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, Validate)]
#[serde(deny_unknown_fields, default)]
pub struct PipelineSettings {
    /// Image pairs that may wait for a worker; beyond this the live path sheds pairs.
    #[garde(range(min = 1, max = 1000))]
    pub queue: usize,
    /// Seconds that the first pair may take before its worker counts as hung. Later pairs may take
    /// ten times as long as the longest pair so far, and at least a minute.
    #[garde(custom(finite), range(min = 0.1, max = 86_400.0))]
    pub first_pair_patience_s: f64,
}

impl Default for PipelineSettings {
    fn default() -> Self {
        Self { queue: 4, first_pair_patience_s: 900.0 }
    }
}

/// Location of a run's results, and spacing of its vectors.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, Validate)]
#[serde(deny_unknown_fields, default)]
pub struct OutputSettings {
    /// Folder in which every run creates its own folder.
    #[garde(skip)]
    pub dir: PathBuf,
    /// Whether every shot also gets a file for ParaView (`.vti`).
    #[garde(skip)]
    pub paraview: bool,
    /// Spacing of the vectors between the centres of the first and the last window, in mm; that of
    /// the windows when absent. Vectors between windows come from the field through single particles.
    #[garde(inner(range(min = 0.01, max = 100.0)))]
    pub spacing_mm: Option<f64>,
}

impl Default for OutputSettings {
    fn default() -> Self {
        Self { dir: PathBuf::from("results"), paraview: true, spacing_mm: None }
    }
}

fn one_or_two(cameras: &[CameraTable], _: &()) -> garde::Result {
    match cameras.len() {
        1 | 2 => Ok(()),
        other => {
            Err(garde::Error::new(format!("{other} cameras; allowed: 1 or 2 [[camera]] tables")))
        }
    }
}

fn one_per_camera(
    cameras: &[CameraTable],
) -> impl FnOnce(&Option<InstrumentSettings>, &()) -> garde::Result + '_ {
    move |instruments, _| match instruments.as_ref().map(|i| i.camera.len()) {
        Some(count) if count != cameras.len() => Err(garde::Error::new(format!(
            "{count} [[instruments.camera]] tables for {} [[camera]] tables; allowed: one for each",
            cameras.len()
        ))),
        _ => Ok(()),
    }
}

fn simulation_or_instruments(
    instruments: &Option<InstrumentSettings>,
) -> impl FnOnce(&Option<Scene>, &()) -> garde::Result + '_ {
    move |simulation, _| match (simulation, instruments) {
        (Some(_), Some(_)) => Err(garde::Error::new(
            "allowed: [simulation] or [instruments], not both, because a run uses one bench only",
        )),
        _ => Ok(()),
    }
}

fn no_more_than_cameras(
    cameras: &[CameraTable],
) -> impl FnOnce(&Option<Scene>, &()) -> garde::Result + '_ {
    move |simulation, _| {
        let Some(scene) = simulation else { return Ok(()) };
        let listed = [
            ("camera_shift_mm", scene.camera_shift_mm.len()),
            ("lighting.camera_light", scene.lighting.camera_light.len()),
            ("camera", scene.camera.len()),
        ];
        match listed.into_iter().find(|(_, count)| *count > cameras.len()) {
            Some((key, count)) => Err(garde::Error::new(format!(
                "{key} lists {count} for {} [[camera]] tables; allowed: at most one for each",
                cameras.len()
            ))),
            None => Ok(()),
        }
    }
}

impl Config {
    /// Parses a configuration's text and checks the range of every value. Consistency is not
    /// checked, so that the configurations of recorded runs stay readable. `file` appears in
    /// messages only.
    ///
    /// # Errors
    /// [`ConfigError::Invalid`] with every problem.
    pub fn parse(file: &str, text: &str) -> Result<Self, ConfigError> {
        problem::read(file, text, None).map_err(|problems| ConfigError::Invalid { problems })
    }

    /// The poses of the cameras.
    pub fn poses(&self) -> Vec<Pose> {
        self.camera.iter().map(CameraTable::pose).collect()
    }

    /// The cameras' calibrations in the order of the cameras; empty without any.
    fn calibrations(&self) -> Vec<CameraCalibration> {
        let of = |camera: usize| {
            let stored = self.calibration.iter().find(|stored| stored.camera == camera + 1);
            stored.map(|stored| stored.known.clone()).unwrap_or_default()
        };
        match self.calibration.is_empty() {
            true => Vec::new(),
            false => (0..self.camera.len()).map(of).collect(),
        }
    }

    /// A warning if only a part of the cameras' parameters is calibrated: which are still nominal, and what
    /// to do.
    pub fn left_nominal(&self) -> Option<String> {
        calibration::left_nominal(self)
    }

    /// The bench as the simulator needs it.
    pub fn bench_geometry(&self) -> BenchGeometry {
        BenchGeometry {
            optics: self.optics.clone(),
            poses: self.poses(),
            volume: Volume {
                voxels: self.volume.voxels,
                voxel_mm: self.volume.voxel_mm,
                centre_mm: self.volume.centre_mm,
            },
            dt_s: self.shot.dt_us / 1e6,
            empty: self.mask.clone().map(|mask| EmptySpace::new(move |at| !mask.is_flow(at))),
        }
    }

    /// Mean number of particles in the volume of a simulated run; `None` without a scene.
    pub fn simulated_particles(&self) -> Option<f64> {
        let scene = self.simulation.as_ref()?;
        let bench = self.bench_geometry();
        let [x_mm, y_mm, _] = bench.volume.extents_mm();
        Some(scene.ppm * x_mm * y_mm / bench.object_pitch_mm().powi(2))
    }

    /// The settings that decide how image pairs become vectors.
    pub fn measurement(&self) -> Measurement {
        Measurement {
            calibrations: self.calibrations(),
            optics: self.optics.clone(),
            cameras: self.poses(),
            volume: self.volume.grid(),
            mask: self.mask.as_ref().map(|stored| stored.mask.clone()),
            image: self.image.clone(),
            model: self.model.clone(),
            reconstruction: self.reconstruction.clone(),
            velocimetry: self.velocimetry.clone(),
            spacing_mm: self.output.spacing_mm,
            dt_s: self.shot.dt_us / 1e6,
        }
    }
}
