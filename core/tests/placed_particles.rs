//! Particles placed in the images, against those that made them.
//!
//! Figures are printed: `cargo test --package lfpiv-core --test capabilities placed -- --nocapture`;
//! the whole bench's are those of `lfpiv bench --set particles`.

use lfpiv_core::{
    lightfield::ImagePair,
    measurement::{Measurement, Processor},
    particles::PlacedParticles,
    velocimetry::{PairResult, Placing, VectorStatus},
};
use lfpiv_sim::{Flow, Scene, Truth, flow::Turbulence};

use crate::support::Bench;

/// Both focal planes cross it, as they do the bench: 3 x 3 x 3 mm, at the bench's density.
fn placed(change: impl Fn(&mut Scene)) -> (PlacedParticles, Truth, Bench) {
    placed_in(30, 3, change)
}

/// The same in a cube of so many voxels along an edge, with these particles.
fn placed_in(
    edge: usize,
    seed: u64,
    change: impl Fn(&mut Scene),
) -> (PlacedParticles, Truth, Bench) {
    let mut config = Bench::shipped("bench");
    config.volume.voxels = [edge; 3];
    let scene = config.simulation.as_mut().unwrap();
    scene.ppm = 12.5 * edge as f64 * 0.001;
    change(scene);
    let shot = config.simulation.as_ref().unwrap().shot(&config.geometry(), seed, 0);
    let pair = ImagePair { cameras: shot.images };
    let processor = Processor::new(config.measurement()).unwrap();
    let (_, placed) = processor.process_with_particles(&pair).unwrap();
    (placed, shot.truth, config)
}

struct Found {
    /// Share of the true particles, lit in both frames, within 0.2 voxel.
    found: f64,
    /// Share of the pairs with no such particle within 0.5 voxel.
    wrong: f64,
    /// Median |error| of a displacement's component, in voxels.
    median_vox: f64,
}

fn judged(placed: &PlacedParticles, truth: &Truth, config: &Bench) -> Found {
    let voxel_mm = config.volume.voxel_mm;
    let half_mm = config.volume.voxels[0] as f64 * voxel_mm / 2.0;
    let inside = |at: &[f64; 3]| at.iter().all(|mm| mm.abs() < half_mm);
    let apart = |a: [f64; 3], b: [f64; 3]| -> f64 {
        (0..3).map(|n| (a[n] - b[n]).powi(2)).sum::<f64>().sqrt() / voxel_mm
    };
    let middle = |a: [f64; 3], b: [f64; 3]| std::array::from_fn(|n| (a[n] + b[n]) / 2.0);
    let lit: Vec<_> = truth.particles.iter().filter(|p| p.visible_a && p.visible_b).collect();
    let counted: Vec<[f64; 3]> =
        lit.iter().map(|p| middle(p.a_mm, p.b_mm)).filter(inside).collect();
    let near = |at: [f64; 3], vox: f64| placed.pairs.iter().any(|p| apart(p.middle_mm(), at) < vox);
    let found = counted.iter().filter(|&&at| near(at, 0.2)).count();
    let (mut errors, mut pairs, mut wrong) = (Vec::new(), 0, 0);
    for pair in placed.pairs.iter().filter(|pair| inside(&pair.middle_mm())) {
        pairs += 1;
        let is = |p: &&&lfpiv_sim::Tracer| apart(middle(p.a_mm, p.b_mm), pair.middle_mm()) < 0.5;
        let Some(particle) = lit.iter().find(is) else {
            wrong += 1;
            continue;
        };
        for n in 0..3 {
            let moved_mm = particle.b_mm[n] - particle.a_mm[n];
            errors.push((pair.displacement_mm()[n] - moved_mm).abs() / voxel_mm);
        }
    }
    errors.sort_by(f64::total_cmp);
    Found {
        found: found as f64 / counted.len() as f64,
        wrong: f64::from(wrong) / f64::from(pairs),
        median_vox: errors[errors.len() / 2],
    }
}

fn print(name: &str, found: &Found) {
    println!(
        "{name}: {:.1} % found, {:.1} % false, median displacement error {:.4} voxel",
        100.0 * found.found,
        100.0 * found.wrong,
        found.median_vox
    );
}

#[test]
fn particles_are_placed_to_a_hundredth_of_a_voxel() {
    let (placed, truth, config) = placed(|_| {});
    let found = judged(&placed, &truth, &config);
    print("bench", &found);
    assert!(found.found > 0.65 && found.wrong < 0.08 && found.median_vox < 0.006);
}

/// Neither blur nor the cameras' shares of the light are told: the images say them.
#[test]
fn blur_and_lights_are_found_in_the_images() {
    let (placed, truth, config) = placed(|scene| {
        scene.diffraction = true;
        scene.lighting.camera_light = vec![1.0, 0.7];
        scene.lighting.camera_spread = 0.3;
    });
    let found = judged(&placed, &truth, &config);
    print("diffraction, uneven light", &found);
    for blur in &placed.blurs {
        // 0.42 wavelengths times f/8 over a pixel of 5.5 µm. Some hundred particles, a third of them not
        // found, tell it to a third.
        assert!((blur.sensor_px - 0.325).abs() < 0.13, "{blur:?}");
    }
    for [first, second] in placed.typical {
        assert!((second / first - 0.7).abs() < 0.1, "{first} {second}");
    }
    assert!(found.found > 0.65 && found.wrong < 0.08 && found.median_vox < 0.01);
}

/// Windows miss parts of this flow by several voxels, and no particle there is where they lead. Their neighbours tell.
#[test]
fn particles_are_found_where_windows_miss_the_flow() {
    let found = [1, 3].map(|seed| {
        let (placed, truth, config) = placed_in(40, seed, |scene| {
            scene.flow = Flow::Turbulence(Turbulence::new([1.6, 10.0], 2.0, 1));
        });
        let found = judged(&placed, &truth, &config);
        print("strong turbulence", &found);
        found
    });
    let mean = |of: fn(&Found) -> f64| found.iter().map(of).sum::<f64>() / 2.0;
    assert!(mean(|of| of.found) > 0.73 && mean(|of| of.wrong) < 0.1);
}

/// Mean |error| along x, y, z over valid vectors, and the share of vectors that are valid, in a cube of so many
/// voxels along an edge.
fn error_of_field(placing: Placing, edge: usize, change: impl Fn(&mut Scene)) -> (f64, f64) {
    let mut config = Bench::shipped("bench");
    config.volume.voxels = [edge; 3];
    config.velocimetry.place_particles = placing;
    let scene = config.simulation.as_mut().unwrap();
    scene.ppm = 12.5 * edge as f64 * 0.001;
    change(scene);
    let scene = scene.clone();
    let shot = scene.shot(&config.geometry(), 5, 0);
    let pair = ImagePair { cameras: shot.images };
    let processor =
        Processor::new(Measurement { spacing_mm: Some(0.4), ..config.measurement() }).unwrap();
    let PairResult { field, particles, .. } = processor.process(&pair).unwrap();
    let valid: Vec<usize> =
        (0..field.grid.len()).filter(|&n| field.status[n] == VectorStatus::Valid).collect();
    let error = |&n: &usize| -> f64 {
        let at_mm = field.grid.position_mm(n);
        // What a vector stands for depends on that (docs/theory.md).
        let moved_mm = match particles {
            Some(_) => scene.flow.displacement_about_mm(at_mm, field.dt_s),
            None => scene.flow.displacement_mm(at_mm, field.dt_s),
        };
        (0..3)
            .map(|c| (f64::from(field.displacement_vox[n][c]) - moved_mm[c] / field.voxel_mm).abs())
            .sum::<f64>()
            / 3.0
    };
    let mean = valid.iter().map(error).sum::<f64>() / valid.len() as f64;
    (mean, valid.len() as f64 / field.grid.len() as f64)
}

#[test]
fn the_field_through_placed_particles_is_closer_to_the_flow() {
    let [(windows, _), (placed, valid)] =
        [Placing::Never, Placing::Always].map(|placing| error_of_field(placing, 30, |_| {}));
    println!("{windows:.4} voxel by correlation, {placed:.4} through placed particles");
    assert!(placed < 0.9 * windows && valid > 0.95, "{windows} {placed} {valid}");
}

/// Windows cannot resolve such waves, and particles hardly predict each other.
#[test]
fn waves_of_ten_voxels_are_measured_by_placed_particles() {
    let rough = |scene: &mut Scene| {
        let flow = "kind = \"turbulence\"\nwavelengths_mm = [1.0, 10.0]\nrms_m_s = 1.5\nseed = 1";
        scene.flow = toml::from_str(flow).unwrap();
    };
    let [(windows, _), (placed, valid)] =
        [Placing::Never, Placing::Auto].map(|placing| error_of_field(placing, 50, rough));
    println!("{windows:.3} voxel by correlation, {placed:.3} through placed particles");
    println!("{:.1} % of these are valid", 100.0 * valid);
    assert!(placed < 0.6 * windows && valid > 0.95, "{windows} {placed} {valid}");
}

/// Windows miss less of it than the 0.05 voxel at which particles are placed. What followed particles miss decides.
#[test]
fn turbulence_below_the_error_of_a_particle_is_measured_by_default() {
    let weak = |scene: &mut Scene| {
        let flow = "kind = \"turbulence\"\nwavelengths_mm = [1.6, 10.0]\nrms_m_s = 0.1\nseed = 1";
        scene.flow = toml::from_str(flow).unwrap();
    };
    let [(windows, _), (placed, valid)] =
        [Placing::Never, Placing::Auto].map(|placing| error_of_field(placing, 36, weak));
    println!("{windows:.4} voxel by correlation, {placed:.4} through placed particles");
    assert!(placed < 0.6 * windows && valid > 0.95, "{windows} {placed} {valid}");
}
