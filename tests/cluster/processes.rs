//! Coordinators and workers as processes.

use std::{
    fs::{self, File},
    path::{Path, PathBuf},
    process::{Child, Command, Stdio},
    sync::atomic::{AtomicU32, Ordering},
    time::{Duration, Instant},
};

use crate::bench::PATIENCE;

/// A processor of 2008, without AVX and fused multiply-add; all of it is this machine otherwise.
#[cfg(target_arch = "x86_64")]
pub const EMULATOR: [&str; 3] = ["qemu-x86_64", "-cpu", "Nehalem"];

/// A running `lfpiv` with its output in files.
pub struct Process {
    child: Child,
    stdout: PathBuf,
    stderr: PathBuf,
}

/// How it ended.
#[derive(Debug)]
pub struct Ended {
    pub code: Option<i32>,
    pub stdout: String,
    pub stderr: String,
}

impl Process {
    /// Starts `lfpiv` with these arguments; what it says goes to files in `root`.
    pub fn start(root: &Path, arguments: &[&str]) -> Self {
        Self::run(root, Command::new(env!("CARGO_BIN_EXE_lfpiv")).args(arguments))
    }

    /// The same in the [`EMULATOR`].
    #[cfg(target_arch = "x86_64")]
    pub fn emulated(root: &Path, arguments: &[&str]) -> Self {
        let [program, more @ ..] = EMULATOR;
        let lfpiv = env!("CARGO_BIN_EXE_lfpiv");
        Self::run(root, Command::new(program).args(more).arg(lfpiv).args(arguments))
    }

    fn run(root: &Path, command: &mut Command) -> Self {
        static NUMBER: AtomicU32 = AtomicU32::new(0);
        let number = NUMBER.fetch_add(1, Ordering::Relaxed);
        let [stdout, stderr] =
            ["out", "err"].map(|kind| root.join(format!("process_{number}.{kind}")));
        let file = |path: &Path| File::create(path).expect("a file in the test's folder");
        let child = command
            .env_remove("RUST_LOG")
            .stdin(Stdio::null())
            .stdout(file(&stdout))
            .stderr(file(&stderr))
            .spawn()
            .expect("the binary starts");
        Self { child, stdout, stderr }
    }

    pub fn is_running(&mut self) -> bool {
        self.child.try_wait().expect("a child").is_none()
    }

    /// What it has logged so far.
    pub fn log(&self) -> String {
        fs::read_to_string(&self.stderr).expect("its log")
    }

    /// What it has printed so far.
    pub fn output(&self) -> String {
        fs::read_to_string(&self.stdout).expect("its output")
    }

    pub fn kill(mut self) {
        self.child.kill().expect("a child");
        self.child.wait().expect("its end");
    }

    /// Asks it to stop, and waits for its end.
    pub fn terminate(self) -> Ended {
        self.signal("TERM");
        self.wait()
    }

    /// Sends a signal to it.
    pub fn signal(&self, name: &str) {
        let kill = format!("kill -{name} {}", self.child.id());
        assert!(Command::new("sh").args(["-c", &kill]).status().expect("sh").success());
    }

    /// Waits for its end.
    pub fn wait(mut self) -> Ended {
        let began = Instant::now();
        while self.is_running() {
            assert!(began.elapsed() < PATIENCE, "it goes on: {}", self.log());
            std::thread::sleep(Duration::from_millis(5));
        }
        let status = self.child.wait().expect("its end");
        let stdout = fs::read_to_string(&self.stdout).expect("its output");
        let ended = Ended { code: status.code(), stdout, stderr: self.log() };
        assert!(!ended.stderr.contains("panicked"), "{ended:?}");
        ended
    }
}

/// A failing test leaves no process behind.
impl Drop for Process {
    fn drop(&mut self) {
        let _ = self.child.kill();
        let _ = self.child.wait();
    }
}

pub fn path(path: &Path) -> &str {
    path.to_str().expect("a path in UTF-8")
}

/// `lfpiv process RUN --cluster URL`, with further arguments.
pub fn coordinator(root: &Path, run: &Path, url: &str, more: &[&str]) -> Process {
    let arguments = [&["process", path(run), "--cluster", url], more].concat();
    Process::start(root, &arguments)
}

/// `lfpiv work --url URL --name NAME`, with further arguments.
pub fn worker(root: &Path, url: &str, name: &str, more: &[&str]) -> Process {
    let arguments = [&["work", "--url", url, "--name", name], more].concat();
    Process::start(root, &arguments)
}

/// Waits until something holds.
pub fn wait_until(what: &str, mut holds: impl FnMut() -> bool) {
    let began = Instant::now();
    while !holds() {
        assert!(began.elapsed() < PATIENCE, "{what}");
        std::thread::sleep(Duration::from_millis(5));
    }
}
