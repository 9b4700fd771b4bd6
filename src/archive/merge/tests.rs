use std::time::Duration;

use lfpiv_core::model::ModelChoice;

use super::*;
use crate::archive::{
    ResultStore, RunResults, ShotResult, StoredResults, stored_vectors,
    test_data::{result, with_particles},
};

/// A folder with one segment for each list of shots.
fn run(segments: &[&[u64]]) -> tempfile::TempDir {
    let root = tempfile::tempdir().unwrap();
    let mut store = ResultStore::create(root.path(), "").unwrap();
    for shots in segments {
        for shot in *shots {
            store.append(*shot, &numbered(*shot)).unwrap();
        }
        store.seal().unwrap();
    }
    store.close().unwrap();
    root
}

/// A result that differs between shots.
fn numbered(shot: u64) -> ShotResult {
    let mut result = result([4, 3, 2]);
    result.measured.field.displacement_vox[5][1] = shot as f32;
    result
}

fn files(folder: &Path) -> Vec<(String, Vec<i64>)> {
    let paths = segments(folder, ".nc").unwrap();
    let name = |path: &Path| path.file_name().unwrap().to_string_lossy().into_owned();
    paths.iter().map(|path| (name(path), records_of(path).unwrap())).collect()
}

fn file(name: &str, shots: &[i64]) -> (String, Vec<i64>) {
    (name.to_owned(), shots.to_vec())
}

#[test]
fn segments_become_one_file_sorted_by_shot_with_every_number_in_place() {
    let root = run(&[&[3, 1], &[2], &[0, 5, 4]]);
    let before = stored_vectors(root.path()).unwrap();
    let stored = StoredResults::find(root.path()).unwrap();
    let attributes = |name: &str| {
        let file = netcdf::open(root.path().join(name)).unwrap();
        let of = |owner: &str| {
            let variable = file.variable(owner).unwrap();
            // Compared as text, because a NaN fill value does not equal itself.
            let found = variable.attributes().map(|a| (a.name().to_owned(), a.value().unwrap()));
            found.map(|attribute| format!("{attribute:?}")).collect::<Vec<_>>()
        };
        [of("u"), of("time"), of("valid")]
    };
    let described = attributes("velocity_000003.nc");
    merge_segments(root.path(), || true).unwrap();
    assert_eq!(files(root.path()), [file("velocity_000000.nc", &[0, 1, 2, 3, 4, 5])]);
    assert_eq!(stored_vectors(root.path()).unwrap(), before);
    assert_eq!(attributes("velocity_000000.nc"), described);
    let merged = StoredResults::find(root.path()).unwrap();
    assert_eq!((merged.shots, merged.times_s), (stored.shots, stored.times_s));
    let file = netcdf::open(root.path().join("velocity_000000.nc")).unwrap();
    let history = file.attribute("history").unwrap().value().unwrap();
    assert!(format!("{history:?}").contains("3 segments merged"), "{history:?}");
    assert_eq!(file.variable("dt").unwrap().get_values::<f64, _>(..).unwrap(), [1e-4; 6]);
}

#[test]
fn the_first_stored_shot_is_kept_in_an_attribute() {
    let root = run(&[&[7, 8], &[2]]);
    // File systems may resolve times coarsely.
    let later = SystemTime::now() + Duration::from_secs(60);
    let younger = File::options().append(true).open(root.path().join("velocity_000002.nc"));
    younger.unwrap().set_modified(later).unwrap();
    for _ in 0..2 {
        merge_segments(root.path(), || true).unwrap();
        assert_eq!(StoredResults::find(root.path()).unwrap().first, Some(7));
    }
    // Shots measured later do not change the first stored shot.
    let (mut store, _) = ResultStore::reopen(root.path(), "").unwrap();
    store.append(1, &numbered(1)).unwrap();
    store.close().unwrap();
    merge_segments(root.path(), || true).unwrap();
    assert_eq!(files(root.path()), [file("velocity_000001.nc", &[1, 2, 7, 8])]);
    assert_eq!(StoredResults::find(root.path()).unwrap().first, Some(7));
}

#[test]
fn another_model_stays_in_a_file_of_its_own() {
    let root = tempfile::tempdir().unwrap();
    let mut store = ResultStore::create(root.path(), "").unwrap();
    for shot in 0..6 {
        let mut result = numbered(shot);
        let refinement = 1 + shot as usize % 2;
        result.measured.model = ModelChoice { refinement, ..ModelChoice::default() }.into();
        store.append(shot, &result).unwrap();
    }
    store.close().unwrap();
    merge_segments(root.path(), || true).unwrap();
    let expected = [file("velocity_000000.nc", &[0, 2, 4]), file("velocity_000001.nc", &[1, 3, 5])];
    assert_eq!(files(root.path()), expected);
}

#[test]
fn merged_files_are_bounded() {
    let root = run(&[&[0, 1], &[2, 3], &[4, 5], &[6, 7], &[8]]);
    let bounds = Bounds { shots: 4, bytes: u64::MAX };
    merge_within(root.path(), bounds, || true).unwrap();
    let expected = [
        file("velocity_000000.nc", &[0, 1, 2, 3]),
        file("velocity_000004.nc", &[4, 5, 6, 7]),
        file("velocity_000008.nc", &[8]),
    ];
    assert_eq!(files(root.path()), expected);
    let bytes = fs::metadata(root.path().join("velocity_000000.nc")).unwrap().len();
    merge_within(root.path(), Bounds { shots: 99, bytes }, || true).unwrap();
    assert_eq!(files(root.path()), expected, "none fits with another");
}

#[test]
fn interleaved_segments_become_files_with_consecutive_shots() {
    let root = run(&[&[0, 2, 4, 6, 8, 10], &[1, 3, 5, 7, 9], &[11, 12]]);
    let before = stored_vectors(root.path()).unwrap();
    let bounds = Bounds { shots: 4, bytes: u64::MAX };
    for _ in 0..2 {
        merge_within(root.path(), bounds, || true).unwrap();
        let mut shots: Vec<Vec<i64>> =
            files(root.path()).into_iter().map(|(_, shots)| shots).collect();
        shots.sort();
        let expected: [&[i64]; 4] = [&[0, 1, 2, 3], &[4, 5, 6, 7], &[8, 9, 10], &[11, 12]];
        assert_eq!(shots, expected);
        assert_eq!(stored_vectors(root.path()).unwrap(), before);
    }
}

#[test]
fn shots_with_different_pulse_separations_share_a_file() {
    let root = tempfile::tempdir().unwrap();
    let mut store = ResultStore::create(root.path(), "").unwrap();
    for (shot, dt_s) in [(0, 1e-4), (1, 2e-4), (2, 1e-4)] {
        let mut result = numbered(shot);
        result.measured.field.dt_s = dt_s;
        store.append(shot, &result).unwrap();
    }
    store.close().unwrap();
    let file = netcdf::open(root.path().join("velocity_000000.nc")).unwrap();
    let dt_s = file.variable("dt").unwrap().get_values::<f64, _>(..).unwrap();
    assert_eq!(dt_s, [1e-4, 2e-4, 1e-4]);
}

#[test]
fn segments_stay_unchanged_when_merging_is_stopped() {
    let root = run(&[&[1, 0], &[2]]);
    let before = files(root.path());
    merge_segments(root.path(), || false).unwrap();
    assert_eq!(files(root.path()), before);
}

#[test]
fn the_next_merge_completes_a_merge_that_was_killed() {
    let root = run(&[&[0], &[1], &[2]]);
    let left = root.path().join("velocity_000001.nc");
    let copy = fs::read(&left).unwrap();
    merge_segments(root.path(), || true).unwrap();
    fs::write(&left, copy).unwrap();
    let stored = StoredResults::find(root.path()).unwrap();
    assert_eq!((stored.shots, stored.records), (BTreeSet::from([0, 1, 2]), 4));
    merge_segments(root.path(), || true).unwrap();
    assert_eq!(files(root.path()), [file("velocity_000000.nc", &[0, 1, 2])]);
}

/// A run whose shot has as many particles as its number; 3 has none because none were placed.
fn run_with_particles(segments: &[&[u64]]) -> tempfile::TempDir {
    let root = tempfile::tempdir().unwrap();
    let mut store = ResultStore::create(root.path(), "").unwrap();
    for shots in segments {
        for shot in *shots {
            let mut result = with_particles(*shot, *shot as usize);
            result.measured.particles.take_if(|_| *shot == 3);
            store.append(*shot, &result).unwrap();
        }
        store.seal().unwrap();
    }
    store.close().unwrap();
    root
}

fn particles(folder: &Path, shot: u64) -> Option<String> {
    let result = RunResults::find(folder, 0.1).unwrap().read(shot).unwrap().unwrap();
    result.measured.particles.map(|particles| format!("{particles:?}"))
}

#[test]
fn particles_stay_with_their_shots() {
    let segments: [&[u64]; 5] = [&[3], &[6, 4, 0], &[5], &[2, 9, 1], &[7, 8]];
    for most in [4, 100] {
        let root = run_with_particles(&segments);
        let before: Vec<_> = (0..10).map(|shot| particles(root.path(), shot)).collect();
        assert_eq!((&before[3], before[0].as_deref()), (&None, Some("[]")));
        // The second time nothing is left to do.
        for _ in 0..2 {
            merge_within(root.path(), Bounds { shots: most, bytes: u64::MAX }, || true).unwrap();
            for (shot, before) in before.iter().enumerate() {
                assert_eq!(particles(root.path(), shot as u64), *before, "shot {shot}");
            }
        }
        let names: Vec<_> = files(root.path())
            .iter()
            .map(|(name, _)| name.replace("velocity", "particles"))
            .collect();
        let mut found: Vec<_> = fs::read_dir(root.path())
            .unwrap()
            .map(|entry| entry.unwrap().file_name().into_string().unwrap())
            .filter(|name| name.starts_with("particles"))
            .collect();
        found.sort();
        assert_eq!(found, names, "each beside its vectors");
        let file = netcdf::open(root.path().join(&names[0])).unwrap();
        let history = format!("{:?}", file.attribute("history").unwrap().value().unwrap());
        assert!(history.contains("segments merged"), "{history}");
        let shots: Vec<i64> = file.variable("shot").unwrap().get_values(..).unwrap();
        assert!(shots.is_sorted(), "{shots:?}");
    }
}

#[test]
fn the_next_merge_completes_one_that_was_killed_between_particles_and_vectors() {
    let root = run_with_particles(&[&[1], &[2], &[4]]);
    let (first, second) =
        (root.path().join("velocity_000001.nc"), root.path().join("velocity_000002.nc"));
    let kept = [&first, &second, &particles_beside(&second)].map(|path| fs::read(path).unwrap());
    let before: Vec<_> = [1, 2, 4].map(|shot| particles(root.path(), shot)).into();
    merge_segments(root.path(), || true).unwrap();
    // The particles of all are beside the vectors of the first; a segment is not removed yet.
    for (path, bytes) in [&first, &second, &particles_beside(&second)].into_iter().zip(kept) {
        fs::write(path, bytes).unwrap();
    }
    let now: Vec<_> = [1, 2].map(|shot| particles(root.path(), shot)).into();
    assert_eq!(now, before[..2]);
    merge_segments(root.path(), || true).unwrap();
    assert_eq!(files(root.path()), [file("velocity_000001.nc", &[1, 2])]);
    let now: Vec<_> = [1, 2].map(|shot| particles(root.path(), shot)).into();
    assert_eq!(now, before[..2]);
}
