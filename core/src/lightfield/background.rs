//! Stationary light: reflections and background that are common to all images of a run.

use lfpiv_hw::RawImage;

/// Offset added after the subtraction of stationary light, so that unsigned counts can represent negative noise. It
/// is the black level of the corrected image.
const PEDESTAL_COUNTS: f32 = 256.0;

/// How the images of a run are combined.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Condensation {
    /// Pixelwise minimum.
    Minimum,
    /// Pixelwise mean.
    Mean,
}

/// Stationary light of one camera and frame, estimated from images of a run.
#[derive(Debug, Clone)]
pub struct StationaryLight {
    condensation: Condensation,
    images: usize,
    columns: usize,
    level: Vec<f32>,
}

impl StationaryLight {
    /// Starts from one image.
    pub fn new(condensation: Condensation, image: &RawImage) -> Self {
        let level = image.counts().iter().map(|&count| f32::from(count)).collect();
        Self { condensation, images: 1, columns: image.columns(), level }
    }

    /// Adds an image of the same size.
    pub fn learn(&mut self, image: &RawImage) {
        self.images += 1;
        let share = 1.0 / self.images as f32;
        for (level, &count) in self.level.iter_mut().zip(image.counts()) {
            let count = f32::from(count);
            match self.condensation {
                Condensation::Minimum => *level = level.min(count),
                Condensation::Mean => *level += (count - *level) * share,
            }
        }
    }

    /// Subtracts the stationary light and adds the pedestal. An image of another size is returned
    /// unchanged; the caller checks sizes.
    pub fn remove_from(&self, image: &RawImage) -> RawImage {
        if image.columns() != self.columns || image.counts().len() != self.level.len() {
            return image.clone();
        }
        let corrected = image
            .counts()
            .iter()
            .zip(&self.level)
            .map(|(&count, &level)| (f32::from(count) - level + PEDESTAL_COUNTS).round() as u16)
            .collect();
        RawImage::new(image.columns(), image.rows(), corrected).unwrap_or_else(|_| image.clone())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn image(counts: [u16; 4]) -> RawImage {
        RawImage::new(2, 2, counts.to_vec()).unwrap()
    }

    #[test]
    fn minimum_keeps_the_stripe_and_not_the_particles() {
        let mut light = StationaryLight::new(Condensation::Minimum, &image([500, 20, 20, 90]));
        light.learn(&image([510, 80, 21, 20]));
        light.learn(&image([505, 22, 70, 25]));
        let corrected = light.remove_from(&image([506, 82, 20, 20]));
        assert_eq!(corrected.counts(), [256 + 6, 256 + 62, 256, 256]);
    }

    #[test]
    fn mean_is_the_mean_and_darker_pixels_stay_below_the_pedestal() {
        let mut light = StationaryLight::new(Condensation::Mean, &image([10, 0, 0, 0]));
        light.learn(&image([20, 0, 0, 0]));
        light.learn(&image([30, 0, 0, 0]));
        assert_eq!(light.remove_from(&image([5, 1, 0, 0])).counts(), [256 - 15, 257, 256, 256]);
    }
}
