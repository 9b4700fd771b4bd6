//! What a pair of images is measured to: ray-traced images of a known flow against the truth, on
//! volumes small enough for a test, and beside it the floor: the error of correlating the true
//! particles by the same windows and passes.
//!
//! Seeding is given as the bench's or the paper's number of particles per mm³: ppm counts them per
//! microlens over the x-y face, so at equal ppm a volume half as deep holds twice as many per mm³.
//!
//! Figures are printed: `cargo test --test accuracy -- --nocapture`.

#![allow(clippy::unwrap_used, reason = "clippy takes the helpers of a test for more than tests")]
#[allow(dead_code)]
mod support;

use lfpiv::{
    config::Config,
    pipeline::{ImagePair, Processor},
    reconstruction::{
        DenseVolume,
        quality::{elongation_mm, quality_factor},
    },
    velocimetry::{Interrogation, PointCloud, VectorStatus, VelocityField},
};
use lfpiv_sim::{
    Flow, FrameOfPair, Truth,
    flow::{Abc, Uniform},
};
use support::{errors_vox, mean_error_vox, shipped};

/// Particles per mm³ at 1 ppm: the bench's volume is 8 mm deep, the paper's 10 mm, and a microlens
/// covers 0.1 x 0.1 mm of either.
const BENCH_DENSITY: f64 = 12.5;
const PAPER_DENSITY: f64 = 10.0;

/// A shipped configuration on fewer voxels, and no more microlenses and pixels than those need.
/// `density` is in particles per mm³.
fn reduced(name: &str, voxels: [usize; 3], density: f64) -> Config {
    let mut config = Config::parse(name, &shipped(name)).unwrap();
    // A voxel is a microlens pitch wide, and 3 mm from focus a point's image reaches 4 further.
    let microlenses = |axis: usize| voxels[axis].max(voxels[1]) + 13;
    let optics = &mut config.optics;
    let pixels = |n: usize| {
        let pitch_um = optics.sensor.pixel_pitch_um;
        (n as f64 * 1000.0 * optics.microlens.pitch_mm / pitch_um).ceil() as usize + 4
    };
    (optics.sensor.columns, optics.sensor.rows) = (pixels(microlenses(0)), pixels(microlenses(1)));
    (optics.microlens.columns, optics.microlens.rows) = (microlenses(0), microlenses(1));
    config.volume.voxels = voxels;
    let depth_mm = voxels[2] as f64 * config.volume.voxel_mm;
    let scene = config.simulation.as_mut().unwrap();
    scene.ppm = density * depth_mm * 0.01;
    config
}

/// The bench on 4.8 x 4 x 4 mm with another flow: particles anywhere, shot and read noise.
fn bench(density: f64, flow: Flow) -> Config {
    let mut config = reduced("bench", [48, 40, 40], density);
    config.simulation.as_mut().unwrap().flow = flow;
    config
}

fn simulated(config: &Config, seed: u64) -> (ImagePair, Truth) {
    let scene = config.simulation.as_ref().unwrap();
    let shot = scene.shot(&config.bench_geometry(), seed, 0);
    (ImagePair { cameras: shot.images }, shot.truth)
}

/// The field that the true particles give.
fn floor(config: &Config, truth: &Truth) -> VelocityField {
    let settings = &config.velocimetry;
    let margin = (settings.max_displacement_vox / 2.0).ceil() as usize + 1;
    let interrogation = Interrogation::new(&config.volume, margin, settings);
    let grid = interrogation.cloud_grid();
    let cloud = |frame| {
        let lit = truth.particles.iter().filter_map(|p| Some((p.lit_mm(frame)?, p.intensity)));
        PointCloud::from_particles(&lit.collect::<Vec<_>>(), &grid)
    };
    interrogation.measure(&cloud(FrameOfPair::A), &cloud(FrameOfPair::B), truth.dt_s)
}

/// Share of all components within `limit_vox` of the truth; those of vectors that are not valid
/// count as misses.
fn share_within(field: &VelocityField, flow: &Flow, limit_vox: f64) -> f64 {
    let errors = errors_vox(field, flow);
    let hits = errors.iter().zip(&field.status).map(|(error, status)| {
        let valid = *status == VectorStatus::Valid;
        error.iter().filter(|e| valid && e.abs() <= limit_vox).count()
    });
    hits.sum::<usize>() as f64 / (3 * errors.len()) as f64
}

fn print_field(name: &str, field: &VelocityField, flow: &Flow) {
    let [x, y, z] = mean_error_vox(field, flow);
    println!(
        "{name}: mean |error| {x:.4} {y:.4} {z:.4} voxels, {:.1} % within 0.3 voxels, {:.1} % \
         valid of {} vectors",
        100.0 * share_within(field, flow, 0.3),
        100.0 * field.valid_share(),
        field.grid.len()
    );
}

/// Measures a seeding of the ABC flow and checks the worst component against `most_vox` and
/// against `most_times` the floor.
fn check_abc(ppm: f64, most_vox: f64, most_times: f64, least_within: f64) {
    let flow = Flow::Abc(Abc { wavelength_mm: 10.0, amplitude_m_s: 2.0, coefficients: [1.0; 3] });
    let config = bench(ppm * BENCH_DENSITY, flow.clone());
    let (pair, truth) = simulated(&config, 3);
    let result = Processor::new(config.measurement()).unwrap().process(&pair).unwrap();
    assert!(result.warnings.is_empty(), "{:?}", result.warnings);
    let floor = floor(&config, &truth);
    print_field(&format!("{ppm} ppm, true particles"), &floor, &flow);
    print_field(&format!("{ppm} ppm, images"), &result.field, &flow);
    println!("{ppm} ppm: {:?}", result.seconds);
    let least = mean_error_vox(&floor, &flow);
    for (error, floor) in mean_error_vox(&result.field, &flow).into_iter().zip(least) {
        assert!(error <= most_vox, "{error}");
        assert!(error <= most_times * floor, "{error}, floor {floor}");
    }
    assert!(share_within(&result.field, &flow, 0.3) >= least_within);
}

#[test]
fn an_abc_flow_at_1_ppm_is_measured_near_the_floor() {
    check_abc(1.0, 0.109, 1.6, 0.96);
}

#[test]
fn an_abc_flow_at_0_3_ppm_is_measured_near_the_floor() {
    check_abc(0.3, 0.12, 1.25, 0.95);
}

#[test]
fn six_voxels_are_measured_by_windows_of_sixteen() {
    let flow = Flow::Uniform(Uniform { velocity_m_s: [6.0, -6.0, 6.0] });
    let config = bench(BENCH_DENSITY, flow.clone());
    let (pair, _) = simulated(&config, 4);
    let processor = Processor::new(config.measurement()).unwrap();
    let field = processor.process(&pair).unwrap().field;
    print_field("6 voxels", &field, &flow);
    assert!(mean_error_vox(&field, &flow).into_iter().all(|error| error < 0.1));
    assert!(share_within(&field, &flow, 0.3) >= 0.96);
}

/// The paper's particles, on voxel centres and still, reconstructed by `cameras` of the two; the
/// volume and the true one.
fn paper_case(voxels: [usize; 3], ppm: f64, cameras: usize) -> [DenseVolume; 2] {
    let mut config = reduced("paper", voxels, ppm * PAPER_DENSITY);
    config.camera.truncate(cameras);
    config.simulation.as_mut().unwrap().flow = Flow::default();
    let (pair, truth) = simulated(&config, 5);
    let processor = Processor::new(config.measurement()).unwrap();
    let (_, [volume, _]) = processor.process_with_volumes(&pair).unwrap();
    let mut intensity = vec![0.0; config.volume.len()];
    for particle in &truth.particles {
        let at = |axis: usize| config.volume.index_of(axis, particle.a_mm[axis]).round() as usize;
        intensity[config.volume.linear([at(0), at(1), at(2)])] = particle.intensity as f32;
    }
    let truth = DenseVolume { grid: config.volume.clone(), intensity };
    [volume, truth]
}

fn quality([volume, truth]: &[DenseVolume; 2]) -> f64 {
    quality_factor(&volume.intensity, &truth.intensity)
}

#[test]
fn particles_on_voxel_centres_are_reconstructed_to_the_papers_quality() {
    for (ppm, least) in [(1.0, 0.95), (0.1, 0.99)] {
        let quality = quality(&paper_case([60; 3], ppm, 2));
        println!("{ppm} ppm on voxel centres: Q {quality:.4}");
        assert!(quality >= least, "{ppm} ppm: {quality}");
    }
}

#[test]
fn one_camera_is_clearly_worse_than_two() {
    for ppm in [0.03, 0.3] {
        let [one, two] = [1, 2].map(|cameras| paper_case([40; 3], ppm, cameras));
        let fwhm_mm = |case: &[DenseVolume; 2]| elongation_mm(&case[0], 2).unwrap();
        println!(
            "{ppm} ppm: one camera Q {:.3}, FWHM along depth {:.3} mm; two cameras Q {:.3}, \
             {:.3} mm",
            quality(&one),
            fwhm_mm(&one),
            quality(&two),
            fwhm_mm(&two)
        );
        assert!(quality(&one) < quality(&two) - 0.2);
        assert!(fwhm_mm(&one) > 2.0 * fwhm_mm(&two));
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
