//! SIGKILL at any moment: acknowledged data is on the disk, byte for byte.

use std::{
    collections::{BTreeMap, BTreeSet},
    path::Path,
    time::{Duration, Instant},
};

use lfpiv::{
    acquisition::journal::{Entry, RAW_FOLDER, RecordedRun},
    archive::StoredResults,
};
use lfpiv_hw::RawImage;
use lfpiv_rawlog::recover;
use rand::{RngExt, SeedableRng};
use rand_pcg::Pcg64Mcg;

use crate::bench::{Running, configuration, finished_run, images, lfpiv, text};

/// Shots of the reference run; killed runs are shorter.
const REFERENCE_SHOTS: &str = "120";
/// Small segments and frequent syncs, so that kills hit every stage of writing.
const RAW_LOG: &str = "[raw_log]\nsegment_mb = 2\nsync_ms = 5\n";

/// Checks that everything acknowledged is there, and that all data is as the cameras delivered it.
fn assert_kept(
    run: &Path,
    acknowledged: &BTreeSet<u64>,
    reference: &BTreeMap<u64, Vec<[RawImage; 2]>>,
) -> usize {
    let kept: BTreeMap<u64, _> = images(run).into_iter().collect();
    let lost: Vec<&u64> = acknowledged.iter().filter(|shot| !kept.contains_key(shot)).collect();
    assert!(lost.is_empty(), "{}: shots {lost:?} were acknowledged", run.display());
    for (shot, images) in &kept {
        assert!(images == &reference[shot], "{}: shot {shot} is another", run.display());
    }
    kept.len()
}

/// Waits until this many shots are synced; returns their number then.
fn fsynced_from(running: &Running, shots: u64) -> usize {
    let fsynced = |status: &serde_json::Value| status["watermarks"]["fsynced"].as_u64();
    let status = running.wait_until(|status| fsynced(status) >= Some(shots));
    fsynced(&status).expect("a count") as usize
}

#[test]
fn acknowledged_data_survives_kills() {
    acknowledged_data_survives(10);
}

#[test]
#[ignore = "long: make soak"]
fn long_acknowledged_data_survives_fifty_kills() {
    acknowledged_data_survives(50);
}

fn acknowledged_data_survives(kills: u64) {
    let root = tempfile::tempdir().expect("a folder");
    let config = configuration(root.path(), RAW_LOG);
    let reference: BTreeMap<u64, _> =
        images(&finished_run(&config, REFERENCE_SHOTS)).into_iter().collect();
    let (mut acknowledged, mut kept, mut torn) = (0, 0, 0);
    let mut last = None;
    for seed in 0..kills {
        let mut random = Pcg64Mcg::seed_from_u64(seed);
        let running = Running::start(&config, &["--shots", REFERENCE_SHOTS]);
        // This many shots, however long they take, and a moment more.
        let shots = random.random_range(0..12);
        let more = Duration::from_micros(random.random_range(0..100_000));
        let promised = if shots > 0 { fsynced_from(&running, shots) } else { 0 };
        let synced = running.acknowledged_until(Instant::now() + more);
        let run = running.kill();
        let raw = run.join(RAW_FOLDER);
        let recovery = recover(&raw).expect("a log that can be recovered");
        torn += recovery.segments.iter().filter(|segment| segment.torn.is_some()).count();
        assert!(recover(&raw).expect("once more").segments.is_empty(), "recovered once for all");
        let kept_of_run = assert_kept(&run, &synced, &reference);
        assert!(kept_of_run >= promised, "{kept_of_run} of {promised}");
        acknowledged += promised.max(synced.len());
        kept += kept_of_run;
        if promised > 3 {
            last = Some(run);
        }
    }
    println!(
        "{kills} kills: {acknowledged} shots acknowledged as synced, all there; {kept} there in \
         all, every byte as delivered; {torn} torn tails cut"
    );
    assert!(acknowledged as u64 > 2 * kills, "the kills come too early to say anything");
    let last = last.expect("a run that came far enough");
    // The next run reports what an earlier one has left to do.
    let config = config.to_str().expect("a path in UTF-8");
    let next = lfpiv(&["run", "--config", config, "--shots", "1"]);
    let advice = format!("lfpiv process {}", last.display());
    assert!(text(&next.stderr).contains(&advice), "{}", text(&next.stderr));
    finish_twice(&last);
}

/// Checks that `lfpiv process` measures shots without a result, once.
fn finish_twice(run: &Path) {
    let folder = run.to_str().expect("a path in UTF-8");
    let shots = images(run).len();
    for had in [None, Some(shots)] {
        let output = lfpiv(&["process", folder]);
        let said = text(&output.stdout);
        let warned = text(&output.stderr);
        assert!(output.status.success() && warned.contains("was cut off"), "{warned}");
        assert!(said.contains(&format!("{shots} have one now")), "{said}");
        let before = had.map(|shots| format!(" {shots} had a result"));
        assert!(before.is_none_or(|words| said.contains(&words)), "{said}");
    }
    let stored = StoredResults::find(run).expect("results");
    assert_eq!(stored.shots.len(), shots);
    assert_eq!(stored.records, shots, "no result is there twice");
    let ledger = std::fs::read_to_string(run.join("ledger.json")).expect("a ledger");
    let ledger: serde_json::Value = serde_json::from_str(&ledger).expect("JSON");
    assert_eq!(ledger["balanced"], true);
    assert!(ledger["error"].as_str().is_some_and(|error| error.contains("cut off")), "{ledger}");
}

/// A run killed in the middle of a burst has counted the triggers given, and reports no other
/// trigger as shed.
#[test]
fn a_killed_run_counts_what_was_fired() {
    let root = tempfile::tempdir().expect("a folder");
    let config = configuration(root.path(), "");
    let running = Running::start(&config, &[]);
    running.wait_until(|status| status["shots"]["done"].as_u64() > Some(7));
    let run = running.kill();
    let folder = run.to_str().expect("a path in UTF-8");
    let output = lfpiv(&["process", folder]);
    assert!(output.status.success(), "{}", text(&output.stderr));
    let recorded = RecordedRun::open(&run).expect("a recorded run");
    // Evidence in the record: triggers announced as given, and two frames per trigger of either
    // camera; of the last one perhaps only the first.
    let (mut given, mut frames) = (0, [0_u64; 2]);
    for placed in recorded.entries() {
        match placed.expect("an entry").entry {
            Entry::Frame { camera, .. } => frames[camera] += 1,
            Entry::Given { trigger } => given = given.max(trigger + 1),
            _ => {}
        }
    }
    let seen = frames.map(|frames| frames.div_ceil(2)).into_iter().fold(given, u64::max);
    let ledger = std::fs::read_to_string(run.join("ledger.json")).expect("a ledger");
    let ledger: serde_json::Value = serde_json::from_str(&ledger).expect("JSON");
    for camera in ledger["cameras"].as_array().expect("cameras") {
        let of = |outcome: &str| camera["outcomes"][outcome].as_u64().unwrap_or_default();
        let taken = of("shed") + of("complete");
        assert!(taken > 7 && taken <= seen, "{seen} triggers were seen: {camera}");
    }
}

/// Shots that the daemon reports as processed are recorded, whatever happens next.
#[test]
fn processed_shots_are_recorded_after_a_kill() {
    processed_shots_are_recorded(6);
}

#[test]
#[ignore = "long: make soak"]
fn long_processed_shots_are_recorded_after_twenty_kills() {
    processed_shots_are_recorded(20);
}

fn processed_shots_are_recorded(kills: u64) {
    let root = tempfile::tempdir().expect("a folder");
    let config = configuration(root.path(), RAW_LOG);
    for seed in 0..kills {
        let mut random = Pcg64Mcg::seed_from_u64(seed);
        let running = Running::start(&config, &["--shots", REFERENCE_SHOTS]);
        let end = Instant::now() + Duration::from_micros(random.random_range(200_000..900_000));
        let mut processed = 0;
        while Instant::now() < end {
            let Some(status) = running.get("/api/v1/status") else { continue };
            processed = status["watermarks"]["processed"].as_u64().unwrap_or(processed);
        }
        let run = running.kill();
        recover(&run.join(RAW_FOLDER)).expect("a log that can be recovered");
        let recorded = images(&run).len() as u64;
        assert!(processed <= recorded, "{processed} processed, {recorded} recorded");
    }
}
