//! The folder of a run.

use std::path::{Path, PathBuf};

use anyhow::Context;
use time::{OffsetDateTime, macros::format_description};

/// Largest number of runs that can start within one second.
const MAX_SUFFIX: u32 = 100;

/// Creates `results_dir/run-<UTC time>`, with a number appended if that exists.
pub(super) fn create_run_folder(results_dir: &Path) -> anyhow::Result<PathBuf> {
    std::fs::create_dir_all(results_dir)
        .with_context(|| format!("cannot create {}", results_dir.display()))?;
    let name = folder_name(OffsetDateTime::now_utc())?;
    for suffix in 1..MAX_SUFFIX {
        let suffix = if suffix == 1 { String::new() } else { format!("-{suffix}") };
        let folder = results_dir.join(format!("{name}{suffix}"));
        match std::fs::create_dir(&folder) {
            Ok(()) => return Ok(folder),
            Err(error) if error.kind() == std::io::ErrorKind::AlreadyExists => {}
            Err(error) => {
                return Err(error).with_context(|| format!("cannot create {}", folder.display()));
            }
        }
    }
    anyhow::bail!("{} has too many runs of this second: try again", results_dir.display())
}

fn folder_name(now: OffsetDateTime) -> anyhow::Result<String> {
    let format = format_description!("run-[year][month][day]T[hour][minute][second]Z");
    now.format(&format).context("the system clock is out of range")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_sort_by_time_and_are_not_reused() {
        let name = folder_name(OffsetDateTime::UNIX_EPOCH).unwrap();
        assert_eq!(name, "run-19700101T000000Z");
        let root = tempfile::tempdir().unwrap();
        let results = root.path().join("a/b");
        let folders: Vec<_> = (0..3).map(|_| create_run_folder(&results).unwrap()).collect();
        assert!(folders.iter().all(|folder| folder.is_dir()));
        assert!(folders[0] != folders[1] && folders[1] != folders[2]);
    }
}
