//! Whether the stated uncertainty is the true one: of all components of valid vectors, 68 % must lie
//! within one standard uncertainty of the truth and 95 % within 1.96, each within eight points.

use lfpiv_sim::{Flow, flow::Abc};

use super::bench::{Measured, measured, scene_of, shot};
use crate::support::Bench;

/// An eighth of the bench's volume with its seeding density, windows and flow: particles anywhere,
/// 2 voxels' amplitude over 10 mm, shot and read noise.
fn octant(ppm: f64) -> Bench {
    let mut config = Bench::shipped("bench");
    config.volume.voxels = [50, 40, 40];
    config.volume.centre_mm = config.volume.voxels.map(|n| n as f64 * config.volume.voxel_mm / 2.0);
    let scene = scene_of(&mut config);
    // ppm counts over the face: half the depth, half the particles per microlens.
    scene.ppm = ppm / 2.0;
    scene.flow = Flow::Abc(Abc { wavelength_mm: 10.0, amplitude_m_s: 2.0, coefficients: [1.0; 3] });
    config
}

/// Shares within 1 and 1.96 uncertainties over pairs that differ in their seed.
fn check(name: &str, measure: impl Fn(u64) -> Measured) {
    const SEEDS: u64 = 3;
    let found: Vec<Measured> = (1..=SEEDS).map(measure).collect();
    let mean = |of: &dyn Fn(&Measured) -> f64| found.iter().map(of).sum::<f64>() / SEEDS as f64;
    let (one, two) = (mean(&|m| m.covered(1.0)), mean(&|m| m.covered(1.96)));
    let (rms, valid) = (mean(&|m| m.rms()), mean(&|m| m.valid_share()));
    println!(
        "{name}: {:.1} % within one uncertainty, {:.1} % within 1.96, {:.1} % valid, rms {rms:.4}",
        100.0 * one,
        100.0 * two,
        100.0 * valid
    );
    assert!(valid >= 0.9, "{name}: {valid}");
    assert!((one - 0.68).abs() <= 0.08, "{name}: {one}");
    assert!((two - 0.95).abs() <= 0.08, "{name}: {two}");
}

fn simulated(config: &Bench, seed: u64) -> Measured {
    let shot = shot(config, seed);
    measured(config, shot.images, &shot.truth.flow)
}

#[test]
fn intervals_hold_at_1_ppm() {
    let config = octant(1.0);
    check("1 ppm", |seed| simulated(&config, seed));
}

#[test]
fn intervals_hold_at_0_3_ppm() {
    let config = octant(0.3);
    check("0.3 ppm", |seed| simulated(&config, seed));
}

#[test]
fn intervals_hold_under_read_noise() {
    let mut config = octant(1.0);
    scene_of(&mut config).sensor.read_noise_electrons = 60.0;
    check("60 electrons of read noise", |seed| simulated(&config, seed));
}

#[test]
fn intervals_hold_with_a_dim_camera() {
    let config = octant(1.0);
    let mut dim = config.clone();
    scene_of(&mut dim).particle_photoelectrons /= 4.0;
    check("camera 2 at a quarter of the light", |seed| {
        let (mut bright, dim) = (shot(&config, seed), shot(&dim, seed));
        bright.images[1] = dim.images[1].clone();
        measured(&config, bright.images, &bright.truth.flow)
    });
}
