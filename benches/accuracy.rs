//! The figures of the shipped cases, measured from end to end: `cargo bench --bench accuracy`.
//!
//! Each case is ray-traced by the simulator and measured by the processor. The floor is the error
//! of correlating the true particles through the same windows and passes: what is left when the
//! reconstruction is perfect. `cargo bench --bench accuracy -- bench` runs the cases whose name
//! contains "bench".

use std::path::Path;

use lfpiv::{
    config::{Config, ConfigFile},
    pipeline::{ImagePair, Processor},
    reconstruction::quality::quality_factor,
    velocimetry::{Interrogation, PointCloud, VectorStatus, VelocityField},
};
use lfpiv_sim::{
    Flow, Scene, Truth,
    flow::Uniform,
    particles::{FrameOfPair, Placement},
};

const SEEDS: [u64; 3] = [1, 2, 3];

fn main() -> anyhow::Result<()> {
    let wanted = std::env::args().skip(1).find(|a| !a.starts_with('-')).unwrap_or_default();
    let run = |name: &str| name.contains(&wanted);
    for ppm in [1.0, 0.3] {
        if run("bench") {
            let mut config = load("bench")?;
            scene(&mut config)?.ppm = ppm;
            velocity(&format!("bench {ppm} ppm"), &config)?;
        }
    }
    for (cameras, ppm) in [(2, 1.0), (2, 0.1), (1, 0.1)] {
        if run("paper") {
            let mut config = load("paper")?;
            config.camera.truncate(cameras);
            let scene = scene(&mut config)?;
            scene.ppm = ppm;
            scene.placement = Placement::OnGrid;
            scene.flow = Flow::Uniform(Uniform { velocity_m_s: [0.0; 3] });
            quality(&format!("paper {ppm} ppm, {cameras} camera(s)"), &config)?;
        }
    }
    if run("large") {
        let mut config = load("paper")?;
        let off_grid = load("bench")?.simulation;
        config.simulation = off_grid;
        velocity("large 100^3 on the paper's sensor, 1 ppm", &config)?;
    }
    Ok(())
}

fn load(name: &str) -> anyhow::Result<Config> {
    let root = Path::new(env!("CARGO_MANIFEST_DIR"));
    Ok(ConfigFile::load(&root.join(format!("config/{name}.toml")))?.config)
}

fn scene(config: &mut Config) -> anyhow::Result<&mut Scene> {
    config.simulation.as_mut().ok_or_else(|| anyhow::anyhow!("the case has no [simulation]"))
}

/// Error of the measured velocity beside the floor.
fn velocity(name: &str, config: &Config) -> anyhow::Result<()> {
    let processor = Processor::new(config.measurement())?;
    let (bench, mut config) = (config.bench_geometry(), config.clone());
    let floor_windows = Interrogation::new(&config.volume, 4, &config.velocimetry);
    let scene = scene(&mut config)?.clone();
    for seed in SEEDS {
        let shot = scene.shot(&bench, seed, 0);
        let clouds = [FrameOfPair::A, FrameOfPair::B]
            .map(|frame| particles(&shot.truth, frame, &floor_windows));
        let floor = floor_windows.measure(&clouds[0], &clouds[1], bench.dt_s);
        let result = processor.process(&ImagePair { cameras: shot.images })?;
        let (floor, error) = (score(&floor, &scene.flow), score(&result.field, &scene.flow));
        let ratio: Vec<String> =
            (0..3).map(|c| format!("{:.2}", error.mean_vox[c] / floor.mean_vox[c])).collect();
        println!(
            "{name}, seed {seed}: mean |error| {} voxel, floor {}, ratio {}; within 0.3 voxel \
             {:.1} %; decode {:.2} s, reconstruct {:.2} s, correlate {:.2} s",
            three(error.mean_vox),
            three(floor.mean_vox),
            ratio.join(" "),
            100.0 * error.within,
            result.seconds.decode_s,
            result.seconds.reconstruct_s,
            result.seconds.correlate_s,
        );
    }
    Ok(())
}

/// Q against the particles on their voxels.
fn quality(name: &str, config: &Config) -> anyhow::Result<()> {
    let processor = Processor::new(config.measurement())?;
    let (bench, mut config) = (config.bench_geometry(), config.clone());
    let grid = config.volume.clone();
    let scene = scene(&mut config)?.clone();
    for seed in SEEDS {
        let shot = scene.shot(&bench, seed, 0);
        let mut truth = vec![0.0f32; grid.len()];
        for particle in &shot.truth.particles {
            let index = |a: usize| grid.index_of(a, particle.mid_mm[a]).round() as usize;
            truth[grid.linear([index(0), index(1), index(2)])] += particle.intensity as f32;
        }
        let pair = ImagePair { cameras: shot.images };
        let (result, volumes) = processor.process_with_volumes(&pair)?;
        println!(
            "{name}, seed {seed}: Q {:.4}; reconstruct {:.2} s for two frames",
            quality_factor(&volumes[0].intensity, &truth),
            result.seconds.reconstruct_s,
        );
    }
    Ok(())
}

fn particles(truth: &Truth, frame: FrameOfPair, windows: &Interrogation) -> PointCloud {
    let lit: Vec<([f64; 3], f64)> = truth
        .particles
        .iter()
        .filter_map(|p| p.lit_mm(frame).map(|at| (at, p.intensity)))
        .collect();
    PointCloud::from_particles(&lit, &windows.cloud_grid())
}

struct Score {
    mean_vox: [f64; 3],
    /// Share of all components within 0.3 voxel; those of invalid vectors count as misses.
    within: f64,
}

fn score(field: &VelocityField, flow: &Flow) -> Score {
    let (mut sum, mut within) = ([0.0; 3], 0);
    for n in 0..field.grid.len() {
        let truth = flow.displacement_mm(field.grid.position_mm(n), field.dt_s);
        for c in 0..3 {
            let error = (f64::from(field.displacement_vox[n][c]) - truth[c] / field.voxel_mm).abs();
            sum[c] += error;
            within += usize::from(error < 0.3 && field.status[n] == VectorStatus::Valid);
        }
    }
    let n = field.grid.len() as f64;
    Score { mean_vox: sum.map(|s| s / n), within: within as f64 / (3.0 * n) }
}

fn three(values: [f64; 3]) -> String {
    values.map(|v| format!("{v:.4}")).join(" ")
}
