//! One camera's image of one frame, and its model from the current particles.

use std::sync::Arc;

use lfpiv_hw::RawImage;

use super::{
    kernels::{self, Equations},
    noise::{PixelNoise, noise_of},
    prefetch::prefetch,
};
use crate::{
    lightfield::LightLevels,
    model::{LANES, PointCamera, PointFootprint},
};

/// A raw image and the model of it.
#[derive(Debug, Clone)]
pub struct ParticleImage {
    /// Counts, row-major, and [`LANES`] more values. Copies of the image share them.
    counts: Arc<[u16]>,
    /// Expected value of each pixel from the particles, in counts above `black`; same length.
    model: Vec<f32>,
    width: usize,
    /// Count of a pixel without light from particles.
    black: f32,
    /// Saturation count.
    saturation: u16,
    /// Noise of its pixels.
    pub noise: PixelNoise,
}

impl ParticleImage {
    /// An image without particles.
    pub fn new(image: &RawImage, levels: &LightLevels, noise: PixelNoise) -> Self {
        let padding = [0; LANES];
        let counts: Arc<[u16]> = image.counts().iter().chain(&padding).copied().collect();
        let model = vec![0.0; counts.len()];
        let black = (levels.offset_counts + levels.background_counts) as f32;
        let saturation = levels.saturation_counts.unwrap_or(u16::MAX);
        Self { counts, model, width: image.columns(), black, saturation, noise }
    }

    /// Removes all particles from the model.
    pub fn clear(&mut self) {
        self.model.fill(0.0);
    }

    /// Makes its model that of `other`, an image of the same size.
    pub fn copy_model(&mut self, other: &Self) {
        self.model.copy_from_slice(&other.model);
    }

    /// Adds a particle of `light` counts in an open pixel to the model; negative light removes it.
    pub fn add(&mut self, camera: &PointCamera, footprint: &PointFootprint, light: f32) {
        let (open, stride) = (camera.open_shares(), camera.open_stride());
        kernels::add_image(&mut self.model, self.width, open, stride, footprint, light);
    }

    /// Asks the processor for the pixels of a particle whose equations are summed up soon. The rows of its image are
    /// on pages of their own, and the processor does not foresee them.
    pub fn prefetch(&self, camera: &PointCamera, footprint: &PointFootprint) {
        self.prefetch_rows::<true>(camera, footprint);
    }

    /// The same for a particle that is added to the model soon.
    pub fn prefetch_model(&self, camera: &PointCamera, footprint: &PointFootprint) {
        self.prefetch_rows::<false>(camera, footprint);
    }

    fn prefetch_rows<const COUNTS: bool>(&self, camera: &PointCamera, footprint: &PointFootprint) {
        for patch in &footprint.patches {
            let columns = patch.columns.len.next_multiple_of(LANES);
            let mut first = patch.rows.first_px * self.width + patch.columns.first_px;
            let mut open = patch.open;
            for _ in 0..patch.rows.len {
                for at in [first, first + columns - 1] {
                    prefetch(&self.model, at);
                    if COUNTS {
                        prefetch(&self.counts, at);
                    }
                }
                prefetch(camera.open_shares(), open);
                first += self.width;
                open += camera.open_stride();
            }
        }
    }

    /// Normal equations of a particle from the residual.
    pub fn equations(&self, camera: &PointCamera, footprint: &PointFootprint) -> Equations {
        let (open, stride) = (camera.open_shares(), camera.open_stride());
        kernels::equations::<false>(&self.view(), open, stride, footprint)
    }

    /// The same with the covariance of the gradient in place of the matrix.
    pub fn gradient_covariance(
        &self,
        camera: &PointCamera,
        footprint: &PointFootprint,
    ) -> Equations {
        let (open, stride) = (camera.open_shares(), camera.open_stride());
        kernels::equations::<true>(&self.view(), open, stride, footprint)
    }

    /// Normal equation of a particle's light alone: Σ g r / v and Σ g² / v, with g its image per unit of
    /// light.
    pub fn light_equation(&self, camera: &PointCamera, footprint: &PointFootprint) -> [f64; 2] {
        let (open, stride) = (camera.open_shares(), camera.open_stride());
        kernels::light_equation(&self.view(), open, stride, footprint)
    }

    /// Sum of squared residuals over a particle's pixels, each weighted by the particle's share of light in it and by
    /// 1 / variance as `reference` models it.
    ///
    /// For the comparison of models: weights from each model itself would favour the one with more noise.
    pub fn weighted_residual(
        &self,
        reference: &Self,
        camera: &PointCamera,
        footprint: &PointFootprint,
    ) -> f64 {
        let mut sum = 0.0;
        for patch in &footprint.patches {
            let columns = footprint.of(0, &patch.columns);
            for (r, &row) in footprint.of(0, &patch.rows).iter().enumerate() {
                let first = (patch.rows.first_px + r) * self.width + patch.columns.first_px;
                let open = &camera.open_shares()[patch.open + r * camera.open_stride()..];
                for (c, &column) in columns.iter().enumerate() {
                    let at = first + c;
                    if self.counts[at] >= self.saturation {
                        continue;
                    }
                    let variance = reference.noise.variance(reference.model[at]);
                    let residual = f32::from(self.counts[at]) - self.black - self.model[at];
                    let share = column * row * f32::from(open[c]) / 255.0;
                    sum += f64::from(share * residual * residual / variance);
                }
            }
        }
        sum
    }

    fn view(&self) -> kernels::ImageSlices<'_> {
        kernels::ImageSlices {
            counts: &self.counts,
            model: &self.model,
            width: self.width,
            black: self.black,
            saturation: self.saturation,
            noise: self.noise,
        }
    }

    /// Noise of its pixels, estimated from the residual; that of dark pixels is kept.
    pub fn noise_of_residual(&self) -> PixelNoise {
        let pixels = self.counts.len() - LANES;
        let residual =
            |n: usize| (self.model[n], f32::from(self.counts[n]) - self.black - self.model[n]);
        let seen = (0..pixels).filter(|&n| self.counts[n] < self.saturation).map(residual);
        noise_of(seen, self.noise.dark)
    }
}
