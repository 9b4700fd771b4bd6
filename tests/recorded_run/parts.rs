//! A run measured in parts, on several machines, is the run measured at once.

// All of this is test; clippy's exception covers only the functions marked as such.
#![allow(clippy::unwrap_used)]

use std::{
    collections::{BTreeMap, BTreeSet},
    fs,
    path::{Path, PathBuf},
    process::{Command, Stdio},
    time::{Duration, Instant},
};

use lfpiv::{acquisition::journal::RecordedRun, archive::StoredResults};

use crate::bench::{PATIENCE, configuration, finished_run, lfpiv, text};

const SHOTS: usize = 7;
/// A shot decides the forward model.
const MODEL: &str = "[model]\nmode = \"auto\"";

/// A recorded run without any result.
fn recorded(root: &Path) -> PathBuf {
    fs::create_dir_all(root).unwrap();
    let run = finished_run(&configuration(root, MODEL), &SHOTS.to_string());
    remove_results(&run);
    run
}

fn is_result(name: &str) -> bool {
    ["velocity", "particles", "shot_"].iter().any(|kind| name.starts_with(kind))
}

fn remove_results(run: &Path) {
    for path in files(run).into_keys().filter(|path| is_result(path)) {
        fs::remove_file(run.join(path)).unwrap();
    }
}

/// Every file below a folder, by its path there.
fn files(folder: &Path) -> BTreeMap<String, Vec<u8>> {
    let mut found = BTreeMap::new();
    for entry in fs::read_dir(folder).unwrap() {
        let path = entry.unwrap().path();
        let name = path.file_name().unwrap().to_str().unwrap().to_owned();
        if path.is_dir() {
            let below = files(&path).into_iter();
            found.extend(below.map(|(path, content)| (format!("{name}/{path}"), content)));
        } else {
            found.insert(name, fs::read(&path).unwrap());
        }
    }
    found
}

fn copied(run: &Path, to: &Path) -> PathBuf {
    let copied = Command::new("cp").arg("-a").args([run, to]).status().unwrap();
    assert!(copied.success());
    to.to_owned()
}

fn path(path: &Path) -> &str {
    path.to_str().unwrap()
}

fn measure(run: &Path, part: &str, out: &Path) {
    let output = lfpiv(&["process", path(run), "--part", part, "--out", path(out)]);
    assert!(output.status.success(), "{}", text(&output.stderr));
}

fn parts(run: &Path, below: &Path, n: usize) -> Vec<PathBuf> {
    let part = |k: usize| {
        let out = below.join(k.to_string());
        measure(run, &format!("{k}/{n}"), &out);
        out
    };
    (1..=n).map(part).collect()
}

/// Whether it succeeded, and what it said.
fn merge(run: &Path, parts: &[PathBuf]) -> (bool, String) {
    let folders = parts.iter().map(|part| path(part));
    let arguments: Vec<&str> =
        ["process", path(run), "--merge"].into_iter().chain(folders).collect();
    let output = lfpiv(&arguments);
    (output.status.success(), text(&output.stdout) + &text(&output.stderr))
}

/// Fails with the names of the files that differ.
fn assert_same_files(
    before: &BTreeMap<String, Vec<u8>>,
    after: &BTreeMap<String, Vec<u8>>,
    said: &str,
) {
    let names: BTreeSet<&String> = before.keys().chain(after.keys()).collect();
    let changed: Vec<_> =
        names.into_iter().filter(|name| before.get(*name) != after.get(*name)).collect();
    assert!(changed.is_empty(), "changed: {changed:?}\n{said}");
}

/// What a merge is refused with. Nothing of the run may have changed.
fn refusal(run: &Path, parts: &[PathBuf]) -> String {
    let before = files(run);
    let (success, said) = merge(run, parts);
    assert!(!success, "{said}");
    assert_same_files(&before, &files(run), &said);
    said
}

/// All that a NetCDF file says, but for times that the measurement took and was made at.
fn results_in(path: &Path) -> BTreeMap<String, String> {
    let file = netcdf::open(path).unwrap();
    let mut found = BTreeMap::new();
    for attribute in file.attributes() {
        if !["history", "first_stored_shot"].contains(&attribute.name()) {
            found.insert(attribute.name().to_owned(), format!("{:?}", attribute.value().unwrap()));
        }
    }
    for dimension in file.dimensions() {
        found.insert(format!("dimension {}", dimension.name()), dimension.len().to_string());
    }
    for variable in file.variables().filter(|variable| !variable.name().ends_with("_seconds")) {
        let attributes = variable.attributes();
        let attributes: Vec<String> = attributes
            .map(|attribute| format!("{} {:?}", attribute.name(), attribute.value().unwrap()))
            .collect();
        let values = variable.get_raw_values(..).unwrap();
        found
            .insert(variable.name(), format!("{:?} {attributes:?} {values:?}", variable.vartype()));
    }
    found
}

/// Two folders of one run hold the same, but for the times that measuring took.
fn assert_same(one: &Path, other: &Path) {
    // The first stored shot decides the forward model of what is measured later.
    let [a, b] = [one, other].map(|folder| StoredResults::find(folder).unwrap());
    assert_eq!(a, b);
    let [a, b] = [one, other].map(files);
    assert_eq!(a.keys().collect::<Vec<_>>(), b.keys().collect::<Vec<_>>());
    for (name, content) in &a {
        if name.ends_with(".nc") {
            let [a, b] = [one, other].map(|folder| results_in(&folder.join(name)));
            assert_eq!(a, b, "{name}");
        } else {
            assert!(*content == b[name], "{name}");
        }
    }
    let output = lfpiv(&["compare", path(one), path(other)]);
    assert!(output.status.success(), "{}", text(&output.stderr));
}

#[test]
fn merged_parts_are_the_run_processed_at_once() {
    let root = tempfile::tempdir().unwrap();
    let run = recorded(root.path());
    // As of a run that was killed: the ledger is made from the record.
    fs::remove_file(run.join("ledger.json")).unwrap();
    let at_once = copied(&run, &root.path().join("at_once"));
    assert!(lfpiv(&["process", path(&at_once)]).status.success());

    let before = files(&run);
    let mut folders = parts(&run, &root.path().join("parts"), 3);
    assert!(files(&run) == before, "parts only read the run");
    let (success, said) = merge(&run, &folders[1..]);
    assert!(!success && said.contains("part 1/3 is missing"), "{said}");

    folders.rotate_left(1);
    let (success, said) = merge(&run, &folders);
    assert!(success, "{said}");
    assert_same(&at_once, &run);
    assert!(said.contains("7 shots recorded, 0 had a result, 7 have one now"), "{said}");

    let said = refusal(&run, &folders);
    assert!(
        said.contains("shot 0 is in more than one place: part 1/3 in") && said.contains("the run"),
        "{said}"
    );
}

#[test]
fn parts_measure_what_the_run_has_not() {
    let root = tempfile::tempdir().unwrap();
    let run = recorded(root.path());
    let half = root.path().join("half");
    measure(&run, "2/2", &half);
    for (name, content) in files(&half).iter().filter(|(name, _)| is_result(name)) {
        fs::write(run.join(name), content).unwrap();
    }
    let at_once = copied(&run, &root.path().join("at_once"));
    assert!(lfpiv(&["process", path(&at_once)]).status.success());
    // More parts than shots, in the run's own folder.
    parts(&run, &run.join("parts"), 5);
    let (success, said) = merge(&run, &[]);
    assert!(success, "{said}");
    assert!(said.contains("3 had a result, 7 have one now"), "{said}");
    fs::remove_dir_all(run.join("parts")).unwrap();
    assert_same(&at_once, &run);
}

#[test]
fn parts_that_are_not_the_run_are_refused_by_name() {
    let root = tempfile::tempdir().unwrap();
    let run = recorded(&root.path().join("run"));
    let folders = parts(&run, &root.path().join("parts"), 2);
    let [one, two] = [&folders[0], &folders[1]];

    let again = root.path().join("again");
    measure(&run, "1/2", &again);
    let said = refusal(&run, &[one.clone(), two.clone(), again]);
    assert!(said.contains("part 1/2 in") && said.contains("is given twice"), "{said}");

    let third = root.path().join("third");
    measure(&run, "1/3", &third);
    let said = refusal(&run, &[third, two.clone()]);
    assert!(said.contains("is one of 2, unlike part 1/3"), "{said}");

    // A file of results that is there twice, and one that is lost.
    let doubled = copied(two, &root.path().join("doubled"));
    fs::copy(doubled.join("velocity_000001.nc"), doubled.join("velocity_000001_2.nc")).unwrap();
    let said = refusal(&run, &[one.clone(), doubled.clone()]);
    assert!(said.contains("shot 1 is in more than one place: part 2/2 in"), "{said}");
    for name in ["velocity_000001.nc", "velocity_000001_2.nc"] {
        fs::remove_file(doubled.join(name)).unwrap();
    }
    let said = refusal(&run, &[one.clone(), doubled.clone()]);
    assert!(said.contains("part 2/2 in") && said.contains("3 of 3 shots not measured"), "{said}");
    fs::copy(one.join("velocity_000000.nc"), doubled.join("velocity_000000.nc")).unwrap();
    let said = refusal(&run, &[one.clone(), doubled]);
    assert!(said.contains("holds shot 0, which is not of this part"), "{said}");

    // What a part of another version, or another choice of the model, says of itself.
    for (key, reason) in [
        ("code_version", "was measured by lfpiv other, and this is"),
        ("model_sha256", "was measured with another forward model than part 1/2"),
    ] {
        let foreign = copied(two, &root.path().join(key));
        let file = foreign.join("part.json");
        let text = fs::read_to_string(&file).unwrap();
        let own = text.split(&format!("\"{key}\": \"")).nth(1).unwrap().split('"').next().unwrap();
        fs::write(&file, text.replacen(own, "other", 1)).unwrap();
        let said = refusal(&run, &[one.clone(), foreign]);
        assert!(said.contains("part 2/2 in") && said.contains(reason), "{said}");
    }

    let other = recorded(&root.path().join("run"));
    let foreign = root.path().join("foreign");
    measure(&other, "2/2", &foreign);
    let said = refusal(&run, &[one.clone(), foreign]);
    assert!(said.contains("part 2/2 in") && said.contains("is of another run"), "{said}");

    let changed = root.path().join("changed");
    fs::create_dir_all(&changed).unwrap();
    let config = configuration(&changed, MODEL);
    let written = fs::read_to_string(&config).unwrap();
    fs::write(&config, written.replacen("median_threshold = 2.0", "median_threshold = 3.0", 1))
        .unwrap();
    let changed = finished_run(&config, "2");
    remove_results(&changed);
    let foreign = root.path().join("otherwise");
    measure(&changed, "2/2", &foreign);
    let said = refusal(&run, &[one.clone(), foreign]);
    assert!(said.contains("was measured with another configuration than the run's"), "{said}");

    let said = refusal(&run, &[other]);
    assert!(said.contains("is no part of a run"), "{said}");
    let output = lfpiv(&["process", path(&run), "--part", "1/2", "--out", path(two)]);
    assert!(text(&output.stderr).contains("holds part 2/2"), "{}", text(&output.stderr));
    let (success, said) = merge(&run, &folders);
    assert!(success, "{said}");
}

#[test]
fn a_part_that_is_cut_off_is_named_and_goes_on() {
    let root = tempfile::tempdir().unwrap();
    let config = configuration(root.path(), MODEL);
    let slow = fs::read_to_string(&config).unwrap();
    fs::write(&config, slow.replacen("refinement = 2", "refinement = 4\npasses = 60", 1)).unwrap();
    let run = finished_run(&config, &SHOTS.to_string());
    remove_results(&run);
    let at_once = copied(&run, &root.path().join("at_once"));
    assert!(lfpiv(&["process", path(&at_once)]).status.success());
    let folders = ["1", "2"].map(|k| root.path().join("parts").join(k)).to_vec();
    measure(&run, "2/2", &folders[1]);

    // What is killed has sealed nothing; what is told to stop seals what it has.
    for signal in ["TERM", "KILL"] {
        let mut command = Command::new(env!("CARGO_BIN_EXE_lfpiv"));
        command.args(["process", path(&run), "--part", "1/2", "--out", path(&folders[0])]);
        let mut child = command.stdout(Stdio::null()).stderr(Stdio::null()).spawn().unwrap();
        let began = Instant::now();
        let measured = || {
            let names = fs::read_dir(&folders[0]).into_iter().flatten();
            names
                .filter(|entry| {
                    entry.as_ref().unwrap().path().extension().is_some_and(|of| of == "vti")
                })
                .count()
        };
        let before = measured();
        while measured() == before {
            assert!(began.elapsed() < PATIENCE);
            std::thread::sleep(Duration::from_millis(1));
        }
        let kill = format!("kill -{signal} {}", child.id());
        assert!(Command::new("sh").args(["-c", &kill]).status().unwrap().success());
        assert!(!child.wait().unwrap().success());
        let said = refusal(&run, &folders);
        assert!(said.contains("part 1/2 in") && said.contains("was cut off"), "{said}");
        assert!(said.contains("--part 1/2 --out"), "{said}");
    }
    measure(&run, "1/2", &folders[0]);
    let (success, said) = merge(&run, &folders);
    assert!(success, "{said}");
    assert_same(&at_once, &run);
}

/// The first shot is lost: the second one decides the forward model, for the parts without it, too.
#[test]
fn what_is_lost_is_lost_in_parts_as_at_once() {
    let root = tempfile::tempdir().unwrap();
    let run = recorded(root.path());
    let shots = RecordedRun::open(&run).unwrap().index().shots;
    let place = shots[&0].frames[1][0];
    let segment = run.join(format!("raw/segment_{:06}.raw", place.segment));
    let mut bytes = fs::read(&segment).unwrap();
    bytes[place.offset as usize + 5000] ^= 1;
    fs::write(&segment, bytes).unwrap();
    let at_once = copied(&run, &root.path().join("at_once"));
    let output = lfpiv(&["process", path(&at_once)]);
    assert_eq!(output.status.code(), Some(3), "{}", text(&output.stderr));

    let folders: Vec<PathBuf> = (1..=3).map(|k| root.path().join(format!("part{k}"))).collect();
    let codes = (1..).zip(&folders).map(|(k, folder)| {
        let part = format!("{k}/3");
        lfpiv(&["process", path(&run), "--part", &part, "--out", path(folder)]).status.code()
    });
    assert_eq!(codes.collect::<Vec<_>>(), [Some(3), Some(0), Some(0)]);
    let merging =
        ["process", path(&run), "--merge", path(&folders[0]), path(&folders[1]), path(&folders[2])];
    let merged = lfpiv(&merging);
    assert_eq!(merged.status.code(), Some(3), "{}", text(&merged.stderr));
    assert!(text(&merged.stderr).contains("shot 0"), "{}", text(&merged.stderr));
    assert_same(&at_once, &run);
    for folder in folders {
        let part = fs::read_to_string(folder.join("part.json")).unwrap();
        let part: serde_json::Value = serde_json::from_str(&part).unwrap();
        assert_eq!(part["decision"]["shot"], 1, "{part}");
    }
}

/// The script for Slurm, as each task of an array runs it.
#[test]
fn the_script_for_a_job_array_measures_its_part() {
    let root = tempfile::tempdir().unwrap();
    let run = recorded(root.path());
    let script = Path::new(env!("CARGO_MANIFEST_DIR")).join("docs/process-run.sbatch");
    let program = Path::new(env!("CARGO_BIN_EXE_lfpiv")).parent().unwrap();
    let search = format!("{}:{}", program.display(), std::env::var("PATH").unwrap());
    for k in ["1", "2"] {
        let mut task = Command::new("bash");
        task.arg(&script).args([path(&run), "2"]).env("PATH", &search);
        let output = task.env("SLURM_ARRAY_TASK_ID", k).output().unwrap();
        assert!(output.status.success(), "{}", text(&output.stderr));
    }
    let (success, said) = merge(&run, &[]);
    assert!(success && said.contains("7 have one now"), "{said}");
}

/// A merge that is killed goes on where it was.
#[test]
fn a_merge_that_is_cut_off_goes_on() {
    let root = tempfile::tempdir().unwrap();
    let run = recorded(root.path());
    let at_once = copied(&run, &root.path().join("at_once"));
    assert!(lfpiv(&["process", path(&at_once)]).status.success());
    let folders = parts(&run, &root.path().join("parts"), 2);
    // As it is when one part is copied and the other is not.
    let name = "velocity_000000.nc";
    fs::copy(folders[0].join(name), run.join(name)).unwrap();
    let said = refusal(&run, &folders);
    assert!(said.contains("shot 0 is in more than one place"), "{said}");
    let merging: String = folders
        .iter()
        .map(|folder| format!("{}\n", folder.canonicalize().unwrap().display()))
        .collect();
    fs::write(run.join("merging_parts"), merging).unwrap();
    let said = refusal(&run, &folders[..1]);
    assert!(said.contains("the merge of other parts was cut off"), "{said}");
    let (success, said) = merge(&run, &folders);
    assert!(success, "{said}");
    assert_same(&at_once, &run);
}

#[test]
fn a_merge_survives_kills_at_any_moment() {
    let root = tempfile::tempdir().unwrap();
    let recorded = recorded(root.path());
    let at_once = copied(&recorded, &root.path().join("at_once"));
    assert!(lfpiv(&["process", path(&at_once)]).status.success());
    let folders = parts(&recorded, &root.path().join("parts"), 3);
    let mut cut_off = 0;
    for turn in 0..8 {
        let run = copied(&recorded, &root.path().join(format!("run{turn}")));
        for kill in 0..2 {
            let mut command = Command::new(env!("CARGO_BIN_EXE_lfpiv"));
            command.args(["process", path(&run), "--merge"]).args(&folders);
            let mut child = command.stdout(Stdio::null()).stderr(Stdio::null()).spawn().unwrap();
            std::thread::sleep(Duration::from_millis(5 + 7 * turn + 11 * kill));
            child.kill().unwrap();
            child.wait().unwrap();
            cut_off += u32::from(run.join("merging_parts").exists());
        }
        let (success, said) = merge(&run, &folders);
        // One that was over before it was killed is not made again.
        assert!(success || said.contains("is in more than one place"), "{said}");
        assert_same(&at_once, &run);
    }
    println!("{cut_off} of 16 merges were cut off while they copied");
}
