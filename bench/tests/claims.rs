//! What README claims, measured: ray-traced images of a known flow against the truth, and beside it the
//! true particles, correlated by the same windows and passes alone and followed afterwards. README's
//! figures are the claims of bench/report.toml; a test fails at [`Claim::MARGIN`] times as much.
//!
//! Figures are printed: `cargo test --test claims -- --nocapture`.

#![allow(clippy::unwrap_used, reason = "clippy takes the helpers of a test for more than tests")]
#[allow(dead_code)]
#[path = "../../tests/support/mod.rs"]
mod support;

use std::path::Path;

use lfpiv::config::Config;
use lfpiv_bench::{Claim, Suite};
use lfpiv_core::{lightfield::ImagePair, measurement::Processor};
use lfpiv_sim::Truth;
use support::{Deviation, true_particles};

fn simulated(config: &Config, seed: u64) -> (ImagePair, Truth) {
    let scene = config.simulation.as_ref().unwrap();
    let shot = scene.shot(&config.bench_geometry(), seed, 0);
    (ImagePair { cameras: shot.images }, shot.truth)
}

/// The suite of the report.
fn suite() -> Suite {
    Suite::load(&Path::new(env!("CARGO_MANIFEST_DIR")).join("report.toml")).unwrap()
}

/// Every component within the margin of what is claimed.
fn assert_claimed(what: &str, measured: &Deviation, claimed_vox: [f64; 3]) {
    measured.print(what);
    for (error, claimed) in measured.mean_vox.into_iter().zip(claimed_vox) {
        let most = Claim::MARGIN * claimed;
        assert!(
            error <= most,
            "{what}: {error:.4} voxel, README says {claimed}, allowed {most:.4}"
        );
    }
}

/// A case of the report, measured as there in a scene that README's figures are not from. An error of
/// the true particles grows where correlation or following get worse, one of the images alone where
/// images or reconstruction do.
fn check_claim(case: &str, ppm: f64, least_within: f64) {
    const SEED: u64 = 4;
    let suite = suite();
    let claim = suite.claim(case, ppm).unwrap_or_else(|| panic!("no claim on {case}, {ppm} ppm"));
    let declared = suite.cases.iter().find(|declared| declared.name == case).unwrap();
    let mut config = declared.configuration(&suite.folder).unwrap();
    if let Some(name) = declared.methods.first() {
        let method = suite.methods.iter().find(|method| method.name == *name).unwrap();
        config.reconstruction = method.reconstruction.clone();
    }
    config.simulation.as_mut().unwrap().ppm = ppm;
    let (pair, truth) = simulated(&config, SEED);
    let result = Processor::new(config.measurement()).unwrap().process(&pair).unwrap();
    assert!(result.warnings.is_empty(), "{:?}", result.warnings);
    let least = true_particles(&config.volume.grid(), &config.velocimetry, &truth);
    let deviation = |field| Deviation::of(field, &truth.flow);
    let name = |what: &str| format!("{case}, {ppm} ppm, {what}");
    let images = deviation(&result.field);
    assert_claimed(&name("images"), &images, claim.error_vox);
    let (windows, followed) = (deviation(&least.by_windows), deviation(&least.followed));
    assert_claimed(&name("true particles, windows only"), &windows, claim.true_windows_vox);
    assert_claimed(&name("true particles, tracked"), &followed, claim.true_followed_vox);
    assert!(images.within >= least_within, "{}", images.within);
}

#[test]
fn the_bench_is_measured_at_1_ppm_as_claimed() {
    check_claim("bench", 1.0, 0.999);
}

#[test]
fn the_bench_is_measured_at_0_3_ppm_as_claimed() {
    check_claim("bench", 0.3, 0.999);
}

/// The whole takes a minute: `make bench SETS=jet`.
#[test]
fn an_eighth_of_the_jet_is_measured_as_claimed() {
    check_claim("jet-eighth", 0.25, 0.999);
}

/// The whole takes a minute: `make bench SETS=ring`.
#[test]
fn a_quarter_of_the_ring_vortex_is_measured_as_claimed() {
    check_claim("ring-quarter", 1.0, 0.99);
}

/// README repeats the claims in cells of a table, so that neither changes alone.
#[test]
fn readme_says_what_is_claimed() {
    let readme = Path::new(env!("CARGO_MANIFEST_DIR")).join("../README.md");
    let readme = std::fs::read_to_string(readme).unwrap();
    let numbers = |cell: &str| cell.split(',').map(|n| n.trim().parse().ok()).collect();
    let rows: Vec<Vec<Option<Vec<f64>>>> =
        readme.lines().map(|line| line.split('|').map(numbers).collect()).collect();
    let suite = suite();
    let claims = || suite.cases.iter().flat_map(|case| &case.claims);
    assert!(claims().count() >= 6);
    for claim in claims() {
        let figures = [claim.error_vox, claim.true_followed_vox, claim.true_windows_vox];
        let cells = figures.map(|figures| Some(figures.to_vec()));
        let said = rows.iter().any(|row| row.windows(3).any(|three| *three == cells));
        assert!(said, "no row of README says {figures:?}");
    }
}
