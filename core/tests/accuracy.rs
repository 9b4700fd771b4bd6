//! What parts of the bench's and of the paper's volume are measured to, and that one camera is not
//! enough. What README claims is measured by the tests of `lfpiv-bench`.
//!
//! Seeding is given in particles per mm³: ppm counts them per microlens over the x-y face, so at equal
//! ppm a volume half as deep holds twice as many per mm³.
//!
//! Figures are printed: `cargo test --package lfpiv-core --test capabilities accuracy -- --nocapture`.

use lfpiv_core::{
    lightfield::ImagePair,
    measurement::Processor,
    reconstruction::quality::{elongation_mm, quality_factor},
};
use lfpiv_sim::{Flow, Truth, flow::Uniform};

use crate::support::{Bench, Deviation};

/// Particles per mm³ at 1 ppm: the bench's volume is 8 mm deep, the paper's 10 mm, and a microlens
/// covers 0.1 x 0.1 mm of either.
const BENCH_DENSITY: f64 = 12.5;
const PAPER_DENSITY: f64 = 10.0;

/// The paper's images have no noise: enough rays that their number is none either.
const RAYS: usize = 40_000;

/// The octant x, y, z > 0 of a shipped configuration's volume: within a millimetre of its focus a
/// camera cannot tell depth, and an octant has as large a share there as the whole. `density` is in
/// particles per mm³.
fn octant(name: &str, voxels: [usize; 3], density: f64) -> Bench {
    let mut config = Bench::shipped(name);
    config.volume.voxels = voxels;
    config.volume.centre_mm = voxels.map(|n| n as f64 * config.volume.voxel_mm / 2.0);
    let depth_mm = voxels[2] as f64 * config.volume.voxel_mm;
    let scene = config.simulation.as_mut().unwrap();
    scene.ppm = density * depth_mm * 0.01;
    config
}

/// The bench on 5 x 4 x 4 mm at 1 ppm with another flow: particles anywhere, shot and read noise.
fn bench(flow: Flow) -> Bench {
    let mut config = octant("bench", [50, 40, 40], BENCH_DENSITY);
    config.simulation.as_mut().unwrap().flow = flow;
    config
}

fn simulated(config: &Bench, seed: u64) -> (ImagePair, Truth) {
    let scene = config.simulation.as_ref().unwrap();
    let shot = scene.shot(&config.geometry(), seed, 0);
    (ImagePair { cameras: shot.images }, shot.truth)
}

#[test]
fn six_voxels_are_measured_by_windows_of_sixteen() {
    let flow = Flow::Uniform(Uniform { velocity_m_s: [6.0, -6.0, 6.0] });
    let config = bench(flow.clone());
    let (pair, _) = simulated(&config, 4);
    let processor = Processor::new(config.measurement()).unwrap();
    let field = processor.process(&pair).unwrap().field;
    let errors = Deviation::of(&field, &flow);
    errors.print("6 voxels");
    assert!(errors.mean_vox.into_iter().all(|error| error < 0.1));
    assert!(errors.within >= 0.96);
}

/// The paper's case, particles on voxel centres and still, on microlenses enough for the octant.
fn paper(voxels: [usize; 3], density: f64) -> Bench {
    let mut config = octant("paper", voxels, density);
    let optics = &mut config.optics;
    (optics.microlens.columns, optics.microlens.rows) = (129, 129);
    (optics.sensor.columns, optics.sensor.rows) = (2352, 2352);
    let scene = config.simulation.as_mut().unwrap();
    scene.flow = Flow::default();
    scene.rays_per_particle = RAYS;
    config
}

/// A case as reconstructed by the first `cameras` of the two.
struct Reconstructed {
    /// Q against the true volume.
    quality: f64,
    /// Width of the brightest particle along z, the first camera's depth.
    fwhm_mm: f64,
}

fn reconstructed(config: &Bench, cameras: usize) -> Reconstructed {
    let mut config = config.clone();
    config.camera.truncate(cameras);
    let (pair, truth) = simulated(&config, 5);
    let processor = Processor::new(config.measurement()).unwrap();
    let (_, [volume, _]) = processor.process_with_volumes(&pair).unwrap();
    let mut light = vec![0.0; config.volume.len()];
    for particle in &truth.particles {
        let at = |axis: usize| config.volume.index_of(axis, particle.a_mm[axis]).round() as usize;
        light[config.volume.linear([at(0), at(1), at(2)])] = particle.intensity as f32;
    }
    Reconstructed {
        quality: quality_factor(&volume.intensity, &light),
        fwhm_mm: elongation_mm(&volume, 2).unwrap(),
    }
}

#[test]
fn particles_on_voxel_centres_are_reconstructed_to_the_papers_quality() {
    for (ppm, least) in [(1.0, 0.95), (0.1, 0.99)] {
        let quality = reconstructed(&paper([50; 3], ppm * PAPER_DENSITY), 2).quality;
        println!("{ppm} ppm on voxel centres: Q {quality:.4}");
        assert!(quality >= least, "{ppm} ppm: {quality}");
    }
}

#[test]
fn one_camera_is_clearly_worse_than_two() {
    let config = paper([50; 3], 0.3 * PAPER_DENSITY);
    let [one, two] = [1, 2].map(|cameras| reconstructed(&config, cameras).quality);
    println!("0.3 ppm: Q {one:.3} with one camera, {two:.3} with two");
    assert!(one < two - 0.2);
}

/// In focus blur tells a single camera nothing about depth, away from it a little.
#[test]
fn a_particle_is_long_for_one_camera_and_not_for_two() {
    for (depth_mm, times) in [(0.0, 10.0), (3.0, 1.4)] {
        // One particle in 1 x 1 x 4 mm.
        let mut config = paper([10, 10, 40], 0.25);
        config.volume.centre_mm[2] = depth_mm;
        let [one, two] = [1, 2].map(|cameras| reconstructed(&config, cameras).fwhm_mm);
        println!(
            "FWHM along depth about {depth_mm} mm: {one:.3} mm by one camera, {two:.3} by two"
        );
        assert!(one > times * two, "{one}, {two}");
    }
}

#[test]
fn one_thread_and_two_give_the_same_bits() {
    let config = Bench::small();
    let (pair, _) = simulated(&config, 6);
    let processor = Processor::new(config.measurement()).unwrap();
    let run = |threads| {
        let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().unwrap();
        pool.install(|| processor.process_with_volumes(&pair).unwrap())
    };
    let ((one, one_volumes), (two, two_volumes)) = (run(1), run(2));
    assert!(one.field.valid_share() > 0.9);
    assert_eq!(one_volumes, two_volumes);
    assert_eq!(one.field, two.field);
    let (again, volumes) = run(1);
    assert_eq!((again.field, volumes), (one.field, one_volumes));
}
