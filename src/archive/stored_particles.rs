//! Reads the particles of a shot beside its vectors.

use std::{collections::BTreeMap, fs, ops::Range, path::Path};

use lfpiv_core::velocimetry::{MeasuredParticle, VelocityField};

use super::{
    ArchiveError,
    netcdf_open::open,
    particle_file::{PARTICLE, RECORD_SHOT, ROW_SIZE, particles_beside},
    stored::{missing, named, segments},
};

/// The particles of a shot whose vectors are `field`, in the file `velocity`. `None`: none were placed.
///
/// # Errors
/// The file of particles cannot be read.
pub(super) fn particles_of(
    velocity: &Path,
    shot: u64,
    field: &VelocityField,
) -> Result<Option<Vec<MeasuredParticle>>, ArchiveError> {
    let path = particles_beside(velocity);
    if !path.exists() {
        return Ok(None);
    }
    let read = || -> netcdf::Result<_> {
        let file = open(&path)?;
        rows_in(&file)?.remove(&shot).map(|rows| read(&file, rows, field)).transpose()
    };
    read().map_err(ArchiveError::unreadable_particles(&path))
}

/// The rows of each shot's particles in a file.
pub(super) fn rows_in(file: &netcdf::File) -> netcdf::Result<BTreeMap<u64, Range<usize>>> {
    let numbers = |name: &str| -> netcdf::Result<Vec<u64>> {
        file.variable(name).ok_or_else(|| missing(name))?.get_values(..)
    };
    let mut end = 0;
    let rows = numbers(RECORD_SHOT.name)?.into_iter().zip(numbers(ROW_SIZE.name)?);
    Ok(rows
        .map(|(shot, size)| {
            let start = end;
            end += size as usize;
            (shot, start..end)
        })
        .collect())
}

/// All numbers of the stored particles of each shot in a run's folder, as bits, to compare runs.
///
/// # Errors
/// The folder cannot be listed, or a file cannot be read.
pub fn stored_particles(folder: &Path) -> Result<BTreeMap<u64, Vec<u64>>, ArchiveError> {
    let mut particles = BTreeMap::new();
    for path in segments(folder, ".nc")?.iter().map(|path| particles_beside(path)) {
        if path.exists() {
            particles
                .append(&mut bits_in(&path).map_err(ArchiveError::unreadable_particles(&path))?);
        }
    }
    Ok(particles)
}

fn bits_in(path: &Path) -> netcdf::Result<BTreeMap<u64, Vec<u64>>> {
    let file = open(path)?;
    let mut shots = BTreeMap::new();
    for (shot, rows) in rows_in(&file)? {
        let mut bits = Vec::new();
        for variable in file.variables().filter(|_| !rows.is_empty()) {
            let numbers: Vec<f64> = match variable.dimensions() {
                [first] if first.name() == PARTICLE => variable.get_values(rows.clone())?,
                [first, _] if first.name() == PARTICLE => {
                    variable.get_values((rows.clone(), ..))?
                }
                _ => continue,
            };
            bits.extend(numbers.into_iter().map(f64::to_bits));
        }
        shots.insert(shot, bits);
    }
    Ok(shots)
}

fn read(
    file: &netcdf::File,
    rows: Range<usize>,
    field: &VelocityField,
) -> netcdf::Result<Vec<MeasuredParticle>> {
    let count = rows.len();
    if count == 0 {
        return Ok(Vec::new());
    }
    let numbers = |name: &str| -> netcdf::Result<Vec<f64>> {
        file.variable(name).ok_or_else(|| missing(name))?.get_values(rows.clone())
    };
    let triples = |names: [&str; 3]| -> netcdf::Result<Vec<[f64; 3]>> {
        let [x, y, z] = names.map(numbers);
        Ok(x?.into_iter().zip(y?).zip(z?).map(|((x, y), z)| [x, y, z]).collect())
    };
    let light = file.variable("light").ok_or_else(|| missing("light"))?;
    let light: Vec<f32> = light.get_values((rows.clone(), ..))?;
    let places = triples(["x", "y", "z"])?;
    let place_uncertainties = triples(["x_uncertainty", "y_uncertainty", "z_uncertainty"])?;
    let velocities = triples(["u", "v", "w"])?;
    let uncertainties = triples(["u_uncertainty", "v_uncertainty", "w_uncertainty"])?;
    let valid = numbers("valid")?;
    let voxels = 1.0 / field.metres_per_second_per_voxel();
    let particle = |n: usize| {
        let mut particle = MeasuredParticle {
            at_mm: places[n],
            place_uncertainty_vox: place_uncertainties[n].map(|mm| (mm / field.voxel_mm) as f32),
            displacement_vox: velocities[n].map(|speed| (speed * voxels) as f32),
            uncertainty_vox: uncertainties[n].map(|speed| (speed * voxels) as f32),
            light: Default::default(),
            agrees: valid[n] == 1.0,
        };
        let cameras = light.len() / count;
        let of_cameras = light[n * cameras..][..cameras].iter();
        particle.light.iter_mut().zip(of_cameras).for_each(|(to, from)| *to = *from);
        particle
    };
    Ok((0..count).map(particle).collect())
}

/// Removes files of particles whose vectors were not stored, because the process was killed in between: their
/// shots have no result. Only for who may write the run's folder.
///
/// # Errors
/// The folder cannot be listed, or a file cannot be removed.
pub(super) fn remove_orphans(folder: &Path) -> Result<(), ArchiveError> {
    let partners: Vec<_> =
        segments(folder, ".nc")?.iter().map(|path| particles_beside(path)).collect();
    let mut left = named(folder, "particles_", ".nc")?;
    left.retain(|path| !partners.contains(path));
    left.extend(named(folder, "particles_", ".nc.part")?);
    for path in &left {
        fs::remove_file(path).map_err(ArchiveError::io("remove", path))?;
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::archive::{
        ResultStore, RunResults, ShotResult, StoredResults,
        test_data::{result, with_particles},
    };

    fn particles(folder: &Path, shot: u64) -> Option<Vec<MeasuredParticle>> {
        let results = RunResults::find(folder, 0.1).unwrap();
        results.read(shot).unwrap().unwrap().measured.particles
    }

    fn assert_same(found: &Option<Vec<MeasuredParticle>>, expected: &ShotResult) {
        let expected = expected.measured.particles.as_ref().unwrap();
        let found = found.as_ref().unwrap();
        assert_eq!(found.len(), expected.len());
        for (found, expected) in found.iter().zip(expected) {
            assert_eq!((found.at_mm, found.light), (expected.at_mm, expected.light));
            assert_eq!(found.agrees, expected.agrees);
            let pairs = [
                (found.place_uncertainty_vox, expected.place_uncertainty_vox),
                (found.displacement_vox, expected.displacement_vox),
                (found.uncertainty_vox, expected.uncertainty_vox),
            ];
            for (a, b) in pairs.iter().flat_map(|(a, b)| a.iter().zip(b)) {
                assert!((a - b).abs() <= 1e-6 * b.abs(), "{a} {b}");
            }
        }
    }

    #[test]
    fn particles_are_read_back_as_they_were_measured() {
        let root = tempfile::tempdir().unwrap();
        let mut store = ResultStore::create(root.path(), "").unwrap();
        let mut later = with_particles(5, 9);
        later.measured.field.dt_s = 3e-4;
        let shots = [(7, with_particles(7, 20)), (6, with_particles(6, 0)), (5, later)];
        for (shot, result) in &shots {
            store.append(*shot, result).unwrap();
        }
        // One whose bench does not explain its images, say.
        store.append(4, &result([4, 3, 2])).unwrap();
        store.close().unwrap();
        for (shot, result) in &shots {
            assert_same(&particles(root.path(), *shot), result);
        }
        assert_eq!(particles(root.path(), 4), None);

        let file = netcdf::open(root.path().join("particles_000007.nc")).unwrap();
        let values = |name: &str| file.variable(name).unwrap().get_values::<f64, _>(..).unwrap();
        assert_eq!(values("record_shot"), [7.0, 6.0, 5.0]);
        assert_eq!(values("row_size"), [20.0, 0.0, 9.0]);
        assert_eq!(values("shot"), [vec![7.0; 20], vec![5.0; 9]].concat());
        assert_eq!(values("time"), [1_700_000_000.25; 29]);
        // A voxel of 0.1 mm in 100 us, and in 300 us, is 1 m/s and a third of it.
        assert_eq!(values("u")[..2], [7.0, f64::from(7.01_f32)]);
        assert!((values("v")[20] - 2.0 / 3.0).abs() < 1e-6);
        assert!((values("x_uncertainty")[0] - 0.1 * 0.18).abs() < 1e-8);
    }

    #[test]
    fn shots_without_particles_have_no_file_and_only_particles_can_be_none() {
        let root = tempfile::tempdir().unwrap();
        let mut store = ResultStore::create(root.path(), "").unwrap();
        store.append(0, &result([4, 3, 2])).unwrap();
        store.seal().unwrap();
        store.append(1, &with_particles(1, 0)).unwrap();
        store.close().unwrap();
        assert!(!root.path().join("particles_000000.nc").exists());
        assert_eq!(particles(root.path(), 1), Some(Vec::new()));
    }

    #[test]
    fn a_segment_with_many_particles_is_sealed() {
        let root = tempfile::tempdir().unwrap();
        let mut store = ResultStore::create(root.path(), "").unwrap();
        // 32 MB are 524,288 of them.
        store.append(0, &with_particles(0, 400_000)).unwrap();
        assert!(StoredResults::find(root.path()).unwrap().shots.is_empty());
        store.append(1, &with_particles(1, 130_000)).unwrap();
        assert_eq!(StoredResults::find(root.path()).unwrap().shots.len(), 2);
        assert_eq!(particles(root.path(), 1).unwrap().len(), 130_000);
    }

    #[test]
    fn particles_without_vectors_are_gone_after_a_crash() {
        let root = tempfile::tempdir().unwrap();
        let mut store = ResultStore::create(root.path(), "").unwrap();
        for shot in [0, 1] {
            store.append(shot, &with_particles(shot, 3)).unwrap();
            store.seal().unwrap();
        }
        store.close().unwrap();
        // Killed between the particles and the vectors of a segment.
        fs::remove_file(root.path().join("velocity_000001.nc")).unwrap();
        fs::write(root.path().join("particles_000002.nc.part"), b"half").unwrap();
        let (mut store, stored) = ResultStore::reopen(root.path(), "").unwrap();
        assert_eq!(stored.shots.into_iter().collect::<Vec<_>>(), [0]);
        assert_eq!(named(root.path(), "particles_", "").unwrap().len(), 1);
        store.append(1, &with_particles(1, 2)).unwrap();
        store.close().unwrap();
        assert_eq!(StoredResults::find(root.path()).unwrap().shots.len(), 2);
        for (shot, count) in [(0, 3), (1, 2)] {
            assert_same(&particles(root.path(), shot), &with_particles(shot, count));
        }
    }

    #[test]
    fn damaged_particles_cost_only_themselves() {
        let root = tempfile::tempdir().unwrap();
        let mut store = ResultStore::create(root.path(), "").unwrap();
        store.append(0, &with_particles(0, 3)).unwrap();
        store.close().unwrap();
        fs::write(root.path().join("particles_000000.nc"), b"damaged").unwrap();
        assert_eq!(particles(root.path(), 0), None);
        let results = RunResults::find(root.path(), 0.1).unwrap();
        let error = results.read_whole(0).unwrap_err().to_string();
        assert!(error.contains("particles_000000.nc"), "{error}");
        assert!(stored_particles(root.path()).is_err());
    }
}
