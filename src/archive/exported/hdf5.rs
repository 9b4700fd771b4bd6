//! HDF5 files of many shots, with vectors as arrays.
//!
//! The stored NetCDF files are also HDF5. These files are for programs that want plain arrays:
//! `velocity` over `shot, z, y, x, component`, and NaN for missing values and times.

use std::path::Path;

use lfpiv_core::velocimetry::{VectorGrid, VectorStatus};

use crate::archive::{
    ArchiveError, StoredShot,
    netcdf_file::{Described, NetCdfFile},
};

const VECTORS: [&str; 5] = ["shot", "z", "y", "x", "component"];
const SCALARS: [&str; 4] = ["shot", "z", "y", "x"];

const SHOT: Described = Described { name: "shot", units: "1", long_name: "shot number" };
const TIME: Described = Described {
    name: "time",
    units: "s",
    long_name: "UTC of the shot's trigger in seconds since 1970; NaN where it is not known",
};
const DT: Described = Described { name: "dt", units: "s", long_name: "time between the frames" };
const VELOCITY: Described =
    Described { name: "velocity", units: "m s-1", long_name: "velocity along x, y, z" };
const UNCERTAINTY: Described = Described {
    name: "velocity_uncertainty",
    units: "m s-1",
    long_name: "standard uncertainty of the velocity along x, y, z",
};
const VORTICITY: Described =
    Described { name: "vorticity", units: "s-1", long_name: "vorticity about x, y, z" };
const DIVERGENCE: Described =
    Described { name: "divergence", units: "s-1", long_name: "divergence of the velocity" };
const PEAK_RATIO: Described = Described {
    name: "peak_ratio",
    units: "1",
    long_name: "highest over second highest correlation peak, 0 without a peak",
};
const VALID: Described =
    Described { name: "valid", units: "1", long_name: "vector was measured and accepted" };
const REPLACED: Described = Described {
    name: "replaced",
    units: "1",
    long_name: "value is interpolated from valid neighbours",
};

const MASKED: Described = Described {
    name: "masked",
    units: "1",
    long_name: "place is not in the flow, as the mask of the volume says",
};

/// Size in bytes from which a file takes no further shot.
const FULL_BYTES: u64 = 128 << 20;
/// Upper bounds for the bytes per vector, and per shot without its vectors.
const VECTOR_BYTES: u64 = 64;
const SHOT_BYTES: u64 = 16 << 10;

/// A file that is being written.
pub struct Hdf5File {
    file: NetCdfFile,
    grid: VectorGrid,
    shots: usize,
}

impl Hdf5File {
    /// Creates a file for shots on the grid of `like`; `configuration` is the TOML text of the
    /// measurement.
    pub fn create(
        path: &Path,
        configuration: &str,
        like: &StoredShot,
    ) -> Result<Self, ArchiveError> {
        let room = FULL_BYTES + SHOT_BYTES + VECTOR_BYTES * like.grid.len() as u64;
        let mut file = NetCdfFile::create(path, room, "Velocity fields", configuration)?;
        file.add_record_dimension("shot")?;
        file.add_dimension("component", 3)?;
        file.add_axes([0, 1, 2].map(|axis| like.grid.axis_mm(axis)))?;
        file.add::<i64>(&SHOT, &["shot"])?;
        file.add::<f64>(&TIME, &["shot"])?;
        file.add::<f64>(&DT, &["shot"])?;
        for described in [&VELOCITY, &UNCERTAINTY, &VORTICITY] {
            file.add_with_gaps(described, &VECTORS)?;
        }
        for described in [&DIVERGENCE, &PEAK_RATIO] {
            file.add_with_gaps(described, &SCALARS)?;
        }
        file.add_flag(&VALID, &SCALARS, "not_measured measured")?;
        file.add_flag(&REPLACED, &SCALARS, "as_measured interpolated")?;
        file.add_flag(&MASKED, &SCALARS, "flow not_flow")?;
        Ok(Self { file, grid: like.grid.clone(), shots: 0 })
    }

    /// Whether the file accepts the shot: the grids are equal and the file is not full.
    pub fn accepts(&self, shot: &StoredShot) -> bool {
        let bytes = (SHOT_BYTES + VECTOR_BYTES * self.grid.len() as u64) * self.shots as u64;
        self.grid == shot.grid && bytes < FULL_BYTES
    }

    /// Adds a shot.
    pub fn append(&mut self, shot: &StoredShot) -> Result<(), ArchiveError> {
        let record = self.shots;
        self.file.put_record(SHOT.name, record, &[shot.shot as i64])?;
        self.file.put_record(TIME.name, record, &[shot.time_s.unwrap_or(f64::NAN)])?;
        self.file.put_record(DT.name, record, &[shot.dt_s])?;
        for (described, values) in [
            (&VELOCITY, &shot.velocity_m_s),
            (&UNCERTAINTY, &shot.uncertainty_m_s),
            (&VORTICITY, &shot.vorticity_per_s),
        ] {
            self.file.put_record(described.name, record, values.as_flattened())?;
        }
        self.file.put_record(DIVERGENCE.name, record, &shot.divergence_per_s)?;
        self.file.put_record(PEAK_RATIO.name, record, &shot.peak_ratio)?;
        for (described, wanted) in [
            (&VALID, VectorStatus::Valid),
            (&REPLACED, VectorStatus::Replaced),
            (&MASKED, VectorStatus::Masked),
        ] {
            let flags: Vec<i8> = shot.status.iter().map(|s| i8::from(*s == wanted)).collect();
            self.file.put_record(described.name, record, &flags)?;
        }
        self.shots += 1;
        Ok(())
    }

    /// Closes the file and writes it to disk.
    pub fn store(self) -> Result<(), ArchiveError> {
        self.file.store()
    }
}
