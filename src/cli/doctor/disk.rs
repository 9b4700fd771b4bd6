//! Checks the output folder: whether it can be written, its speed, and its free space.

use std::{
    fs::{self, File, OpenOptions},
    io::{self, Write},
    path::{Path, PathBuf},
    time::{Duration, Instant},
};

use rustix::fs::{StatVfs, statvfs};

use super::{Finding, Need};

/// Largest number of bytes to write.
const SAMPLE_BYTES: u64 = 256 << 20;
const BLOCK_BYTES: usize = 4 << 20;
/// Longest time to write.
const SAMPLE_TIME: Duration = Duration::from_secs(4);
/// Largest part of the free space to write: one in this number.
const SAMPLE_PART: u64 = 4;
/// With fewer bytes the speed cannot be measured.
const LEAST_SAMPLE_BYTES: u64 = 8 << 20;
/// Required ratio of the disk's speed to the bench's data rate, because the disk has other work,
/// too.
const SPEED_MARGIN: f64 = 2.0;
/// Hours of shots for which space should be free (advice below), and must be free (problem below).
const FREE_SPACE_HOURS: f64 = 1.0;
const MIN_FREE_SPACE_HOURS: f64 = 10.0 / 60.0;

/// Checks writing, its speed, and free space.
pub fn examine(output: &Path, need: Option<&Need>) -> Vec<Finding> {
    let folder = nearest_existing(output);
    let place = folder.display();
    let free_bytes = match statvfs(&folder) {
        Ok(statistics) => free_bytes(&statistics),
        Err(error) => {
            let todo = "set output.dir to a folder that this user can access";
            return vec![Finding::problem("output folder", format!("{place}: {error}"), todo)];
        }
    };
    let sample = (free_bytes / SAMPLE_PART).min(SAMPLE_BYTES);
    let written = match measure(&folder, sample) {
        Ok(written) => written,
        Err(error) => {
            let todo = format!(
                "make {place} writable for the user that runs lfpiv (chown, or mount -o \
                 remount,rw), or set output.dir to another folder"
            );
            let found = format!("{place} cannot be written: {error}");
            return vec![
                Finding::problem("output folder", found, todo),
                free_space(&folder, free_bytes, need),
            ];
        }
    };
    vec![
        Finding::ok("output folder", format!("{place} can be written")),
        writing_speed(&folder, written, need),
        free_space(&folder, free_bytes, need),
    ]
}

/// The folder itself, or its closest existing ancestor.
fn nearest_existing(folder: &Path) -> PathBuf {
    let absolute = std::path::absolute(folder).unwrap_or_else(|_| folder.to_owned());
    let existing = absolute.ancestors().find(|ancestor| ancestor.is_dir());
    existing.unwrap_or(Path::new("/")).to_owned()
}

fn free_bytes(statistics: &StatVfs) -> u64 {
    statistics.f_bavail.saturating_mul(statistics.f_frsize)
}

/// Bytes written and synced, and the time taken.
#[derive(Debug, Clone, Copy)]
struct Written {
    bytes: u64,
    time: Duration,
}

impl Written {
    fn bytes_per_s(self) -> f64 {
        self.bytes as f64 / self.time.as_secs_f64().max(1e-6)
    }
}

/// Writes up to `sample` bytes and syncs them, in an unlinked file, so that nothing is left behind
/// in any case.
fn measure(folder: &Path, sample: u64) -> io::Result<Written> {
    let mut file = unlinked_file(folder)?;
    let block = incompressible_block();
    let (began, mut bytes) = (Instant::now(), 0);
    while bytes < sample && began.elapsed() < SAMPLE_TIME {
        let next = &block[..BLOCK_BYTES.min((sample - bytes) as usize)];
        file.write_all(next)?;
        bytes += next.len() as u64;
    }
    file.sync_all()?;
    Ok(Written { bytes, time: began.elapsed() })
}

fn unlinked_file(folder: &Path) -> io::Result<File> {
    let path = folder.join(format!(".lfpiv-doctor-{}", std::process::id()));
    let file = OpenOptions::new().write(true).create_new(true).open(&path)?;
    fs::remove_file(&path)?;
    Ok(file)
}

/// Incompressible data, as camera noise is: a compressing file system would otherwise look too
/// fast.
fn incompressible_block() -> Vec<u8> {
    let mut state = 0x9e37_79b9_7f4a_7c15_u64;
    let words = std::iter::repeat_with(|| {
        // Marsaglia's xorshift.
        state ^= state << 13;
        state ^= state >> 7;
        state ^= state << 17;
        state
    });
    words.take(BLOCK_BYTES / 8).flat_map(u64::to_le_bytes).collect()
}

fn writing_speed(folder: &Path, written: Written, need: Option<&Need>) -> Finding {
    const CHECK: &str = "writing speed";
    let place = folder.display();
    if written.bytes < LEAST_SAMPLE_BYTES {
        let found = format!("{place} has too little free space to measure it");
        return Finding::advice(CHECK, found, "free some space, then run this again");
    }
    let speed = written.bytes_per_s();
    let found = format!(
        "{} MB written and synced to {place} at {}",
        written.bytes / 1_000_000,
        mb_per_s(speed)
    );
    let finding = match need {
        None => Finding::ok(CHECK, found),
        Some(need) => {
            let produced = need.bytes_per_s();
            let found = format!("{found}; the bench produces {}", mb_per_s(produced));
            let faster = "put output.dir on a faster disk (a local SSD), or lower shot.rate_hz";
            if speed < produced {
                Finding::problem(CHECK, found, faster)
            } else if speed < SPEED_MARGIN * produced {
                Finding::advice(
                    CHECK,
                    found,
                    format!("the disk should be twice as fast as the bench: {faster}"),
                )
            } else {
                Finding::ok(CHECK, found)
            }
            .with("needed_mb_per_s", produced / 1e6)
        }
    };
    finding.with("write_mb_per_s", speed / 1e6)
}

fn free_space(folder: &Path, free_bytes: u64, need: Option<&Need>) -> Finding {
    const CHECK: &str = "free space";
    let found = format!("{:.1} GB in {}", free_bytes as f64 / 1e9, folder.display());
    let finding = match need {
        None => Finding::ok(CHECK, found),
        Some(need) => {
            let hours = free_bytes as f64 / need.bytes_per_s() / 3600.0;
            let lasts = match hours {
                1.0.. => format!("{hours:.1} hours"),
                _ => format!("{:.0} minutes", 60.0 * hours),
            };
            let found = format!("{found}, {lasts} of shots");
            let more = "remove old runs or set output.dir to a larger disk";
            if hours < MIN_FREE_SPACE_HOURS {
                Finding::problem(CHECK, found, more)
            } else if hours < FREE_SPACE_HOURS {
                Finding::advice(CHECK, found, more)
            } else {
                Finding::ok(CHECK, found)
            }
            .with("hours_of_shots", hours)
        }
    };
    finding.with("free_gb", free_bytes as f64 / 1e9)
}

fn mb_per_s(bytes_per_s: f64) -> String {
    format!("{:.0} MB/s", bytes_per_s / 1e6)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::cli::doctor::Verdict;

    fn need(bytes_per_s: usize) -> Need {
        let frame_bytes = vec![bytes_per_s / 2];
        Need { frame_bytes, rate_hz: 1.0, pixels: 1, shots_in_memory: 1 }
    }

    #[test]
    fn the_written_bytes_are_measured_and_no_file_remains() {
        let folder = tempfile::tempdir().unwrap();
        let written = measure(folder.path(), 9_000_000).unwrap();
        assert_eq!(written.bytes, 9_000_000);
        assert!(written.bytes_per_s() > 1e5);
        assert_eq!(fs::read_dir(folder.path()).unwrap().count(), 0);
    }

    #[test]
    fn the_speed_is_compared_with_the_data_rate_of_the_bench() {
        let written = Written { bytes: 100_000_000, time: Duration::from_secs(1) };
        let verdict =
            |produced| writing_speed(Path::new("/x"), written, Some(&need(produced))).verdict;
        assert_eq!(verdict(40_000_000), Verdict::Ok);
        assert_eq!(verdict(60_000_000), Verdict::Advice);
        assert_eq!(verdict(110_000_000), Verdict::Problem);
        assert_eq!(writing_speed(Path::new("/x"), written, None).verdict, Verdict::Ok);
    }

    #[test]
    fn free_space_is_stated_in_hours_of_shots() {
        let hour = 3600 * 1_000_000_u64;
        let finding = |bytes| free_space(Path::new("/x"), bytes, Some(&need(1_000_000)));
        assert_eq!(finding(2 * hour).verdict, Verdict::Ok);
        assert_eq!(finding(hour / 2).verdict, Verdict::Advice);
        assert_eq!(finding(hour / 10).verdict, Verdict::Problem);
        assert!(finding(2 * hour).found.contains("2.0 hours"));
    }

    #[test]
    fn the_nearest_existing_ancestor_of_a_folder_is_found() {
        let root = tempfile::tempdir().unwrap();
        assert_eq!(nearest_existing(&root.path().join("a/b")), root.path());
    }
}
