//! White and dark images: images of a diffuser, and images with the lens covered.

use lfpiv_hw::RawImage;

use super::Scene;
use crate::{
    geometry::BenchGeometry,
    imaging::{ElectronImage, TrueMicroImageGrid},
    sensor::SensorSettings,
};

/// Rays per microlens of a white image, relative to the rays of a particle. With the default number
/// a pixel's light scatters by 2.3 %, about as much as by shot noise.
const WHITE_RAYS: usize = 8;

/// Brightest pixel of a white image, as a share of the sensor's range above the black level.
const WHITE_LEVEL: f64 = 0.7;

/// Number of an exposure in the random streams; those of a pair are 0 and 1.
#[derive(Debug, Clone, Copy)]
pub(super) enum Exposure {
    White = 2,
    Dark = 3,
    Card = 4,
}

impl Scene {
    /// Light on a camera's sensor from a diffuser that fills the pupil, exposed so that the
    /// brightest pixel fills 0.7 of the sensor's range, without background and noise. It is the
    /// same for all white images of a camera. Dark if the bench has no such camera.
    pub fn white_light(&self, bench: &BenchGeometry, camera: usize) -> ElectronImage {
        let (rays, electrons) = self.white_exposure(camera);
        match self.tracer(bench, camera) {
            None => ElectronImage::dark(&bench.optics),
            Some(tracer) => tracer.trace_white(rays, electrons, &[camera as u64]),
        }
    }

    /// Rays per microlens, and photo-electrons of the brightest pixel.
    pub(super) fn white_exposure(&self, camera: usize) -> (usize, f64) {
        let sensor = self.sensor_of(camera);
        let range_counts = f64::from(sensor.saturation_counts()) - sensor.offset_counts;
        let electrons = WHITE_LEVEL * range_counts / sensor.gain_counts_per_electron
            - sensor.background_electrons;
        (WHITE_RAYS * self.rays_per_particle, electrons.max(0.0))
    }

    /// White images 0 … `count` − 1 of a camera: equal light, traced once, with different noise.
    pub fn white_images(
        &self,
        bench: &BenchGeometry,
        camera: usize,
        seed: u64,
        count: u64,
    ) -> impl Iterator<Item = RawImage> + use<> {
        let (light, sensor) = (self.white_light(bench, camera), self.sensor_of(camera));
        let key = move |n| [seed, n, camera as u64, Exposure::White as u64];
        (0..count).map(move |n| sensor.expose(&light, &key(n)))
    }

    /// Dark images 0 … `count` − 1 of a camera: black level and read noise only.
    pub fn dark_images(
        &self,
        bench: &BenchGeometry,
        camera: usize,
        seed: u64,
        count: u64,
    ) -> impl Iterator<Item = RawImage> + use<> {
        let light = ElectronImage::dark(&bench.optics);
        let sensor = SensorSettings { background_electrons: 0.0, ..self.sensor_of(camera) };
        let key = move |n| [seed, n, camera as u64, Exposure::Dark as u64];
        (0..count).map(move |n| sensor.expose(&light, &key(n)))
    }

    /// The true micro-image grid of a camera; `None` if the bench has no such camera.
    pub fn micro_image_grid(
        &self,
        bench: &BenchGeometry,
        camera: usize,
    ) -> Option<TrueMicroImageGrid> {
        self.tracer(bench, camera).map(|tracer| tracer.micro_image_grid())
    }
}
