//! A full disk: firing is suspended, nothing acknowledged is lost, and firing resumes once there is
//! space.

use std::{
    fs,
    io::Write,
    path::{Path, PathBuf},
    process::{Child, Command, Stdio},
    time::{Duration, Instant},
};

use serde_json::Value;

use crate::{
    bench::{PATIENCE, Running, configuration, images, lfpiv, text},
    small_disk::{in_namespace, mount_small_disk},
};

#[test]
fn a_full_disk_suspends_firing_until_there_is_space() {
    if let Some(passed) = in_namespace("disk::half_of_a_full_disk") {
        assert!(passed);
    }
}

#[test]
fn a_disk_that_fills_up_loses_nothing_that_was_acknowledged() {
    if let Some(passed) = in_namespace("disk::half_of_a_disk_that_fills_up") {
        assert!(passed);
    }
}

#[test]
fn even_the_first_shot_waits_for_room() {
    if let Some(passed) = in_namespace("disk::half_of_the_first_shot") {
        assert!(passed);
    }
}

#[test]
fn processing_onto_a_full_disk_says_so_and_is_resumed() {
    if let Some(passed) = in_namespace("disk::half_of_processing") {
        assert!(passed);
    }
}

#[test]
#[ignore = "the half of a_disk_that_fills_up_... that runs in a namespace"]
fn half_of_a_disk_that_fills_up() {
    let root = tempfile::tempdir().expect("a folder");
    mount_small_disk(&root.path().join("results"), 30);
    let config = configuration(root.path(), "[raw_log]\nreserve_mb = 0\nsync_ms = 5\n");
    let running = Running::start(&config, &["--shots", "10000"]);
    let status = running.wait_until(|status| status["watermarks"]["fsynced"].as_u64() > Some(5));
    let acknowledged = status["watermarks"]["fsynced"].as_u64().expect("a count") as usize;
    // The disk is filled from outside.
    let mut ballast = fs::File::create(root.path().join("results/ballast")).expect("a file");
    while ballast.write_all(&[1; 1 << 16]).is_ok() {}
    let began = Instant::now();
    let stopped = |status: &Value| status["shots"]["triggered"].clone();
    let mut before = Value::Null;
    // Either firing is suspended, or the log has failed and the run is over.
    while let Some(status) = running.get("/api/v1/status") {
        let now = stopped(&status);
        if status["state"] == "failed" || now == before {
            break;
        }
        before = now;
        assert!(began.elapsed() < PATIENCE, "{status}");
        std::thread::sleep(Duration::from_millis(1500));
    }
    let run = running.kill();
    let kept = images(&run);
    assert!(kept.len() >= acknowledged, "{} of {acknowledged}", kept.len());
    let numbers: Vec<u64> = kept.iter().map(|(shot, _)| *shot).collect();
    assert_eq!(numbers, (0..kept.len() as u64).collect::<Vec<_>>());
}

struct Daemon {
    child: Child,
    log: PathBuf,
}

impl Daemon {
    fn start(root: &Path, config: &Path, shots: &str) -> Self {
        let log = root.join("log");
        let child = Command::new(env!("CARGO_BIN_EXE_lfpiv"))
            .args(["run", "--shots", shots, "--config"])
            .arg(config)
            .stdout(Stdio::null())
            .stderr(fs::File::create(&log).expect("a file"))
            .spawn()
            .expect("the binary starts");
        Self { child, log }
    }

    fn wait_for_the_end(&mut self) {
        let began = Instant::now();
        while self.child.try_wait().expect("its state").is_none() {
            assert!(began.elapsed() < PATIENCE, "{}", self.log());
            std::thread::sleep(Duration::from_millis(20));
        }
    }

    fn log(&self) -> String {
        fs::read_to_string(&self.log).expect("its log")
    }

    fn wait_for(&self, words: &str) {
        let began = Instant::now();
        while !self.log().contains(words) {
            assert!(began.elapsed() < PATIENCE, "{}", self.log());
            std::thread::sleep(Duration::from_millis(20));
        }
    }
}

impl Drop for Daemon {
    fn drop(&mut self) {
        let _ = self.child.kill();
    }
}

#[test]
#[ignore = "the half of a_full_disk_suspends_firing_until_there_is_space that runs in a namespace"]
fn half_of_a_full_disk() {
    let root = tempfile::tempdir().expect("a folder");
    mount_small_disk(&root.path().join("results"), 40);
    let ballast = root.path().join("results/ballast");
    fs::write(&ballast, vec![1; 35 << 20]).expect("room for ballast");
    let config = configuration(root.path(), "[raw_log]\nreserve_mb = 2\nsync_ms = 5\n");
    let mut daemon = Daemon::start(root.path(), &config, "20");
    daemon.wait_for("firing is on hold");
    assert!(daemon.log().contains("free space"), "{}", daemon.log());
    fs::remove_file(&ballast).expect("the ballast");
    daemon.wait_for_the_end();
    let shots = images(&run_in(root.path()));
    assert_eq!(shots.len(), 20, "{}", daemon.log());
}

fn run_in(root: &Path) -> PathBuf {
    let entries = fs::read_dir(root.join("results")).expect("results");
    let mut folders = entries.map(|entry| entry.expect("an entry").path()).filter(|p| p.is_dir());
    folders.next().expect("a run")
}

/// Regression: the HDF5 library crashed at exit after a failed write.
#[test]
#[ignore = "the half of processing_onto_a_full_disk_... that runs in a namespace"]
fn half_of_processing() {
    const DISK: usize = 2 << 20;
    const FREE: usize = 120_000;
    let root = tempfile::tempdir().expect("a folder");
    let config = configuration(root.path(), "");
    let path = |name: &str| root.path().join(name).to_str().expect("UTF-8").to_owned();
    let simulated = lfpiv(&[
        "simulate",
        "--config",
        config.to_str().expect("UTF-8"),
        "--out",
        &path("pairs"),
        "--shots",
        "4",
    ]);
    assert!(simulated.status.success(), "{}", text(&simulated.stderr));
    mount_small_disk(&root.path().join("disk"), 2);
    fs::write(path("disk/ballast"), vec![1; DISK - FREE]).expect("room for ballast");
    let process = |more: &[&str]| {
        let (pairs, out) = (path("pairs"), path("disk/out"));
        let config = config.to_str().expect("UTF-8");
        let fixed = ["process", "--config", config, "--out", &out, &pairs];
        lfpiv(&[&fixed, more].concat())
    };
    let full = process(&[]);
    let said = text(&full.stderr);
    assert_eq!(full.status.code(), Some(1), "{said}");
    assert!(said.contains("the disk is full") && said.contains("--resume"), "{said}");
    assert!(!said.contains("HDF"), "{said}");
    fs::remove_file(path("disk/ballast")).expect("the ballast");
    let resumed = process(&["--resume"]);
    assert!(resumed.status.success(), "{}", text(&resumed.stderr));
    for shot in 0..4 {
        assert!(Path::new(&path(&format!("disk/out/shot_{shot:04}/velocity.nc"))).exists());
    }
}

/// Results that do not fit end the run with an error message; the ledger is written, and earlier
/// results are intact.
#[test]
fn a_run_without_space_for_its_results_reports_it() {
    if let Some(passed) = in_namespace("disk::half_of_results") {
        assert!(passed);
    }
}

#[test]
#[ignore = "the half of a_run_without_space_for_its_results_reports_it that runs in a namespace"]
fn half_of_results() {
    const DISK: usize = 2 << 20;
    const FREE: usize = 180_000;
    let root = tempfile::tempdir().expect("a folder");
    mount_small_disk(&root.path().join("results"), 2);
    let ballast = root.path().join("results/ballast");
    fs::write(&ballast, vec![1; DISK - FREE]).expect("room for ballast");
    let config = configuration(root.path(), "[raw_log]\nkeep = false\nreserve_mb = 0\n");
    let mut daemon = Daemon::start(root.path(), &config, "40");
    daemon.wait_for_the_end();
    let log = daemon.log();
    assert_eq!(daemon.child.wait().expect("its state").code(), Some(1), "{log}");
    assert!(log.contains("the disk is full") && !log.contains("HDF"), "{log}");
    let has_ledger = run_in(root.path()).join("ledger.json").exists();
    assert!(has_ledger || log.contains("ledger.json"), "{log}");
}

/// The size of a frame is known from the configuration before the first frame.
#[test]
#[ignore = "the half of even_the_first_shot_waits_for_room that runs in a namespace"]
fn half_of_the_first_shot() {
    // Two cameras, two exposures, 240 x 240 pixels of two bytes: 0.46 MB per shot. The disk has 0.3
    // MB more than the reserve, part of which the run's small files take.
    const DISK: usize = 24 << 20;
    const FREE: usize = 4_300_000;
    let root = tempfile::tempdir().expect("a folder");
    mount_small_disk(&root.path().join("results"), 24);
    let ballast = root.path().join("results/ballast");
    fs::write(&ballast, vec![1; DISK - FREE]).expect("room for ballast");
    let config = configuration(root.path(), "[raw_log]\nreserve_mb = 4\nsync_ms = 5\n");
    let mut daemon = Daemon::start(root.path(), &config, "1");
    daemon.wait_for("firing is on hold");
    assert!(daemon.log().contains("1 MB of images"), "{}", daemon.log());
    fs::remove_file(&ballast).expect("the ballast");
    daemon.wait_for_the_end();
    assert_eq!(images(&run_in(root.path())).len(), 1, "{}", daemon.log());
}
