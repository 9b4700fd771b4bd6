//! `lfpiv serve RUN`: a run that is over, on the same page and the same interface.

use std::{
    collections::BTreeMap,
    fs,
    path::{Path, PathBuf},
    time::Instant,
};

use crate::{
    BROWSER,
    daemon::{BODY, Daemon, READ, Scene, configuration, lfpiv, only_run},
    script::run_script,
};

const SHOTS: u64 = 4;
/// Time between SIGTERM and its end, with requests under way.
const END_S: f64 = 20.0;

#[test]
fn a_finished_run_is_shown_and_cannot_be_controlled() {
    let _browser = BROWSER.lock().unwrap_or_else(|poisoned| poisoned.into_inner());
    let folder = tempfile::tempdir().unwrap();
    let run = finished_run(folder.path(), Scene::Body, SHOTS);
    // What a run was measured with is in the run.
    fs::remove_file(folder.path().join(BODY)).unwrap();
    let before = contents(&run);
    let mut daemon = Daemon::serve(&run);

    let status = daemon.get("/api/v1/status");
    assert_eq!((&status["state"], &status["shots"]["done"]), (&"finished".into(), &SHOTS.into()));
    assert_eq!(status["ledger"]["balanced"], true);
    let mask = &status["configuration"]["mask"];
    assert!((0.8..0.98).contains(&mask["flow_share"].as_f64().unwrap()), "{mask}");
    assert_eq!(mask["files"][0]["file"], BODY);
    let shots = daemon.get("/api/v1/shots?limit=100");
    let numbers: Vec<u64> = shots["shots"]
        .as_array()
        .unwrap()
        .iter()
        .filter_map(|shot| shot["shot"].as_u64())
        .collect();
    assert_eq!(numbers.len() as u64, SHOTS, "{shots}");
    for shot in numbers {
        let result = daemon.get(&format!("/api/v1/results/{shot}"));
        assert_eq!(result["shot"], shot);
    }

    // The configuration allows arming; there is nothing to arm.
    assert_eq!(daemon.get("/api/v1/control")["controllable"], false);
    for command in ["start", "stop", "arm", "disarm"] {
        assert_eq!(daemon.post(&format!("/api/v1/control/{command}"), ""), 409, "{command}");
    }
    for (command, body) in [("dt", r#"{"dt_us": 90.0}"#), ("note", r#"{"text": "later"}"#)] {
        assert_eq!(daemon.post(&format!("/api/v1/control/{command}"), body), 409, "{command}");
    }

    run_script("served.mjs", &[&daemon.url(), READ, &SHOTS.to_string()], |asked| {
        panic!("asked for {asked}")
    });
    let told = Instant::now();
    assert!(daemon.terminate().success());
    assert!(told.elapsed().as_secs_f64() < END_S, "{:?}", told.elapsed());
    assert!(contents(&run) == before, "something in the run's folder has changed");
}

/// Takes shots to the end, and gives the run's folder.
pub fn finished_run(folder: &Path, scene: Scene, shots: u64) -> PathBuf {
    let mut command = lfpiv(&["run", "--shots", &shots.to_string(), "--config"]);
    let output = command.arg(configuration(folder, 0, scene)).output().unwrap();
    assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
    only_run(folder)
}

/// Every file below a folder.
fn contents(folder: &Path) -> BTreeMap<PathBuf, Vec<u8>> {
    let mut files = BTreeMap::new();
    for entry in fs::read_dir(folder).unwrap() {
        let path = entry.unwrap().path();
        if path.is_dir() {
            files.extend(contents(&path));
        } else {
            files.insert(path.clone(), fs::read(&path).unwrap());
        }
    }
    files
}
