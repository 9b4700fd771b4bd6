//! One and two light-field cameras.

use lfpiv::{config::Config, pipeline::monotonic};
use lfpiv_core::{
    lightfield::ImagePair,
    measurement::Processor,
    velocimetry::{VectorGrid, VelocityField},
};

use crate::BenchmarkError;

/// Some of the bench's cameras.
pub(super) struct LightField {
    name: &'static str,
    cameras: Vec<usize>,
    processor: Processor,
}

impl LightField {
    /// Each camera by itself, and both.
    pub fn all(config: &Config) -> Result<Vec<Self>, BenchmarkError> {
        let some: [(&str, &[usize]); 3] = [
            ("single camera 1 (depth z)", &[0]),
            ("single camera 2 (depth x)", &[1]),
            ("dual cameras", &[0, 1]),
        ];
        some.into_iter().map(|(name, cameras)| Self::new(config, name, cameras)).collect()
    }

    fn new(config: &Config, name: &'static str, cameras: &[usize]) -> Result<Self, BenchmarkError> {
        let mut config = config.clone();
        config.camera = config
            .camera
            .into_iter()
            .enumerate()
            .filter_map(|(n, camera)| cameras.contains(&n).then_some(camera))
            .collect();
        let processor = Processor::timed(config.measurement(), monotonic)?;
        Ok(Self { name, cameras: cameras.to_vec(), processor })
    }

    pub fn name(&self) -> &'static str {
        self.name
    }

    /// Where the vectors will be.
    pub fn vector_grid(&self) -> VectorGrid {
        self.processor.interrogation().vector_grid()
    }

    /// The velocity from these cameras' images of a pair.
    pub fn measure(&self, pair: &ImagePair) -> Result<VelocityField, BenchmarkError> {
        let cameras = self.cameras.iter().filter_map(|&n| pair.cameras.get(n).cloned()).collect();
        Ok(self.processor.process(ImagePair { cameras })?.field)
    }
}
