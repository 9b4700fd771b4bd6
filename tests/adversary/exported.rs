//! Compares the output of `lfpiv export` before and after damage to a run.

use std::{
    collections::BTreeMap,
    fs,
    path::{Path, PathBuf},
    process::Command,
};

use crate::{campaign::Case, child::Ended, report::FaultKind};

/// Exit code for damaged or missing data.
const DAMAGED: i32 = 3;

/// The images of each shot, as files.
pub type Shots = BTreeMap<u64, Vec<Vec<u8>>>;

/// Copies a folder.
pub fn copy(from: &Path, to: &Path) {
    assert!(Command::new("cp").arg("-r").args([from, to]).status().expect("cp").success());
}

/// The path as an argument.
pub fn argument(path: &Path) -> &str {
    path.to_str().expect("a path in UTF-8")
}

/// The shots in a folder of exported images.
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

/// Losses that are not a fault.
pub enum Allowed {
    /// At most this many shots, all reported.
    Named(usize),
    /// Any number, all reported.
    AnyNamed,
    /// Any number; those at the end may be unreported, because the run was cut off.
    End,
}

/// Exports a run and compares every shot with the `whole` ones.
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
    let may_be_silent = |shot: u64| matches!(allowed, Allowed::End) && Some(shot) > last;
    for shot in missing {
        if !is_reported(&ended, shot) && !may_be_silent(shot) {
            let words = ended.last_words();
            case.fault(
                FaultKind::Unreported,
                format!("{harm}: the loss of shot {shot} is not reported: {words}"),
            );
        }
    }
}

/// Whether the loss of a shot is reported, or nothing can be read at all.
fn is_reported(ended: &Ended, shot: u64) -> bool {
    match ended.code {
        Some(DAMAGED) => ended.stderr.contains(&format!("shot {shot}: ")),
        Some(1) => ended.stderr.contains("error: "),
        _ => false,
    }
}
