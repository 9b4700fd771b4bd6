//! Effects on the pixels: dust, and crosstalk between neighbours.

use lfpiv_hw::Optics;
use rand::RngExt;
use rayon::prelude::*;

use super::{CameraFlaws, ElectronImage};
use crate::stream::{Purpose, random_stream};

/// Sampling points per axis and pixel for the area that a speck covers.
const COVERAGE_POINTS: u32 = 8;

/// Smallest number of passes with three weights, for a blur close to a Gaussian.
const LEAST_BLUR_PASSES: usize = 4;

/// Dust and crosstalk of one sensor.
#[derive(Debug, Clone)]
pub(super) struct Blemishes {
    /// Pixels under dust, and the share of their light that passes.
    dust: Vec<(usize, f32)>,
    /// Symmetric weights of the blur along one axis; empty without blur.
    blur: Vec<f32>,
}

impl Blemishes {
    pub(super) fn new(optics: &Optics, flaws: &CameraFlaws) -> Self {
        Self { dust: dusty_pixels(optics, flaws), blur: blur_weights(flaws.blur_px) }
    }

    /// Applies dust and crosstalk to the light on the sensor.
    pub(super) fn apply(&self, image: &mut ElectronImage) {
        for &(pixel, transmission) in &self.dust {
            image.electrons_mut()[pixel] *= transmission;
        }
        if !self.blur.is_empty() {
            self.blur_rows(image);
            self.blur_columns(image);
        }
    }

    fn blur_rows(&self, image: &mut ElectronImage) {
        let columns = image.columns();
        let reach = self.blur.len() / 2;
        image.electrons_mut().par_chunks_mut(columns).for_each(|row| {
            // Light beyond the sensor's edge is lost, and none enters from there.
            let mut padded = vec![0.0; columns + 2 * reach];
            padded[reach..reach + columns].copy_from_slice(row);
            for (pixel, window) in row.iter_mut().zip(padded.windows(self.blur.len())) {
                *pixel = window.iter().zip(&self.blur).map(|(light, weight)| light * weight).sum();
            }
        });
    }

    fn blur_columns(&self, image: &mut ElectronImage) {
        let (columns, rows) = (image.columns(), image.rows());
        let reach = self.blur.len() / 2;
        let sharp = image.electrons().to_vec();
        image.electrons_mut().par_chunks_mut(columns).enumerate().for_each(|(row, blurred)| {
            blurred.fill(0.0);
            for (weight, from) in self.blur.iter().zip(row..) {
                let Some(from) = from.checked_sub(reach).filter(|from| *from < rows) else {
                    continue;
                };
                let source = &sharp[from * columns..(from + 1) * columns];
                blurred.iter_mut().zip(source).for_each(|(sum, light)| *sum += weight * light);
            }
        });
    }
}

/// Pixels under specks, with their transmission. A pixel under two specks occurs twice.
fn dusty_pixels(optics: &Optics, flaws: &CameraFlaws) -> Vec<(usize, f32)> {
    let (dust, sensor) = (&flaws.dust, &optics.sensor);
    let mut rng = random_stream(Purpose::Dust, &[flaws.blemish_seed]);
    let radius_px = dust.radius_mm / optics.pixel_pitch_mm();
    let mut dusty = Vec::new();
    for _ in 0..dust.specks {
        let centre_px =
            [sensor.columns, sensor.rows].map(|count| rng.random_range(0.0..count as f64) - 0.5);
        let near = |axis: usize, count: usize| {
            let first = (centre_px[axis] - radius_px).round().max(0.0) as usize;
            let last = (centre_px[axis] + radius_px).round().max(0.0) as usize;
            first..(last + 1).min(count)
        };
        for row in near(1, sensor.rows) {
            for column in near(0, sensor.columns) {
                let from_speck_px = [column as f64 - centre_px[0], row as f64 - centre_px[1]];
                let covered = covered_share(from_speck_px, radius_px);
                let passes = 1.0 - covered * (1.0 - dust.transmission);
                dusty.push((row * sensor.columns + column, passes as f32));
            }
        }
    }
    dusty
}

/// Share of a pixel that a speck covers; the pixel's centre is at `from_speck_px` from the speck's
/// centre.
fn covered_share(from_speck_px: [f64; 2], radius_px: f64) -> f64 {
    let step = 1.0 / f64::from(COVERAGE_POINTS);
    let place = |index: u32| (f64::from(index) + 0.5) * step - 0.5;
    let points = (0..COVERAGE_POINTS).flat_map(|j| (0..COVERAGE_POINTS).map(move |i| (i, j)));
    let covered = points.filter(|&(i, j)| {
        (from_speck_px[0] + place(i)).hypot(from_speck_px[1] + place(j)) < radius_px
    });
    covered.count() as f64 * step * step
}

/// A discrete Gaussian with exactly the variance σ²: three weights (a, 1 − 2a, a) with variance 2a,
/// applied so often that a ≤ 1/4. A sampled Gaussian would have too small a variance for σ below
/// one pixel.
fn blur_weights(sigma_px: f64) -> Vec<f32> {
    if sigma_px == 0.0 {
        return Vec::new();
    }
    let variance = sigma_px * sigma_px;
    let passes = ((2.0 * variance).ceil() as usize).max(LEAST_BLUR_PASSES);
    let side = variance / (2.0 * passes as f64);
    let mut weights = vec![1.0];
    for _ in 0..passes {
        let mut wider = vec![0.0; weights.len() + 2];
        for (index, weight) in weights.iter().enumerate() {
            wider[index] += side * weight;
            wider[index + 1] += (1.0 - 2.0 * side) * weight;
            wider[index + 2] += side * weight;
        }
        weights = wider;
    }
    weights.into_iter().map(|weight| weight as f32).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{imaging::Dust, test_bench};

    /// Light of 1000 on one pixel, at (column 100, row 80).
    fn lit_pixel(optics: &Optics) -> ElectronImage {
        let mut image = ElectronImage::dark(optics);
        image.electrons_mut()[80 * optics.sensor.columns + 100] = 1000.0;
        image
    }

    #[test]
    fn blur_has_the_stated_variance_and_keeps_light() {
        let optics = test_bench::small().optics;
        for blur_px in [0.2, 0.5, 1.7] {
            let mut image = lit_pixel(&optics);
            let flaws = CameraFlaws { blur_px, ..CameraFlaws::default() };
            Blemishes::new(&optics, &flaws).apply(&mut image);
            let moment = |axis: usize| {
                let light = image.electrons().iter().enumerate().map(|(index, &light)| {
                    let place = [index % image.columns(), index / image.columns()][axis] as f64;
                    f64::from(light) * (place - [100.0, 80.0][axis]).powi(2)
                });
                light.sum::<f64>() / image.total()
            };
            assert!((image.total() / 1000.0 - 1.0).abs() < 1e-6);
            for axis in [0, 1] {
                assert!((moment(axis) / blur_px.powi(2) - 1.0).abs() < 1e-4, "{blur_px} px");
            }
        }
    }

    #[test]
    fn light_at_the_edge_is_partly_lost() {
        let optics = test_bench::small().optics;
        let mut image = ElectronImage::dark(&optics);
        image.electrons_mut()[0] = 1000.0;
        let flaws = CameraFlaws { blur_px: 1.0, ..CameraFlaws::default() };
        Blemishes::new(&optics, &flaws).apply(&mut image);
        assert!((400.0..600.0).contains(&image.total()), "{}", image.total());
    }

    /// Specks darken their area by the blocked share, and hit the same pixels each time.
    #[test]
    fn dust_darkens_as_much_as_it_covers() {
        let optics = test_bench::small().optics;
        let dust = Dust { specks: 3, radius_mm: 0.033, transmission: 0.4 };
        let lost = |blemish_seed| {
            let flaws = CameraFlaws { dust: dust.clone(), blemish_seed, ..CameraFlaws::default() };
            let mut image = ElectronImage::uniform(384, 312, 100.0);
            Blemishes::new(&optics, &flaws).apply(&mut image);
            image
        };
        let image = lost(1);
        // Discs of 6 pixels radius, apart from each other and from the edge for this seed.
        let expected = 3.0 * std::f64::consts::PI * 36.0 * 0.6 * 100.0;
        let got = 384.0 * 312.0 * 100.0 - image.total();
        assert!((got / expected - 1.0).abs() < 0.01, "{got} instead of {expected}");
        let darkest = image.electrons().iter().copied().fold(f32::MAX, f32::min);
        assert!((darkest - 40.0).abs() < 1e-3, "{darkest}");
        assert_eq!(image, lost(1));
        assert_ne!(image, lost(2));
    }
}
