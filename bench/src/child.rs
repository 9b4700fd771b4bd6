//! `lfpiv process` as a process of its own: what a user waits for and what the machine must hold.

use std::{
    fs,
    io::Read,
    path::Path,
    process::{Command, Stdio},
    thread,
    time::{Duration, Instant},
};

use super::BenchmarkError;

/// How often memory is read: the time of a run is known to no better than this.
const POLL: Duration = Duration::from_millis(2);

/// What a process took.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Taken {
    /// Wall-clock time from start to end, in s.
    pub seconds: f64,
    /// Processor time of all threads, in s, where the system tells it: other work on the machine
    /// changes it less than the clock's time.
    pub cpu_seconds: Option<f64>,
    /// Peak resident memory, in bytes, where the system tells it.
    pub peak_bytes: Option<u64>,
}

/// Runs `program process` on one pair folder to its end.
///
/// Peak memory is the high-water mark of the process itself, read while it runs. The figure that
/// the system hands out with the exit status is not used: it includes this process's own memory
/// from before the child became another program.
///
/// # Errors
/// The program cannot be started, or does not succeed.
pub fn process(
    program: &Path,
    config: &Path,
    results: &Path,
    pair: &Path,
) -> Result<Taken, BenchmarkError> {
    let spawn = |reason| BenchmarkError::Spawn { program: program.into(), reason };
    let mut command = Command::new(program);
    command.arg("process").arg("--overwrite").arg("--config").arg(config);
    command.arg("--out").arg(results).arg(pair);
    command.env("RUST_LOG", "error").stdout(Stdio::null()).stderr(Stdio::piped());
    let started = Instant::now();
    let mut child = command.spawn().map_err(spawn)?;
    let (mut peak_bytes, mut cpu_seconds) = (None, None);
    let status = loop {
        peak_bytes = peak_bytes.max(high_water_bytes(child.id()));
        cpu_seconds = processor_seconds(child.id()).or(cpu_seconds);
        if let Some(status) = child.try_wait().map_err(spawn)? {
            break status;
        }
        thread::sleep(POLL);
    };
    let seconds = started.elapsed().as_secs_f64();
    if status.success() {
        return Ok(Taken { seconds, cpu_seconds, peak_bytes });
    }
    let mut message = String::new();
    if let Some(mut stderr) = child.stderr.take() {
        // What cannot be read cannot be told; that the process failed is told anyway.
        let _ = stderr.read_to_string(&mut message);
    }
    Err(BenchmarkError::Child { command: format!("{command:?}"), message })
}

/// `VmHWM` of a process: the most memory it has had resident so far, in bytes.
pub(super) fn high_water_bytes(process: u32) -> Option<u64> {
    let status = fs::read_to_string(format!("/proc/{process}/status")).ok()?;
    let line = status.lines().find(|line| line.starts_with("VmHWM:"))?;
    let kilobytes: u64 = line.split_whitespace().nth(1)?.parse().ok()?;
    Some(kilobytes * 1024)
}

/// User and system time of a process so far, in s, where the system tells it.
pub fn processor_seconds(process: u32) -> Option<f64> {
    /// Linux tells user space 100 ticks a second on every machine.
    const TICKS_PER_SECOND: f64 = 100.0;
    let stat = fs::read_to_string(format!("/proc/{process}/stat")).ok()?;
    // The second field, the program's name, may hold anything but ends with the last bracket;
    // user and system time are the fourteenth and fifteenth.
    let (_, after_name) = stat.rsplit_once(')')?;
    let mut ticks = after_name.split_whitespace().skip(11).map(str::parse::<u64>);
    let (user, system) = (ticks.next()?.ok()?, ticks.next()?.ok()?);
    Some((user + system) as f64 / TICKS_PER_SECOND)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_process_uses_memory_and_time() {
        let own = std::process::id();
        assert!(high_water_bytes(own).unwrap() > 1 << 20);
        // Other tests of this process count as well: it may have used any time before.
        let before = processor_seconds(own).unwrap();
        while processor_seconds(own).unwrap() < before + 0.02 {
            std::hint::black_box(before.sqrt());
        }
        assert_eq!(high_water_bytes(u32::MAX), None);
    }
}
