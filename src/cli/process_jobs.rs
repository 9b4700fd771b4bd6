//! Lists the pairs that `lfpiv process` measures, and handles existing results.

use std::{
    collections::{BTreeSet, HashMap},
    ffi::OsString,
    fs,
    io::ErrorKind,
    path::{Path, PathBuf},
};

use anyhow::{Context, bail};

use super::output::count;
use crate::archive::{find_pair_folders, stored_configuration};

/// Treatment of existing results.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Existing {
    /// Refuse to measure if there are any.
    Refuse,
    /// Keep them, and measure the other pairs.
    Keep,
    /// Remove them, and measure all pairs.
    Replace,
}

/// The files of a pair's results. `velocity.nc` is written last and marks complete results.
pub(super) const RESULT_FILES: [&str; 3] = ["velocity.vti", "volumes.nc", "velocity.nc"];

/// One pair and the folder of its results.
#[derive(Debug, PartialEq)]
pub(super) struct Job {
    pub pair: PathBuf,
    pub name: String,
    pub results: PathBuf,
    /// The pair's shot number.
    pub shot: u64,
    /// Whether existing results are kept.
    pub is_done: bool,
}

impl Job {
    fn file(&self, name: &str) -> PathBuf {
        self.results.join(name)
    }
}

/// The pairs in all given folders, and a message for each folder that cannot be used.
pub(super) fn jobs(folders: &[PathBuf], out: &Path) -> (Vec<Job>, Vec<String>) {
    let (mut jobs, mut failures) = (Vec::new(), Vec::new());
    let mut taken: HashMap<String, PathBuf> = HashMap::new();
    for folder in folders {
        let pairs = match find_pair_folders(folder) {
            Ok(pairs) => pairs,
            Err(error) => {
                failures.push(error.to_string());
                continue;
            }
        };
        for pair in pairs {
            let name = name_of(&pair);
            if let Some(other) = taken.insert(name.clone(), pair.clone()) {
                failures.push(format!(
                    "{}: its results would replace those of {}: rename one of the folders or \
                     process them with different --out",
                    pair.display(),
                    other.display()
                ));
                taken.insert(name, other);
                continue;
            }
            jobs.push(Job { results: out.join(&name), pair, name, shot: 0, is_done: false });
        }
    }
    number_shots(&mut jobs);
    (jobs, failures)
}

/// Numbers each pair by the number at the end of its folder's name. If these numbers are missing or
/// not unique, pairs are numbered in order.
fn number_shots(jobs: &mut [Job]) {
    let named: Option<Vec<u64>> = jobs.iter().map(|job| last_number(&job.name)).collect();
    let distinct =
        |numbers: &Vec<u64>| numbers.iter().collect::<BTreeSet<_>>().len() == numbers.len();
    let numbers = named.filter(distinct).unwrap_or_else(|| (0..jobs.len() as u64).collect());
    for (job, shot) in jobs.iter_mut().zip(numbers) {
        job.shot = shot;
    }
}

/// The number at the end of a name.
fn last_number(name: &str) -> Option<u64> {
    let digits = name.len() - name.trim_end_matches(|c: char| c.is_ascii_digit()).len();
    // Digits of a date and time may exceed the range of shot numbers in files.
    name[name.len() - digits..].parse().ok().filter(|number| *number <= i64::MAX as u64)
}

/// Handles existing results. `configuration` is the text for the new measurements; `with_volumes`
/// tells whether results must include volumes.
///
/// # Errors
/// Results exist but no treatment was requested, or results to keep were made with another
/// configuration.
pub(super) fn settle_existing(
    jobs: &mut [Job],
    existing: Existing,
    configuration: &str,
    with_volumes: bool,
) -> anyhow::Result<()> {
    let has_results = |job: &&mut Job| job.file("velocity.nc").exists();
    match existing {
        Existing::Refuse => {
            let pairs = jobs.len();
            let found: Vec<&mut Job> = jobs.iter_mut().filter(has_results).collect();
            let Some(first) = found.first() else { return Ok(()) };
            bail!(
                "{} of {} have results already, such as {}: --resume measures the others, \
                 --overwrite removes these results and measures all pairs, another --out keeps \
                 both",
                found.len(),
                count(pairs, "pair"),
                first.file("velocity.nc").display()
            )
        }
        Existing::Keep => {
            for job in jobs.iter_mut().filter(has_results) {
                let path = job.file("velocity.nc");
                if stored_configuration(&path)? != configuration {
                    bail!(
                        "{} was measured with another configuration than the given one (see its \
                         attribute `configuration`): resume with that one, or measure all pairs \
                         again with --overwrite",
                        path.display()
                    );
                }
                job.is_done = !with_volumes || job.file("volumes.nc").exists();
            }
            Ok(())
        }
        Existing::Replace => {
            let results = jobs.iter().flat_map(|job| RESULT_FILES.map(|name| job.file(name)));
            results.into_iter().try_for_each(|path| match fs::remove_file(&path) {
                Err(error) if error.kind() != ErrorKind::NotFound => {
                    Err(error).with_context(|| format!("cannot remove {}", path.display()))
                }
                _ => Ok(()),
            })
        }
    }
}

/// A folder's name, also for `.` and `..`.
fn name_of(folder: &Path) -> String {
    let own = |path: &Path| path.file_name().map(OsString::from);
    let name = own(folder).or_else(|| folder.canonicalize().ok().as_deref().and_then(own));
    name.map_or_else(|| "pair".to_owned(), |name| name.to_string_lossy().into_owned())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn pairs_with_the_same_name_do_not_overwrite_each_other() {
        let root = tempfile::tempdir().unwrap();
        let folders: Vec<PathBuf> =
            ["monday/shot_0000", "tuesday/shot_0000"].map(|name| root.path().join(name)).into();
        for folder in &folders {
            std::fs::create_dir_all(folder).unwrap();
            std::fs::write(folder.join("cam1_a.tif"), b"").unwrap();
        }
        let (jobs, failures) = jobs(&folders, Path::new("out"));
        assert_eq!(jobs.len(), 1);
        assert_eq!(jobs[0].results, Path::new("out/shot_0000"));
        assert!(failures[0].contains("tuesday") && failures[0].contains("monday"), "{failures:?}");
    }

    #[test]
    fn pairs_are_numbered_by_their_folders_or_in_order() {
        let numbers = |names: &[&str]| -> Vec<u64> {
            let job = |name: &&str| Job {
                pair: PathBuf::new(),
                name: (*name).to_owned(),
                results: PathBuf::new(),
                shot: 9,
                is_done: false,
            };
            let mut jobs: Vec<Job> = names.iter().map(job).collect();
            number_shots(&mut jobs);
            jobs.iter().map(|job| job.shot).collect()
        };
        assert_eq!(numbers(&["shot_0007", "shot_000012"]), [7, 12]);
        assert_eq!(numbers(&["b", "a"]), [0, 1]);
        assert_eq!(numbers(&["a1", "b1", "b2"]), [0, 1, 2]);
        assert_eq!(numbers(&["99999999999999999999"]), [0]);
    }

    #[test]
    fn a_folder_given_as_a_dot_is_resolved() {
        let here = std::env::current_dir().unwrap();
        assert_eq!(name_of(Path::new(".")), here.file_name().unwrap().to_string_lossy());
    }
}
