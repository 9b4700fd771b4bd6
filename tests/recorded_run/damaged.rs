//! Damaged or incomplete records: every command reads around the damage, reports losses, and ends
//! with exit code 3.

use std::{
    collections::BTreeSet,
    fs,
    path::{Path, PathBuf},
    process::Command,
};

use lfpiv::acquisition::journal::RecordedRun;
use lfpiv_rawlog::{Position, RawLogReader};

use crate::bench::{configuration, finished_run, lfpiv, text};

const SHOTS: u64 = 12;
const DAMAGED: i32 = 3;

fn copy(run: &Path, to: &Path) {
    assert!(Command::new("cp").arg("-r").args([run, to]).status().expect("cp").success());
}

fn segment(run: &Path, number: u32) -> PathBuf {
    run.join(format!("raw/segment_{number:06}.raw"))
}

fn change(path: &Path, change: impl FnOnce(&mut Vec<u8>)) {
    let mut bytes = fs::read(path).expect("a segment");
    change(&mut bytes);
    fs::write(path, bytes).expect("a segment");
}

/// Positions of the records with an image.
fn frames(run: &Path) -> Vec<Position> {
    let heads = RawLogReader::open(&run.join("raw")).expect("a log").heads().map(Result::unwrap);
    heads.filter(|(.., has_image)| *has_image).map(|(_, position, ..)| position).collect()
}

/// Shots that can no longer be read.
fn lost(run: &Path) -> BTreeSet<u64> {
    let recorded = RecordedRun::open(run).expect("a run").finished();
    let shots = recorded.index().shots;
    let whole = shots.values().filter(|shot| recorded.pair(shot).is_ok());
    let whole: BTreeSet<u64> = whole.map(|shot| shot.trigger).collect();
    (0..SHOTS).filter(|shot| !whole.contains(shot)).collect()
}

/// Output and exit code of each command for a run.
fn read_by_all(run: &Path, out: &Path) -> Vec<(&'static str, Option<i32>, String)> {
    let (pairs, again) = (out.join("pairs"), out.join("again"));
    let [run, pairs, again] =
        [run, &pairs, &again].map(|path| path.to_str().expect("a path in UTF-8"));
    let commands = [
        ("export", vec!["export", "--out", pairs, run]),
        ("replay", vec!["replay", "--out", again, run]),
        ("process", vec!["process", run]),
    ];
    commands
        .into_iter()
        .map(|(name, arguments)| {
            let output = lfpiv(&arguments);
            let said = format!("{}{}", text(&output.stdout), text(&output.stderr));
            (name, output.status.code(), said)
        })
        .collect()
}

/// A kind of damage, and the number of shots that it may cost.
struct Harm {
    name: &'static str,
    harm: fn(&Path, &[Position]),
    costs: std::ops::RangeInclusive<usize>,
}

const HARMS: [Harm; 7] = [
    Harm { name: "none", harm: |_, _| {}, costs: 0..=0 },
    Harm {
        name: "a bit of the first image",
        harm: |run, frames| {
            change(&segment(run, frames[0].segment), |bytes| {
                bytes[frames[0].offset as usize + 1000] ^= 4;
            });
        },
        costs: 1..=1,
    },
    Harm {
        name: "a bit of a record's header",
        harm: |run, frames| {
            let frame = frames[frames.len() / 2];
            change(&segment(run, frame.segment), |bytes| bytes[frame.offset as usize + 9] ^= 1);
        },
        costs: 1..=1,
    },
    Harm {
        name: "a bit of the first header's version",
        harm: |run, _| change(&segment(run, 0), |bytes| bytes[8] ^= 4),
        costs: 0..=0,
    },
    Harm {
        name: "a segment cut",
        harm: |run, _| change(&segment(run, 1), |bytes| bytes.truncate(bytes.len() / 2)),
        costs: 1..=6,
    },
    Harm {
        name: "a segment lost",
        harm: |run, _| fs::remove_file(segment(run, 1)).expect("a segment"),
        costs: 1..=6,
    },
    Harm {
        name: "the last segment lost",
        harm: |run, frames| {
            let last = frames.last().expect("a frame").segment;
            fs::remove_file(segment(run, last)).expect("a segment");
            let _ = fs::remove_file(segment(run, last + 1));
        },
        costs: 1..=6,
    },
];

#[test]
fn every_command_reads_around_damage_names_it_and_says_so_with_its_exit_code() {
    let root = tempfile::tempdir().expect("a folder");
    let config = configuration(root.path(), "[raw_log]\nsegment_mb = 1\ncodec = \"raw\"\n");
    let run = finished_run(&config, &SHOTS.to_string());
    let places = frames(&run);
    assert!(places.last().expect("a frame").segment >= 3, "too few segments to lose one");
    for (number, Harm { name, harm, costs }) in HARMS.iter().enumerate() {
        let out = root.path().join(number.to_string());
        fs::create_dir(&out).expect("a folder");
        let harmed = out.join("run");
        copy(&run, &harmed);
        harm(&harmed, &places);
        let lost = lost(&harmed);
        assert!(costs.contains(&lost.len()), "{name}: {lost:?}");
        for (command, code, said) in read_by_all(&harmed, &out) {
            // Images of shots with a result are not read again.
            let is_seen = *name != "none" && !(command == "process" && name.contains("image"));
            let wanted = if is_seen { DAMAGED } else { 0 };
            assert_eq!(code, Some(wanted), "{command}, {name}: {said}");
            for shot in lost.iter().filter(|_| is_seen) {
                assert!(said.contains(&format!("shot {shot}: ")), "{command}, {name}: {said}");
            }
            assert_eq!(said.contains("damaged"), is_seen, "{command}, {name}: {said}");
        }
        let exported = fs::read_dir(out.join("pairs")).expect("pairs").flatten();
        let pairs = exported.filter(|entry| entry.path().is_dir()).count() as u64;
        assert_eq!(pairs, SHOTS - lost.len() as u64, "{name}");
    }
}

#[test]
fn a_run_of_version_1_that_was_cut_short_is_read_as_far_as_it_goes() {
    let root = tempfile::tempdir().expect("a folder");
    let run = root.path().join("run");
    let fixtures = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/fixtures");
    copy(&fixtures.join("recorded_run_v1"), &run);
    change(&segment(&run, 0), |bytes| bytes.truncate(bytes.len() * 3 / 4));
    let out = root.path().join("pairs");
    let output = lfpiv(&["export", "--out", out.to_str().unwrap(), run.to_str().unwrap()]);
    let said = text(&output.stderr);
    assert_eq!(output.status.code(), Some(DAMAGED), "{said}");
    assert!(said.contains("shot 1: ") && said.contains("segment_000000.raw"), "{said}");
    assert!(out.join("shot_000000").is_dir());
}

#[test]
fn a_damaged_shot_without_a_result_is_reported_and_the_others_are_measured() {
    let root = tempfile::tempdir().expect("a folder");
    let config = configuration(root.path(), "");
    let run = finished_run(&config, "4");
    let places = frames(&run);
    for entry in fs::read_dir(&run).expect("a run").flatten() {
        if entry.path().extension().is_some_and(|of| of == "nc") {
            fs::remove_file(entry.path()).expect("a result");
        }
    }
    change(&segment(&run, 0), |bytes| bytes[places[0].offset as usize + 1000] ^= 4);
    let output = lfpiv(&["process", run.to_str().unwrap()]);
    let said = text(&output.stderr);
    assert_eq!(output.status.code(), Some(DAMAGED), "{said}");
    assert!(said.contains("shot 0: ") && said.contains("from byte"), "{said}");
    assert!(text(&output.stdout).contains("3 have one now"), "{}", text(&output.stdout));
    // The others are unchanged.
    assert_eq!(lost(&run), (0..1).chain(4..SHOTS).collect::<BTreeSet<_>>());
}

#[test]
fn a_damaged_ledger_is_named_and_made_again_from_the_record() {
    let root = tempfile::tempdir().expect("a folder");
    let run = finished_run(&configuration(root.path(), ""), "3");
    let path = run.join("ledger.json");
    let triggers = || -> serde_json::Value {
        let ledger = fs::read(&path).expect("a ledger");
        let ledger: serde_json::Value = serde_json::from_slice(&ledger).expect("JSON");
        assert_eq!(ledger["error"], serde_json::Value::Null);
        ledger["cameras"].clone()
    };
    let whole = triggers();
    change(&path, |bytes| bytes.truncate(bytes.len() / 2));
    let process = || lfpiv(&["process", run.to_str().unwrap()]);
    let first = process();
    let said = text(&first.stderr);
    assert_eq!(first.status.code(), Some(DAMAGED), "{said}");
    assert!(said.contains("ledger.json is not a ledger"), "{said}");
    assert!(said.contains("ledger.json.damaged"), "{said}");
    assert_eq!(triggers(), whole);
    assert!(run.join("ledger.json.damaged").exists());
    assert_eq!(process().status.code(), Some(0));
}

/// A pipe in place of a file of the run: every command ends by itself and names the file.
#[test]
fn a_pipe_in_the_folder_of_a_run_is_not_waited_for() {
    let root = tempfile::tempdir().expect("a folder");
    let whole = finished_run(&configuration(root.path(), ""), "2");
    let results = fs::read_dir(&whole).expect("a run").flatten().map(|entry| entry.file_name());
    let mut results = results.map(|name| name.into_string().expect("a name in UTF-8"));
    let stored = results.find(|name| name.ends_with(".nc")).expect("results");
    let (out, run) = (root.path().join("out"), root.path().join("run"));
    let [out, run_text] = [&out, &run].map(|path| path.to_str().expect("a path in UTF-8"));
    for name in ["raw/segment_000000.raw", "ledger.json", &stored] {
        copy(&whole, &run);
        let pipe = run.join(name);
        fs::remove_file(&pipe).expect("a file of the run");
        assert!(Command::new("mkfifo").arg(&pipe).status().expect("mkfifo").success());
        for arguments in [
            &["export", "--out", out, run_text][..],
            &["process", run_text],
            &["replay", "--out", out, run_text],
            &["compare", run_text, run_text],
        ] {
            // `timeout` kills a hanging command and exits with 124.
            let limited = Command::new("timeout")
                .args(["300", env!("CARGO_BIN_EXE_lfpiv")])
                .args(arguments)
                .output()
                .expect("timeout");
            let said = text(&limited.stderr);
            assert!(matches!(limited.status.code(), Some(0 | 1 | 3)), "{name}: {said}");
            let is_read = match arguments[0] {
                "export" => !name.ends_with(".nc"),
                "compare" => !name.starts_with("raw"),
                _ => true,
            };
            let words = "it is not a regular file";
            assert_eq!(said.contains(words), is_read, "{name}, {}: {said}", arguments[0]);
        }
        fs::remove_dir_all(&run).expect("a run");
    }
}
