//! Runs a process to its end, with a time limit.

use std::{
    fs::{self, File},
    io::{Read, Seek},
    os::unix::process::ExitStatusExt,
    path::Path,
    process::{Child, Command, ExitStatus, Stdio},
    time::{Duration, Instant},
};

/// Only a hang takes this long.
const PATIENCE: Duration = Duration::from_secs(900);

/// Number of characters of the output's end in reports.
const LAST_WORDS: usize = 600;

/// How a process ended.
pub struct Ended {
    /// Its exit code, unless a signal ended it.
    pub code: Option<i32>,
    /// The signal that ended it, if it was not ours.
    pub signal: Option<i32>,
    /// It was killed at the time limit.
    pub has_hung: bool,
    /// Standard output.
    pub stdout: String,
    /// Standard error.
    pub stderr: String,
    /// Peak memory.
    pub peak_bytes: u64,
}

impl Ended {
    /// Runs `lfpiv` with these arguments.
    pub fn of(arguments: &[&str]) -> Self {
        let (stdout, stderr) = (temporary(), temporary());
        let mut child = Command::new(env!("CARGO_BIN_EXE_lfpiv"))
            .args(arguments)
            .env_remove("RUST_LOG")
            .stdin(Stdio::null())
            .stdout(stdout.try_clone().expect("a file"))
            .stderr(stderr.try_clone().expect("a file"))
            .spawn()
            .expect("the binary starts");
        let waited = wait(&mut child, ended_with_memory);
        Self { stdout: text(stdout), ..waited.with_log(text(stderr)) }
    }

    /// Waits for a daemon that was told to exit and logs to a file.
    pub fn of_daemon(daemon: &mut Child, log: &Path) -> Self {
        let ended = |daemon: &mut Child| {
            let status = daemon.try_wait().expect("a child")?;
            Some(Waited { status: Some(status), peak_bytes: 0 })
        };
        wait(daemon, ended).with_log(fs::read_to_string(log).unwrap_or_default())
    }

    /// The end of its log.
    pub fn last_words(&self) -> &str {
        let from = self.stderr.len().saturating_sub(LAST_WORDS);
        let from = (from..).find(|at| self.stderr.is_char_boundary(*at)).unwrap_or(0);
        &self.stderr[from..]
    }
}

fn temporary() -> File {
    tempfile::tempfile().expect("a temporary file")
}

fn text(mut file: File) -> String {
    let mut bytes = Vec::new();
    file.rewind().and_then(|()| file.read_to_end(&mut bytes)).expect("its output");
    String::from_utf8_lossy(&bytes).into_owned()
}

struct Waited {
    status: Option<ExitStatus>,
    peak_bytes: u64,
}

impl Waited {
    fn with_log(self, stderr: String) -> Ended {
        Ended {
            code: self.status.and_then(|status| status.code()),
            signal: self.status.and_then(|status| status.signal()),
            has_hung: self.status.is_none(),
            stdout: String::new(),
            stderr,
            peak_bytes: self.peak_bytes,
        }
    }
}

/// Waits for a child, and kills it at the time limit.
fn wait(child: &mut Child, ended: impl Fn(&mut Child) -> Option<Waited>) -> Waited {
    let began = Instant::now();
    let mut pause = Duration::from_millis(1);
    loop {
        if let Some(waited) = ended(child) {
            return waited;
        }
        if began.elapsed() > PATIENCE {
            let _ = child.kill();
            let _ = child.wait();
            return Waited { status: None, peak_bytes: 0 };
        }
        std::thread::sleep(pause);
        pause = (2 * pause).min(Duration::from_millis(20));
    }
}

/// Exit status and memory of a child, which the standard library does not provide. The child must
/// not be waited for again.
#[expect(unsafe_code)]
fn ended_with_memory(child: &mut Child) -> Option<Waited> {
    let process = child.id() as libc::pid_t;
    let mut status = 0;
    // SAFETY: all zeros are a valid value of this structure of numbers.
    let mut usage: libc::rusage = unsafe { std::mem::zeroed() };
    // SAFETY: both pointers are to values that live through the call, and the process is our child,
    // which nobody else waits for.
    let ended = unsafe { libc::wait4(process, &mut status, libc::WNOHANG, &mut usage) };
    (ended == process).then(|| Waited {
        status: Some(ExitStatus::from_raw(status)),
        peak_bytes: (usage.ru_maxrss as u64) << 10,
    })
}
