//! The configuration: one TOML file describes bench, volume, method and, for simulated runs,
//! the scene. Each room owns the settings of its own table; this file only puts them together.

use std::{net::SocketAddr, path::PathBuf};

use garde::Validate;
use lfpiv_hw::{Optics, Pose};
use lfpiv_sim::Scene;
use serde::{Deserialize, Serialize};

use crate::{
    lightfield::ImageSettings, model::VolumeGrid, pipeline::Measurement,
    reconstruction::ReconstructionSettings, velocimetry::VelocimetrySettings,
};

/// A whole configuration file.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, Validate)]
#[serde(deny_unknown_fields)]
pub struct Config {
    /// The optics that all cameras share.
    #[garde(dive)]
    pub optics: Optics,
    /// Where the cameras stand; one or two.
    #[garde(length(min = 1, max = 2), dive)]
    pub camera: Vec<Pose>,
    /// The measurement volume.
    #[garde(dive)]
    pub volume: VolumeGrid,
    /// Laser and shot timing.
    #[garde(dive)]
    pub shot: ShotSettings,
    /// What is known about the images.
    #[serde(default)]
    #[garde(dive)]
    pub image: ImageSettings,
    /// How volumes are reconstructed.
    #[serde(default)]
    #[garde(dive)]
    pub reconstruction: ReconstructionSettings,
    /// How volumes are correlated.
    #[serde(default)]
    #[garde(dive)]
    pub velocimetry: VelocimetrySettings,
    /// Worker pool and queue.
    #[serde(default)]
    #[garde(dive)]
    pub pipeline: PipelineSettings,
    /// HTTP.
    #[serde(default)]
    #[garde(skip)]
    pub server: ServerSettings,
    /// Where results go.
    #[serde(default)]
    #[garde(skip)]
    pub output: OutputSettings,
    /// The simulated bench; without it a run needs hardware.
    #[serde(default)]
    #[garde(dive)]
    pub simulation: Option<Scene>,
}

/// Timing of a shot.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, Validate)]
#[serde(deny_unknown_fields)]
pub struct ShotSettings {
    /// Time between the two laser pulses, in µs.
    #[garde(range(min = 0.1, max = 1e6))]
    pub dt_us: f64,
    /// Shots per second.
    #[garde(range(min = 0.001, max = 1000.0))]
    pub rate_hz: f64,
}

/// Worker pool and its queue.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, Validate)]
#[serde(deny_unknown_fields, default)]
pub struct PipelineSettings {
    /// Image pairs that may wait for a worker; the live path sheds beyond this.
    #[garde(range(min = 1, max = 1000))]
    pub queue: usize,
}

impl Default for PipelineSettings {
    fn default() -> Self {
        Self { queue: 4 }
    }
}

/// The HTTP endpoint.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields, default)]
pub struct ServerSettings {
    /// Address to bind; loopback unless changed.
    pub address: SocketAddr,
}

impl Default for ServerSettings {
    fn default() -> Self {
        Self { address: SocketAddr::from(([127, 0, 0, 1], 8640)) }
    }
}

/// Where a run's results go.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields, default)]
pub struct OutputSettings {
    /// Folder under which every run makes its own.
    pub dir: PathBuf,
}

impl Default for OutputSettings {
    fn default() -> Self {
        Self { dir: PathBuf::from("results") }
    }
}

impl Config {
    /// The part of the configuration that turns image pairs into vectors.
    pub fn measurement(&self) -> Measurement {
        Measurement {
            optics: self.optics.clone(),
            cameras: self.camera.clone(),
            volume: self.volume.clone(),
            image: self.image.clone(),
            reconstruction: self.reconstruction.clone(),
            velocimetry: self.velocimetry.clone(),
            dt_s: self.shot.dt_us * 1e-6,
        }
    }
}
