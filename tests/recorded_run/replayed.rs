//! A replay of a recorded run: the same vectors, bit for bit, and the same ledger.

use std::{fs, path::Path, process::Command};

use lfpiv::archive::StoredResults;
use lfpiv_rawlog::{RawLog, RawLogReader, RawLogSettings};

use crate::bench::{configuration, finished_run, images, lfpiv, text};

#[test]
fn a_replay_gives_the_same_vectors_and_the_same_ledger() {
    let root = tempfile::tempdir().expect("a folder");
    let run = finished_run(&configuration(root.path(), ""), "30");
    let out = root.path().join("again");
    for speed in ["max", "1"] {
        let arguments =
            ["replay", "--speed", speed, "--out", out.to_str().unwrap(), run.to_str().unwrap()];
        let output = lfpiv(&arguments);
        let said = text(&output.stdout);
        assert!(output.status.success(), "{said}{}", text(&output.stderr));
        assert!(said.contains("30 shots compared with"), "{said}");
        assert!(said.contains("0 different") && said.contains("ledgers are the same"), "{said}");
        let again = said.lines().find_map(|line| line.strip_prefix("results are in ")).unwrap();
        let times_s = |run: &Path| StoredResults::find(run).unwrap().times_s;
        assert_eq!(times_s(Path::new(again)), times_s(&run));
        assert_eq!(times_s(&run).len(), 30);
    }
}

#[test]
fn a_replay_with_faults_reports_their_outcomes() {
    let root = tempfile::tempdir().expect("a folder");
    let run = finished_run(&configuration(root.path(), ""), "16");
    let faults = root.path().join("faults.toml");
    fs::write(&faults, "seed = 3\n[camera.shares]\ndropped = 0.1\ntruncated = 0.1\n").unwrap();
    let out = root.path().join("again");
    let output = lfpiv(&[
        "replay",
        "--faults",
        faults.to_str().unwrap(),
        "--out",
        out.to_str().unwrap(),
        run.to_str().unwrap(),
    ]);
    assert!(output.status.success(), "{}", text(&output.stderr));
    let again = fs::read_dir(&out).unwrap().next().unwrap().unwrap().path();
    let ledger = fs::read(again.join("ledger.json")).unwrap();
    let ledger: serde_json::Value = serde_json::from_slice(&ledger).unwrap();
    assert_eq!(ledger["balanced"], true);
    let outcomes = &ledger["cameras"][0]["outcomes"];
    let missing = outcomes["missing_packets"].as_u64().unwrap();
    assert!((1..8).contains(&missing), "{outcomes}");
    assert_eq!(ledger["cameras"][0]["triggers"], 16);
}

#[test]
fn a_record_that_is_changed_is_found_out() {
    let root = tempfile::tempdir().expect("a folder");
    let run = finished_run(&configuration(root.path(), ""), "3");
    assert_eq!(images(&run).len(), 3);
    let segment = run.join("raw/segment_000000.raw");
    let mut bytes = fs::read(&segment).unwrap();
    let middle = bytes.len() / 2;
    bytes[middle] ^= 0x10;
    fs::write(&segment, bytes).unwrap();
    let output = lfpiv(&["process", run.to_str().unwrap()]);
    let said = text(&output.stderr);
    let replayed = lfpiv(&["replay", run.to_str().unwrap()]);
    assert!(!replayed.status.success() || !output.status.success(), "{said}");
    assert!(text(&replayed.stderr).contains("segment_000000.raw"), "{}", text(&replayed.stderr));
}

/// Regression: with an inconsistent record (with valid checksums) the run loop waited for a burst
/// for ever.
#[test]
fn the_end_of_a_burst_without_a_start_does_not_block_a_replay() {
    let root = tempfile::tempdir().expect("a folder");
    let run = finished_run(&configuration(root.path(), ""), "2");
    let reader = RawLogReader::open(&run.join("raw")).expect("a log");
    let (again, settings) = (root.path().join("run"), RawLogSettings::default());
    fs::create_dir(&again).expect("a folder");
    let (log, writer) =
        RawLog::create(&again.join("raw"), reader.description(), &settings).expect("a log");
    let mut ends = 0;
    for record in reader.records() {
        let record = record.expect("a record").1;
        let entry: serde_json::Value = serde_json::from_slice(&record.head).expect("JSON");
        if entry["entry"] == "burst_ended" {
            ends += 1;
            log.append_blocking(record.clone()).expect("room");
        }
        log.append_blocking(record).expect("room");
    }
    writer.close().expect("a closed log");
    assert!(ends > 0);
    // `timeout` kills a hanging command and exits with 124.
    let output = Command::new("timeout")
        .args(["300", env!("CARGO_BIN_EXE_lfpiv"), "replay", "--out"])
        .args([&root.path().join("out"), &again])
        .output()
        .expect("timeout");
    let said = text(&output.stderr);
    assert!(matches!(output.status.code(), Some(0 | 1 | 3)), "{:?}: {said}", output.status);
}

#[test]
fn the_ledger_and_the_record_say_the_same() {
    let root = tempfile::tempdir().expect("a folder");
    let run = finished_run(&configuration(root.path(), ""), "12");
    let accounts = || {
        let ledger = fs::read(run.join("ledger.json")).expect("a ledger");
        let ledger: serde_json::Value = serde_json::from_slice(&ledger).expect("JSON");
        (ledger["cameras"].clone(), ledger["streams"].clone())
    };
    let written_by_the_run = accounts();
    // Without it the ledger is rebuilt from the record.
    fs::remove_file(run.join("ledger.json")).expect("the ledger");
    let output = lfpiv(&["process", run.to_str().unwrap()]);
    assert!(output.status.success(), "{}", text(&output.stderr));
    assert_eq!(accounts(), written_by_the_run);
}
