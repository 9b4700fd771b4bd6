//! Calibrations as a user makes them: this program's own commands, on simulated images.

use std::{
    ffi::OsStr,
    fs, io,
    path::Path,
    process::{Command, Stdio},
};

use lfpiv::{
    archive::write_replacing,
    config::{Config, ConfigFile},
};
use lfpiv_core::model::CameraCalibration;
use lfpiv_hw::CameraName;
use lfpiv_sim::Flow;

use crate::{BenchmarkError, case::Setting};

/// White and dark images of each camera.
const IMAGES: &str = "5";

/// Benches that were calibrated before, by their drawing and card: particles and flow change nothing.
#[derive(Debug, Default)]
pub struct CalibratedBenches(Vec<(String, Vec<CameraCalibration>)>);

impl CalibratedBenches {
    /// See [`calibrations_by_commands`], which runs once for each bench.
    ///
    /// # Errors
    /// As [`calibrations_by_commands`].
    pub fn found(
        &mut self,
        setting: &Setting,
        program: &Path,
        work: &Path,
        card: Option<&Path>,
    ) -> Result<Vec<CameraCalibration>, BenchmarkError> {
        let mut config = setting.config.clone();
        if let Some(scene) = &mut config.simulation {
            (scene.ppm, scene.flow) = (1.0, Flow::default());
        }
        let bench = format!("{config:?} {card:?}");
        if let Some((_, known)) = self.0.iter().find(|(other, _)| *other == bench) {
            return Ok(known.clone());
        }
        let found = calibrations_by_commands(setting, program, work, card)?;
        self.0.push((bench, found.clone()));
        Ok(found)
    }
}

/// What the commands find of a case's cameras: their grids, and with `card` their maps. Files go to
/// the folder `work`, which exists.
///
/// # Errors
/// A command fails, or its file does not fit the bench.
fn calibrations_by_commands(
    setting: &Setting,
    program: &Path,
    work: &Path,
    card: Option<&Path>,
) -> Result<Vec<CameraCalibration>, BenchmarkError> {
    let folder = work.join("calibration");
    let unreadable =
        |reason: io::Error| BenchmarkError::Unreadable { path: folder.clone(), reason };
    fs::create_dir_all(&folder).map_err(unreadable)?;
    let drawn = folder.join("drawn.toml");
    write_configuration(&drawn, &setting.config)?;
    let images = folder.join("images");
    let at = |path: &Path| path.as_os_str().to_owned();
    let mut simulate = vec!["simulate".into(), "--config".into(), at(&drawn)];
    for (name, value) in [("--shots", "0"), ("--white", IMAGES), ("--dark", IMAGES)] {
        simulate.extend([name.into(), value.into()]);
    }
    simulate.extend(["--out".into(), at(&images)]);
    if let Some(card) = card {
        simulate.extend(["--card".into(), at(card)]);
    }
    run(program, &simulate)?;
    let cameras = setting.config.camera.len();
    let mut grids = Vec::new();
    for camera in 0..cameras {
        let name = CameraName(camera).to_string();
        let grid = folder.join(format!("{name}_grid.json"));
        let mut calibrate = vec!["calibrate".into(), "grid".into(), "--config".into(), at(&drawn)];
        calibrate.extend(["--camera".into(), (camera + 1).to_string().into()]);
        for kind in ["white", "dark"] {
            calibrate.push(format!("--{kind}").into());
            let taken = (0..5).map(|n| images.join(kind).join(format!("{name}_{n:02}.tif")));
            calibrate.extend(taken.map(|path| at(&path)));
        }
        calibrate.extend(["--out".into(), at(&grid)]);
        run(program, &calibrate)?;
        grids.push(grid);
    }
    let files = match card {
        None => grids,
        Some(_) => {
            let calibration = folder.join("calibration.json");
            let mut calibrate =
                vec!["calibrate".into(), "volume".into(), "--config".into(), at(&drawn)];
            calibrate.extend(["--card".into(), at(&images.join("card/card.toml"))]);
            calibrate.push("--grid".into());
            calibrate.extend(grids.iter().map(|grid| at(grid)));
            calibrate.extend(["--out".into(), at(&calibration)]);
            run(program, &calibrate)?;
            vec![calibration; cameras]
        }
    };
    let mut config = setting.config.clone();
    for (camera, file) in config.camera.iter_mut().zip(&files) {
        // Relative to the configuration.
        camera.calibration = file.file_name().map(Into::into);
    }
    let calibrated = folder.join("calibrated.toml");
    write_configuration(&calibrated, &config)?;
    let refused =
        |reason| BenchmarkError::Configuration { case: setting.case.name.clone(), reason };
    let found = ConfigFile::load(&calibrated).map_err(refused)?.config.measurement().calibrations;
    // The next case has its own; a folder left behind costs room alone.
    let _ = fs::remove_dir_all(&folder);
    Ok(found)
}

fn write_configuration(path: &Path, config: &Config) -> Result<(), BenchmarkError> {
    let text = toml::to_string(config).map_err(|error| BenchmarkError::Malformed {
        path: path.into(),
        reason: error.to_string(),
    })?;
    Ok(write_replacing(path, |writer| io::Write::write_all(writer, text.as_bytes()))?)
}

fn run(program: &Path, arguments: &[impl AsRef<OsStr>]) -> Result<(), BenchmarkError> {
    let mut command = Command::new(program);
    command.args(arguments).stdin(Stdio::null());
    let output = command
        .output()
        .map_err(|reason| BenchmarkError::Spawn { program: program.into(), reason })?;
    if output.status.success() {
        return Ok(());
    }
    let message = String::from_utf8_lossy(&output.stderr).trim().to_owned();
    Err(BenchmarkError::Child { command: format!("{command:?}"), message })
}
