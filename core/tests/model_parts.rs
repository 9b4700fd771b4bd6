//! What each part of the forward model costs and buys, on small ray-traced volumes.
//!
//! Figures are printed: `cargo test --release --package lfpiv-core --test capabilities model_parts -- --ignored --nocapture`.

use std::{
    sync::LazyLock,
    time::{Duration, Instant},
};

use lfpiv_core::{
    lightfield::ImagePair,
    measurement::Processor,
    model::{ModelMode, ModelSettings, Switch},
    velocimetry::PairResult,
};
use lfpiv_sim::{Flow, Truth, flow::Abc};

use crate::support::{Bench, mean_error_vox, true_particles};

fn flow() -> Flow {
    Flow::Abc(Abc { wavelength_mm: 10.0, amplitude_m_s: 2.0, coefficients: [1.0; 3] })
}

/// The bench on 4 x 4 x 4 mm about `centre_mm`, seeded with `per_mm3` particles.
fn bench(centre_mm: [f64; 3], per_mm3: f64) -> Bench {
    let mut config = Bench::shipped("bench");
    config.volume.voxels = [40; 3];
    config.volume.centre_mm = centre_mm;
    let scene = config.simulation.as_mut().unwrap();
    scene.flow = flow();
    // Particles per microlens over the x-y face of a volume 4 mm deep.
    scene.ppm = per_mm3 * 4.0 * 0.01;
    config
}

fn simulated(config: &Bench) -> (ImagePair, Truth) {
    let scene = config.simulation.as_ref().unwrap();
    let shot = scene.shot(&config.geometry(), 11, 0);
    (ImagePair { cameras: shot.images }, shot.truth)
}

/// Monotonic time.
fn monotonic() -> Duration {
    static START: LazyLock<Instant> = LazyLock::new(Instant::now);
    START.elapsed()
}

/// A measurement and the shortest of three times that its reconstruction took, in s.
fn timed(config: &Bench, pair: &ImagePair) -> (PairResult, f64) {
    let processor = Processor::timed(config.measurement(), monotonic).unwrap();
    let results = [0; 3].map(|_| processor.process(pair).unwrap());
    let seconds = results.iter().map(|r| r.seconds.reconstruct_s).fold(f64::INFINITY, f64::min);
    let [result, ..] = results;
    (result, seconds)
}

/// Mean |error| over all vectors and components, in voxels.
fn error_vox(result: &PairResult) -> f64 {
    mean_error_vox(&result.field, &flow()).iter().sum::<f64>() / 3.0
}

/// The same for the true particles.
fn floor_vox(config: &Bench, truth: &Truth) -> f64 {
    let field = true_particles(&config.volume, &config.velocimetry, truth).by_windows;
    mean_error_vox(&field, &flow()).iter().sum::<f64>() / 3.0
}

fn settings(change: impl Fn(&mut ModelSettings)) -> ModelSettings {
    let mut settings = ModelSettings::default();
    change(&mut settings);
    settings
}

/// Every part on and off, its name before it.
fn variants() -> Vec<(&'static str, ModelSettings, usize)> {
    let nm = Some(532.0);
    vec![
        ("default", settings(|_| ()), 4),
        ("no pupil blur", settings(|s| s.pupil_blur = Switch::Off), 4),
        ("no aperture coverage", settings(|s| s.aperture_coverage = Switch::Off), 4),
        ("diffraction", settings(|s| (s.wavelength_nm, s.diffraction) = (nm, Switch::On)), 4),
        ("no noise weighting", settings(|s| s.noise_weighting = Switch::Off), 4),
        ("voxels split by 2", settings(|_| ()), 2),
        ("voxels not split", settings(|s| s.fine_voxels = Switch::Off), 4),
        ("auto", settings(|s| (s.mode, s.wavelength_nm) = (ModelMode::Auto, nm)), 4),
    ]
}

#[test]
#[ignore = "a table for people: minutes"]
fn what_each_part_costs_and_buys() {
    // In focus, and where the pupil blur of both cameras is widest.
    let scenes = [
        ("in focus, 12.5 per mm3", [0.0; 3], 12.5, 5.0, false),
        ("corner, 12.5 per mm3", [2.0; 3], 12.5, 5.0, false),
        ("corner, 3.75 per mm3", [2.0; 3], 3.75, 5.0, false),
        ("corner, 3.75 per mm3, noise 50", [2.0; 3], 3.75, 50.0, false),
        ("corner, 12.5 per mm3, diffraction", [2.0; 3], 12.5, 5.0, true),
        ("corner, 3.75 per mm3, diffraction", [2.0; 3], 3.75, 5.0, true),
    ];
    for (name, centre_mm, per_mm3, noise, diffraction) in scenes {
        let mut config = bench(centre_mm, per_mm3);
        let scene = config.simulation.as_mut().unwrap();
        scene.sensor.read_noise_electrons = noise;
        scene.diffraction = diffraction;
        let (pair, truth) = simulated(&config);
        println!("{name}: true particles {:.4} voxel", floor_vox(&config, &truth));
        for (variant, model, refinement) in variants() {
            (config.model, config.reconstruction.refinement) = (model, refinement);
            let (result, seconds) = timed(&config, &pair);
            println!(
                "  {variant:22} {:.4} voxel, {seconds:.2} s; {}",
                error_vox(&result),
                result.model
            );
            if let Some(scene) = result.model.scene {
                println!("  {scene:.3?}");
                for part in &result.model.parts {
                    println!("    {}: {}", part.part, part.reason);
                }
            }
        }
    }
}

#[test]
#[ignore = "a table for people: minutes"]
fn the_error_of_true_particles_by_seeding_and_window() {
    for per_mm3 in [1.25, 3.75, 12.5, 30.0] {
        for window_mm in [0.8, 1.6, 2.4] {
            let mut config = bench([0.0; 3], per_mm3);
            config.volume.voxels = [80; 3];
            config.simulation.as_mut().unwrap().ppm = per_mm3 * 8.0 * 0.01;
            config.simulation.as_mut().unwrap().rays_per_particle = 1;
            config.velocimetry.window_mm = window_mm;
            let (_, truth) = simulated(&config);
            let particles = per_mm3 * window_mm.powi(3);
            println!(
                "{per_mm3} per mm3, windows of {window_mm} mm, {particles:.1} particles: {:.4} voxel",
                floor_vox(&config, &truth)
            );
        }
    }
}
