//! Expected processing time of a pair, extrapolated from a part of the volume.
//!
//! The work for a pair depends on the number of active voxels, which results from seeding, depths,
//! noise and solver together and has no simple formula. Therefore a part of the volume is simulated
//! and measured like any pair, on this machine under its present load, and the time is scaled.
//!
//! The part is a slab across an axis that every camera sees from the side. Depths, and thus shadow
//! widths and the share of false voxels, are those of the whole volume. SART on the whole volume
//! visits every voxel in every pass, so one pass over a cube is sufficient.

use anyhow::Context;
use lfpiv_core::{
    lightfield::{ImagePair, ImageSettings},
    measurement::{Plan, Processor},
    reconstruction::Solver,
    velocimetry::StageSeconds,
};
use lfpiv_sim::Scene;
use tracing::subscriber::NoSubscriber;

use crate::{
    config::{Config, VolumeTable},
    pipeline::monotonic,
};

/// Assumed particles per microlens if the configuration has no scene.
pub const ASSUMED_PPM: f64 = 0.5;

/// Edge of the cube, in voxels: large enough that the start of threads is negligible.
const CUBE_VOX: usize = 16;

/// Smallest thickness of the slab, in voxels.
const LEAST_SLAB_VOX: usize = 16;

/// Parts measured in less time than this are measured twice, because the first run has cold caches.
const SHORT_S: f64 = 1.0;

/// The expected seconds of a pair of `config`'s bench on this machine; `plan` is that of the whole
/// volume.
///
/// # Errors
/// A scene or a part of the volume that cannot be simulated or measured.
pub fn expected(config: &Config, plan: &Plan) -> anyhow::Result<StageSeconds> {
    // Log messages about the part would be misleading.
    tracing::subscriber::with_default(NoSubscriber::default(), || {
        expected_by(config, &|piece| measure(piece, plan))
    })
}

/// [`expected`], with the time for a part given by `measure`.
fn expected_by(
    config: &Config,
    measure: &dyn Fn(&Config) -> anyhow::Result<StageSeconds>,
) -> anyhow::Result<StageSeconds> {
    let settings = &config.reconstruction;
    let sart =
        matches!(settings.solver, Solver::Sart | Solver::OsSart) && !settings.on_active_voxels();
    let piece = if sart { one_pass(cube(config)) } else { slab(config) };
    let measured = measure(&piece).context("a part of the volume cannot be measured")?;
    let voxels = larger(config, &piece);
    let passes = if sart { config.reconstruction.sart_passes() as f64 } else { 1.0 };
    Ok(StageSeconds {
        decode_s: measured.decode_s,
        reconstruct_s: measured.reconstruct_s * voxels * passes,
        correlate_s: measured.correlate_s * voxels,
        judge_s: measured.judge_s * voxels,
    })
}

/// Seconds for a pair of this part. Decoding is scaled to the views of the whole volume.
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

/// Ratio of the volume to its part. Both are surrounded by voxels that may contain light: half of
/// the margin is counted.
fn larger(config: &Config, piece: &Config) -> f64 {
    let margin = config.velocimetry.margin_vox() as f64;
    let along = |axis: usize| {
        let [whole, part] = [config, piece].map(|c| c.volume.voxels[axis] as f64 + margin);
        whole / part
    };
    (0..3).map(along).product()
}

/// A slab across the longest axis that no camera looks along, with the seeding density of the
/// whole.
fn slab(config: &Config) -> Config {
    let from_the_side =
        |axis: &usize| config.camera.iter().all(|pose| pose.axis[*axis].abs() < 0.5);
    let across = (0..3).filter(from_the_side).max_by_key(|&axis| config.volume.voxels[axis]);
    let search = config.velocimetry.in_voxels(&config.volume.grid()).search;
    let mut most = config.volume.voxels;
    if let Some(axis) = across {
        most[axis] = search.max(LEAST_SLAB_VOX);
    }
    let mut slab = cut(config, most);
    // Seeding is counted per area of the volume's x and y, so a thinner z has fewer particles per
    // area.
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

/// A cube in the centre of the volume with the same number of particles per microlens.
fn cube(config: &Config) -> Config {
    let mut cube = cut(config, [CUBE_VOX; 3]);
    cube.simulation = Some(Scene { sheet_mm: None, ..scene(config) });
    cube
}

fn one_pass(mut piece: Config) -> Config {
    piece.reconstruction.passes = Some(1);
    piece
}

/// The configuration with the volume limited to `most` voxels, all of them flow. Image settings are reset, because
/// they describe images of the bench, not simulated ones.
fn cut(config: &Config, most: [usize; 3]) -> Config {
    let voxels = std::array::from_fn(|axis| config.volume.voxels[axis].min(most[axis]));
    Config {
        volume: VolumeTable { voxels, mask: None, ..config.volume.clone() },
        mask: None,
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

    /// The bench's cameras, with the second one at an angle of `degrees` to the first about x.
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

    /// Views times active voxels, summed over the passes. The solver's time is proportional to it,
    /// whatever the load of the machine.
    fn work(config: &Config) -> anyhow::Result<StageSeconds> {
        let (optics, scene) = (&config.optics, scene(config));
        let bench = config.bench_geometry();
        let reconstructor = Reconstructor::new(
            optics,
            &config.poses(),
            &config.volume.grid(),
            &config.reconstruction,
        )?;
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

    /// The work in a long volume is predicted from that in a slab, at low and high seeding, with
    /// cameras along the axes and at other angles.
    #[test]
    fn the_work_in_a_slab_predicts_that_in_the_volume() {
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
        // Cameras along x and y: the slab is across z, with fewer particles per microlens.
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
