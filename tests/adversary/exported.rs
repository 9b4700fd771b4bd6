//! What `lfpiv export` gives of a run, held against what it gave before the run was damaged.

use std::{
    collections::BTreeMap,
    fs,
    path::{Path, PathBuf},
    process::Command,
};

use crate::{campaign::Case, child::Ended, report::FaultKind};

/// Damaged or missing data is in what was done.
const DAMAGED: i32 = 3;

/// The images of each shot, file by file.
pub type Shots = BTreeMap<u64, Vec<Vec<u8>>>;

/// A folder as a copy of its own.
pub fn copy(from: &Path, to: &Path) {
    assert!(Command::new("cp").arg("-r").args([from, to]).status().expect("cp").success());
}

/// The path as an argument.
pub fn argument(path: &Path) -> &str {
    path.to_str().expect("a path in UTF-8")
}

/// What is in a folder of exported shots.
pub fn shots_in(folder: &Path) -> Shots {
    let mut shots = Shots::new();
    for entry in fs::read_dir(folder).into_iter().flatten().flatten() {
        let name = entry.file_name().into_string().unwrap_or_default();
        let Some(shot) = name.strip_prefix("shot_").and_then(|number| number.parse().ok()) else {
            continue;
        };
        let mut images: Vec<PathBuf> = fs::read_dir(entry.path())
            .expect("a shot's folder")
            .map(|image| image.expect("an image").path())
            .collect();
        images.sort();
        let bytes = images.iter().map(|image| fs::read(image).expect("an image")).collect();
        shots.insert(shot, bytes);
    }
    shots
}

/// What may be missing from an export without a fault.
pub enum Allowed {
    /// So many shots, all of them named.
    Named(usize),
    /// Any, all of them named.
    AnyNamed,
    /// Any; those at the end without a word, because the run was cut off anyway.
    End,
}

/// Exports a run and holds every shot against the `whole` ones.
pub fn check_export(
    case: &mut Case<'_>,
    run: &Path,
    out: &Path,
    whole: &Shots,
    allowed: &Allowed,
    harm: &str,
) {
    let ended = case.lfpiv(&["export", "--out", argument(out), argument(run)]);
    let found = shots_in(out);
    for (shot, images) in &found {
        if whole.get(shot) != Some(images) {
            case.fault(FaultKind::Lost, format!("{harm}: shot {shot} has other images"));
        }
    }
    let missing: Vec<u64> =
        whole.keys().filter(|shot| !found.contains_key(shot)).copied().collect();
    if let Allowed::Named(most) = allowed
        && missing.len() > *most
    {
        case.fault(FaultKind::Lost, format!("{harm}: {missing:?} are lost"));
    }
    let last = found.keys().next_back().copied();
    let may_be_unsaid = |shot: u64| matches!(allowed, Allowed::End) && Some(shot) > last;
    for shot in missing {
        if !is_said(&ended, shot) && !may_be_unsaid(shot) {
            let words = ended.last_words();
            case.fault(
                FaultKind::Unsaid,
                format!("{harm}: nothing says that {shot} is lost: {words}"),
            );
        }
    }
}

/// Whether a shot is named as lost, or nothing at all can be read.
fn is_said(ended: &Ended, shot: u64) -> bool {
    match ended.code {
        Some(DAMAGED) => ended.stderr.contains(&format!("shot {shot}: ")),
        Some(1) => ended.stderr.contains("error: "),
        _ => false,
    }
}
