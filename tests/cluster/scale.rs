//! The forecast for many machines, from costs measured on this one.

use std::fs;

use serde_json::Value;

use crate::{
    bench::{lfpiv, text},
    broker::Nats,
    processes::path,
    recorded::recorded,
};

/// Whether the predictions hold is for a machine that is not busy: see docs/cluster.md.
#[test]
fn costs_are_measured_predictions_made_and_many_machines_forecast() {
    let root = tempfile::tempdir().expect("a folder");
    let run = recorded(root.path());
    let nats = Nats::start(root.path());
    let out = root.path().join("scale");
    let url = nats.url();
    let output = lfpiv(&["scale", path(&run), "--url", &url, "--out", path(&out), "--cores", "16"]);
    let (stdout, stderr) = (text(&output.stdout), text(&output.stderr));
    let is_busy = stderr.contains("predictions were wrong by more than");
    assert!(output.status.success() || is_busy, "{stderr}");
    assert!(stdout.contains("Extrapolated: shots a second of machines with 16 cores"), "{stdout}");

    let forecast = fs::read_to_string(out.join("scale.json")).expect("a forecast");
    let forecast: Value = serde_json::from_str(&forecast).expect("JSON");
    let checks = forecast["checks"].as_array().expect("checks");
    assert_eq!(checks.len(), 6);
    for check in checks {
        let number = |key: &str| check[key].as_f64().expect("a number");
        assert!(number("predicted_per_s") > 0.0 && number("measured_per_s") > 0.0, "{check}");
    }
    for network in forecast["networks"].as_array().expect("networks") {
        let rates = network["extrapolated"].as_array().expect("rates").iter();
        let rates: Vec<f64> = rates.map(|at| at["shots_per_s"].as_f64().expect("a rate")).collect();
        let most = network["most_shots_per_s"].as_f64().expect("a limit");
        // At the limit the rates differ by rounding only.
        let rounding = 1e-12 * most;
        let grow = rates.windows(2).all(|pair| pair[1] >= pair[0] - rounding);
        assert!(grow && rates.iter().all(|rate| *rate <= most + rounding), "{network}");
    }
    let picture = fs::read_to_string(out.join("scale.svg")).expect("a picture");
    assert!(picture.contains("Extrapolated") && picture.matches("<circle").count() == 6);
    // Nothing is left of the trials, and the run is as it was.
    assert!(!out.join("trial").exists() && !run.join("delivered").exists());
}
