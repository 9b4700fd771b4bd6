//! Finds the results of a run on disk.

use std::{
    collections::{BTreeMap, BTreeSet},
    fs,
    path::{Path, PathBuf},
};

use netcdf::AttributeValue;

use super::{ArchiveError, netcdf_file::FILL_F64, netcdf_open::open};

/// Attribute of a merged file: the shot that was stored first.
pub(super) const FIRST_STORED: &str = "first_stored_shot";

/// The results in a run's folder. Only sealed segments count, because they are complete.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct StoredResults {
    /// Shots with a stored result.
    pub shots: BTreeSet<u64>,
    /// UTC of the shots with a known time, in seconds since 1970.
    pub times_s: BTreeMap<u64, f64>,
    /// Number of records; larger than the number of shots if a shot is stored twice.
    pub records: usize,
    /// The shot that was stored first. It decided the forward model.
    pub first: Option<u64>,
    /// Incomplete segments of a killed run.
    pub unreadable: Vec<PathBuf>,
}

impl StoredResults {
    /// Reads the sealed segments in a run's folder.
    ///
    /// # Errors
    /// The folder cannot be listed, or a sealed segment cannot be read.
    pub fn find(folder: &Path) -> Result<Self, ArchiveError> {
        let mut stored = Self::default();
        let mut oldest = None;
        for path in segments(folder, ".nc")? {
            let shots = shots_in(&path)?;
            let sealed = fs::metadata(&path).and_then(|metadata| metadata.modified()).ok();
            if sealed.is_some() && (oldest.is_none() || sealed < oldest) {
                (oldest, stored.first) = (sealed, first_stored(&path)?);
            }
            stored.times_s.extend(times_in(&path)?);
            stored.records += shots.len();
            stored.shots.extend(shots);
        }
        stored.unreadable = segments(folder, ".nc.part")?;
        Ok(stored)
    }
}

/// All numbers of the stored vectors of each shot in a run's folder, as bits, to compare runs.
///
/// # Errors
/// As [`StoredResults::find`].
pub fn stored_vectors(folder: &Path) -> Result<BTreeMap<u64, Vec<u32>>, ArchiveError> {
    let mut vectors: BTreeMap<u64, Vec<u32>> = BTreeMap::new();
    for path in segments(folder, ".nc")? {
        for (record, shot) in records_of(&path)?.into_iter().enumerate() {
            let Ok(shot) = u64::try_from(shot) else { continue };
            let bits =
                vectors_of(&path, record).map_err(ArchiveError::unreadable_results(&path))?;
            vectors.insert(shot, bits);
        }
    }
    Ok(vectors)
}

fn vectors_of(path: &Path, record: usize) -> Result<Vec<u32>, netcdf::Error> {
    let file = open(path)?;
    let numbers_of = |name: &str| -> Result<Vec<f32>, netcdf::Error> {
        let variable = file.variable(name).ok_or_else(|| missing(name))?;
        variable.get_values((record, .., .., ..))
    };
    let (valid, replaced) = (numbers_of("valid")?, numbers_of("replaced")?);
    let mut bits = Vec::new();
    for name in COMPARED {
        let numbers = numbers_of(name)?;
        let is_flag = name == "valid" || name == "replaced";
        // The first versions stored zeros for missing vectors, later ones fill values.
        let missing = |n: usize| !is_flag && valid[n] == 0.0 && replaced[n] == 0.0;
        let number = |(n, value)| if missing(n) { f32::NAN } else { value };
        bits.extend(numbers.into_iter().enumerate().map(number).map(f32::to_bits));
    }
    Ok(bits)
}

/// The compared variables; processing times are left out.
const COMPARED: [&str; 8] =
    ["u", "v", "w", "u_uncertainty", "v_uncertainty", "w_uncertainty", "valid", "replaced"];

/// Segments in the run's folder whose names end in `ending`, sorted by name.
pub(super) fn segments(folder: &Path, ending: &str) -> Result<Vec<PathBuf>, ArchiveError> {
    named(folder, "velocity_", ending)
}

/// Files in a folder whose names begin and end so, sorted by name.
pub(super) fn named(
    folder: &Path,
    beginning: &str,
    ending: &str,
) -> Result<Vec<PathBuf>, ArchiveError> {
    let entries = fs::read_dir(folder).map_err(ArchiveError::io("list the folder", folder))?;
    let mut paths = Vec::new();
    for entry in entries {
        let path = entry.map_err(ArchiveError::io("list the folder", folder))?.path();
        let name = path.file_name().unwrap_or_default().to_string_lossy();
        if name.starts_with(beginning) && name.ends_with(ending) {
            paths.push(path);
        }
    }
    paths.sort();
    Ok(paths)
}

pub(super) fn missing(variable: &str) -> netcdf::Error {
    netcdf::Error::NotFound(variable.to_owned())
}

/// Shot numbers of a segment in the order of storage, without incomplete records.
pub(super) fn shots_in(path: &Path) -> Result<Vec<u64>, ArchiveError> {
    let records = records_of(path)?;
    Ok(records.into_iter().filter_map(|shot| u64::try_from(shot).ok()).collect())
}

/// The shot of a segment that was stored first.
pub(super) fn first_stored(path: &Path) -> Result<Option<u64>, ArchiveError> {
    let read = || -> Result<_, netcdf::Error> {
        open(path)?.attribute(FIRST_STORED).map(|first| first.value()).transpose()
    };
    match read().map_err(ArchiveError::unreadable_results(path))? {
        Some(AttributeValue::Longlong(shot)) => Ok(u64::try_from(shot).ok()),
        _ => Ok(shots_in(path)?.first().copied()),
    }
}

/// What a sealed file of results says of itself.
#[derive(Debug, Clone, PartialEq)]
pub struct SealedFile {
    /// Where it is.
    pub path: PathBuf,
    /// Its shots, in the order in which they were stored.
    pub shots: Vec<u64>,
    /// The configuration, TOML.
    pub configuration: String,
    /// The forward model and why, JSON; absent in files of earlier versions.
    pub model_choice: Option<String>,
}

impl SealedFile {
    /// Those in the folder of a run, sorted by name.
    ///
    /// # Errors
    /// As [`StoredResults::find`].
    pub fn find_all(folder: &Path) -> Result<Vec<Self>, ArchiveError> {
        segments(folder, ".nc")?.into_iter().map(Self::read).collect()
    }

    fn read(path: PathBuf) -> Result<Self, ArchiveError> {
        let model_choice = || -> Result<Option<String>, netcdf::Error> {
            let file = open(&path)?;
            let Some(choice) = file.attribute("model_choice") else { return Ok(None) };
            choice.value().and_then(String::try_from).map(Some)
        };
        Ok(Self {
            shots: shots_in(&path)?,
            configuration: stored_configuration(&path)?,
            model_choice: model_choice().map_err(ArchiveError::unreadable_results(&path))?,
            path,
        })
    }
}

/// The configuration of a result file, TOML.
///
/// # Errors
/// The file cannot be read.
pub fn stored_configuration(path: &Path) -> Result<String, ArchiveError> {
    let read = || -> Result<String, netcdf::Error> {
        let file = open(path)?;
        let text = file.attribute("configuration").ok_or_else(|| missing("configuration"))?;
        String::try_from(text.value()?)
    };
    read().map_err(ArchiveError::unreadable_results(path))
}

/// The known times of a segment's shots; earlier versions stored none.
fn times_in(path: &Path) -> Result<Vec<(u64, f64)>, ArchiveError> {
    let read = || -> Result<Vec<f64>, netcdf::Error> {
        let file = open(path)?;
        file.variable("time").map_or(Ok(Vec::new()), |time| time.get_values(..))
    };
    let times_s = read().map_err(ArchiveError::unreadable_results(path))?;
    let records = records_of(path)?.into_iter().zip(times_s);
    let known = records.filter(|(_, time_s)| *time_s < FILL_F64);
    Ok(known.filter_map(|(shot, time_s)| Some((u64::try_from(shot).ok()?, time_s))).collect())
}

/// Shot numbers as stored: negative for an incomplete record.
pub(super) fn records_of(path: &Path) -> Result<Vec<i64>, ArchiveError> {
    let read = || -> Result<Vec<i64>, netcdf::Error> {
        open(path)?.variable("shot").ok_or_else(|| missing("shot"))?.get_values(..)
    };
    read().map_err(ArchiveError::unreadable_results(path))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::archive::{ResultStore, test_data::result};

    #[test]
    fn only_sealed_results_count_after_a_crash() {
        let root = tempfile::tempdir().unwrap();
        let mut store = ResultStore::create(root.path(), "").unwrap();
        for shot in [3, 4] {
            store.append(shot, &result([4, 3, 2])).unwrap();
        }
        store.seal().unwrap();
        store.append(5, &result([4, 3, 2])).unwrap();
        // Like a killed process: the destructor does not run and an incomplete file remains.
        std::mem::forget(store);
        fs::write(root.path().join("velocity_000005.nc.part"), b"half").unwrap();
        let stored = StoredResults::find(root.path()).unwrap();
        assert_eq!((stored.shots, stored.first), (BTreeSet::from([3, 4]), Some(3)));
        assert_eq!(stored.unreadable.len(), 1);

        let (mut store, _) = ResultStore::reopen(root.path(), "").unwrap();
        store.append(5, &result([4, 3, 2])).unwrap();
        store.close().unwrap();
        let stored = StoredResults::find(root.path()).unwrap();
        assert_eq!(stored.shots, BTreeSet::from([3, 4, 5]));
        assert!(stored.unreadable.is_empty());
        assert_eq!(stored.times_s, BTreeMap::from([3, 4, 5].map(|shot| (shot, 1_700_000_000.25))));
        let series = fs::read_to_string(root.path().join("velocity.vti.series")).unwrap();
        assert_eq!(series.matches("shot_0000").count(), 3, "{series}");
        assert_eq!(series.matches("1700000000.25").count(), 3, "{series}");
    }
}
