//! What a pair of images is measured to: ray-traced images of a known flow against the truth, and
//! beside it the true particles, correlated by the same windows and passes alone and followed
//! afterwards. README's figures are the claims of bench/report.toml; a test fails at
//! [`Claim::MARGIN`] times as much.
//!
//! Seeding of parts of a volume is given in particles per mm³: ppm counts them per microlens over
//! the x-y face, so at equal ppm a volume half as deep holds twice as many per mm³.
//!
//! Figures are printed: `cargo test --test accuracy -- --nocapture`.

#![allow(clippy::unwrap_used, reason = "clippy takes the helpers of a test for more than tests")]
#[allow(dead_code)]
#[path = "../../tests/support/mod.rs"]
mod support;

use std::path::Path;

use lfpiv::config::Config;
use lfpiv_bench::{Claim, Suite};
use lfpiv_core::{
    lightfield::ImagePair,
    measurement::Processor,
    reconstruction::quality::{elongation_mm, quality_factor},
    velocimetry::{VectorStatus, VelocityField},
};
use lfpiv_sim::{Flow, Truth, flow::Uniform};
use support::{errors_vox, mean_error_vox, shipped, true_particles};

/// Particles per mm³ at 1 ppm: the bench's volume is 8 mm deep, the paper's 10 mm, and a microlens
/// covers 0.1 x 0.1 mm of either.
const BENCH_DENSITY: f64 = 12.5;
const PAPER_DENSITY: f64 = 10.0;

/// The paper's images have no noise: enough rays that their number is none either.
const RAYS: usize = 40_000;

/// The octant x, y, z > 0 of a shipped configuration's volume: within a millimetre of its focus a
/// camera cannot tell depth, and an octant has as large a share there as the whole. `density` is in
/// particles per mm³.
fn octant(name: &str, voxels: [usize; 3], density: f64) -> Config {
    let mut config = Config::parse(name, &shipped(name)).unwrap();
    config.volume.voxels = voxels;
    config.volume.centre_mm = voxels.map(|n| n as f64 * config.volume.voxel_mm / 2.0);
    let depth_mm = voxels[2] as f64 * config.volume.voxel_mm;
    let scene = config.simulation.as_mut().unwrap();
    scene.ppm = density * depth_mm * 0.01;
    config
}

/// The bench on 5 x 4 x 4 mm at 1 ppm with another flow: particles anywhere, shot and read noise.
fn bench(flow: Flow) -> Config {
    let mut config = octant("bench", [50, 40, 40], BENCH_DENSITY);
    config.simulation.as_mut().unwrap().flow = flow;
    config
}

fn simulated(config: &Config, seed: u64) -> (ImagePair, Truth) {
    let scene = config.simulation.as_ref().unwrap();
    let shot = scene.shot(&config.bench_geometry(), seed, 0);
    (ImagePair { cameras: shot.images }, shot.truth)
}

/// How far a field is from the truth.
struct Deviation {
    /// Mean |error| along x, y, z over all vectors, in voxels.
    mean_vox: [f64; 3],
    /// Share of all components within 0.3 voxels; those of vectors that are not valid are misses.
    within: f64,
}

impl Deviation {
    fn of(field: &VelocityField, flow: &Flow) -> Self {
        let errors = errors_vox(field, flow);
        let hits = errors.iter().zip(&field.status).map(|(error, status)| {
            let valid = *status == VectorStatus::Valid;
            error.iter().filter(|e| valid && e.abs() <= 0.3).count()
        });
        let within = hits.sum::<usize>() as f64 / (3 * errors.len()) as f64;
        Self { mean_vox: mean_error_vox(field, flow), within }
    }

    fn print(&self, name: &str) {
        let ([x, y, z], within) = (self.mean_vox, 100.0 * self.within);
        println!("{name}: mean |error| {x:.4} {y:.4} {z:.4} voxels, {within:.1} % within 0.3");
    }
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
    let least = true_particles(&config, &truth);
    let deviation = |field| Deviation::of(field, &truth.flow);
    let name = |what: &str| format!("{case}, {ppm} ppm, {what}");
    let images = deviation(&result.field);
    assert_claimed(&name("images"), &images, claim.error_vox);
    let (windows, followed) = (deviation(&least.by_windows), deviation(&least.followed));
    assert_claimed(&name("true particles, windows only"), &windows, claim.true_windows_vox);
    assert_claimed(&name("true particles, followed"), &followed, claim.true_followed_vox);
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
fn paper(voxels: [usize; 3], density: f64) -> Config {
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

fn reconstructed(config: &Config, cameras: usize) -> Reconstructed {
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
    let config = support::small_bench();
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
