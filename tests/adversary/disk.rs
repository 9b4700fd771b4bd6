//! Disks that fill up, become read-only or disappear under a running daemon.

use std::{
    fs::{self, File},
    io::Write,
    path::{Path, PathBuf},
    process::Command,
    time::{Duration, Instant},
};

use rand::RngExt;
use tempfile::TempDir;

use crate::{
    bench::{Running, configuration, images},
    campaign::{Campaign, Case},
    child::Ended,
    exported::argument,
    loop_disk::LoopDisk,
    report::FaultKind,
    small_disk::mount_small_disk,
};

const RAW_LOG: &str = "[raw_log]\nreserve_mb = 0\nsegment_mb = 2\nsync_ms = 5\n";
const MEGABYTES: u32 = 48;

/// A disk for one case.
enum Disk {
    /// A file system on a loop device.
    Loop(LoopDisk),
    /// A tmpfs, where loop devices are not available.
    Memory(PathBuf),
}

/// A failure of a disk.
#[derive(Debug, Clone, Copy)]
enum Failure {
    Full,
    ReadOnly,
    Shutdown,
}

/// See the module.
pub struct Disks {
    root: TempDir,
    config: PathBuf,
    counts: [u64; 3],
    is_loop: bool,
}

impl Disks {
    /// Finds out which disks are available.
    pub fn prepare() -> Self {
        let root = tempfile::tempdir().expect("a folder");
        let config = configuration(root.path(), RAW_LOG);
        let is_loop =
            LoopDisk::mount(root.path(), &root.path().join("results"), MEGABYTES).is_some();
        Self { root, config, counts: [0; 3], is_loop }
    }

    fn disk(&self) -> Disk {
        let results = self.root.path().join("results");
        if self.is_loop {
            let disk = LoopDisk::mount(self.root.path(), &results, MEGABYTES);
            return Disk::Loop(disk.expect("a loop device, as there was one before"));
        }
        mount_small_disk(&results, MEGABYTES);
        Disk::Memory(results)
    }
}

impl Disk {
    fn folder(&self) -> &Path {
        match self {
            Self::Loop(disk) => disk.folder(),
            Self::Memory(folder) => folder,
        }
    }

    fn fail(&self, failure: Failure, case: &mut Case<'_>) {
        match (self, failure) {
            (Self::Loop(disk), Failure::ReadOnly) => disk.make_read_only(),
            (Self::Loop(disk), Failure::Shutdown) => disk.shut_down(case.random.random_range(0..3)),
            _ => fill(self.folder()),
        }
    }

    /// As after a restart of the machine.
    fn restart(&mut self) {
        if let Self::Loop(disk) = self {
            disk.mount_again();
        }
    }
}

impl Drop for Disk {
    fn drop(&mut self) {
        if let Self::Memory(folder) = self {
            let _ = Command::new("umount").arg(folder).status();
        }
    }
}

/// Fills the disk from outside.
fn fill(folder: &Path) {
    let mut ballast = File::create(folder.join("ballast")).expect("a file");
    for piece in [1 << 16, 1 << 12, 1] {
        while ballast.write_all(&vec![1; piece]).is_ok() {}
    }
}

impl Campaign for Disks {
    fn run(&mut self, case: &mut Case<'_>) {
        let failure = match (self.is_loop, case.random.random_range(0..3)) {
            (true, 1) => Failure::ReadOnly,
            (true, 2) => Failure::Shutdown,
            _ => Failure::Full,
        };
        self.counts[failure as usize] += 1;
        let mut disk = self.disk();
        let log = self.root.path().join("log");
        let file = File::create(&log).expect("a file");
        let running = Running::logged(&self.config, &["--shots", "10000"], file);
        let alive = Duration::from_micros(case.random.random_range(50_000..1_200_000));
        let mut synced = running.acknowledged_until(Instant::now() + alive);
        case.note_memory(running.child.id());
        disk.fail(failure, case);
        let after = Duration::from_micros(case.random.random_range(0..1_000_000));
        synced.extend(answered_until(&running, Instant::now() + after));
        let run = running.folder.clone();
        let ended = told_to_end(running, &log);
        case.judge(&format!("the daemon on a disk that failed ({failure:?})"), &ended);
        if matches!(failure, Failure::Full) {
            case.lfpiv(&["process", argument(&run)]);
            let _ = fs::remove_file(disk.folder().join("ballast"));
        }
        disk.restart();
        let kept: Vec<u64> = match synced.is_empty() {
            true => Vec::new(),
            false => images(&run).into_iter().map(|(shot, _)| shot).collect(),
        };
        for shot in synced {
            case.tally.acknowledged += 1;
            if !kept.contains(&shot) {
                case.fault(FaultKind::Lost, format!("{failure:?}: {shot} was acknowledged"));
            }
        }
        if !kept.is_empty() {
            let ended = case.lfpiv(&["process", argument(&run)]);
            if ended.code != Some(0) {
                let words = ended.last_words();
                case.fault(FaultKind::Wrong, format!("{failure:?}: not measured: {words}"));
            }
        }
    }

    fn remark(&self) -> String {
        let [full, read_only, shutdown] = self.counts;
        match self.is_loop {
            true => format!(
                "ext4 on a loop device: {full} full, {read_only} read-only, {shutdown} shut down"
            ),
            false => format!("tmpfs (no loop device here): {full} full"),
        }
    }
}

/// As [`Running::acknowledged_until`], for a daemon that may exit meanwhile.
fn answered_until(running: &Running, end: Instant) -> Vec<u64> {
    let mut synced = Vec::new();
    while Instant::now() < end {
        let Some(list) = running.get("/api/v1/shots?limit=1000") else { break };
        let shots = list["shots"].as_array().cloned().unwrap_or_default();
        let safe = shots.iter().filter(|shot| shot["raw"] == "synced");
        synced = safe.filter_map(|shot| shot["shot"].as_u64()).collect();
        std::thread::sleep(Duration::from_millis(5));
    }
    synced
}

/// Sends SIGTERM and returns how the daemon ended.
fn told_to_end(mut running: Running, log: &Path) -> Ended {
    // It may have exited already, and was not waited for.
    let terminate = format!("kill -TERM {}", running.child.id());
    let _ = Command::new("sh").args(["-c", &terminate]).status();
    Ended::of_daemon(&mut running.child, log)
}
