//! `lfpiv doctor` through the real binary: folders that cannot be written, missing or forbidden
//! ports, an address in use.

use std::{
    fs,
    io::{BufRead, BufReader},
    os::{fd::OwnedFd, unix::fs::PermissionsExt},
    path::{Path, PathBuf},
    process::{Child, Command, Stdio},
};

use rustix::pty::{OpenptFlags, grantpt, openpt, ptsname, unlockpt};
use serde_json::Value;

use crate::support::{changed_configuration, lfpiv, shipped};

/// A pseudo-terminal that exists as long as this value.
struct Terminal {
    _controller: OwnedFd,
    path: PathBuf,
}

impl Terminal {
    fn open() -> Self {
        let controller = openpt(OpenptFlags::RDWR | OpenptFlags::NOCTTY).expect("a terminal");
        grantpt(&controller).expect("granted");
        unlockpt(&controller).expect("unlocked");
        let name = ptsname(&controller, Vec::new()).expect("a name");
        Self { _controller: controller, path: PathBuf::from(name.to_str().expect("text")) }
    }
}

/// Output of a command that ran the doctor.
struct Examined {
    code: Option<i32>,
    report: Value,
    stderr: String,
}

impl Examined {
    /// Runs `lfpiv doctor` through a prefix command such as `setpriv` or `unshare`.
    fn by(prefix: &[&str], config: &Path) -> Self {
        let binary = env!("CARGO_BIN_EXE_lfpiv");
        let config = config.to_str().expect("text");
        let words = [prefix, &[binary, "doctor", "--json", "--config", config]].concat();
        let output = Command::new(words[0]).args(&words[1..]).output().expect("it starts");
        let stderr = String::from_utf8_lossy(&output.stderr).into_owned();
        let report = serde_json::from_slice(&output.stdout).unwrap_or_else(|_| panic!("{stderr}"));
        Self { code: output.status.code(), report, stderr }
    }

    fn of(config: &Path) -> Self {
        Self::by(&[], config)
    }

    /// Verdict, finding and advice of a check.
    fn check(&self, name: &str) -> (&str, &str, &str) {
        let checks = self.report["checks"].as_array().expect("checks");
        let found = checks.iter().find(|check| check["check"] == name);
        let found = found.unwrap_or_else(|| panic!("{name} is not in {}", self.report));
        let text = |key: &str| found[key].as_str().unwrap_or("");
        (text("verdict"), text("found"), text("advice"))
    }
}

/// The small bench, with its results in `output`, at one shot per second.
fn bench_writing_to(folder: &Path, output: &Path) -> PathBuf {
    let changed = changed_configuration(folder, "dir = \"results\"", &format!("dir = {output:?}"));
    let text = fs::read_to_string(&changed).expect("the configuration");
    fs::write(&changed, text.replace("rate_hz = 10.0", "rate_hz = 1.0")).expect("written");
    changed
}

/// The loopback bench with this serial port.
fn bench_at_port(folder: &Path, port: &Path) -> PathBuf {
    let text = shipped("loopback");
    let changed = text
        .replace("\"results/loopback/synchroniser\"", &format!("{port:?}"))
        .replace("127.0.0.1:8641", "127.0.0.1:0")
        .replace("dir = \"results\"", &format!("dir = {folder:?}"));
    assert!(changed.contains(port.to_str().expect("text")));
    let path = folder.join("bench.toml");
    fs::write(&path, changed).expect("written");
    path
}

/// Prefix for a command that is to see a small tmpfs at `place`, mounted with `options`; `None`,
/// with a message, if this machine does not allow it.
fn with_tmpfs(place: &Path, options: &str) -> Option<Vec<String>> {
    let mount = format!("mount -t tmpfs -o {options} tmpfs {place:?} && exec \"$@\"");
    let words = |flags: &str| ["unshare", flags, "sh", "-c", &mount, "sh"].map(str::to_owned);
    let works = |words: &[String; 6]| {
        let tried = Command::new(&words[0]).args(&words[1..]).arg("true").output();
        tried.is_ok_and(|output| output.status.success())
    };
    let allowed = ["-rm", "-m"].map(words).into_iter().find(works);
    if allowed.is_none() {
        eprintln!("SKIPPED: no mount namespace can be made here (unshare -rm)");
    }
    allowed.map(Vec::from)
}

fn borrowed(words: &[String]) -> Vec<&str> {
    words.iter().map(String::as_str).collect()
}

#[test]
fn a_fit_machine_passes_with_measured_values() {
    let root = tempfile::tempdir().expect("a folder");
    let config = bench_writing_to(root.path(), &root.path().join("not/yet"));
    let examined = Examined::of(&config);
    assert_eq!(examined.code, Some(0), "{}{}", examined.report, examined.stderr);
    for check in ["output folder", "free space", "processor", "memory", "clock", "address"] {
        assert_ne!(examined.check(check).0, "problem", "{}", examined.report);
    }
    let checks = examined.report["checks"].as_array().expect("checks");
    let speed = checks.iter().find(|check| check["check"] == "writing speed").expect("measured");
    let value = |name: &str| speed["values"][name].as_f64().expect("a number");
    assert!(value("write_mb_per_s") > 1.0);
    // 2 cameras x 2 frames x 748 x 748 pixels x 1.5 bytes, once a second.
    assert!((value("needed_mb_per_s") - 3.357).abs() < 0.001, "{speed}");
    let left: Vec<_> = fs::read_dir(root.path()).expect("the folder").collect();
    assert_eq!(left.len(), 1, "only the configuration is left: {left:?}");
}

#[test]
fn the_report_has_a_line_per_check_and_needs_no_configuration() {
    let done = lfpiv(["doctor"]);
    assert!(
        done.stdout.contains("writing speed") && done.stdout.contains("cores"),
        "{}",
        done.stdout
    );
    let last = done.stdout.lines().last().expect("a line");
    assert!(last.contains("checks: ") && last.contains(" ok, "), "{last}");
}

#[test]
fn a_folder_that_cannot_be_written_is_a_problem() {
    let root = tempfile::tempdir().expect("a folder");
    let results = root.path().join("results");
    fs::create_dir(&results).expect("a folder");
    let config = bench_writing_to(root.path(), &results);
    let Some(prefix) = with_tmpfs(&results, "size=64m,ro") else { return };
    let examined = Examined::by(&borrowed(&prefix), &config);
    assert_eq!(examined.code, Some(1), "{}", examined.report);
    assert!(examined.stderr.contains("found; a run would fail"), "{}", examined.stderr);
    let (verdict, found, advice) = examined.check("output folder");
    assert_eq!(verdict, "problem", "{found}");
    assert!(found.contains("Read-only file system") && advice.contains("remount,rw"), "{found}");
}

#[test]
fn a_disk_that_will_soon_be_full_is_a_problem() {
    let root = tempfile::tempdir().expect("a folder");
    let results = root.path().join("results");
    fs::create_dir(&results).expect("a folder");
    let config = bench_writing_to(root.path(), &results);
    let Some(prefix) = with_tmpfs(&results, "size=64m") else { return };
    let examined = Examined::by(&borrowed(&prefix), &config);
    assert_eq!(examined.code, Some(1), "{}", examined.report);
    assert_eq!(examined.check("output folder").0, "ok");
    assert!(examined.check("writing speed").1.contains("16 MB written and synced"));
    let (verdict, found, advice) = examined.check("free space");
    assert_eq!(verdict, "problem", "{found}");
    assert!(found.starts_with("0.1 GB") && advice.contains("remove old runs"), "{found}");
}

#[test]
fn a_serial_port_that_is_missing_is_a_problem() {
    let root = tempfile::tempdir().expect("a folder");
    let examined = Examined::of(&bench_at_port(root.path(), &root.path().join("ttyUSB0")));
    assert_eq!(examined.code, Some(1));
    let (verdict, found, advice) = examined.check("serial port");
    assert_eq!(verdict, "problem");
    assert!(found.contains("ttyUSB0") && advice.contains("/dev/serial/by-id"), "{found}");
    assert_eq!(examined.check("packet size").0, "ok", "the loopback takes packets of 16000 bytes");
}

#[test]
fn a_terminal_is_a_port_for_users_with_access() {
    let root = tempfile::tempdir().expect("a folder");
    let terminal = Terminal::open();
    let config = bench_at_port(root.path(), &terminal.path);
    assert_eq!(Examined::of(&config).check("serial port").0, "ok");

    // Root may do anything, so the doctor is run as another user.
    fs::set_permissions(&terminal.path, fs::Permissions::from_mode(0o000)).expect("its owner");
    fs::set_permissions(root.path(), fs::Permissions::from_mode(0o755)).expect("its owner");
    let nobody = ["setpriv", "--reuid=65534", "--regid=65534", "--clear-groups"];
    let prefix: &[&str] = if rustix::process::geteuid().is_root() { &nobody } else { &[] };
    let reachable = prefix.is_empty()
        || Command::new(nobody[0])
            .args([&nobody[1..], &[env!("CARGO_BIN_EXE_lfpiv"), "--version"]].concat())
            .output()
            .is_ok_and(|output| output.status.success());
    if !reachable {
        eprintln!("SKIPPED: nobody else may run the binary here (setpriv)");
        return;
    }
    let examined = Examined::by(prefix, &config);
    assert_eq!(examined.code, Some(1));
    let (verdict, found, advice) = examined.check("serial port");
    assert_eq!(verdict, "problem", "{found}");
    assert!(found.contains("Permission denied") && advice.contains("adduser"), "{found} {advice}");
}

/// `lfpiv run` without end; killed on drop.
struct Run(Child);

impl Drop for Run {
    fn drop(&mut self) {
        // It may have ended by itself if the test failed.
        let _ = self.0.kill();
        let _ = self.0.wait();
    }
}

#[test]
fn a_running_daemon_is_recognised() {
    let root = tempfile::tempdir().expect("a folder");
    let config = bench_writing_to(root.path(), &root.path().join("results"));
    let mut command = Command::new(env!("CARGO_BIN_EXE_lfpiv"));
    command.args(["run", "--config"]).arg(&config);
    let child = command.stdout(Stdio::piped()).stderr(Stdio::null()).spawn().expect("it starts");
    let mut run = Run(child);
    let mut lines = BufReader::new(run.0.stdout.take().expect("a pipe")).lines();
    let status = lines.next().expect("a line").expect("text");
    let address = status.split('/').nth(2).expect("an address");
    let text = fs::read_to_string(&config).expect("the configuration");
    fs::write(&config, text.replace("127.0.0.1:0", address)).expect("written");
    let examined = Examined::of(&config);
    let (verdict, found, _) = examined.check("address");
    assert_eq!(verdict, "advice", "{found}");
    assert!(found.contains("another lfpiv runs"), "{found}");
}
