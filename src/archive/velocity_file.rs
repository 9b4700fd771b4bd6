//! Velocity fields as NetCDF-4/CF, one record per shot.
//!
//! Dimensions `shot, z, y, x`. Velocity and uncertainty of an invalid vector are the fill value,
//! NaN. A replaced vector has the interpolated value, `valid` = 0 and `replaced` = 1. A vector that is
//! not in the flow, as the mask of the volume says, has the fill value as well, and `masked` = 1. Vorticity and
//! divergence are the fill value where the field has no gradient. Each velocity component names its
//! standard uncertainty as an ancillary variable.
//!
//! `time` is the time of the shot's trigger (CF, UTC), with its standard uncertainty. Both are the
//! fill value for images without a time.

use std::{path::Path, sync::Arc};

use lfpiv_core::{
    model::ModelChoice,
    velocimetry::{StageSeconds, VectorGrid, VectorStatus, VelocityField},
};

use super::{
    ArchiveError, ShotResult, ShotTime, fit_variables,
    netcdf_file::{Described, FILL_F64, Finished, NetCdfFile},
};

/// Meanings of `raw_level`, in the order of [`RawLevel`](super::RawLevel).
const RAW_LEVELS: &str = "not_kept lost acquired written synced";

/// A quantity of each vector.
type PerVector = fn(&VelocityField, usize) -> f32;

/// The time spent in one stage.
type PerStage = fn(&StageSeconds) -> f64;

const SHOT: Described =
    Described { name: "shot", units: "1", long_name: "shot number within the run" };
const TIME: Described = Described {
    name: "time",
    units: "seconds since 1970-01-01T00:00:00Z",
    long_name: "UTC of the shot's trigger, T0 of the pulse schedule",
};
const TIME_UNCERTAINTY: Described =
    Described { name: "time_uncertainty", units: "s", long_name: "standard uncertainty of time" };
const CLOCK: Described = Described {
    name: "time_clock",
    units: "1",
    long_name: "whether the clock behind time was known to be synchronised; where it was not, the \
                error of that clock is not in time_uncertainty",
};
const DT: Described = Described { name: "dt", units: "s", long_name: "time between the frames" };
const RAW_LEVEL: Described = Described {
    name: "raw_level",
    units: "1",
    long_name: "how safe the raw images were when this was stored",
};
const VALID: Described =
    Described { name: "valid", units: "1", long_name: "vector was measured and accepted" };
const REPLACED: Described = Described {
    name: "replaced",
    units: "1",
    long_name: "measurement was rejected, value is interpolated from valid neighbours",
};

const MASKED: Described = Described {
    name: "masked",
    units: "1",
    long_name: "place is not in the flow, as the mask of the volume says",
};

const FIELDS: [(Described, PerVector); 11] = [
    (velocity("u", "velocity along x"), |f, i| velocity_of(f, i, 0)),
    (velocity("v", "velocity along y"), |f, i| velocity_of(f, i, 1)),
    (velocity("w", "velocity along z"), |f, i| velocity_of(f, i, 2)),
    (velocity("u_uncertainty", "standard uncertainty of u"), |f, i| uncertainty_of(f, i, 0)),
    (velocity("v_uncertainty", "standard uncertainty of v"), |f, i| uncertainty_of(f, i, 1)),
    (velocity("w_uncertainty", "standard uncertainty of w"), |f, i| uncertainty_of(f, i, 2)),
    (
        Described {
            name: "peak_ratio",
            units: "1",
            long_name: "highest over second highest correlation peak, 0 without a peak",
        },
        |f, i| f.peak_ratio[i],
    ),
    (rate("vorticity_x", "vorticity about x"), |f, i| per_second(f, i, f.vorticity[i][0])),
    (rate("vorticity_y", "vorticity about y"), |f, i| per_second(f, i, f.vorticity[i][1])),
    (rate("vorticity_z", "vorticity about z"), |f, i| per_second(f, i, f.vorticity[i][2])),
    (rate("divergence", "divergence of the velocity"), |f, i| per_second(f, i, f.divergence[i])),
];

const SECONDS: [(Described, PerStage); 4] = [
    (seconds("decode_seconds", "time spent from raw images to views"), |s| s.decode_s),
    (seconds("reconstruct_seconds", "time spent from views to volumes"), |s| s.reconstruct_s),
    (seconds("correlate_seconds", "time spent from volumes to vectors"), |s| s.correlate_s),
    (seconds("judge_seconds", "time spent on how well the bench explains the images"), |s| {
        s.judge_s
    }),
];

const fn velocity(name: &'static str, long_name: &'static str) -> Described<'static> {
    Described { name, units: "m s-1", long_name }
}

const fn rate(name: &'static str, long_name: &'static str) -> Described<'static> {
    Described { name, units: "s-1", long_name }
}

const fn seconds(name: &'static str, long_name: &'static str) -> Described<'static> {
    Described { name, units: "s", long_name }
}

fn velocity_of(field: &VelocityField, index: usize, component: usize) -> f32 {
    in_metres_per_second(field, index, field.displacement_vox[index][component])
}

fn uncertainty_of(field: &VelocityField, index: usize, component: usize) -> f32 {
    in_metres_per_second(field, index, field.uncertainty_vox[index][component])
}

/// Converts voxels per pair to m/s for vector `index`; NaN if it has no value.
fn in_metres_per_second(field: &VelocityField, index: usize, number_vox: f32) -> f32 {
    match field.status[index] {
        VectorStatus::Valid | VectorStatus::Replaced => {
            (f64::from(number_vox) * field.metres_per_second_per_voxel()) as f32
        }
        VectorStatus::Invalid | VectorStatus::Masked => f32::NAN,
    }
}

/// Converts voxels per voxel and pair to s⁻¹ for vector `index`; NaN if it has no gradient.
fn per_second(field: &VelocityField, index: usize, gradient: f32) -> f32 {
    match field.has_gradient[index] {
        true => (f64::from(gradient) / field.dt_s) as f32,
        false => f32::NAN,
    }
}

/// Adds the time of the trigger over a dimension, unknown times being [`FILL_F64`]; its name is returned.
pub(super) fn add_utc(
    file: &mut NetCdfFile,
    dimension: &str,
) -> Result<&'static str, ArchiveError> {
    file.add_with_fill(&TIME, &[dimension])?;
    file.put_text(TIME.name, "standard_name", "time")?;
    file.put_text(TIME.name, "calendar", "standard")?;
    // Seconds since 1970 without leap seconds, as the system's clock counts.
    file.put_text(TIME.name, "units_metadata", "leap_seconds: none")?;
    Ok(TIME.name)
}

fn add_time(file: &mut NetCdfFile) -> Result<(), ArchiveError> {
    add_utc(file, "shot")?;
    file.add_with_fill(&TIME_UNCERTAINTY, &["shot"])?;
    file.add_flag(&CLOCK, &["shot"], "not_known_to_be_synchronised synchronised")?;
    let ancillary = format!("{} {}", TIME_UNCERTAINTY.name, CLOCK.name);
    file.put_text(TIME.name, "ancillary_variables", &ancillary)
}

/// Writes the result of one pair as a file of one shot, replacing an older one.
pub fn write_velocity(
    path: &Path,
    configuration: &str,
    shot: u64,
    result: &ShotResult,
) -> Result<(), ArchiveError> {
    let mut file = VelocityFile::create(path, configuration, result)?;
    file.append(shot, result)?;
    file.finish()?.store()
}

/// Memory requested for a file; it is twice the size at which a file counts as full.
const LARGEST_BYTES: u64 = 2 * FULL_BYTES;
/// Size at which a file counts as full.
const FULL_BYTES: u64 = 32 << 20;

/// A velocity file that is being written.
pub(super) struct VelocityFile {
    file: NetCdfFile,
    grid: VectorGrid,
    model: Arc<ModelChoice>,
    shots: usize,
}

impl VelocityFile {
    /// Creates a file for results with the grid and model of `like`.
    pub fn create(
        path: &Path,
        configuration: &str,
        like: &ShotResult,
    ) -> Result<Self, ArchiveError> {
        const VECTORS: [&str; 4] = ["shot", "z", "y", "x"];
        let mut file = NetCdfFile::create(path, LARGEST_BYTES, "Velocity fields", configuration)?;
        let ShotResult { measured: like, time, .. } = like;
        file.add_attribute("model", &like.model.to_string())?;
        file.add_attribute("model_choice", &like.model.to_json())?;
        let (model, fit, like) = (like.model.clone(), &like.fit, &like.field);
        file.add_record_dimension("shot")?;
        file.add_axes([0, 1, 2].map(|axis| like.grid.axis_mm(axis)))?;
        file.add::<i64>(&SHOT, &["shot"])?;
        add_time(&mut file)?;
        file.add_flag(&RAW_LEVEL, &["shot"], RAW_LEVELS)?;
        file.add::<f64>(&DT, &["shot"])?;
        for (described, _) in &FIELDS {
            file.add_with_gaps(described, &VECTORS)?;
        }
        file.add_flag(&VALID, &VECTORS, "not_measured measured")?;
        file.add_flag(&REPLACED, &VECTORS, "as_measured interpolated")?;
        file.add_flag(&MASKED, &VECTORS, "flow not_flow")?;
        for component in ["u", "v", "w"] {
            let ancillary = format!("{component}_uncertainty valid replaced masked peak_ratio");
            file.put_text(component, "ancillary_variables", &ancillary)?;
        }
        if time.is_some() {
            // CF readers treat data with an unknown auxiliary coordinate as missing.
            for (described, _) in &FIELDS {
                file.put_text(described.name, "coordinates", TIME.name)?;
            }
        }
        for (described, _) in &SECONDS {
            file.add::<f64>(described, &["shot"])?;
        }
        if let Some(fit) = fit {
            fit_variables::define(&mut file, fit)?;
        }
        Ok(Self { file, grid: like.grid.clone(), model, shots: 0 })
    }

    /// Whether a result can be added: all results of a file have the same model.
    pub fn suits(&self, result: &ShotResult) -> bool {
        self.model == result.measured.model
    }

    /// Adds one shot.
    pub fn append(&mut self, shot: u64, result: &ShotResult) -> Result<(), ArchiveError> {
        let measured = &result.measured;
        let field = &measured.field;
        if field.grid != self.grid {
            return Err(ArchiveError::GridChanged { shot, path: self.file.path().into() });
        }
        let record = self.shots;
        self.put_time(record, result.time)?;
        self.file.put_record(DT.name, record, &[field.dt_s])?;
        self.file.put_record("raw_level", record, &[result.raw as i8])?;
        for (described, value_of) in &FIELDS {
            let values: Vec<f32> = (0..self.grid.len()).map(|i| value_of(field, i)).collect();
            self.file.put_record(described.name, record, &values)?;
        }
        for (described, wanted) in [
            (VALID, VectorStatus::Valid),
            (REPLACED, VectorStatus::Replaced),
            (MASKED, VectorStatus::Masked),
        ] {
            let flags: Vec<i8> = field.status.iter().map(|s| i8::from(*s == wanted)).collect();
            self.file.put_record(described.name, record, &flags)?;
        }
        for (described, value_of) in &SECONDS {
            self.file.put_record(described.name, record, &[value_of(&measured.seconds)])?;
        }
        if let Some(fit) = &measured.fit {
            fit_variables::put(&mut self.file, record, fit)?;
        }
        // Written last: an incomplete record has no shot number and is ignored.
        self.file.put_record(SHOT.name, record, &[shot as i64])?;
        self.shots += 1;
        Ok(())
    }

    fn put_time(&mut self, record: usize, time: Option<ShotTime>) -> Result<(), ArchiveError> {
        let or_fill = |number: Option<f64>| [number.unwrap_or(FILL_F64)];
        let synchronised = time.is_some_and(|time| time.clock_synchronised);
        self.file.put_record(TIME.name, record, &or_fill(time.map(|time| time.utc_s())))?;
        let uncertainty_s = time.map(|time| time.uncertainty_s());
        self.file.put_record(TIME_UNCERTAINTY.name, record, &or_fill(uncertainty_s))?;
        self.file.put_record(CLOCK.name, record, &[i8::from(synchronised)])
    }

    /// Whether the file has reached its intended size.
    pub fn is_full(&self) -> bool {
        self.file.bytes() >= FULL_BYTES
    }

    /// Closes the file; it is not on disk yet.
    pub fn finish(self) -> Result<Finished, ArchiveError> {
        self.file.finish()
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::archive::test_data::result;

    #[test]
    fn velocities_flags_and_seconds_are_in_si_units() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("velocity.nc");
        let result = result([4, 3, 2]);
        write_velocity(&path, "[volume]\n", 7, &result).unwrap();

        let file = netcdf::open(&path).unwrap();
        let floats = |name: &str| file.variable(name).unwrap().get_values::<f64, _>(..).unwrap();
        let names: Vec<_> =
            file.variable("u").unwrap().dimensions().iter().map(|d| d.name()).collect();
        assert_eq!(names, ["shot", "z", "y", "x"]);
        assert_eq!(floats("shot"), [7.0]);
        assert_eq!(floats("dt"), [1e-4]);
        // One voxel of 0.1 mm in 100 us is 1 m/s.
        let expected: Vec<f64> =
            result.measured.field.displacement_vox.iter().map(|d| f64::from(d[1])).collect();
        for (n, (found, expected)) in floats("v").iter().zip(expected).enumerate() {
            // Every third vector is invalid.
            let missing = found.is_nan() && n % 3 == 2;
            assert!(missing || (found - expected).abs() < 1e-6, "{n}: {found} {expected}");
        }
        for name in ["u", "w_uncertainty", "vorticity_y", "divergence"] {
            assert!(floats(name)[2].is_nan(), "{name}");
            let fill = file.variable(name).unwrap().fill_value::<f32>().unwrap();
            assert!(fill.is_some_and(f32::is_nan), "{name}");
        }
        let uncertainty = f64::from(result.measured.field.uncertainty_vox[4][1]);
        assert!((floats("v_uncertainty")[4] - uncertainty).abs() < 1e-6);
        let ancillary = file.variable("v").unwrap().attribute_value("ancillary_variables");
        let ancillary = String::try_from(ancillary.unwrap().unwrap()).unwrap();
        assert_eq!(ancillary, "v_uncertainty valid replaced masked peak_ratio");
        let spin = f64::from(result.measured.field.vorticity[4][2]) / 1e-4;
        assert!((floats("vorticity_z")[4] - spin).abs() < 1e-3 * spin.abs());
        assert_eq!(floats("valid")[..3], [1.0, 0.0, 0.0]);
        assert_eq!(floats("replaced")[..3], [0.0, 1.0, 0.0]);
        assert_eq!(floats("correlate_seconds"), [3.0]);
        assert_eq!(floats("x"), result.measured.field.grid.axis_mm(0));
    }

    #[test]
    fn a_shot_has_its_time_and_one_without_has_the_fill_value() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("velocity.nc");
        let timed = result([4, 3, 2]);
        let mut file = VelocityFile::create(&path, "", &timed).unwrap();
        file.append(0, &timed).unwrap();
        file.append(1, &ShotResult { time: None, ..timed.clone() }).unwrap();
        file.finish().unwrap().store().unwrap();

        let file = netcdf::open(&path).unwrap();
        let variable = |name: &str| file.variable(name).unwrap();
        let values = |name: &str| variable(name).get_values::<f64, _>(..).unwrap();
        let text = |name: &str, attribute: &str| {
            let value = variable(name).attribute_value(attribute).unwrap().unwrap();
            String::try_from(value).unwrap()
        };
        assert_eq!(values("time"), [1_700_000_000.25, FILL_F64]);
        assert_eq!(values("time_uncertainty"), [0.0015, FILL_F64]);
        assert_eq!(values("time_clock"), [1.0, 0.0]);
        assert_eq!(text("time", "units"), "seconds since 1970-01-01T00:00:00Z");
        assert_eq!(text("time", "standard_name"), "time");
        assert_eq!(text("time", "ancillary_variables"), "time_uncertainty time_clock");
        assert_eq!(text("v", "coordinates"), "time");
        assert_eq!(variable("time").fill_value::<f64>().unwrap(), Some(FILL_F64));
    }

    #[test]
    fn a_shot_on_another_grid_is_refused() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("velocity.nc");
        let mut file = VelocityFile::create(&path, "", &result([4, 3, 2])).unwrap();
        file.append(0, &result([4, 3, 2])).unwrap();
        let message = file.append(1, &result([4, 4, 2])).unwrap_err().to_string();
        assert!(message.contains("shot 1"), "{message}");
    }
}
