//! `lfpiv run` through the real binary: signals, exit codes, messages.

use std::{
    fs,
    io::{BufRead, BufReader},
    path::Path,
    process::{Child, Command, Stdio},
    time::{Duration, Instant},
};

use serde_json::Value;

use crate::support::{changed_configuration, lfpiv};

/// Only a hang takes this long.
const PATIENCE: Duration = Duration::from_secs(900);

/// `lfpiv run` without end, after it has printed its status address.
struct Running {
    child: Child,
    status_url: String,
    results: String,
}

impl Running {
    fn start(root: &Path) -> Self {
        let results = format!("dir = \"{}\"", root.join("results").display());
        let config = changed_configuration(root, "dir = \"results\"", &results);
        let mut child = Command::new(env!("CARGO_BIN_EXE_lfpiv"))
            .args(["run", "--config"])
            .arg(config)
            .stdout(Stdio::piped())
            .stderr(Stdio::null())
            .spawn()
            .expect("the binary starts");
        let mut lines = BufReader::new(child.stdout.take().expect("a pipe")).lines();
        let mut value_of = |name: &str| {
            let line = lines.next().expect("a line").expect("text");
            line.strip_prefix(name).unwrap_or_else(|| panic!("{line}")).trim().to_owned()
        };
        let (status_url, results) = (value_of("status:"), value_of("results:"));
        Self { child, status_url, results }
    }

    fn status(&self) -> Value {
        let mut response = ureq::get(&self.status_url).call().expect("an answer");
        response.body_mut().read_json().expect("JSON")
    }

    /// Waits until a shot has left the pool.
    fn wait_for_a_shot(&self) {
        let began = Instant::now();
        loop {
            let shots = &self.status()["shots"];
            if shots["done"].as_u64().unwrap_or(0) + shots["failed"].as_u64().unwrap_or(0) > 0 {
                return;
            }
            assert!(began.elapsed() < PATIENCE, "{shots}");
            std::thread::sleep(Duration::from_millis(50));
        }
    }

    fn signal(&self, name: &str) {
        let kill = format!("kill -{name} {}", self.child.id());
        assert!(Command::new("sh").args(["-c", &kill]).status().expect("sh").success());
    }

    /// The exit code.
    fn wait(&mut self) -> Option<i32> {
        let began = Instant::now();
        loop {
            if let Some(status) = self.child.try_wait().expect("a child") {
                return status.code();
            }
            assert!(began.elapsed() < PATIENCE, "it does not end");
            std::thread::sleep(Duration::from_millis(50));
        }
    }
}

impl Drop for Running {
    fn drop(&mut self) {
        // It has ended unless the test failed.
        let _ = self.child.kill();
        let _ = self.child.wait();
    }
}

fn stops_cleanly_on(signal: &str) {
    let root = tempfile::tempdir().expect("a folder");
    let mut running = Running::start(root.path());
    running.wait_for_a_shot();
    running.signal(signal);
    assert_eq!(running.wait(), Some(0));
    let results = Path::new(&running.results);
    let text = fs::read(results.join("ledger.json")).expect("the ledger");
    let ledger: Value = serde_json::from_slice(&text).expect("JSON");
    assert_eq!((&ledger["balanced"], &ledger["error"]), (&true.into(), &Value::Null));
    for camera in ledger["cameras"].as_array().expect("accounts") {
        assert_eq!(camera["open"], 0);
        assert!(camera["triggers"].as_u64().expect("a number") > 0);
    }
    let unsealed = fs::read_dir(results).expect("the results").filter(|entry| {
        let entry = entry.as_ref().expect("an entry");
        entry.path().extension().is_some_and(|extension| extension == "part")
    });
    assert_eq!(unsealed.count(), 0);
}

/// The complete chain without replacements: rendered, reconstructed, correlated, written,
/// tabulated.
#[test]
fn a_bounded_run_measures_the_simulated_flow() {
    let root = tempfile::tempdir().expect("a folder");
    let results = format!("dir = \"{}\"", root.path().join("results").display());
    let config = changed_configuration(root.path(), "dir = \"results\"", &results);
    let done = lfpiv([
        "run".as_ref(),
        "--config".as_ref(),
        config.as_os_str(),
        "--shots".as_ref(),
        "3".as_ref(),
    ]);
    assert!(done.success, "{}{}", done.stdout, done.stderr);
    let rows: Vec<Vec<&str>> = done
        .stdout
        .lines()
        .map(|line| line.split_whitespace().collect::<Vec<_>>())
        .filter(|words| words.get(3) == Some(&"%"))
        .collect();
    assert_eq!(rows.len(), 3, "{}", done.stdout);
    for (shot, row) in rows.iter().enumerate() {
        assert_eq!(row[0], shot.to_string());
        let number = |column: usize| row[column].parse::<f64>().expect("a number");
        assert!(number(1) > 0.0 && number(2) > 50.0, "vectors and valid share: {row:?}");
        assert!((4..7).all(|column| number(column) < 0.3), "errors: {row:?}");
    }
    // Without a progress bar a line is printed for every shot.
    for shot in 0..3 {
        let told = |line: &str| line.starts_with(&format!("shot {shot}: ")) && line.contains(" s");
        assert!(done.stdout.lines().any(told), "{}", done.stdout);
    }
    let folder = done.stdout.lines().find_map(|line| line.strip_prefix("results are in "));
    let folder = Path::new(folder.expect("where the results are"));
    for name in ["velocity_000000.nc", "velocity.vti.series", "shot_000002.vti", "ledger.json"] {
        assert!(folder.join(name).exists(), "{name}");
    }
}

#[test]
fn sigterm_ends_a_run_cleanly() {
    stops_cleanly_on("TERM");
}

#[test]
fn ctrl_c_ends_a_run_cleanly() {
    stops_cleanly_on("INT");
}

#[test]
fn without_a_simulation_hardware_is_missing() {
    let root = tempfile::tempdir().expect("a folder");
    let text = fs::read_to_string(crate::support::small_configuration()).expect("small.toml");
    let (bench, _) = text.split_once("[simulation]").expect("a simulation");
    let config = root.path().join("bench.toml");
    fs::write(&config, bench).expect("a file");
    let done = lfpiv(["run".as_ref(), "--config".as_ref(), config.as_os_str()]);
    assert!(!done.success);
    assert!(done.stderr.contains("no [simulation] table"), "{}", done.stderr);
}

#[test]
fn a_schedule_beyond_the_limits_of_the_laser_is_refused() {
    let root = tempfile::tempdir().expect("a folder");
    let config = changed_configuration(root.path(), "rate_hz = 10.0", "rate_hz = 15.0");
    let done = lfpiv(["run".as_ref(), "--config".as_ref(), config.as_os_str()]);
    assert!(!done.success);
    let said = "shot.rate_hz = 15.0: laser rate = 15 Hz: allowed: at most 10 Hz";
    assert!(done.stderr.contains(said), "{}", done.stderr);
    assert!(!root.path().join("results").exists());
}

#[test]
fn zero_shots_are_refused_as_a_wrong_command_line() {
    let done = lfpiv(["run", "--config", "any.toml", "--shots", "0"]);
    assert!(!done.success && done.stderr.contains("--shots"), "{}", done.stderr);
}
