//! `lfpiv timing` through the real binary.

use std::{
    fs,
    process::{Command, Output},
};

use crate::support::shipped;

/// Runs the command on `config/bench.toml` with some text replaced.
fn timing(from: &str, to: &str) -> (Output, Option<String>) {
    let folder = tempfile::tempdir().unwrap();
    let (config, svg) = (folder.path().join("run.toml"), folder.path().join("timing.svg"));
    let text = shipped("bench");
    assert!(text.contains(from), "{from}");
    fs::write(&config, text.replace(from, to)).unwrap();
    let output = Command::new(env!("CARGO_BIN_EXE_lfpiv"))
        .args(["timing", "--config"])
        .arg(&config)
        .arg("--svg")
        .arg(&svg)
        .output()
        .unwrap();
    (output, fs::read_to_string(svg).ok())
}

#[test]
fn the_diagram_follows_the_timing_table() {
    let (output, svg) = timing("# lamp_1_us = 100.0 ", "lamp_1_us = 150.0 ");
    let text = String::from_utf8(output.stdout).unwrap();
    assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
    assert!(text.starts_with("dt 100 us, 10 shots/s, internal clock\n"), "{text}");
    let q_switch = text.lines().rfind(|line| line.starts_with("Q-switch 1")).unwrap();
    let times: Vec<&str> = q_switch.split_whitespace().skip(2).collect();
    assert_eq!(times, ["330", "380"]);
    assert!(svg.unwrap().contains("Q-switch 1: 330 to 380 us"));
}

#[test]
fn an_impossible_schedule_is_refused_with_every_rule_it_breaks() {
    let (output, svg) = timing("rate_hz = 10.0", "rate_hz = 15.0");
    let message = String::from_utf8(output.stderr).unwrap();
    assert_eq!(output.status.code(), Some(1));
    assert!(message.contains("laser rate = 15 Hz: allowed: at most 10 Hz"), "{message}");
    assert!(message.contains("cameras ready again at 80331.000 us"), "{message}");
    assert_eq!(svg, None);
}
