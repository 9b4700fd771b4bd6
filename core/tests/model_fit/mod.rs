//! A wrong bench is told from a right one, and what is wrong is named.
//!
//! One seed at one seeding on a smaller volume; `cargo bench --bench model_fit` has ten seeds and four
//! seedings on the whole one.

mod cases;

use lfpiv_core::{measurement::Processor, reconstruction::FitVerdict};

use cases::{CASES, bench, shots};

#[test]
fn wrong_benches_are_warned_of_with_their_cause_and_right_ones_are_not() {
    let (config, seed) = (bench([64, 56, 56], 0.5), 3);
    let shots = shots(&config, seed);
    let mut missed = Vec::new();
    for case in &CASES {
        let (fit, valid_share) = case.fit(&config, seed, &shots);
        println!("{}: {}; {:?}", case.name, fit.verdict, fit);
        if fit.verdict == FitVerdict::Poor {
            assert_eq!(valid_share, 0.0, "{}: a poor fit has no valid vector", case.name);
        }
        if !case.is_met(&fit) {
            missed.push(format!("{}: {fit:?}", case.name));
        }
    }
    assert!(missed.is_empty(), "{}", missed.join("\n"));
}

#[test]
fn identical_frames_are_remarked() {
    let config = bench([40, 30, 30], 0.5);
    let [mut pair, _] = shots(&config, 4);
    for frames in &mut pair.cameras {
        frames[1] = frames[0].clone();
    }
    let result = Processor::new(config.measurement()).unwrap().process(&pair).unwrap();
    for camera in ["cam1", "cam2"] {
        let said = |warning: &String| warning.starts_with(camera) && warning.contains("same image");
        assert!(result.warnings.iter().any(said), "{:?}", result.warnings);
    }
}
