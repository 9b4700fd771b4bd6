//! `lfpiv bench` on cases of a few thousand voxels: every measurement, every figure, every file.
//! What the figures say is not asserted, least of all how long things took. `lfpiv validate` refuses a bench that it
//! cannot compare.

#![allow(clippy::unwrap_used, reason = "clippy takes the helpers of a test for more than tests")]
#[allow(dead_code)]
#[path = "../../tests/support/mod.rs"]
mod support;

use std::{fs, path::Path};

use serde_json::Value;

const SUITE: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/smoke.toml");

/// Headings of the page that must be there when every measurement was made.
const SECTIONS: [&str; 20] = [
    "reached",
    "error-seconds",
    "quality-seconds",
    "quality-ppm",
    "quality-iterations",
    "error-iterations",
    "projections",
    "elongation",
    "vorticity",
    "slices",
    "error-ppm",
    "cumulative",
    "matrices",
    "process",
    "growth",
    "beside",
    "imperfect",
    "peers",
    "methods",
    "rows",
];

fn bench(out: &Path, more: &[&str]) -> support::Done {
    let out = out.display().to_string();
    let fixed = ["bench", "--suite", SUITE, "--out", &out];
    support::lfpiv(fixed.iter().chain(more))
}

/// Every number of a JSON value.
fn numbers(value: &Value, found: &mut Vec<f64>) {
    match value {
        Value::Number(number) => found.push(number.as_f64().unwrap()),
        Value::Array(values) => values.iter().for_each(|value| numbers(value, found)),
        Value::Object(map) => map.values().for_each(|value| numbers(value, found)),
        _ => {}
    }
}

#[test]
fn a_report_has_every_section_and_every_number_is_finite() {
    let folder = tempfile::tempdir().unwrap();
    let peers = folder.path().join("peers.json");
    let peer = r#"[
        {"case": "a", "method": "SART, full volume", "peer": "ASTRA", "threads": 1,
         "seconds": 9.0, "seconds_of": "solve", "q": 0.5},
        {"case": "a", "method": "os-mart", "peer": "lfpiv", "threads": 1, "seconds": 1.0, "q": 0.6},
        {"case": "b", "method": "single pass", "peer": "OpenPIV", "threads": 1, "seconds": 20.0,
         "vectors": 10, "mean_abs_error_vox": [0.2, 0.2, 0.2]},
        {"case": "b", "method": "single pass", "peer": "lfpiv", "threads": 1, "seconds": 1.0,
         "vectors": 10, "mean_abs_error_vox": [0.1, 0.1, 0.1]}]"#;
    fs::write(&peers, peer).unwrap();
    let out = folder.path().join("report");
    let done = bench(&out, &["--peers", &peers.display().to_string()]);
    assert!(done.success, "{}", done.stderr);

    let json: Value = serde_json::from_slice(&fs::read(out.join("report.json")).unwrap()).unwrap();
    let rows = json["rows"].as_array().unwrap();
    let cases: Vec<&str> = json["suite"]["case"]
        .as_array()
        .unwrap()
        .iter()
        .map(|c| c["name"].as_str().unwrap())
        .collect();
    for case in &cases {
        assert!(rows.iter().any(|row| row["case"] == *case), "{case} has no row");
    }
    for row in rows {
        for fact in ["machine", "version", "date", "method", "voxels"] {
            assert!(!row[fact].as_str().unwrap().is_empty(), "{fact} is missing: {row}");
        }
        assert!(row["threads"].as_u64().unwrap() > 0 && row["seed"].is_u64());
    }
    let mut found = Vec::new();
    numbers(&json, &mut found);
    assert!(found.len() > 1000 && found.iter().all(|number| number.is_finite()));
    let verdicts = json["reached"].as_array().unwrap();
    let verdict_on = |work: &str| {
        let bar = verdicts.iter().find(|bar| bar["work"].as_str().unwrap().contains(work)).unwrap();
        bar["verdict"].as_str().unwrap()
    };
    assert_eq!((verdict_on("ASTRA's SART"), verdict_on("OpenPIV")), ("missed", "met"));
    // ASTRA on active voxels is not among the peers' rows above.
    assert_eq!(verdicts.iter().filter(|bar| bar["verdict"] == "not-measured").count(), 1);

    let page = fs::read_to_string(out.join("report.html")).unwrap();
    for section in SECTIONS {
        assert!(page.contains(&format!("<h2 id=\"{section}\">")), "{section} is missing");
    }
    assert!(!page.contains("NaN") && !page.contains("http"), "self-contained and finite");
    assert_eq!(page.matches("<svg").count(), page.matches("</svg>").count());

    let table = fs::read_to_string(out.join("rows.csv")).unwrap();
    assert_eq!(table.lines().count(), 1 + rows.len() + 4);
    let curves = fs::read_to_string(out.join("curves.csv")).unwrap();
    assert!(curves.lines().count() > 100);
    // JSON writes what is not finite as null; CSV says it.
    assert!([table, curves].iter().all(|text| !text.contains("NaN") && !text.contains("inf")));
    assert!(!out.join("work").exists());
}

#[test]
fn one_set_can_be_asked_for_and_an_unknown_one_is_refused() {
    let folder = tempfile::tempdir().unwrap();
    let done = bench(folder.path(), &["--set", "growth"]);
    assert!(done.success, "{}", done.stderr);
    let page = fs::read_to_string(folder.path().join("report.html")).unwrap();
    assert!(page.contains("id=\"growth\"") && !page.contains("id=\"elongation\""));
    let done = bench(folder.path(), &["--set", "groth"]);
    assert!(!done.success && done.stderr.contains("growth"), "{}", done.stderr);
}

#[test]
fn a_case_that_cannot_be_measured_does_not_take_the_others_with_it() {
    let folder = tempfile::tempdir().unwrap();
    let config = support::small_configuration();
    let case = |name: &str, deep: f64| {
        format!(
            "[[case]]\nname = '{name}'\nset = 'a'\nmeasure = 'matrix'\nconfig = '{}'\n\
             with = {{ volume = {{ voxels = [4, 4, 4], centre_mm = [0.0, 0.0, {deep}] }} }}\n",
            config.display()
        )
    };
    let suite = folder.path().join("suite.toml");
    fs::write(&suite, case("outside", 99.9) + &case("inside", 0.0)).unwrap();
    let out = folder.path().join("report");
    let arguments = [Path::new("bench"), Path::new("--suite"), &suite, Path::new("--out"), &out];
    let done = support::lfpiv(arguments);
    assert!(!done.success && done.stderr.contains("outside"), "{}", done.stderr);
    let table = fs::read_to_string(out.join("rows.csv")).unwrap();
    assert!(table.contains("inside") && !table.contains("outside"));
    assert!(fs::read_to_string(out.join("report.html")).unwrap().contains("Not measured"));
}

#[test]
fn the_shipped_suite_names_methods_that_exist() {
    let suite = Path::new(env!("CARGO_MANIFEST_DIR")).join("report.toml");
    let suite = lfpiv_bench::Suite::load(&suite).unwrap();
    assert!(suite.cases.len() > 5);
}

#[test]
fn the_comparison_of_cameras_refuses_a_bench_of_one() {
    let folder = tempfile::tempdir().unwrap();
    let text = support::shipped("jet");
    let (start, second) = text.split_once("# Camera 2 looks along x").unwrap();
    let (_, rest) = second.split_once("[volume]").unwrap();
    let file = folder.path().join("single.toml");
    fs::write(&file, format!("{start}[volume]{rest}")).unwrap();
    let done = support::lfpiv(["validate", "--config", &file.display().to_string()]);
    assert!(!done.success);
    assert!(done.stderr.contains("single.toml has 1 camera"), "{}", done.stderr);
}
