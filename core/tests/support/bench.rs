//! A bench with its method, from a configuration file.

use std::path::Path;

use lfpiv_core::{
    lightfield::ImageSettings,
    measurement::Measurement,
    model::{ModelSettings, VolumeGrid, mode_or_table},
    reconstruction::ReconstructionSettings,
    velocimetry::{Placing, VelocimetrySettings},
};
use lfpiv_hw::{Optics, Pose};
use lfpiv_sim::{BenchGeometry, Scene, Volume};
use serde::Deserialize;

/// The tables of a configuration file that simulating and measuring need. The daemon reads the rest,
/// and checks the whole.
#[derive(Debug, Clone, Deserialize)]
pub struct Bench {
    pub optics: Optics,
    pub camera: Vec<Pose>,
    pub volume: VolumeGrid,
    pub shot: Shot,
    #[serde(default)]
    pub image: ImageSettings,
    #[serde(default, deserialize_with = "mode_or_table")]
    pub model: ModelSettings,
    #[serde(default)]
    pub reconstruction: ReconstructionSettings,
    #[serde(default)]
    pub velocimetry: VelocimetrySettings,
    pub simulation: Option<Scene>,
}

#[derive(Debug, Clone, Deserialize)]
pub struct Shot {
    pub dt_us: f64,
}

impl Bench {
    /// A configuration of the folder `config/`.
    pub fn shipped(name: &str) -> Self {
        Self::read(&format!("config/{name}.toml"))
    }

    /// A bench that is quick to simulate and to measure. The tests of the programs have fewer rays,
    /// less background and no placed particles, to be quicker; accuracy is tested with all of them.
    pub fn small() -> Self {
        let mut bench = Self::read("tests/data/small.toml");
        bench.velocimetry.place_particles = Placing::default();
        if let Some(scene) = &mut bench.simulation {
            scene.rays_per_particle = Scene::default().rays_per_particle;
            scene.sensor.background_electrons = 10.0;
        }
        bench
    }

    fn read(path: &str) -> Self {
        let project = Path::new(env!("CARGO_MANIFEST_DIR")).ancestors();
        let path = project.map(|folder| folder.join(path)).find(|path| path.is_file());
        let text = std::fs::read_to_string(path.expect("a file of the project")).unwrap();
        toml::from_str(&text).unwrap()
    }

    /// What the simulator needs of it.
    pub fn geometry(&self) -> BenchGeometry {
        BenchGeometry {
            optics: self.optics.clone(),
            poses: self.camera.clone(),
            volume: Volume {
                voxels: self.volume.voxels,
                voxel_mm: self.volume.voxel_mm,
                centre_mm: self.volume.centre_mm,
            },
            dt_s: self.shot.dt_us / 1e6,
            empty: None,
        }
    }

    /// What turns its image pairs into vectors.
    pub fn measurement(&self) -> Measurement {
        Measurement {
            calibrations: Vec::new(),
            optics: self.optics.clone(),
            cameras: self.camera.clone(),
            volume: self.volume.clone(),
            mask: None,
            image: self.image.clone(),
            model: self.model.clone(),
            reconstruction: self.reconstruction.clone(),
            velocimetry: self.velocimetry.clone(),
            spacing_mm: None,
            dt_s: self.shot.dt_us / 1e6,
        }
    }
}
