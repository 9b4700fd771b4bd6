//! A bench so small that a shot takes some milliseconds, run by the real binary.

use std::{
    collections::BTreeSet,
    fs,
    io::{BufRead, BufReader},
    path::{Path, PathBuf},
    process::{Child, Command, Output, Stdio},
    time::{Duration, Instant},
};

use lfpiv::acquisition::journal::RecordedRun;
use lfpiv_hw::RawImage;
use serde_json::Value;

/// Timeout of every wait: only a hang takes this long.
pub const PATIENCE: Duration = Duration::from_secs(900);

/// Writes a configuration with results below `root`, with `more` appended.
pub fn configuration(root: &Path, more: &str) -> PathBuf {
    let small = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/data/small.toml");
    let mut text = fs::read_to_string(small).expect("small.toml");
    let results = format!("dir = \"{}\"", root.join("results").display());
    for (from, to) in [
        ("columns = 41\nrows = 41", "columns = 13\nrows = 13"),
        ("columns = 748\nrows = 748", "columns = 240\nrows = 240"),
        ("voxels = [24, 20, 16]", "voxels = [8, 8, 8]"),
        ("dir = \"results\"", results.as_str()),
    ] {
        assert!(text.contains(from), "{from}");
        text = text.replacen(from, to, 1);
    }
    let path = root.join("bench.toml");
    fs::write(&path, format!("{text}\n{more}")).expect("a file in the test's folder");
    path
}

/// Runs the program to its end. After [`PATIENCE`] it is sent SIGTERM, so that it reports what it
/// was waiting for.
pub fn lfpiv(arguments: &[&str]) -> Output {
    Command::new("timeout")
        .args(["--kill-after=30", &PATIENCE.as_secs().to_string(), env!("CARGO_BIN_EXE_lfpiv")])
        .args(arguments)
        .env_remove("RUST_LOG")
        .output()
        .expect("the binary starts")
}

pub fn text(bytes: &[u8]) -> String {
    String::from_utf8_lossy(bytes).into_owned()
}

/// Runs `shots` shots to the end; returns the run's folder.
pub fn finished_run(config: &Path, shots: &str) -> PathBuf {
    let config = config.to_str().expect("a path in UTF-8");
    let output = lfpiv(&["run", "--config", config, "--shots", shots]);
    assert!(output.status.success(), "{}", text(&output.stderr));
    let stdout = text(&output.stdout);
    let folder = stdout.lines().find_map(|line| line.strip_prefix("results: "));
    PathBuf::from(folder.expect("a line with the folder").trim())
}

/// A running `lfpiv run`.
pub struct Running {
    pub child: Child,
    pub address: String,
    pub folder: PathBuf,
    token: Option<&'static str>,
}

impl Running {
    pub fn start(config: &Path, arguments: &[&str]) -> Self {
        Self::logged(config, arguments, Stdio::null())
    }

    /// The same, with its log redirected.
    pub fn logged(config: &Path, arguments: &[&str], log: impl Into<Stdio>) -> Self {
        let mut command = Command::new(env!("CARGO_BIN_EXE_lfpiv"));
        command.args(["run", "--config"]).arg(config).args(arguments);
        Self::of(command, log.into())
    }

    /// The same, with a hard limit of open files.
    pub fn limited(config: &Path, open_files: u64, log: impl Into<Stdio>) -> Self {
        let mut command = Command::new("sh");
        let limited = format!("ulimit -n {open_files}; exec \"$0\" \"$@\"");
        command.args(["-c", &limited, env!("CARGO_BIN_EXE_lfpiv"), "run", "--config"]).arg(config);
        Self::of(command, log.into())
    }

    fn of(mut command: Command, log: Stdio) -> Self {
        let mut child =
            command.stdout(Stdio::piped()).stderr(log).spawn().expect("the binary starts");
        let mut lines = BufReader::new(child.stdout.take().expect("a pipe")).lines();
        let mut value_of = |name: &str| {
            let line = lines.next().expect("a line").expect("text");
            line.strip_prefix(name).unwrap_or_else(|| panic!("{line}")).trim().to_owned()
        };
        let address = value_of("status:").trim_end_matches("/api/v1/status").to_owned();
        let folder = PathBuf::from(value_of("results:"));
        Self { child, address, folder, token: None }
    }

    /// Uses this token from now on.
    pub fn with_token(mut self, token: &'static str) -> Self {
        self.token = Some(token);
        self
    }

    /// The answer, if there is one: the daemon may be exiting.
    pub fn get(&self, path: &str) -> Option<Value> {
        let agent = ureq::Agent::config_builder().timeout_global(Some(PATIENCE)).build();
        let agent: ureq::Agent = agent.into();
        let mut request = agent.get(&format!("{}{path}", self.address));
        if let Some(token) = self.token {
            request = request.header("Authorization", &format!("Bearer {token}"));
        }
        request.call().ok()?.body_mut().read_json().ok()
    }

    /// Shots reported as synced, polled until `end`.
    pub fn acknowledged_until(&self, end: Instant) -> BTreeSet<u64> {
        let mut synced = BTreeSet::new();
        while Instant::now() < end {
            let Some(list) = self.get("/api/v1/shots?limit=1000") else { continue };
            let shots = list["shots"].as_array().expect("a list");
            let safe = shots.iter().filter(|shot| shot["raw"] == "synced");
            synced.extend(safe.filter_map(|shot| shot["shot"].as_u64()));
            std::thread::sleep(Duration::from_millis(3));
        }
        synced
    }

    /// Waits until the status satisfies `reached`.
    pub fn wait_until(&self, reached: impl Fn(&Value) -> bool) -> Value {
        let began = Instant::now();
        loop {
            if let Some(status) = self.get("/api/v1/status").filter(|status| reached(status)) {
                return status;
            }
            assert!(began.elapsed() < PATIENCE, "{:?}", self.get("/api/v1/status"));
            std::thread::sleep(Duration::from_millis(10));
        }
    }

    pub fn kill(mut self) -> PathBuf {
        self.child.kill().expect("a running daemon");
        self.child.wait().expect("its end");
        self.folder.clone()
    }

    /// Asks it to stop, and waits for its end.
    pub fn terminate(mut self) -> PathBuf {
        let terminate = format!("kill -TERM {}", self.child.id());
        assert!(Command::new("sh").args(["-c", &terminate]).status().expect("sh").success());
        assert!(self.child.wait().expect("its end").success());
        self.folder.clone()
    }
}

/// A failing test leaves no daemon behind.
impl Drop for Running {
    fn drop(&mut self) {
        let _ = self.child.kill();
        let _ = self.child.wait();
    }
}

/// The four images of each shot of a recorded run, in the order of the shots.
pub fn images(run: &Path) -> Vec<(u64, Vec<[RawImage; 2]>)> {
    let recorded = RecordedRun::open(run).expect("a recorded run");
    let index = recorded.index();
    assert_eq!(index.damaged, Vec::<String>::new());
    let pair = |shot| recorded.pair(shot).expect("a whole shot").cameras;
    index.shots.values().map(|shot| (shot.trigger, pair(shot))).collect()
}
