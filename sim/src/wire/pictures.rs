//! What the cameras see.

use lfpiv_hw::RawImage;

use crate::{BenchGeometry, LightPulse, Scene};

/// What a camera makes of one trigger.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum Delivery {
    /// Exposures 1 and 2. A frame without an image is counted by the camera and lost on its way.
    Frames([Option<RawImage>; 2]),
    /// The camera does not see the trigger: there is no frame, and none is counted.
    Missed,
}

impl From<[RawImage; 2]> for Delivery {
    fn from(images: [RawImage; 2]) -> Self {
        Self::Frames(images.map(Some))
    }
}

/// Makes the pictures of a shot from the light that fell into its exposures.
pub trait Pictures: Send + Sync {
    /// Exposures 1 and 2 of every camera. `light` is what fell into them, per camera;
    /// `separation_s` the time between the pulses, `None` unless both were fired.
    fn of(
        &self,
        shot: u64,
        light: &[[Vec<LightPulse>; 2]],
        separation_s: Option<f64>,
    ) -> Vec<Delivery>;
}

/// A scene by ray tracing.
#[derive(Debug, Clone)]
pub struct ScenePictures {
    /// What is in front of the cameras.
    pub scene: Scene,
    /// Where they stand; `dt_s` is that of shots whose pulses do not tell.
    pub geometry: BenchGeometry,
    /// Seed of the run.
    pub seed: u64,
}

impl Pictures for ScenePictures {
    fn of(
        &self,
        shot: u64,
        light: &[[Vec<LightPulse>; 2]],
        separation_s: Option<f64>,
    ) -> Vec<Delivery> {
        let dt_s = separation_s.filter(|s| *s > 0.0).unwrap_or(self.geometry.dt_s);
        let geometry = BenchGeometry { dt_s, ..self.geometry.clone() };
        let shown = self.scene.exposures(&geometry, self.seed, shot, light);
        shown.images.into_iter().map(Delivery::from).collect()
    }
}
