//! Predictions, and the measurements that they are compared with.

use serde::Serialize;

use super::{costs::Measured, trial::Trial};

/// Largest difference that counts as agreement.
pub(super) const TOLERANCE: f64 = 0.15;
/// Shots of a worker while it is timed.
const SHOTS: usize = 8;
/// Time of a shot where the network decides, in s.
const NETWORK_SHOT_S: f64 = 1.0;
/// Time of a slow network for the frames of a shot, in s.
const SLOW_NETWORK_S: f64 = 0.2;

/// A trial and the rate that is expected of it.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub(super) struct Check {
    pub what: String,
    #[serde(skip)]
    pub trial: Trial,
    pub predicted_per_s: f64,
    /// Absent before the trial.
    pub measured_per_s: Option<f64>,
}

impl Check {
    fn new(what: String, trial: Trial, measured: &Measured) -> Self {
        let costs = measured.costs(trial.shot_s, trial.bytes_per_s);
        let predicted_per_s = costs.shots_per_s(trial.workers);
        Self { what, trial, predicted_per_s, measured_per_s: None }
    }

    /// Relative difference of the measurement from the prediction.
    pub fn difference(&self) -> Option<f64> {
        Some(self.measured_per_s? / self.predicted_per_s - 1.0)
    }

    /// Whether they agree.
    pub fn holds(&self) -> bool {
        self.difference().is_some_and(|difference| difference.abs() <= TOLERANCE)
    }
}

/// Workers that measure at a fraction of this machine's speed, many that sleep, and a slow network.
pub(super) fn checks(measured: &Measured) -> Vec<Check> {
    let mut checks = Vec::new();
    // Three of them leave this machine idle half of the time.
    let shot_s = (8.0 * measured.shot.core_s / cores() as f64).max(0.25);
    for workers in 1..=3 {
        let trial = Trial { workers, shots: SHOTS, shot_s, measures: true, bytes_per_s: None };
        let what = format!("{workers} throttled to {shot_s:.2} s a shot");
        checks.push(Check::new(what, trial, measured));
    }
    // Half of what the coordinator can do.
    let shot_s = (2.0 * 64.0 / measured.crowd.shots_per_s).max(1.0);
    let trial = Trial { workers: 64, shots: SHOTS / 2, shot_s, measures: false, bytes_per_s: None };
    checks.push(Check::new(format!("64 that sleep {shot_s:.2} s a shot"), trial, measured));
    let rate = measured.shot.frame_bytes as f64 / SLOW_NETWORK_S;
    for workers in [3, 12] {
        let trial = Trial {
            workers,
            shots: SHOTS,
            shot_s: NETWORK_SHOT_S,
            measures: false,
            bytes_per_s: Some(rate),
        };
        let what = format!("{workers} at a network of {:.2} Mbit/s", rate * 8e-6);
        checks.push(Check::new(what, trial, measured));
    }
    checks
}

/// Cores of this machine.
pub(super) fn cores() -> usize {
    std::thread::available_parallelism().map_or(1, std::num::NonZero::get)
}
