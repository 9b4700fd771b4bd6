//! Runs a simulated unit on a pseudo-terminal, on a thread of its own.

use std::{
    env, fs,
    io::{self, Error, ErrorKind},
    os::{fd::OwnedFd, unix::fs::symlink},
    path::PathBuf,
    process,
    sync::{
        Arc, Mutex, MutexGuard, PoisonError,
        atomic::{AtomicBool, AtomicU64, Ordering},
    },
    thread::{self, JoinHandle},
    time::{Duration, Instant},
};

use rustix::{
    event::{PollFd, PollFlags, Timespec, poll},
    fs::{Mode, OFlags, open},
    pty::{OpenptFlags, grantpt, openpt, ptsname, unlockpt},
    termios::{OptionalActions, ioctl_tiocnxcl, tcgetattr, tcsetattr},
};

use super::PeriodOutputs;

/// Longest sleep of the unit's thread, and so its latency when it should end.
const TICK: Duration = Duration::from_millis(5);

/// A unit behind a serial line. Time is passed in, in ns since it was switched on.
pub trait SerialUnit: Send + 'static {
    /// Baud rate of its line.
    fn baud_rate(&self) -> u32;
    /// Processes received bytes.
    fn receive(&mut self, bytes: &[u8], now_ns: u64);
    /// Whether its cable is cut: the host's end is then hung up.
    fn is_cut(&self) -> bool {
        false
    }
    /// Advances time.
    fn advance(&mut self, now_ns: u64) -> Step;
}

/// Output of a unit up to some time.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Step {
    /// Bytes to the host.
    pub bytes: Vec<u8>,
    /// Periods that have started.
    pub periods: Vec<PeriodOutputs>,
    /// When it must be called next.
    pub wake_ns: Option<u64>,
}

/// Called for every period at its start.
pub type PeriodObserver = Box<dyn FnMut(PeriodOutputs) + Send>;

/// A running unit. Dropping it cuts the line.
pub struct Served<U> {
    unit: Arc<Mutex<U>>,
    path: String,
    off: Arc<AtomicBool>,
    line_cut: Arc<AtomicBool>,
    /// A new line that replaces a cut one.
    new_line: Arc<Mutex<Option<Terminal>>>,
    thread: Option<JoinHandle<()>>,
}

impl<U: SerialUnit> Served<U> {
    /// Runs the unit on a new pseudo-terminal.
    ///
    /// # Errors
    ///
    /// The system provides no pseudo-terminal or thread.
    pub fn start(unit: U, observer: PeriodObserver) -> io::Result<Self> {
        let terminal = Terminal::open()?;
        let path = terminal.path.clone();
        let unit = Arc::new(Mutex::new(unit));
        let off = Arc::new(AtomicBool::new(false));
        let line_cut = Arc::new(AtomicBool::new(false));
        let new_line = Arc::new(Mutex::new(None));
        let (shared, stop, cut) = (Arc::clone(&unit), Arc::clone(&off), Arc::clone(&line_cut));
        let plugged_in = Arc::clone(&new_line);
        let run = move || {
            let port = terminal.path.clone();
            if let Err(error) = serve(terminal, &shared, observer, &stop, (&cut, &plugged_in)) {
                tracing::error!(port, %error, "the simulated unit has failed");
            }
        };
        let thread = thread::Builder::new().name("simulated unit".into()).spawn(run)?;
        Ok(Self { unit, path, off, line_cut, new_line, thread: Some(thread) })
    }

    /// The port to open: a link with a unique name.
    pub fn path(&self) -> &str {
        &self.path
    }

    /// The unit, for inspection and faults.
    pub fn unit(&self) -> MutexGuard<'_, U> {
        self.unit.lock().unwrap_or_else(PoisonError::into_inner)
    }

    /// Cuts the serial line: the host's end is hung up; the unit continues.
    pub fn cut_line(&self) {
        self.line_cut.store(true, Ordering::Relaxed);
    }

    /// Replaces a cut serial line by a new one; returns the port to open.
    ///
    /// # Errors
    ///
    /// The system provides no pseudo-terminal.
    pub fn plug_in_line(&self) -> io::Result<String> {
        let terminal = Terminal::open()?;
        let path = terminal.path.clone();
        *self.new_line.lock().unwrap_or_else(PoisonError::into_inner) = Some(terminal);
        Ok(path)
    }

    /// Ends the unit: the host's end of the line is hung up.
    pub fn cut(&mut self) {
        self.off.store(true, Ordering::Relaxed);
        if let Some(thread) = self.thread.take()
            && thread.join().is_err()
        {
            tracing::error!(port = self.path, "the simulated unit panicked");
        }
    }
}

impl<U> Drop for Served<U> {
    fn drop(&mut self) {
        self.off.store(true, Ordering::Relaxed);
        if let Some(thread) = self.thread.take() {
            // The thread has printed its panic.
            let _ = thread.join();
        }
    }
}

fn serve<U: SerialUnit>(
    terminal: Terminal,
    unit: &Mutex<U>,
    mut observer: PeriodObserver,
    off: &AtomicBool,
    (line_cut, new_line): (&AtomicBool, &Mutex<Option<Terminal>>),
) -> io::Result<()> {
    let mut line = Some(terminal);
    let on = Instant::now();
    let now_ns = || on.elapsed().as_nanos() as u64;
    let mut wait = TICK;
    while !off.load(Ordering::Relaxed) {
        if line_cut.load(Ordering::Relaxed) {
            line = None;
        }
        if let Some(terminal) = new_line.lock().unwrap_or_else(PoisonError::into_inner).take() {
            line_cut.store(false, Ordering::Relaxed);
            line = Some(terminal);
        }
        let bytes = match &line {
            Some(terminal) => terminal.read(wait)?,
            None => {
                thread::sleep(wait);
                Vec::new()
            }
        };
        let step = {
            let mut unit = unit.lock().unwrap_or_else(PoisonError::into_inner);
            if let (Some(terminal), false) = (&line, bytes.is_empty()) {
                let received = terminal.as_heard(bytes, unit.baud_rate())?;
                unit.receive(&received, now_ns());
            }
            if unit.is_cut() {
                line_cut.store(true, Ordering::Relaxed);
            }
            unit.advance(now_ns())
        };
        if let Some(terminal) = &line {
            terminal.write(&step.bytes)?;
        }
        step.periods.into_iter().for_each(&mut observer);
        let until_wake = step
            .wake_ns
            .map_or(TICK, |wake_ns| Duration::from_nanos(wake_ns.saturating_sub(now_ns())));
        wait = until_wake.min(TICK);
    }
    Ok(())
}

/// Both ends of a pseudo-terminal. The host's end is also kept open here: otherwise the line would
/// be hung up whenever the host closes it.
///
/// The system reuses the number of a closed pseudo-terminal. A driver that searches for a lost unit
/// must not find another one there, so the port is a link with a unique name that is removed before
/// the terminal is closed.
struct Terminal {
    unit_end: OwnedFd,
    host_end: OwnedFd,
    path: String,
}

/// Number of pseudo-terminals opened by this process.
static OPENED: AtomicU64 = AtomicU64::new(0);

impl Terminal {
    fn open() -> io::Result<Self> {
        let unit_end = openpt(OpenptFlags::RDWR | OpenptFlags::NOCTTY | OpenptFlags::CLOEXEC)?;
        grantpt(&unit_end)?;
        unlockpt(&unit_end)?;
        let path = ptsname(&unit_end, Vec::new())?;
        let flags = OFlags::RDWR | OFlags::NOCTTY | OFlags::CLOEXEC;
        let host_end = open(&path, flags, Mode::empty())?;
        let mut settings = tcgetattr(&host_end)?;
        settings.make_raw();
        tcsetattr(&host_end, OptionalActions::Now, &settings)?;
        let terminal =
            path.into_string().map_err(|error| Error::new(ErrorKind::InvalidData, error))?;
        let path = linked(&terminal)?;
        Ok(Self { unit_end, host_end, path })
    }

    /// Bytes from the host; empty if none arrive within `at_most`.
    fn read(&self, at_most: Duration) -> io::Result<Vec<u8>> {
        let timeout = Timespec {
            tv_sec: at_most.as_secs() as i64,
            tv_nsec: i64::from(at_most.subsec_nanos()),
        };
        let mut ends = [PollFd::new(&self.unit_end, PollFlags::IN)];
        match poll(&mut ends, Some(&timeout)) {
            Ok(0) | Err(rustix::io::Errno::INTR) => return Ok(Vec::new()),
            ready => ready?,
        };
        let mut buffer = [0_u8; 512];
        let count = rustix::io::read(&self.unit_end, &mut buffer)?;
        // Unlike a serial port, a pseudo-terminal stays exclusively reserved after its user was killed,
        // because its other end stays open.
        ioctl_tiocnxcl(&self.host_end)?;
        Ok(buffer[..count].to_vec())
    }

    fn write(&self, mut bytes: &[u8]) -> io::Result<()> {
        while !bytes.is_empty() {
            let written = rustix::io::write(&self.unit_end, bytes)?;
            bytes = &bytes[written..];
        }
        Ok(())
    }

    /// The bytes as received at the unit's baud rate: garbled if the rates differ.
    fn as_heard(&self, bytes: Vec<u8>, baud_rate: u32) -> io::Result<Vec<u8>> {
        match tcgetattr(&self.host_end)?.output_speed() == baud_rate {
            true => Ok(bytes),
            false => Ok(bytes.into_iter().map(|byte| byte.rotate_left(3) | 0x80).collect()),
        }
    }
}

impl Drop for Terminal {
    fn drop(&mut self) {
        // It may have been removed already.
        let _ = fs::remove_file(&self.path);
    }
}

/// Creates a uniquely named link to a pseudo-terminal.
fn linked(terminal: &str) -> io::Result<String> {
    let number = OPENED.fetch_add(1, Ordering::Relaxed);
    let name = format!("lfpiv-unit-{}-{number}", process::id());
    let link: PathBuf = env::temp_dir().join(name);
    // A killed process with the same number may have left one.
    let _ = fs::remove_file(&link);
    symlink(terminal, &link)?;
    let not_text =
        |_| Error::new(ErrorKind::InvalidData, "the temporary folder's name is not UTF-8");
    link.into_os_string().into_string().map_err(not_text)
}
