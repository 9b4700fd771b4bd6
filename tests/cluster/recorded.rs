//! A recorded run without results, and the same measured on one machine.

use std::{
    fs,
    path::{Path, PathBuf},
    process::Command,
    sync::OnceLock,
};

use lfpiv::archive::{StoredResults, stored_particles, stored_vectors};

use crate::{
    bench::{configuration, finished_run, lfpiv, text},
    processes::path,
};

pub const SHOTS: usize = 40;
/// A shot decides the forward model.
pub const MODEL: &str = "[model]\nmode = \"auto\"";

/// The recorded run, and the same measured locally. Made once for all tests.
struct Fixture {
    _root: tempfile::TempDir,
    bare: PathBuf,
    measured: PathBuf,
}

fn fixture() -> &'static Fixture {
    static FIXTURE: OnceLock<Fixture> = OnceLock::new();
    FIXTURE.get_or_init(|| {
        let root = tempfile::tempdir().expect("a folder");
        let bare = finished_run(&configuration(root.path(), MODEL), &SHOTS.to_string());
        remove_results(&bare);
        let measured = copied(&bare, &root.path().join("measured"));
        let output = lfpiv(&["process", path(&measured)]);
        assert!(output.status.success(), "{}", text(&output.stderr));
        Fixture { _root: root, bare, measured }
    })
}

/// A copy of the recorded run below `root`, without results.
pub fn recorded(root: &Path) -> PathBuf {
    copied(&fixture().bare, &root.join("run"))
}

/// A recorded run of another configuration, of `shots` shots, without results.
pub fn recorded_otherwise(root: &Path, (from, to): (&str, &str), shots: usize) -> PathBuf {
    fs::create_dir_all(root).expect("a folder");
    let config = configuration(root, MODEL);
    let text = fs::read_to_string(&config).expect("a configuration");
    assert!(text.contains(from), "{from}");
    fs::write(&config, text.replacen(from, to, 1)).expect("a configuration");
    let run = finished_run(&config, &shots.to_string());
    remove_results(&run);
    run
}

pub fn copied(run: &Path, to: &Path) -> PathBuf {
    let copied = Command::new("cp").arg("-a").args([run, to]).status().expect("cp");
    assert!(copied.success());
    to.to_owned()
}

pub fn remove_results(run: &Path) {
    for entry in fs::read_dir(run).expect("a folder") {
        let entry = entry.expect("an entry");
        let name = entry.file_name().into_string().expect("UTF-8");
        if ["velocity", "particles", "shot_"].iter().any(|start| name.starts_with(start)) {
            fs::remove_file(entry.path()).expect("a file");
        }
    }
}

/// Shots whose results the coordinator has stored so far.
pub fn stored_so_far(run: &Path) -> usize {
    let names =
        fs::read_dir(run).expect("the run").map(|entry| entry.expect("an entry").file_name());
    names.filter(|name| name.to_string_lossy().ends_with(".vti")).count()
}

/// The run holds what `lfpiv process` makes of the recorded run on one machine, bit for bit.
pub fn assert_as_on_one_machine(run: &Path) {
    assert_same(&fixture().measured, run);
}

/// Both folders hold the same results, each shot once, and nothing is left of the work.
pub fn assert_same(one: &Path, other: &Path) {
    let [a, b] = [one, other].map(|run| StoredResults::find(run).expect("results"));
    assert_eq!(a, b);
    assert_eq!(b.records, b.shots.len(), "each shot once");
    let [a, b] = [one, other].map(|run| stored_vectors(run).expect("vectors"));
    assert!(a == b, "vectors differ");
    let [a, b] = [one, other].map(|run| stored_particles(run).expect("particles"));
    assert!(a == b, "particles differ");
    let names = |run: &Path| {
        let entries = fs::read_dir(run).expect("a run");
        let mut names: Vec<_> = entries.map(|entry| entry.expect("an entry").file_name()).collect();
        names.sort();
        names
    };
    assert_eq!(names(one), names(other));
    for name in names(one).iter().filter(|name| name.to_string_lossy().ends_with(".vti")) {
        let [a, b] = [one, other].map(|run| fs::read(run.join(name)).expect("a file"));
        assert!(a == b, "{name:?}");
    }
    let output = lfpiv(&["compare", path(one), path(other)]);
    assert!(output.status.success(), "{}", text(&output.stderr));
}
