//! Reads the record of a shot in a NetCDF file of results, variable by variable.

use std::{
    collections::BTreeMap,
    path::{Path, PathBuf},
};

use lfpiv_core::velocimetry::{VectorGrid, VectorStatus};

use super::{
    ArchiveError,
    stored::{missing, records_of, segments},
};

/// Location of a shot's record.
#[derive(Debug, Clone)]
pub(super) struct RecordPlace {
    pub(super) path: PathBuf,
    pub(super) record: usize,
}

/// The records in a run's sealed segments, by shot. A shot that is stored twice, after an
/// interrupted merge, counts once.
///
/// # Errors
/// The folder or a segment cannot be read.
pub(super) fn places_in_segments(
    folder: &Path,
) -> Result<BTreeMap<u64, RecordPlace>, ArchiveError> {
    let mut places = BTreeMap::new();
    for path in segments(folder, ".nc")? {
        for (record, shot) in records_of(&path)?.into_iter().enumerate() {
            let Ok(shot) = u64::try_from(shot) else { continue };
            places.entry(shot).or_insert_with(|| RecordPlace { path: path.clone(), record });
        }
    }
    Ok(places)
}

/// A record of an open file.
#[derive(Debug, Clone, Copy)]
pub(super) struct StoredRecord<'a> {
    pub(super) file: &'a netcdf::File,
    pub(super) record: usize,
}

impl StoredRecord<'_> {
    /// One number per vector.
    pub(super) fn vectors(&self, name: &str) -> netcdf::Result<Vec<f32>> {
        let variable = self.file.variable(name).ok_or_else(|| missing(name))?;
        variable.get_values((self.record, .., .., ..))
    }

    /// Three numbers per vector.
    pub(super) fn triples(&self, names: [&str; 3]) -> netcdf::Result<Vec<[f32; 3]>> {
        let [x, y, z] = names.map(|name| self.vectors(name));
        Ok(x?.into_iter().zip(y?).zip(z?).map(|((x, y), z)| [x, y, z]).collect())
    }

    /// The status of each vector.
    pub(super) fn status(&self) -> netcdf::Result<Vec<VectorStatus>> {
        let (valid, replaced) = (self.vectors("valid")?, self.vectors("replaced")?);
        // Earlier versions knew no masks.
        let masked = match self.file.variable("masked") {
            Some(_) => self.vectors("masked")?,
            None => vec![0.0; valid.len()],
        };
        let status = valid.iter().zip(&replaced).zip(&masked).map(|flags| match flags {
            ((1.0, _), _) => VectorStatus::Valid,
            ((_, 1.0), _) => VectorStatus::Replaced,
            (_, 1.0) => VectorStatus::Masked,
            _ => VectorStatus::Invalid,
        });
        Ok(status.collect())
    }

    /// A number of the shot, or, in files of earlier versions, of all shots; `None` if the file has
    /// no such variable.
    pub(super) fn number(&self, name: &str) -> netcdf::Result<Option<f64>> {
        let Some(variable) = self.file.variable(name) else { return Ok(None) };
        let numbers = variable.get_values::<f64, _>(..)?;
        Ok(numbers.get(if variable.dimensions().is_empty() { 0 } else { self.record }).copied())
    }

    /// The grid of the vectors.
    pub(super) fn grid(&self) -> netcdf::Result<VectorGrid> {
        let axis = |name: &str| -> netcdf::Result<Vec<f64>> {
            self.file.variable(name).ok_or_else(|| missing(name))?.get_values(..)
        };
        let axes = [axis("x")?, axis("y")?, axis("z")?];
        let spacings = axes.iter().filter(|axis| axis.len() > 1);
        let mut spacings =
            spacings.map(|axis| (axis[axis.len() - 1] - axis[0]) / (axis.len() - 1) as f64);
        Ok(VectorGrid {
            vectors: axes.each_ref().map(Vec::len),
            first_mm: axes.each_ref().map(|axis| axis.first().copied().unwrap_or_default()),
            spacing_mm: spacings.next().unwrap_or(1.0),
        })
    }
}
