//! The daemon as a service: its messages to systemd, through a socket that replaces the manager's;
//! its output for journald; and the unit file.

use std::{
    fs::{self, File},
    os::unix::{fs::MetadataExt, net::UnixDatagram},
    path::Path,
    process::{Child, Command, Stdio},
    time::{Duration, Instant},
};

use crate::support::changed_configuration;

/// Only a hang takes this long.
const PATIENCE: Duration = Duration::from_secs(900);
/// The daemon's watchdog limit.
const WATCHDOG: Duration = Duration::from_secs(4);

/// `lfpiv run` without end, with a listening service manager.
struct Service {
    child: Child,
    manager: UnixDatagram,
    /// The messages sent, with their times.
    told: Vec<(Instant, String)>,
}

impl Service {
    fn start(root: &Path) -> Self {
        let socket = root.join("notify");
        let manager = UnixDatagram::bind(&socket).expect("a socket");
        manager.set_read_timeout(Some(Duration::from_millis(100))).expect("a timeout");
        let results = format!("dir = {:?}", root.join("results"));
        let config = changed_configuration(root, "dir = \"results\"", &results);
        let child = Command::new(env!("CARGO_BIN_EXE_lfpiv"))
            .args(["run", "--config"])
            .arg(config)
            .env("NOTIFY_SOCKET", &socket)
            .env("WATCHDOG_USEC", WATCHDOG.as_micros().to_string())
            .env_remove("WATCHDOG_PID")
            .stdout(Stdio::null())
            .stderr(Stdio::null())
            .spawn()
            .expect("the binary starts");
        Self { child, manager, told: Vec::new() }
    }

    /// Listens until `enough` returns true for the messages so far.
    fn listen(&mut self, enough: impl Fn(&[(Instant, String)]) -> bool) {
        let began = Instant::now();
        let mut datagram = [0; 4096];
        while !enough(&self.told) {
            assert!(began.elapsed() < PATIENCE, "{:?}", self.told);
            if let Ok(length) = self.manager.recv(&mut datagram) {
                let text = String::from_utf8_lossy(&datagram[..length]);
                let now = Instant::now();
                self.told.extend(text.lines().map(|line| (now, line.to_owned())));
            }
        }
    }

    fn times_of(&self, what: &str) -> Vec<Instant> {
        self.told.iter().filter(|(_, line)| line == what).map(|(at, _)| *at).collect()
    }

    fn terminate(&self) {
        let kill = format!("kill -TERM {}", self.child.id());
        assert!(Command::new("sh").args(["-c", &kill]).status().expect("sh").success());
    }
}

impl Drop for Service {
    fn drop(&mut self) {
        // It has ended unless the test failed.
        let _ = self.child.kill();
        let _ = self.child.wait();
    }
}

fn count(told: &[(Instant, String)], what: &str) -> usize {
    told.iter().filter(|(_, line)| line == what).count()
}

#[test]
fn systemd_gets_ready_watchdog_and_stopping_messages() {
    let root = tempfile::tempdir().expect("a folder");
    let mut service = Service::start(root.path());
    service.listen(|told| count(told, "READY=1") > 0);
    let before = service.told.len();
    service.listen(|told| {
        let measured =
            |line: &str| line.starts_with("STATUS=taking shots") && !line.contains(" 0 shots");
        count(told, "WATCHDOG=1") >= 4 && told[before..].iter().any(|(_, line)| measured(line))
    });
    let fed = service.times_of("WATCHDOG=1");
    let gaps = fed.windows(2).map(|pair| pair[1] - pair[0]);
    assert!(gaps.max() < Some(WATCHDOG), "fed in time");
    service.terminate();
    service.listen(|told| count(told, "STOPPING=1") > 0);
    assert_eq!(service.child.wait().expect("a child").code(), Some(0));
    service.listen(|_| true);
    let told: Vec<&str> = service.told.iter().map(|(_, line)| line.as_str()).collect();
    assert_eq!(service.times_of("READY=1").len(), 1, "{told:?}");
    let starting = told.iter().position(|line| line.starts_with("STATUS=preparing"));
    let ready = told.iter().position(|line| *line == "READY=1");
    assert!(starting < ready && starting.is_some(), "{told:?}");
}

#[test]
fn lines_for_journald_have_priorities_but_no_colour_or_time() {
    let root = tempfile::tempdir().expect("a folder");
    let log = root.path().join("log");
    let file = File::create(&log).expect("a file");
    let stream = file.metadata().expect("its identity");
    let results = format!("dir = {:?}", root.path().join("results"));
    let config = changed_configuration(root.path(), "dir = \"results\"", &results);
    let run = |stream: String, stderr: File| {
        let mut command = Command::new(env!("CARGO_BIN_EXE_lfpiv"));
        command.args(["run", "--shots", "1", "--config"]).arg(&config);
        command.env("JOURNAL_STREAM", stream).env("RUST_LOG", "debug");
        command.stdout(Stdio::null()).stderr(stderr).status().expect("it runs").success()
    };
    assert!(run(format!("{}:{}", stream.dev(), stream.ino()), file));
    let text = fs::read_to_string(&log).expect("the log");
    assert!(text.contains("waits for triggers"), "{text}");
    for line in text.lines() {
        assert!(["<3>", "<4>", "<6>", "<7>"].contains(&line.get(..3).unwrap_or("")), "{line}");
        assert!(!line.contains('\u{1b}') && !has_time(line), "{line}");
    }
    // The variable is inherited, but standard error is not the journal.
    let other = File::create(&log).expect("a file");
    assert!(run("1:1".into(), other));
    let text = fs::read_to_string(&log).expect("the log");
    assert!(!text.starts_with('<') && text.lines().any(has_time), "{text}");
}

/// Whether a line contains a time of day, such as 12:34:56.
fn has_time(line: &str) -> bool {
    let digits = |text: &str| text.bytes().all(|byte| byte.is_ascii_digit());
    line.match_indices(':').any(|(at, _)| {
        let (before, after) =
            (at.checked_sub(2).and_then(|from| line.get(from..at)), line.get(at + 1..at + 3));
        let colon = line.as_bytes().get(at + 3) == Some(&b':');
        colon && before.is_some_and(digits) && after.is_some_and(digits)
    })
}

/// The shipped unit with the built binary.
#[test]
fn systemd_accepts_the_unit() {
    let unit = Path::new(env!("CARGO_MANIFEST_DIR")).join("packaging/lfpiv.service");
    let text = fs::read_to_string(unit).expect("the unit");
    assert!(text.contains("/usr/local/bin/lfpiv run"), "{text}");
    let root = tempfile::tempdir().expect("a folder");
    let copy = root.path().join("lfpiv.service");
    let text = text.replace("/usr/local/bin/lfpiv", env!("CARGO_BIN_EXE_lfpiv"));
    fs::write(&copy, &text).expect("written");
    let verify = |path: &Path| Command::new("systemd-analyze").arg("verify").arg(path).output();
    let Ok(verified) = verify(&copy) else {
        eprintln!("SKIPPED: systemd-analyze is not here");
        return;
    };
    let said = String::from_utf8_lossy(&verified.stderr);
    assert!(verified.status.success() && !said.contains("lfpiv.service"), "{said}");
    // systemd would have reported a wrong line.
    fs::write(&copy, text.replace("WatchdogSec=60", "WatchdogSec=soon")).expect("written");
    let said = verify(&copy).expect("it ran before").stderr;
    assert!(String::from_utf8_lossy(&said).contains("lfpiv.service"));
}
