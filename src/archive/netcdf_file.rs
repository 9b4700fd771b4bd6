//! Common parts of the program's NetCDF files: provenance, axes, described variables.

use std::path::{Path, PathBuf};

use lfpiv_hw::CameraName;
use netcdf::{FileMut, NcTypeDescriptor};
use time::{OffsetDateTime, format_description::well_known::Rfc3339};

use super::{ArchiveError, durable::MemoryFile, netcdf_open::create};

/// Program name and version in files.
const VERSION: &str = concat!("lfpiv ", env!("CARGO_PKG_VERSION"));

/// Name and description of a variable.
pub(super) struct Described<'a> {
    /// NetCDF name.
    pub name: &'a str,
    /// UDUNITS unit; "1" for a dimensionless number.
    pub units: &'a str,
    /// Description in one line.
    pub long_name: &'a str,
}

/// Fill value for unknown numbers: the library's default, outside of every range.
pub(super) const FILL_F64: f64 = 9.969_209_968_386_869e36;

/// The library's value for data that was never written.
pub(super) const FILL_F32: f32 = 9.969_21e36;

/// A NetCDF-4 file being written in memory. On disk, a failed write may crash the HDF5 library when
/// the process ends.
pub(super) struct NetCdfFile {
    path: PathBuf,
    file: FileMut,
    memory: MemoryFile,
}

/// A finished file that is not on disk yet.
#[derive(Debug)]
pub(super) struct Finished {
    path: PathBuf,
    memory: MemoryFile,
}

impl Finished {
    /// Path of the file on disk.
    pub fn path(&self) -> &Path {
        &self.path
    }

    /// Writes the file to disk. A failed call can be repeated.
    pub fn store(&self) -> Result<(), ArchiveError> {
        self.memory.store(&self.path)
    }
}

/// The hashes of the calibrations in a configuration, as `cam1: HASH, cam2: HASH`; `None` without
/// any.
fn calibration_hashes(configuration: &str) -> Option<String> {
    let table: toml::Table = configuration.parse().ok()?;
    let hashes: Vec<String> = table
        .get("calibration")?
        .as_array()?
        .iter()
        .filter_map(|entry| {
            let camera = usize::try_from(entry.get("camera")?.as_integer()?).ok()?;
            let hash = entry.get("sha256")?.as_str()?;
            Some(format!("{}: {hash}", CameraName(camera.checked_sub(1)?)))
        })
        .collect();
    (!hashes.is_empty()).then(|| hashes.join(", "))
}

/// The hashes of the files of bodies in a configuration, as `FILE: HASH, FILE: HASH`; `None` without any.
fn mask_hashes(configuration: &str) -> Option<String> {
    let table: toml::Table = configuration.parse().ok()?;
    let files = table.get("mask")?.get("file")?.as_array()?.iter();
    let hash = |entry: &toml::Value| {
        Some(format!("{}: {}", entry.get("file")?.as_str()?, entry.get("sha256")?.as_str()?))
    };
    let hashes: Vec<String> = files.filter_map(hash).collect();
    (!hashes.is_empty()).then(|| hashes.join(", "))
}

impl NetCdfFile {
    /// Creates a file of at most `bytes`, to be stored at `path`, with the global attributes.
    /// `configuration` is the TOML text of the measurement.
    pub fn create(
        path: &Path,
        bytes: u64,
        title: &str,
        configuration: &str,
    ) -> Result<Self, ArchiveError> {
        let (memory, created) =
            MemoryFile::create(bytes, create).map_err(ArchiveError::io("write", path))?;
        let describe = |mut file: FileMut| {
            let history = history_line("written");
            let version = VERSION;
            file.add_attribute("Conventions", "CF-1.11")?;
            file.add_attribute("title", title)?;
            file.add_attribute("source", version)?;
            file.add_attribute("code_version", version)?;
            file.add_attribute("history", history.as_str())?;
            file.add_attribute("configuration", configuration)?;
            if let Some(hashes) = calibration_hashes(configuration) {
                file.add_attribute("calibration_sha256", hashes.as_str())?;
            }
            if let Some(hashes) = mask_hashes(configuration) {
                file.add_attribute("mask_sha256", hashes.as_str())?;
            }
            Ok(file)
        };
        let file = created.and_then(describe).map_err(ArchiveError::netcdf(path))?;
        Ok(Self { path: path.into(), file, memory })
    }

    /// Size of the file so far, in bytes.
    pub fn bytes(&self) -> u64 {
        self.memory.bytes()
    }

    /// Path of the finished file.
    pub fn path(&self) -> &Path {
        &self.path
    }

    /// Adds the dimensions x, y, z with their coordinates in mm (`axes_mm` in this order). They
    /// have no attribute `axis`, which in CF means longitude, latitude and height.
    pub fn add_axes(&mut self, axes_mm: [Vec<f64>; 3]) -> Result<(), ArchiveError> {
        for (name, coordinates) in ["x", "y", "z"].into_iter().zip(axes_mm) {
            self.with(|file| file.add_dimension(name, coordinates.len()).map(|_| ()))?;
            self.add::<f64>(&axis(name), &[name])?;
            self.put(name, &coordinates)?;
        }
        Ok(())
    }

    /// Adds a global attribute.
    pub fn add_attribute(&mut self, name: &str, text: &str) -> Result<(), ArchiveError> {
        self.with(|file| file.add_attribute(name, text).map(|_| ()))
    }

    /// Adds the dimension along which records are appended.
    pub fn add_record_dimension(&mut self, name: &str) -> Result<(), ArchiveError> {
        self.with(|file| file.add_unlimited_dimension(name).map(|_| ()))
    }

    /// Adds a dimension of fixed length.
    pub fn add_dimension(&mut self, name: &str, length: usize) -> Result<(), ArchiveError> {
        self.with(|file| file.add_dimension(name, length).map(|_| ()))
    }

    /// Sets the value that marks missing data of a variable. Must be called before values are
    /// written.
    pub fn put_fill_value<T: NcTypeDescriptor>(
        &mut self,
        name: &str,
        value: T,
    ) -> Result<(), ArchiveError> {
        self.with(|file| required(file, name)?.set_fill_value(value))
    }

    /// Adds a described variable.
    pub fn add<T: NcTypeDescriptor>(
        &mut self,
        described: &Described,
        dimensions: &[&str],
    ) -> Result<(), ArchiveError> {
        self.with(|file| {
            let mut variable = file.add_variable::<T>(described.name, dimensions)?;
            variable.put_attribute("units", described.units)?;
            variable.put_attribute("long_name", described.long_name)?;
            Ok(())
        })
    }

    /// Adds a variable of vectors with missing values. Its fill value is NaN, which readers that
    /// ignore fill values also recognize as missing.
    pub fn add_with_gaps(
        &mut self,
        described: &Described,
        dimensions: &[&str],
    ) -> Result<(), ArchiveError> {
        self.add::<f32>(described, dimensions)?;
        self.with(|file| required(file, described.name)?.set_fill_value(f32::NAN))
    }

    /// Adds a variable of numbers that may be unknown; unknown ones are [`FILL_F64`].
    pub fn add_with_fill(
        &mut self,
        described: &Described,
        dimensions: &[&str],
    ) -> Result<(), ArchiveError> {
        self.add::<f64>(described, dimensions)?;
        self.with(|file| required(file, described.name)?.set_fill_value(FILL_F64))
    }

    /// Adds a variable of signed bytes 0, 1, ... with the meaning of each value.
    pub fn add_flag(
        &mut self,
        described: &Described,
        dimensions: &[&str],
        meanings: &str,
    ) -> Result<(), ArchiveError> {
        self.add::<i8>(described, dimensions)?;
        self.with(|file| {
            let mut variable = required(file, described.name)?;
            let values = 0..meanings.split(' ').count() as i8;
            variable.put_attribute("flag_values", values.collect::<Vec<_>>())?;
            variable.put_attribute("flag_meanings", meanings)?;
            Ok(())
        })
    }

    /// Adds a text attribute to a variable.
    pub fn put_text(
        &mut self,
        name: &str,
        attribute: &str,
        text: &str,
    ) -> Result<(), ArchiveError> {
        self.with(|file| required(file, name)?.put_attribute(attribute, text).map(|_| ()))
    }

    /// Compresses a variable losslessly. Must be called before values are written.
    pub fn compress(&mut self, name: &str) -> Result<(), ArchiveError> {
        self.with(|file| required(file, name)?.set_compression(1, true))
    }

    /// Writes a whole variable that has no record dimension.
    pub fn put<T: NcTypeDescriptor>(
        &mut self,
        name: &str,
        values: &[T],
    ) -> Result<(), ArchiveError> {
        self.with(|file| required(file, name)?.put_values(values, ..))
    }

    /// Writes record `index` of a variable.
    pub fn put_record<T: NcTypeDescriptor>(
        &mut self,
        name: &str,
        index: usize,
        values: &[T],
    ) -> Result<(), ArchiveError> {
        self.with(|file| {
            let mut variable = required(file, name)?;
            let mut extents = vec![netcdf::Extent::from(index..index + 1)];
            extents.resize(variable.dimensions().len(), (..).into());
            variable.put_values(values, extents)
        })
    }

    /// Closes the file.
    pub fn finish(self) -> Result<Finished, ArchiveError> {
        self.file.close().map_err(ArchiveError::netcdf(&self.path))?;
        Ok(Finished { path: self.path, memory: self.memory })
    }

    /// Closes the file and writes it to disk.
    pub fn store(self) -> Result<(), ArchiveError> {
        self.finish()?.store()
    }

    fn with<R>(
        &mut self,
        action: impl FnOnce(&mut FileMut) -> netcdf::Result<R>,
    ) -> Result<R, ArchiveError> {
        action(&mut self.file).map_err(ArchiveError::netcdf(&self.path))
    }
}

/// A line for a file's history: the current time and what was done.
pub(super) fn history_line(done: &str) -> String {
    let now = OffsetDateTime::now_utc().truncate_to_second().format(&Rfc3339);
    format!("{} {done} by {VERSION}", now.unwrap_or_default())
}

fn axis(name: &'static str) -> Described<'static> {
    let long_name = match name {
        "x" => "x in the world frame",
        "y" => "y in the world frame",
        _ => "z in the world frame",
    };
    Described { name, units: "mm", long_name }
}

fn required<'f>(file: &'f mut FileMut, name: &str) -> netcdf::Result<netcdf::VariableMut<'f>> {
    file.variable_mut(name).ok_or_else(|| netcdf::Error::NotFound(name.into()))
}
