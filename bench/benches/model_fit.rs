//! How often right and wrong benches are told apart: `cargo bench --package lfpiv-bench --bench model_fit [-- SEEDS]`.
//!
//! Every case of `core/tests/model_fit/cases.rs` on the bench of `config/bench.toml`, at 0.05, 0.3, 1 and
//! 2 particles per microlens, ten seeds each unless told otherwise. Prints a row per case and seeding:
//! how many seeds were judged rightly (a wrong bench warned of with its cause among the first three, a
//! right one not), and the worst numbers.

#![allow(clippy::unwrap_used)]

#[path = "../../core/tests/model_fit/cases.rs"]
mod cases;
#[path = "../../core/tests/support/bench.rs"]
#[allow(dead_code)]
mod configured;
/// Of the tests that share the cases.
mod support {
    pub use super::configured::Bench;
}

use cases::{CASES, bench, shots};

const SEEDINGS: [f64; 4] = [0.05, 0.3, 1.0, 2.0];

fn main() {
    let seeds =
        std::env::args().skip(1).find_map(|argument| argument.parse().ok()).unwrap_or(10u64);
    println!(
        "{:<42} {:>5} {:>8} {:>12} {:>11} {:>10}",
        "case", "ppm", "right", "unexplained", "agreement", "disparity"
    );
    for ppm in SEEDINGS {
        let config = bench([100, 80, 80], ppm);
        let mut met = [0; CASES.len()];
        let mut numbers = vec![Vec::new(); CASES.len()];
        for seed in 1..=seeds {
            let shots = shots(&config, seed);
            for (n, case) in CASES.iter().enumerate() {
                let (fit, _) = case.fit(&config, seed, &shots);
                met[n] += u64::from(case.is_met(&fit));
                numbers[n].push([
                    fit.cameras.iter().map(|camera| camera.unexplained).fold(0.0, f64::max),
                    fit.camera_agreement.unwrap_or(f64::NAN),
                    fit.camera_disparity_mm.unwrap_or(f64::NAN),
                ]);
            }
        }
        for (n, case) in CASES.iter().enumerate() {
            let range = |number: usize| -> String {
                let values = numbers[n].iter().map(|row: &[f64; 3]| row[number]);
                let low = values.clone().fold(f64::INFINITY, f64::min);
                let high = values.fold(f64::NEG_INFINITY, f64::max);
                format!("{low:.2}..{high:.2}")
            };
            println!(
                "{:<42} {ppm:>5} {:>8} {:>12} {:>11} {:>10}",
                case.name,
                format!("{}/{seeds}", met[n]),
                range(0),
                range(1),
                range(2)
            );
        }
    }
}
