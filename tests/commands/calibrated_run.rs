//! A run with calibrated cameras holds its calibration: it is measured and replayed without the file.

use std::{
    fs,
    path::{Path, PathBuf},
    process::Command,
};

use lfpiv::archive::StoredResults;

use crate::support::{Done, lfpiv};

const SHOTS: usize = 2;

fn succeeds(arguments: &[&Path]) -> String {
    let Done { success, stdout, stderr } = lfpiv(arguments);
    assert!(success, "{arguments:?}: {stdout}{stderr}");
    stdout
}

/// The only folder in a folder.
fn only(folder: &Path) -> PathBuf {
    let mut entries = fs::read_dir(folder).unwrap();
    let entry = entries.next().unwrap().unwrap().path();
    assert!(entries.next().is_none());
    entry
}

/// `config` names `calibration`, of the hash `sha256`, and results in the folder `results`; all in `root`.
pub fn outlives_its_calibration(root: &Path, config: &Path, calibration: &Path, sha256: &str) {
    let path = Path::new;
    let shots = SHOTS.to_string();
    succeeds(&[path("run"), path("--config"), config, path("--shots"), path(&shots)]);
    let run = only(&root.join("results"));
    let stored = StoredResults::find(&run).unwrap();
    assert_eq!(stored.shots.len(), SHOTS);
    for result in files(&run, ".nc") {
        let file = netcdf::open(&result).unwrap();
        let hash = file.attribute("calibration_sha256").unwrap().value().unwrap();
        assert_eq!(String::try_from(hash).unwrap(), format!("cam1: {sha256}, cam2: {sha256}"));
    }

    fs::remove_file(calibration).unwrap();
    let again = root.join("again");
    let said = succeeds(&[path("replay"), &run, path("--out"), &again]);
    assert!(said.contains("0 different"), "{said}");

    // The same record, and nothing measured of it yet.
    let later = root.join("later");
    let copied = Command::new("cp").arg("-a").args([&run, &later]).status().unwrap();
    assert!(copied.success());
    for result in files(&later, ".nc").into_iter().chain(files(&later, ".vti")) {
        fs::remove_file(result).unwrap();
    }
    let said = succeeds(&[path("process"), &later]);
    assert!(said.contains(&format!("0 had a result, {SHOTS} have one now")), "{said}");
    for other in [&later, &only(&again)] {
        let said = succeeds(&[path("compare"), &run, other]);
        assert!(said.contains(&format!("{SHOTS} shots")) && said.contains("0 different"), "{said}");
    }
}

fn files(folder: &Path, kind: &str) -> Vec<PathBuf> {
    let all = fs::read_dir(folder).unwrap().map(|entry| entry.unwrap().path());
    let found: Vec<PathBuf> = all.filter(|path| path.to_str().unwrap().ends_with(kind)).collect();
    assert!(kind != ".nc" || !found.is_empty());
    found
}
