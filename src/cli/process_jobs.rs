//! Which pairs `lfpiv process` is to measure, and which have results already.

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

/// What becomes of results that are there already.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Existing {
    /// Nothing is measured beside them.
    Refuse,
    /// They stay, and the pairs without are measured.
    Keep,
    /// They are removed, and all pairs are measured.
    Replace,
}

/// The files of a pair's results. `velocity.nc` comes last: with it the results are whole.
pub(super) const RESULT_FILES: [&str; 3] = ["velocity.vti", "volumes.nc", "velocity.nc"];

/// One pair and where its results go.
#[derive(Debug, PartialEq)]
pub(super) struct Job {
    pub pair: PathBuf,
    pub name: String,
    pub results: PathBuf,
    /// Its number among the pairs.
    pub shot: u64,
    /// Its results are there already, and stay.
    pub is_done: bool,
}

impl Job {
    fn file(&self, name: &str) -> PathBuf {
        self.results.join(name)
    }
}

/// The pairs below all folders given, and a message for each that cannot be one.
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

/// Gives each pair the number at the end of its folder's name, or, where not every name has one of its own,
/// that of its turn.
fn number_shots(jobs: &mut [Job]) {
    let named: Option<Vec<u64>> = jobs.iter().map(|job| last_number(&job.name)).collect();
    let distinct =
        |numbers: &Vec<u64>| numbers.iter().collect::<BTreeSet<_>>().len() == numbers.len();
    let numbers = named.filter(distinct).unwrap_or_else(|| (0..jobs.len() as u64).collect());
    for (job, shot) in jobs.iter_mut().zip(numbers) {
        job.shot = shot;
    }
}

/// The number that a name ends with.
fn last_number(name: &str) -> Option<u64> {
    let digits = name.len() - name.trim_end_matches(|c: char| c.is_ascii_digit()).len();
    // A date and a time are no shot number that a file can hold.
    name[name.len() - digits..].parse().ok().filter(|number| *number <= i64::MAX as u64)
}

/// Deals with results that are there already; `configuration` is the text that the others will be
/// measured with, and `with_volumes` whether volumes belong to a pair's results.
///
/// # Errors
/// There are some and nothing was said about them, or those that shall stay were made otherwise.
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
                "{} of {} have results already, {} among them: --resume measures the others, \
                 --overwrite removes these results and measures all, another --out keeps both",
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
                        "{} was measured with another configuration than the one given (its \
                         attribute `configuration` has it): resume with that one, or measure all \
                         anew with --overwrite",
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

/// A folder's own name, for `.` and `..` too.
fn name_of(folder: &Path) -> String {
    let own = |path: &Path| path.file_name().map(OsString::from);
    let name = own(folder).or_else(|| folder.canonicalize().ok().as_deref().and_then(own));
    name.map_or_else(|| "pair".to_owned(), |name| name.to_string_lossy().into_owned())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn two_pairs_of_one_name_are_not_written_over_each_other() {
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
    fn pairs_have_the_numbers_of_their_folders_or_of_their_turns() {
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
    fn a_folder_given_as_a_dot_has_its_own_name() {
        let here = std::env::current_dir().unwrap();
        assert_eq!(name_of(Path::new(".")), here.file_name().unwrap().to_string_lossy());
    }
}
