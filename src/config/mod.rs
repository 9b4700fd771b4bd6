//! The configuration: one TOML file describes bench, volume, method and, for simulated runs,
//! the scene. Each room owns the settings of its own table; this room puts them together and says
//! where a file is wrong.

mod calibration;
mod calibration_file;
mod camera;
mod instruments;
mod location;
mod misfit;
mod problem;
mod range;
mod server;
mod shipped;
mod surplus;

use std::path::{Path, PathBuf};

use garde::Validate;
use lfpiv_core::{
    lightfield::ImageSettings,
    measurement::Measurement,
    model::{CameraCalibration, ModelSettings, VolumeGrid, mode_or_table},
    reconstruction::ReconstructionSettings,
    velocimetry::VelocimetrySettings,
};
use lfpiv_hw::{Optics, Pose, TimingSettings, check::finite};
use lfpiv_rawlog::RawLogSettings;
use lfpiv_sim::{BenchGeometry, Scene, Volume, wire::WireSettings};
use serde::{Deserialize, Serialize};

pub use calibration::StoredCalibration;
pub use calibration_file::{
    CalibratedCameraEntry, CalibrationFile, Content as CalibrationContent, GRID as GRID_FORMAT,
    VERSION as CALIBRATION_VERSION, hash_of, read_calibration,
};
pub use camera::CameraTable;
pub use instruments::InstrumentSettings;
pub use misfit::Purpose;
pub use problem::{ConfigError, Problem};
pub use server::{ServerSettings, TlsSettings};
pub use shipped::read_or_shipped;

/// A configuration and the text it was read from, with what was read from the calibrations that it
/// names: this text is stored with the results.
#[derive(Debug, Clone, PartialEq)]
pub struct ConfigFile {
    /// Where it was read from.
    pub path: PathBuf,
    /// The file's text.
    pub text: String,
    /// Its content, checked.
    pub config: Config,
}

impl ConfigFile {
    /// Reads a configuration file to measure images with it.
    ///
    /// # Errors
    /// [`ConfigError`]: the file cannot be read, or what is wrong in it, line by line.
    pub fn load(path: &Path) -> Result<Self, ConfigError> {
        Self::load_for(Purpose::Images, path)
    }

    /// Reads a configuration file and checks that its parts fit together for `purpose`.
    ///
    /// # Errors
    /// As [`Self::load`].
    pub fn load_for(purpose: Purpose, path: &Path) -> Result<Self, ConfigError> {
        let text = read_or_shipped(path)
            .map_err(|reason| ConfigError::Unreadable { path: path.into(), reason })?;
        let folder = path.parent().unwrap_or(Path::new(""));
        let config = problem::read(&path.display().to_string(), &text, Some((purpose, folder)))
            .map_err(|problems| ConfigError::Invalid { problems })?;
        Ok(Self { path: path.into(), text: with_calibrations(text, &config)?, config })
    }
}

/// The text of a configuration with what was read from calibrations, where that is not in it yet.
fn with_calibrations(text: String, config: &Config) -> Result<String, ConfigError> {
    let has_them = text.parse::<toml::Table>().is_ok_and(|table| table.contains_key("calibration"));
    if has_them {
        return Ok(text);
    }
    let stored = calibration::stored_text(&config.calibration)?;
    Ok(text + &stored)
}

/// A whole configuration file.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, Validate)]
#[serde(deny_unknown_fields)]
pub struct Config {
    /// The optics that all cameras share.
    #[garde(dive)]
    pub optics: Optics,
    /// Where the cameras stand; one or two.
    #[garde(custom(one_or_two), dive)]
    pub camera: Vec<CameraTable>,
    /// The measurement volume.
    #[garde(dive)]
    pub volume: VolumeGrid,
    /// Laser and shot timing.
    #[garde(dive)]
    pub shot: ShotSettings,
    /// What laser and cameras need in time.
    #[serde(default)]
    #[garde(dive)]
    pub timing: TimingSettings,
    /// What is known about the images.
    #[serde(default)]
    #[garde(dive)]
    pub image: ImageSettings,
    /// Which parts the forward model has; `model = "auto"` is short for a table with that mode.
    #[serde(default, deserialize_with = "mode_or_table")]
    #[garde(dive)]
    pub model: ModelSettings,
    /// How volumes are reconstructed.
    #[serde(default)]
    #[garde(dive)]
    pub reconstruction: ReconstructionSettings,
    /// How volumes are correlated.
    #[serde(default)]
    #[garde(dive)]
    pub velocimetry: VelocimetrySettings,
    /// Worker pool and queue.
    #[serde(default)]
    #[garde(dive)]
    pub pipeline: PipelineSettings,
    /// How raw data is kept.
    #[serde(default)]
    #[garde(dive)]
    pub raw_log: RawLogSettings,
    /// HTTP.
    #[serde(default)]
    #[garde(dive)]
    pub server: ServerSettings,
    /// Where results go.
    #[serde(default)]
    #[garde(skip)]
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
    /// The wires at whose ends `lfpiv sim-bench` puts simulated instruments.
    #[serde(default)]
    #[garde(dive)]
    pub wire: Option<WireSettings>,
    /// What was read from the cameras' calibration files.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    #[garde(dive)]
    pub calibration: Vec<StoredCalibration>,
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
    /// Image pairs that may wait for a worker; the live path sheds beyond this.
    #[garde(range(min = 1, max = 1000))]
    pub queue: usize,
    /// Seconds that the first pair may take before its worker counts as hung. Later ones may take
    /// ten times as long as the longest before them, and a minute at least.
    #[garde(custom(finite), range(min = 0.1, max = 86_400.0))]
    pub first_pair_patience_s: f64,
}

impl Default for PipelineSettings {
    fn default() -> Self {
        Self { queue: 4, first_pair_patience_s: 900.0 }
    }
}

/// Where a run's results go.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields, default)]
pub struct OutputSettings {
    /// Folder under which every run makes its own.
    pub dir: PathBuf,
    /// Whether every shot gets a file for ParaView (`.vti`), too.
    pub paraview: bool,
}

impl Default for OutputSettings {
    fn default() -> Self {
        Self { dir: PathBuf::from("results"), paraview: true }
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
            "allowed: [simulation] or [instruments], not both: a run would not know which bench to \
             use",
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
    /// Reads the text of a configuration and checks every value's range, not whether the parts fit
    /// together: that of a recorded run stays readable. `file` is only named in the messages.
    ///
    /// # Errors
    /// [`ConfigError::Invalid`] with everything that is wrong.
    pub fn parse(file: &str, text: &str) -> Result<Self, ConfigError> {
        problem::read(file, text, None).map_err(|problems| ConfigError::Invalid { problems })
    }

    /// Where the cameras stand.
    pub fn poses(&self) -> Vec<Pose> {
        self.camera.iter().map(CameraTable::pose).collect()
    }

    /// What is known of the cameras beyond the drawing, in their order.
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

    /// A warning where calibrations correct only a part of what cameras are: what is still taken as drawn,
    /// and what to do.
    pub fn left_as_drawn(&self) -> Option<String> {
        calibration::left_as_drawn(self)
    }

    /// The bench as the simulator sees it.
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
        }
    }

    /// Mean number of particles in the volume of a simulated run; `None` without a scene.
    pub fn simulated_particles(&self) -> Option<f64> {
        let scene = self.simulation.as_ref()?;
        let bench = self.bench_geometry();
        let [x_mm, y_mm, _] = bench.volume.extents_mm();
        Some(scene.ppm * x_mm * y_mm / bench.object_pitch_mm().powi(2))
    }

    /// The part of the configuration that turns image pairs into vectors.
    pub fn measurement(&self) -> Measurement {
        Measurement {
            calibrations: self.calibrations(),
            optics: self.optics.clone(),
            cameras: self.poses(),
            volume: self.volume.clone(),
            image: self.image.clone(),
            model: self.model.clone(),
            reconstruction: self.reconstruction.clone(),
            velocimetry: self.velocimetry.clone(),
            dt_s: self.shot.dt_us / 1e6,
        }
    }
}
