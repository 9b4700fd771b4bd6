//! Reads the vectors in a folder of results, shot by shot.

use std::{
    collections::{BTreeMap, BTreeSet},
    path::Path,
};

use lfpiv_core::velocimetry::{VectorGrid, VectorStatus};

use super::{
    ArchiveError,
    netcdf_file::FILL_F64,
    netcdf_open::open,
    pair_results::pair_results,
    stored::{missing, records_of, stored_configuration},
    stored_record::{RecordPlace, StoredRecord, places_in_segments},
};

/// A stored result in SI units, with positions in mm. Arrays are in the order z, y, x (x fastest).
/// Missing numbers are NaN.
#[derive(Debug, Clone, PartialEq)]
pub struct StoredShot {
    /// Shot number.
    pub shot: u64,
    /// UTC of the trigger in seconds since 1970, if known.
    pub time_s: Option<f64>,
    /// Time between the frames, in s.
    pub dt_s: f64,
    /// The grid of the vectors.
    pub grid: VectorGrid,
    /// Velocity along x, y, z, in m/s.
    pub velocity_m_s: Vec<[f32; 3]>,
    /// Standard uncertainty of the velocity, in m/s.
    pub uncertainty_m_s: Vec<[f32; 3]>,
    /// The status of each vector.
    pub status: Vec<VectorStatus>,
    /// Highest over second highest correlation peak.
    pub peak_ratio: Vec<f32>,
    /// Vorticity, in 1/s.
    pub vorticity_per_s: Vec<[f32; 3]>,
    /// Divergence, in 1/s.
    pub divergence_per_s: Vec<f32>,
}

/// The shots with stored results in a folder: that of a run, or one in which `lfpiv process` has
/// stored the results of pairs.
#[derive(Debug)]
pub struct StoredShots {
    /// Location of each shot's record.
    places: BTreeMap<u64, RecordPlace>,
}

impl StoredShots {
    /// Indexes the sealed files in `folder`. A shot that is stored twice counts once.
    ///
    /// # Errors
    /// The folder or a file cannot be read.
    pub fn find(folder: &Path) -> Result<Self, ArchiveError> {
        let places = places_in_segments(folder)?;
        if !places.is_empty() {
            return Ok(Self { places });
        }
        let (mut numbered, mut places) = (BTreeMap::new(), Vec::new());
        for path in pair_results(folder)? {
            for shot in records_of(&path)?.into_iter().filter_map(|shot| u64::try_from(shot).ok()) {
                let place = RecordPlace { path: path.clone(), record: 0 };
                numbered.insert(shot, place.clone());
                places.push(place);
            }
        }
        // Earlier versions gave every pair the number 0.
        if numbered.len() < places.len() {
            numbered = (0..).zip(places).collect();
        }
        Ok(Self { places: numbered })
    }

    /// Number of shots.
    pub fn len(&self) -> usize {
        self.places.len()
    }

    /// Whether there are no shots.
    pub fn is_empty(&self) -> bool {
        self.places.is_empty()
    }

    /// Number of files that contain the shots.
    pub fn files(&self) -> usize {
        self.places.values().map(|place| &place.path).collect::<BTreeSet<_>>().len()
    }

    /// The configuration of the first shot, TOML; empty without shots.
    ///
    /// # Errors
    /// The file cannot be read.
    pub fn configuration(&self) -> Result<String, ArchiveError> {
        self.places
            .values()
            .next()
            .map_or(Ok(String::new()), |place| stored_configuration(&place.path))
    }

    /// The shot numbers, ascending.
    pub fn shots(&self) -> impl Iterator<Item = u64> {
        self.places.keys().copied()
    }

    /// Keeps only the shots for which `is_wanted` is true.
    pub fn retain(&mut self, is_wanted: impl Fn(u64) -> bool) {
        self.places.retain(|shot, _| is_wanted(*shot));
    }

    /// Reads the shots in ascending order and passes each to `take`, which can stop with an error.
    ///
    /// # Errors
    /// A file cannot be read, or the error of `take`.
    pub fn for_each<E: From<ArchiveError>>(
        &self,
        mut take: impl FnMut(StoredShot) -> Result<(), E>,
    ) -> Result<(), E> {
        let mut last: Option<(&Path, netcdf::File)> = None;
        for (shot, RecordPlace { path, record }) in &self.places {
            let unreadable = ArchiveError::unreadable_results(path);
            let file = match last.take().filter(|(open, _)| *open == path) {
                Some((_, file)) => file,
                None => match open(path) {
                    Ok(file) => file,
                    Err(reason) => return Err(unreadable(reason).into()),
                },
            };
            let read = read(StoredRecord { file: &file, record: *record }, *shot)
                .map_err(ArchiveError::unreadable_results(path))?;
            last = Some((path, file));
            take(read)?;
        }
        Ok(())
    }
}

fn read(record: StoredRecord<'_>, shot: u64) -> netcdf::Result<StoredShot> {
    let status = record.status()?;
    // The first versions stored zeros for missing vectors.
    let or_nan = |mut values: Vec<[f32; 3]>| {
        for (value, status) in values.iter_mut().zip(&status) {
            if !status.has_value() {
                *value = [f32::NAN; 3];
            }
        }
        values
    };
    Ok(StoredShot {
        shot,
        time_s: record.number("time")?.filter(|time_s| *time_s < FILL_F64),
        dt_s: record.number("dt")?.ok_or_else(|| missing("dt"))?,
        grid: record.grid()?,
        velocity_m_s: or_nan(record.triples(["u", "v", "w"])?),
        uncertainty_m_s: or_nan(record.triples([
            "u_uncertainty",
            "v_uncertainty",
            "w_uncertainty",
        ])?),
        peak_ratio: record.vectors("peak_ratio")?,
        vorticity_per_s: record.triples(["vorticity_x", "vorticity_y", "vorticity_z"])?,
        divergence_per_s: record.vectors("divergence")?,
        status,
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::archive::{ResultStore, ShotResult, test_data::result, write_velocity};

    fn shots(folder: &Path) -> Vec<StoredShot> {
        let mut found = Vec::new();
        let take = |shot| -> Result<(), ArchiveError> {
            found.push(shot);
            Ok(())
        };
        StoredShots::find(folder).unwrap().for_each(take).unwrap();
        found
    }

    #[test]
    fn shots_are_read_in_order_as_measured() {
        let root = tempfile::tempdir().unwrap();
        let mut store = ResultStore::create(root.path(), "").unwrap();
        for shot in [4, 3, 9] {
            let mut result = result([4, 3, 2]);
            result.measured.field.dt_s = 1e-4 * shot as f64;
            store.append(shot, &result).unwrap();
            if shot == 3 {
                store.seal().unwrap();
            }
        }
        store.close().unwrap();
        let found = shots(root.path());
        assert_eq!(found.iter().map(|shot| shot.shot).collect::<Vec<_>>(), [3, 4, 9]);
        let field = result([4, 3, 2]).measured.field;
        let [shot, ..] = &found[..] else { panic!() };
        assert!((shot.dt_s - 3e-4).abs() < 1e-12);
        assert_eq!(shot.time_s, Some(1_700_000_000.25));
        assert_eq!(shot.status, field.status);
        for axis in 0..3 {
            assert_eq!(shot.grid.vectors[axis], field.grid.vectors[axis]);
            assert!((shot.grid.first_mm[axis] - field.grid.first_mm[axis]).abs() < 1e-9);
        }
        assert!((shot.grid.spacing_mm - 0.8).abs() < 1e-9);
        // A voxel of 0.1 mm in 300 us.
        let speed = field.displacement_vox[4][1] / 3.0;
        assert!((shot.velocity_m_s[4][1] - speed).abs() < 1e-6);
        assert!(shot.velocity_m_s[2].iter().all(|v| v.is_nan()));
        assert!(shot.divergence_per_s[2].is_nan());
    }

    #[test]
    fn processed_pairs_are_read_as_shots() {
        let root = tempfile::tempdir().unwrap();
        for (shot, name) in [(0, "a"), (1, "b")] {
            let folder = root.path().join(name);
            std::fs::create_dir(&folder).unwrap();
            let imported = ShotResult { time: None, ..result([4, 3, 2]) };
            write_velocity(&folder.join("velocity.nc"), "", shot, &imported).unwrap();
        }
        let found = shots(root.path());
        assert_eq!(
            found.iter().map(|shot| (shot.shot, shot.time_s)).collect::<Vec<_>>(),
            [(0, None), (1, None)]
        );
    }
}
