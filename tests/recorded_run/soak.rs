//! Hundreds of shots: memory does not grow; prints the bench's throughput.

use std::{
    fs,
    time::{Duration, Instant},
};

use serde_json::Value;

use crate::bench::{Running, configuration, images};

/// Shots after which memory has settled: pools and tables are full, and a first segment of results
/// is sealed.
const SETTLED: u64 = 700;
/// Allowed growth after that: allocators are not exact.
const GROWTH_BYTES: u64 = 8 << 20;
/// Longest time without another shot.
const PATIENCE: Duration = Duration::from_secs(120);

/// Resident memory of a process, in bytes.
fn resident_bytes(process: u32) -> u64 {
    let status = fs::read_to_string(format!("/proc/{process}/status")).expect("its status");
    let line = status.lines().find_map(|line| line.strip_prefix("VmRSS:")).expect("its memory");
    let kilobytes: u64 = line.trim().trim_end_matches(" kB").parse().expect("a number");
    kilobytes << 10
}

fn count(status: &Value, name: &str) -> u64 {
    status["shots"][name].as_u64().unwrap_or(0)
}

#[test]
fn shots_in_flat_memory() {
    // Coarse voxels: half the time.
    in_flat_memory(1000, 1);
}

#[test]
#[ignore = "long: make soak"]
fn long_five_thousand_shots_in_flat_memory() {
    in_flat_memory(5000, 2);
}

fn in_flat_memory(shots: u64, refinement: u32) {
    let root = tempfile::tempdir().expect("a folder");
    let config = configuration(root.path(), "[raw_log]\nsegment_mb = 20\n");
    let text = fs::read_to_string(&config).expect("the configuration");
    let tiny = text
        .replacen("columns = 13\nrows = 13", "columns = 5\nrows = 5", 1)
        .replacen("columns = 240\nrows = 240", "columns = 92\nrows = 92", 1)
        .replacen("voxels = [8, 8, 8]", "voxels = [4, 4, 4]", 1)
        .replacen("refinement = 2", &format!("refinement = {refinement}"), 1)
        .replacen("window_mm = 0.8", "window_mm = 0.4", 1);
    fs::write(&config, tiny).expect("the configuration");
    let running = Running::start(&config, &["--shots", &shots.to_string()]);
    let process = running.child.id();
    let (began, mut settled, mut most, mut deepest) = (Instant::now(), 0, 0, 0);
    let (mut last, mut last_done) = (Value::Null, (0, Instant::now()));
    while let Some(status) = running.get("/api/v1/status") {
        let (done, resident) = (count(&status, "done"), resident_bytes(process));
        if done >= SETTLED && settled == 0 {
            settled = resident;
        }
        (most, deepest) = (most.max(resident), deepest.max(count(&status, "queued")));
        if done > last_done.0 {
            last_done = (done, Instant::now());
        }
        assert!(last_done.1.elapsed() < PATIENCE, "{status}");
        if done < shots {
            last = status;
        }
        std::thread::sleep(Duration::from_millis(50));
    }
    let seconds = began.elapsed().as_secs_f64();
    let run = running.kill();
    let latency = &last["latency"];
    println!(
        "{shots} shots in {seconds:.0} s: {:.1} acquired and processed per second, queue {deepest} \
         deep at most; from trigger to velocity p50 {:.3}, p95 {:.3}, p99 {:.3} s; memory {:.1} MB \
         after {SETTLED} shots, {:.1} MB at most",
        shots as f64 / seconds,
        latency["p50_s"].as_f64().unwrap_or(f64::NAN),
        latency["p95_s"].as_f64().unwrap_or(f64::NAN),
        latency["p99_s"].as_f64().unwrap_or(f64::NAN),
        settled as f64 / 1e6,
        most as f64 / 1e6,
    );
    assert!(settled > 0 && most < settled + GROWTH_BYTES, "{settled} grew to {most}");
    assert_eq!(images(&run).len() as u64, shots);
}

/// A bench in real time whose shots are shed if processing is slower; for its figures.
#[test]
fn ten_shots_a_second_in_real_time() {
    let root = tempfile::tempdir().expect("a folder");
    let small = std::path::Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/data/small.toml");
    let results = format!("dir = \"{}\"", root.path().join("results").display());
    let text = fs::read_to_string(small).expect("small.toml");
    let config = root.path().join("bench.toml");
    fs::write(&config, text.replacen("dir = \"results\"", &results, 1)).expect("a file");
    let running = Running::start(&config, &[]);
    running.wait_until(|status| count(status, "triggered") > 5);
    let (began, first) = (Instant::now(), running.get("/api/v1/status").expect("a status"));
    let mut deepest = 0;
    while began.elapsed() < Duration::from_secs(2) {
        let status = running.get("/api/v1/status").expect("a status");
        deepest = deepest.max(count(&status, "queued"));
        std::thread::sleep(Duration::from_millis(100));
    }
    let seconds = began.elapsed().as_secs_f64();
    let measured = running.get("/api/v1/status").expect("a status");
    let since = |status: &Value| count(status, "done") - count(&first, "done");
    let mark = |status: &Value, name: &str| status["watermarks"][name].as_u64();
    let rate = |of: &dyn Fn(&Value) -> u64| (of(&measured) - of(&first)) as f64 / seconds;
    let acquired = rate(&|status| mark(status, "acquired").unwrap_or(0));
    let (processed, shed) = (rate(&|s| count(s, "done")), rate(&|s| count(s, "shed")));
    let raw = &measured["raw_log"];
    println!(
        "748 x 748 pixels, 24 x 20 x 16 voxels, 10 Hz asked for: {acquired:.1} shots/s acquired \
         while the same cores render them, {processed:.1} processed, {shed:.1} shed; queue {deepest} deep at most; latency {}; raw data {:.0} MB in, \
         {:.0} MB on disk; {}",
        measured["latency"],
        raw["bytes_in"].as_f64().unwrap_or(0.0) / 1e6,
        raw["bytes_written"].as_f64().unwrap_or(0.0) / 1e6,
        measured["watermarks"],
    );
    // On a busy machine it takes longer, but every stage makes progress.
    let goes_on = |status: &Value| since(status) > 0 && mark(status, "fsynced") > Some(0);
    let last = running.wait_until(goes_on);
    let marks = ["acquired", "paired", "written", "fsynced"].map(|name| mark(&last, name));
    assert!(marks.is_sorted_by(|earlier, later| earlier >= later), "{last}");
    let fsynced = mark(&last, "fsynced").expect("a count");
    let run = running.kill();
    assert!(images(&run).len() as u64 >= fsynced);
}
