//! Loads the calibration files named by `[[camera]]` tables and checks them against the bench.
//!
//! A file made for another camera, other optics or another pose is refused. The content used is
//! appended to the configuration's text, which is stored with every result. Results thus document
//! their calibration, and a recorded run can be measured again without the files.

use std::path::{Path, PathBuf};

use garde::Validate;
use lfpiv_core::{
    lightfield::MicroImageGrid,
    model::{CameraCalibration, VolumeGrid, VolumeMap},
};
use lfpiv_hw::{CameraName, Optics};
use serde::{Deserialize, Serialize};
use serde_json::Value;

use super::{
    CalibratedCameraEntry, CalibrationFile, Config,
    calibration_file::{Content, GridContent, read_calibration},
    consistency::Inconsistency,
};

/// Relative difference up to which two numbers count as equal: files round numbers.
const RELATIVE_TOLERANCE: f64 = 1e-9;

/// A `[[calibration]]` table of a stored configuration: the content of a camera's calibration file.
/// It is written by the program, not by hand.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, Validate)]
#[serde(deny_unknown_fields)]
pub struct StoredCalibration {
    /// Number of the camera: 1 for the first `[[camera]]` table.
    #[garde(range(min = 1, max = 2))]
    pub camera: usize,
    /// The calibration file.
    #[garde(skip)]
    pub file: PathBuf,
    /// The file's SHA-256 hash.
    #[garde(skip)]
    pub sha256: String,
    /// Serial number of the calibrated device, if the file states it.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    #[garde(skip)]
    pub serial: Option<String>,
    /// The camera's calibration as read from the file.
    #[garde(skip)]
    pub known: CameraCalibration,
}

/// Reads the calibration files named by the `[[camera]]` tables, relative to `folder`.
pub(super) fn load(
    config: &Config,
    folder: &Path,
) -> Result<Vec<StoredCalibration>, Vec<Inconsistency>> {
    let mut found = Vec::new();
    let mut inconsistencies = Vec::new();
    for (index, table) in config.camera.iter().enumerate() {
        let Some(file) = &table.calibration else { continue };
        match read_for_camera(config, index, &folder.join(file)) {
            Ok((known, serial, sha256)) => {
                let (camera, file) = (index + 1, file.clone());
                found.push(StoredCalibration { camera, file, sha256, serial, known });
            }
            Err(message) => {
                inconsistencies
                    .push(Inconsistency::new(format!("camera[{index}].calibration"), message));
            }
        }
    }
    if let [one, other] = found.as_slice()
        && one.known.map.is_some()
        && other.known.map.is_some()
        && one.sha256 != other.sha256
    {
        let message = "the cameras' maps come from different calibrations, so their cards may have \
                       stood at different places: give both cameras the file of one `lfpiv \
                       calibrate volume`";
        inconsistencies.push(Inconsistency::new("camera[1].calibration", message.to_owned()));
    }
    if inconsistencies.is_empty() { Ok(found) } else { Err(inconsistencies) }
}

/// Which cameras have nominal poses and optics although something is calibrated, and what to do. `None` without
/// calibrations, and if every camera is calibrated in the volume.
pub(super) fn left_nominal(config: &Config) -> Option<String> {
    let with = |has: fn(&CameraCalibration) -> bool| -> Vec<usize> {
        let of_kind = config.calibration.iter().filter(|stored| has(&stored.known));
        of_kind.filter_map(|stored| stored.camera.checked_sub(1)).collect()
    };
    let (grids, maps) = (with(|known| known.grid.is_some()), with(|known| known.map.is_some()));
    let names = |of: &dyn Fn(&usize) -> bool| {
        let cameras = (0..config.camera.len()).filter(of);
        cameras.map(|camera| CameraName(camera).to_string()).collect::<Vec<_>>().join(" and ")
    };
    let nominal = names(&|camera| !maps.contains(camera));
    if config.calibration.is_empty() || nominal.is_empty() {
        return None;
    }
    let calibrated = names(&|camera| grids.contains(camera));
    Some(format!(
        "the micro-images of {calibrated} are calibrated, but pose and optics of {nominal} are the nominal ones of \
         the configuration, which invalidates vectors if the bench differs by about a voxel: run `lfpiv \
         calibrate volume` and name its file in each [[camera]] table"
    ))
}

/// A camera's calibration from its file, the device's serial number if stated, and the file's hash.
fn read_for_camera(
    config: &Config,
    index: usize,
    path: &Path,
) -> Result<(CameraCalibration, Option<String>, String), String> {
    let (content, sha256) = read_calibration(path)?;
    let name = CameraName(index).to_string();
    let (known, serial) = match content {
        Content::Grid(GridContent { camera, grid }) => {
            if let Some(other) = camera.filter(|camera| *camera != name) {
                return Err(format!("the file is the grid of {other}, not of {name}"));
            }
            check_grid(&grid, &config.optics)?;
            (CameraCalibration { grid: Some(grid), map: None }, None)
        }
        Content::Cameras(file) => {
            let CalibrationFile { optics, cameras, .. } = *file;
            if let Some(different) = difference(&optics, &config.optics) {
                return Err(format!(
                    "the file was made with other optics: {different}; calibrate again with this \
                     [optics]"
                ));
            }
            let Some(entry) = cameras.into_iter().find(|entry| entry.camera == name) else {
                return Err(format!("the file has no entry for {name}"));
            };
            check_device(&entry, config, index)?;
            if let Some(different) = difference(&entry.pose, &config.camera[index].pose()) {
                return Err(format!(
                    "the file was made with {name} at another pose: {different}; calibrate again \
                     with this pose, or correct it"
                ));
            }
            check_grid(&entry.grid, &config.optics)?;
            check_reach(&entry.map, config)?;
            let known = CameraCalibration { grid: Some(entry.grid), map: Some(entry.map) };
            (known, entry.serial)
        }
    };
    Ok((known, serial, sha256))
}

/// Checks that device and sensor region are those of the configuration, where both state them.
fn check_device(
    entry: &CalibratedCameraEntry,
    config: &Config,
    index: usize,
) -> Result<(), String> {
    let Some(device) = config.instruments.as_ref().and_then(|all| all.camera.get(index)) else {
        return Ok(());
    };
    if let (Some(of_file), Some(here)) = (&entry.serial, &device.serial)
        && of_file != here
    {
        return Err(format!(
            "the file is for the camera with serial {of_file}, but \
             instruments.camera[{index}].serial is {here}: calibrate this camera"
        ));
    }
    let offset = |offset_px: Option<[u32; 2]>| {
        offset_px.map_or("the whole sensor".to_owned(), |[column, row]| {
            format!("a region from column {column} and row {row}")
        })
    };
    if entry.offset_px != device.offset_px {
        return Err(format!(
            "the file is for {}, but instruments.camera[{index}].offset_px asks for {}: take the \
             images of the calibration with the region of the run",
            offset(entry.offset_px),
            offset(device.offset_px)
        ));
    }
    Ok(())
}

/// Checks that the grid is square and has the number of microlenses of `optics`.
fn check_grid(grid: &MicroImageGrid, optics: &Optics) -> Result<(), String> {
    if !grid.is_square() {
        return Err(
            "its microlens array is not square: volumes can be reconstructed from square arrays \
             only (hexagonal arrays can be calibrated, but not used for measurements)"
                .into(),
        );
    }
    let lenses = [optics.microlens.columns, optics.microlens.rows];
    if grid.microlenses != lenses {
        let [[i, j], [columns, rows]] = [grid.microlenses, lenses];
        return Err(format!(
            "the file has {i} x {j} microlenses, but [optics.microlens] has {columns} x {rows}: \
             calibrate the grid with --config and --camera, which number the lenses as the \
             configuration does"
        ));
    }
    Ok(())
}

/// Checks that the map is valid in the whole volume and its margin.
fn check_reach(map: &VolumeMap, config: &Config) -> Result<(), String> {
    let VolumeGrid { voxels, voxel_mm, centre_mm } = &config.volume.grid();
    let margin = config.velocimetry.margin_vox() as f64;
    let holds_mm = map.holds_mm();
    for axis in 0..3 {
        let half_mm = (voxels[axis] as f64 / 2.0 + margin) * voxel_mm;
        let [from, to] = [centre_mm[axis] - half_mm, centre_mm[axis] + half_mm];
        if from < holds_mm[axis][0] - 1e-6 || to > holds_mm[axis][1] + 1e-6 {
            return Err(format!(
                "the map is valid from {:.2} to {:.2} mm along {}, but [volume] with its margin \
                 reaches from {from:.2} to {to:.2}: run `lfpiv calibrate volume` again with this \
                 [volume]",
                holds_mm[axis][0],
                holds_mm[axis][1],
                ["x", "y", "z"][axis]
            ));
        }
    }
    Ok(())
}

/// The first value in which the two serialized values differ, in words.
fn difference<T: Serialize>(of_file: &T, here: &T) -> Option<String> {
    let values = [of_file, here].map(|thing| serde_json::to_value(thing).unwrap_or(Value::Null));
    first_difference("", &values[0], &values[1])
}

fn first_difference(key: &str, of_file: &Value, here: &Value) -> Option<String> {
    match (of_file, here) {
        (Value::Object(a), Value::Object(b)) => b.iter().find_map(|(name, value)| {
            let below = if key.is_empty() { name.clone() } else { format!("{key}.{name}") };
            first_difference(&below, a.get(name).unwrap_or(&Value::Null), value)
        }),
        (Value::Array(a), Value::Array(b)) if a.len() == b.len() => {
            let differ = a.iter().zip(b).any(|(a, b)| first_difference(key, a, b).is_some());
            differ.then(|| format!("{key} = {of_file} in the file, {here} in the configuration"))
        }
        _ => {
            let alike = match (of_file.as_f64(), here.as_f64()) {
                (Some(a), Some(b)) => {
                    (a - b).abs() <= RELATIVE_TOLERANCE * (1.0 + a.abs().max(b.abs()))
                }
                _ => of_file == here,
            };
            (!alike).then(|| format!("{key} = {of_file} in the file, {here} in the configuration"))
        }
    }
}

/// The text that is appended to the configuration's text before it is stored.
pub(super) fn stored_text(calibration: &[StoredCalibration]) -> Result<String, toml::ser::Error> {
    #[derive(Serialize)]
    struct Tables<'a> {
        calibration: &'a [StoredCalibration],
    }
    if calibration.is_empty() {
        return Ok(String::new());
    }
    let tables = toml::to_string(&Tables { calibration })?;
    Ok(format!("\n# Content of the calibration files named in [[camera]]:\n{tables}"))
}
