//! True volumes, and images cut into views.

use lfpiv_core::{
    lightfield::{PhotometricZones, ViewStack},
    model::VolumeGrid,
    reconstruction::{DenseVolume, Reconstructor, ViewLevels},
    velocimetry::{Interrogation, PointCloud},
};
use lfpiv_hw::Optics;
use lfpiv_sim::{FrameOfPair, Scene, Truth};

use super::{BenchmarkError, case::Setting};

/// One frame of all cameras as the solver gets it.
pub struct Frame {
    /// Per camera, in counts above the black level.
    pub views: Vec<ViewStack>,
    /// Per camera.
    pub levels: Vec<ViewLevels>,
}

impl Frame {
    /// Simulates what the cameras see of `truth` in frame a and decodes it as the processor does:
    /// black level and noise are estimated from the image.
    pub fn simulate(setting: &Setting, truth: &Truth, reconstructor: &Reconstructor) -> Self {
        let mut frame = Self { views: Vec::new(), levels: Vec::new() };
        for (camera, layout) in reconstructor.layouts().iter().enumerate() {
            let light = setting.scene.light(&setting.bench, truth, camera, FrameOfPair::A);
            let key = [truth.seed, truth.shot, camera as u64, 0];
            let image = setting.scene.sensor.expose(&light, &key);
            let zones = PhotometricZones::of(&setting.bench.optics, layout);
            let levels = zones.levels(&image, &setting.config.image);
            let views = layout.decode_above_black(&image, &levels);
            frame.levels.push(ViewLevels::of(&views, levels.noise_counts));
            frame.views.push(views);
        }
        frame
    }
}

/// The true volume of frame a, in the intensities of [`lfpiv_core::model::ForwardModel`]: every particle
/// trilinearly on the eight voxels about it, which for one on a voxel centre is that voxel.
pub fn true_volume(setting: &Setting, truth: &Truth, grid: &VolumeGrid) -> DenseVolume {
    let counts = counts_per_open_cell(&setting.bench.optics, &setting.scene);
    let mut volume = DenseVolume { grid: grid.clone(), intensity: vec![0.0; grid.len()] };
    for particle in &truth.particles {
        let Some(at_mm) = particle.lit_mm(FrameOfPair::A) else { continue };
        let at: [f64; 3] = std::array::from_fn(|axis| grid.index_of(axis, at_mm[axis]));
        for corner in 0..8 {
            let index = std::array::from_fn(|a| at[a].floor() as i64 + (corner >> a & 1));
            let weight: f64 = (0..3).map(|a| 1.0 - (at[a] - index[a] as f64).abs()).product();
            let inside = (0..3).all(|a| (0..grid.voxels[a] as i64).contains(&index[a]));
            if inside {
                let voxel = grid.linear(index.map(|i| i as usize));
                volume.intensity[voxel] += (particle.intensity * counts * weight) as f32;
            }
        }
    }
    volume
}

/// Counts of the mean particle in a pixel whose pupil cell is open and that gets all of its light.
fn counts_per_open_cell(optics: &Optics, scene: &Scene) -> f64 {
    let pupil_mm2 = std::f64::consts::PI * (optics.pupil_diameter_mm() / 2.0).powi(2);
    let share = optics.pupil_cell_mm().powi(2) / pupil_mm2;
    scene.particle_photoelectrons * scene.sensor.gain_counts_per_electron * share
}

/// The true particles of one frame as the correlation gets light.
pub fn true_cloud(truth: &Truth, frame: FrameOfPair, windows: &Interrogation) -> PointCloud {
    let lit = truth.particles.iter().filter_map(|p| Some((p.lit_mm(frame)?, p.intensity)));
    PointCloud::from_particles(&lit.collect::<Vec<_>>(), &windows.cloud_grid())
}

/// The solver for a setting's own volume, without the margin that velocimetry adds.
pub fn reconstructor(config: &lfpiv::config::Config) -> Result<Reconstructor, BenchmarkError> {
    let (optics, poses) = (&config.optics, &config.poses());
    Ok(Reconstructor::new(optics, poses, &config.volume.grid(), &config.reconstruction)?)
}
