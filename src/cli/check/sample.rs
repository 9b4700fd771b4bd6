//! How long a pair will take here, measured on a piece of the volume.
//!
//! The work in a pair follows from how many voxels its light leaves possible, and that from seeding,
//! depths, noise and solver together. No formula says it well, so a piece of the volume is simulated
//! and measured as any pair is, on this machine as busy as it is, and its seconds are scaled.
//!
//! The piece is a slab across an axis that every camera sees from the side: depths, and so the
//! widths of shadows and the share of false voxels, are those of the whole volume. SART over the whole
//! volume visits every voxel in every pass, so one pass over a cube says all.

use anyhow::Context;
use lfpiv_core::{
    lightfield::{ImagePair, ImageSettings},
    measurement::{Plan, Processor},
    model::VolumeGrid,
    reconstruction::Solver,
    velocimetry::StageSeconds,
};
use lfpiv_sim::Scene;
use tracing::subscriber::NoSubscriber;

use crate::{config::Config, pipeline::monotonic};

/// Particles per microlens where the configuration has no scene that says it.
pub const ASSUMED_PPM: f64 = 0.5;

/// Edge of a cube, in voxels: wide enough that work and not the start of threads is measured.
const CUBE_VOX: usize = 16;

/// A slab is at least so thick, in voxels.
const LEAST_SLAB_VOX: usize = 16;

/// Pieces measured in less than this are measured twice: the first pair finds cold caches.
const SHORT_S: f64 = 1.0;

/// The seconds that a pair of `config`'s bench will take on this machine; `plan` is that of the whole
/// volume.
///
/// # Errors
/// A scene or a piece of the volume that cannot be simulated or measured.
pub fn expected(config: &Config, plan: &Plan) -> anyhow::Result<StageSeconds> {
    // What is logged about a piece is not about the bench.
    tracing::subscriber::with_default(NoSubscriber::default(), || {
        expected_by(config, &|piece| measure(piece, plan))
    })
}

/// [`expected`], with what a piece takes as `measure` tells it.
fn expected_by(
    config: &Config,
    measure: &dyn Fn(&Config) -> anyhow::Result<StageSeconds>,
) -> anyhow::Result<StageSeconds> {
    let settings = &config.reconstruction;
    let sart =
        matches!(settings.solver, Solver::Sart | Solver::OsSart) && !settings.on_active_voxels();
    let piece = if sart { one_pass(cube(config)) } else { slab(config) };
    let measured = measure(&piece).context("a piece of the volume cannot be measured")?;
    let voxels = larger(config, &piece);
    let passes = if sart { config.reconstruction.sart_passes() as f64 } else { 1.0 };
    Ok(StageSeconds {
        decode_s: measured.decode_s,
        reconstruct_s: measured.reconstruct_s * voxels * passes,
        correlate_s: measured.correlate_s * voxels,
        judge_s: measured.judge_s * voxels,
    })
}

/// Seconds of a pair of this piece. Decoding is scaled to the views of the whole volume.
fn measure(piece: &Config, whole: &Plan) -> anyhow::Result<StageSeconds> {
    let (bench, scene) = (piece.bench_geometry(), scene(piece));
    scene.check(&bench)?;
    let pair = ImagePair { cameras: scene.shot(&bench, scene.seed, 0).images };
    let processor = Processor::timed(piece.measurement(), monotonic)?;
    let mut seconds = processor.process(&pair)?.seconds;
    if seconds.total_s() < SHORT_S {
        let again = processor.process(&pair)?.seconds;
        seconds = if again.total_s() < seconds.total_s() { again } else { seconds };
    }
    seconds.decode_s *= whole.view_bytes as f64 / processor.plan().view_bytes.max(1) as f64;
    Ok(seconds)
}

fn scene(config: &Config) -> Scene {
    let assumed = || Scene { ppm: ASSUMED_PPM, ..Scene::default() };
    config.simulation.clone().unwrap_or_else(assumed)
}

/// How many times larger the volume is than its piece. Around both are voxels that light may be in:
/// half of the margin is counted.
fn larger(config: &Config, piece: &Config) -> f64 {
    let margin = config.velocimetry.max_displacement_vox / 2.0 + 1.0;
    let along = |axis: usize| {
        let [whole, part] = [config, piece].map(|c| c.volume.voxels[axis] as f64 + margin);
        whole / part
    };
    (0..3).map(along).product()
}

/// A slab across the longest axis that no camera looks along, seeded as densely as the whole.
fn slab(config: &Config) -> Config {
    let from_the_side =
        |axis: &usize| config.camera.iter().all(|pose| pose.axis[*axis].abs() < 0.5);
    let across = (0..3).filter(from_the_side).max_by_key(|&axis| config.volume.voxels[axis]);
    let search = config.velocimetry.in_voxels(&config.volume).search;
    let mut most = config.volume.voxels;
    if let Some(axis) = across {
        most[axis] = search.max(LEAST_SLAB_VOX);
    }
    let mut slab = cut(config, most);
    // Seeding counts particles per area of the volume's x and y: a thinner z has fewer.
    let thinner = slab.volume.voxels[2] as f64 / config.volume.voxels[2] as f64;
    let scene = scene(config);
    let sheet_mm = scene.sheet_mm.map(|mut sheet| {
        if let Some(axis) = across {
            sheet[axis] = sheet[axis].min(most[axis] as f64 * config.volume.voxel_mm);
        }
        sheet
    });
    slab.simulation = Some(Scene { ppm: scene.ppm * thinner, sheet_mm, ..scene });
    slab
}

/// A cube in the volume's middle with as many particles under a microlens.
fn cube(config: &Config) -> Config {
    let mut cube = cut(config, [CUBE_VOX; 3]);
    cube.simulation = Some(Scene { sheet_mm: None, ..scene(config) });
    cube
}

fn one_pass(mut piece: Config) -> Config {
    piece.reconstruction.passes = Some(1);
    piece
}

/// The configuration for a part of its volume, at most so many voxels long. What is known about
/// images holds for those of the bench, not for simulated ones.
fn cut(config: &Config, most: [usize; 3]) -> Config {
    let VolumeGrid { voxels, .. } = config.volume;
    let voxels = std::array::from_fn(|axis| voxels[axis].min(most[axis]));
    Config {
        volume: VolumeGrid { voxels, ..config.volume.clone() },
        image: ImageSettings::default(),
        ..config.clone()
    }
}

#[cfg(test)]
mod tests {
    use lfpiv_hw::Pose;
    use lfpiv_sim::FrameOfPair;
    use nalgebra::Vector3;

    use super::*;
    use crate::config::CameraTable;
    use lfpiv_core::{
        lightfield::{PhotometricZones, ViewLayout},
        reconstruction::{Reconstructor, ViewLevels},
    };

    /// The second camera of the bench, turned about x until it looks `degrees` beside the first.
    fn cameras(degrees: f64) -> Vec<CameraTable> {
        let mut poses = small().camera;
        let (sin, cos) = degrees.to_radians().sin_cos();
        poses[1].axis = Vector3::new(0.0, sin, cos);
        poses[1].up = Vector3::new(0.0, cos, -sin);
        poses
    }

    fn small() -> Config {
        let text = include_str!("../../../tests/data/small.toml");
        Config::parse("small", text).unwrap()
    }

    /// Views times active voxels, summed over the passes: what the solver's time goes with, whatever
    /// the machine does besides.
    fn work(config: &Config) -> anyhow::Result<StageSeconds> {
        let (optics, scene) = (&config.optics, scene(config));
        let bench = config.bench_geometry();
        let reconstructor =
            Reconstructor::new(optics, &config.poses(), &config.volume, &config.reconstruction)?;
        let layouts = reconstructor.layouts();
        let truth = scene.truth(&bench, scene.seed, 0);
        let decode = |(camera, layout): (usize, &ViewLayout)| {
            let light = scene.light(&bench, &truth, camera, FrameOfPair::A);
            let image = scene.sensor.expose(&light, &[1, 0, camera as u64, 0]);
            let zones = PhotometricZones::of(optics, layout);
            let levels = zones.levels(&image, &config.image);
            let views = layout.decode_above_black(&image, &levels);
            let levels = ViewLevels::of(&views, levels.noise_counts);
            (views, levels)
        };
        let (views, levels): (Vec<_>, Vec<_>) = layouts.iter().enumerate().map(decode).unzip();
        let solved = reconstructor.reconstruct(&views, &levels);
        let per_pass: usize = layouts.iter().map(|layout| layout.views.len()).sum();
        let active: usize = solved.passes.iter().map(|pass| pass.active_voxels).sum();
        let reconstruct_s = (per_pass * active) as f64;
        Ok(StageSeconds { reconstruct_s, ..StageSeconds::default() })
    }

    /// The work in a long volume follows from that in a slab of it, at light seeding and at heavy,
    /// with cameras along the axes and beside them.
    #[test]
    fn the_work_in_a_slab_tells_that_in_the_volume() {
        let mut config = small();
        config.optics.microlens.columns = 81;
        config.optics.sensor.columns = 1480;
        config.volume.voxels = [64, 20, 16];
        for (ppm, degrees) in [(0.2, 90.0), (1.0, 90.0), (0.2, 60.0)] {
            config.simulation.as_mut().unwrap().ppm = ppm;
            config.camera = cameras(degrees);
            let whole = work(&config).unwrap().reconstruct_s;
            let expected = expected_by(&config, &work).unwrap();
            let ratio = expected.reconstruct_s / whole;
            assert!((0.5..2.0).contains(&ratio), "{ppm} per microlens, {degrees} degrees: {ratio}");
        }
    }

    #[test]
    fn a_slab_keeps_depths_and_density() {
        let mut config = small();
        config.volume.voxels = [100, 20, 16];
        let piece = slab(&config);
        assert_eq!(piece.volume.voxels, [16, 20, 16]);
        assert_eq!(piece.simulation.as_ref().unwrap().ppm, scene(&config).ppm);
        assert!((larger(&config, &piece) - 102.0 / 18.0).abs() < 1e-12);
        // Cameras along x and y: the slab lies across z, with fewer particles under a microlens.
        config.volume.voxels = [20, 20, 64];
        let x = Pose {
            right: -Vector3::z(),
            up: Vector3::y(),
            axis: Vector3::x(),
            origin_mm: Vector3::zeros(),
        };
        let y = config.camera[1].clone();
        config.camera = vec![x.into(), y];
        let piece = slab(&config);
        assert_eq!(piece.volume.voxels, [20, 20, 16]);
        let thinner = piece.simulation.unwrap().ppm / scene(&config).ppm;
        assert!((thinner - 0.25).abs() < 1e-12);
    }
}
