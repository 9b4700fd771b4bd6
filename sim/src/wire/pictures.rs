//! Sources of the cameras' images.

use lfpiv_hw::RawImage;

use crate::{BenchGeometry, LightPulse, Scene};

/// Response of a camera to one trigger.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum Delivery {
    /// Exposures 1 and 2. A frame without an image is counted by the camera and lost in transit.
    Frames([Option<RawImage>; 2]),
    /// The camera does not see the trigger: there is no frame, and none is counted.
    Missed,
}

impl From<[RawImage; 2]> for Delivery {
    fn from(images: [RawImage; 2]) -> Self {
        Self::Frames(images.map(Some))
    }
}

/// Makes the images of a shot from the light in its exposures.
pub trait Pictures: Send + Sync {
    /// Exposures 1 and 2 of every camera. `light` is the light in each exposure, per camera;
    /// `separation_s` the time between the pulses, `None` unless both were fired.
    fn of(
        &self,
        shot: u64,
        light: &[[Vec<LightPulse>; 2]],
        separation_s: Option<f64>,
    ) -> Vec<Delivery>;
}

/// A ray-traced scene.
#[derive(Debug, Clone)]
pub struct ScenePictures {
    /// The scene.
    pub scene: Scene,
    /// Camera poses; `dt_s` is used for shots without a pulse separation.
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
