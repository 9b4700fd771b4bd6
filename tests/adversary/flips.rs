//! Damage to the files of a run: flipped bits, truncation, deletion, duplication.

use std::{
    fs,
    path::{Path, PathBuf},
};

use rand::{RngExt, seq::IndexedRandom};
use tempfile::TempDir;

use crate::{
    bench::{Running, configuration, finished_run, lfpiv},
    campaign::{Campaign, Case},
    exported::{Allowed, Shots, argument, check_export, copy, shots_in},
    mutation::Damage,
};

/// Small segments with uncompressed images.
const RAW_LOG: &str = "[raw_log]\nsegment_mb = 1\ncodec = \"raw\"\nsync_ms = 5\n";
const SHOTS: u64 = 5;

/// An undamaged run and its exported shots.
struct Base {
    run: PathBuf,
    shots: Shots,
    /// It was killed: its last segment is unsealed, and there is no ledger.
    is_open: bool,
}

impl Base {
    fn of(run: PathBuf, out: &Path, is_open: bool) -> Self {
        let exported = lfpiv(&["export", "--out", argument(out), argument(&run)]);
        assert!(exported.status.success(), "{exported:?}");
        Self { run, shots: shots_in(out), is_open }
    }
}

/// See the module.
pub struct Flips {
    root: TempDir,
    bases: [Base; 2],
}

impl Flips {
    /// Records a run that ends, and one that is killed.
    pub fn prepare() -> Self {
        let root = tempfile::tempdir().expect("a folder");
        let config = configuration(root.path(), RAW_LOG);
        let closed = finished_run(&config, &SHOTS.to_string());
        let running = Running::start(&config, &[]);
        running.wait_until(|status| status["watermarks"]["fsynced"].as_u64() > Some(SHOTS));
        let open = running.kill();
        let closed = Base::of(closed, &root.path().join("closed"), false);
        let open = Base::of(open, &root.path().join("open"), true);
        Self { root, bases: [closed, open] }
    }
}

impl Campaign for Flips {
    fn run(&mut self, case: &mut Case<'_>) {
        let base = &self.bases[usize::from(case.random.random_bool(0.4))];
        let folder = self.root.path().join("case");
        let _ = fs::remove_dir_all(&folder);
        fs::create_dir(&folder).expect("a folder");
        let run = folder.join("run");
        copy(&base.run, &run);
        let damage = Damage::any(&mut case.random);
        let file = any_file(&run, case);
        let bytes = fs::read(&file).expect("a file of the run");
        match damage.of(bytes, &mut case.random) {
            Some(bytes) => fs::write(&file, bytes).expect("a file of the run"),
            None => fs::remove_file(&file).expect("a file of the run"),
        }
        case.tally.mutations += 1;
        let name = file.strip_prefix(&run).expect("a file of the run").display().to_string();
        let harm = format!("{damage:?} of {name}");
        let allowed = match (name.starts_with("raw"), damage) {
            (false, _) => Allowed::Named(0),
            (true, Damage::Flip) => Allowed::Named(1),
            (true, _) if base.is_open => Allowed::End,
            (true, _) => Allowed::AnyNamed,
        };
        check_export(case, &run, &folder.join("pairs"), &base.shots, &allowed, &harm);
        match case.random.random_range(0..8) {
            0 => drop(case.lfpiv(&["replay", "--out", argument(&folder), argument(&run)])),
            1 => drop(case.lfpiv(&["compare", argument(&base.run), argument(&run)])),
            2 | 3 => drop(case.lfpiv(&["process", argument(&run)])),
            _ => {}
        }
    }
}

/// A random file of the run: of the raw log with probability 0.6.
fn any_file(run: &Path, case: &mut Case<'_>) -> PathBuf {
    let files = |folder: &Path| {
        let entries = fs::read_dir(folder).expect("a folder").flatten();
        let mut files: Vec<PathBuf> =
            entries.map(|entry| entry.path()).filter(|path| path.is_file()).collect();
        files.sort();
        files
    };
    let results = files(run);
    let of_log = results.is_empty() || case.random.random_bool(0.6);
    let files = if of_log { files(&run.join("raw")) } else { results };
    files.choose(&mut case.random).expect("a file").clone()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::report::{FaultKind, Tally};

    /// Unreported losses and changed data are detected.
    #[test]
    fn an_unreported_loss_is_found() {
        let flips = Flips::prepare();
        let closed = &flips.bases[0];
        let mut tally = Tally::default();
        let mut case = Case::alone(&mut tally);
        let out = flips.root.path().join("out");
        let mut whole = closed.shots.clone();
        whole.insert(SHOTS, Vec::new());
        whole.insert(0, Vec::new());
        check_export(&mut case, &closed.run, &out, &whole, &Allowed::Named(0), "none");
        let counts = [FaultKind::Lost, FaultKind::Unreported].map(|kind| tally.count(kind));
        assert_eq!(counts, [2, 1], "one is another, one is gone and not named");
    }
}
