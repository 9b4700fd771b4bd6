//! Assignment of pixels to microlenses and to pupil intervals, for an array along the sensor's axes.
//!
//! A pixel column belongs to the microlens with the nearest micro-image centre X_c (1 + f_m/s_i), and
//! samples the pupil interval U = X_c − (x_s − X_c) s_i/f_m ± p s_i/(2 f_m) (docs/theory.md, section 3).
//! The micro-image pitch is not a whole number of pixels, so the interval's centre varies between
//! microlenses by up to half a cell; it is stored for each of them, and nothing is resampled. A column
//! on the border of two micro-images receives light from two microlenses and is dropped (about 3 % of the light).

use lfpiv_hw::Optics;

/// The sampling of one sensor axis (columns along `right`, or rows along `up`).
#[derive(Debug, Clone, PartialEq)]
pub struct AxisSampling {
    /// Number of microlenses along this axis.
    pub microlenses: usize,
    /// View indices run from `-reach` to `reach`; view `k` samples the pupil near `k` pupil cells from its
    /// centre.
    pub reach: i32,
    /// Width of a pixel's interval on the pupil, in mm.
    pub cell_mm: f64,
    samples: Vec<Option<Sample>>,
}

/// One pixel behind one microlens, along one axis.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Sample {
    /// Pixel column or row.
    pub pixel: u32,
    /// Centre of its pupil interval, in mm.
    pub pupil_mm: f64,
}

impl AxisSampling {
    /// The sampling of the sensor's columns.
    pub fn columns(optics: &Optics) -> Self {
        let sensor = &optics.sensor;
        Self::new(
            optics,
            optics.microlens.columns,
            sensor.columns,
            |c| sensor.column_centre_mm(c),
            |i| optics.microlens.column_centre_mm(i),
        )
    }

    /// The sampling of the sensor's rows.
    pub fn rows(optics: &Optics) -> Self {
        let sensor = &optics.sensor;
        Self::new(
            optics,
            optics.microlens.rows,
            sensor.rows,
            |r| sensor.row_centre_mm(r),
            |j| optics.microlens.row_centre_mm(j),
        )
    }

    fn new(
        optics: &Optics,
        microlenses: usize,
        pixels: usize,
        pixel_centre_mm: impl Fn(usize) -> f64,
        microlens_centre_mm: impl Fn(usize) -> f64,
    ) -> Self {
        let cell_mm = optics.pupil_cell_mm();
        let magnification = optics.micro_image_magnification();
        let half_pitch_mm = optics.micro_image_pitch_mm() / 2.0;
        let half_pixel_mm = optics.pixel_pitch_mm() / 2.0;
        let pupil_per_sensor = optics.image_distance_mm() / optics.microlens.focal_length_mm;
        let reach = (half_pitch_mm * pupil_per_sensor / cell_mm).ceil() as i32;
        let stride = (2 * reach + 1) as usize;
        let mut samples = vec![None; stride * microlenses];
        for pixel in 0..pixels {
            let x_s = pixel_centre_mm(pixel);
            let nearest =
                (x_s / optics.micro_image_pitch_mm() + (microlenses as f64 - 1.0) / 2.0).round();
            if nearest < 0.0 || nearest >= microlenses as f64 {
                continue;
            }
            let i = nearest as usize;
            let x_c = microlens_centre_mm(i);
            if (x_s - x_c * magnification).abs() + half_pixel_mm > half_pitch_mm {
                continue;
            }
            let pupil_mm = x_c - (x_s - x_c) * pupil_per_sensor;
            let k = (pupil_mm / cell_mm).round() as i32;
            samples[(k + reach) as usize * microlenses + i] =
                Some(Sample { pixel: pixel as u32, pupil_mm });
        }
        Self { microlenses, reach, cell_mm, samples }
    }

    /// The pixel of microlens `i` in view `k`. `None` if it is shared or off the sensor.
    pub fn sample(&self, k: i32, i: usize) -> Option<Sample> {
        self.samples[(k + self.reach) as usize * self.microlenses + i]
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::test_bench;

    #[test]
    fn every_pixel_has_one_microlens_and_view_and_border_columns_none() {
        let optics = test_bench::optics();
        let axis = AxisSampling::columns(&optics);
        let mut seen = vec![0; optics.sensor.columns];
        for k in -axis.reach..=axis.reach {
            for i in 0..axis.microlenses {
                if let Some(sample) = axis.sample(k, i) {
                    seen[sample.pixel as usize] += 1;
                }
            }
        }
        assert!(seen.iter().all(|&n| n <= 1));
        // Of 18.25 pixels per micro-image, one is shared.
        let share = seen.iter().sum::<usize>() as f64 / seen.len() as f64;
        assert!((share - 17.25 / 18.25).abs() < 0.01, "{share}");
    }

    #[test]
    fn a_view_samples_its_own_pupil_cell() {
        let axis = AxisSampling::rows(&test_bench::optics());
        for k in -axis.reach..=axis.reach {
            for j in 0..axis.microlenses {
                if let Some(sample) = axis.sample(k, j) {
                    assert!((sample.pupil_mm - f64::from(k) * 1.375).abs() <= 1.375 / 2.0 + 1e-9);
                }
            }
        }
    }

    /// A ray traced as in docs/theory.md, section 2, must hit the pixel whose sample has its pupil point.
    #[test]
    fn traced_rays_hit_the_pixel_of_their_pupil_point() {
        let optics = test_bench::optics();
        let axis = AxisSampling::columns(&optics);
        let s_i = optics.image_distance_mm();
        for i in [0, 3, 64, 100, 128] {
            for k in -8..=8 {
                let Some(sample) = axis.sample(k, i) else { continue };
                let x_c = optics.microlens.column_centre_mm(i);
                let x_s = x_c + optics.microlens.focal_length_mm * (x_c - sample.pupil_mm) / s_i;
                let centre = optics.sensor.column_centre_mm(sample.pixel as usize);
                assert!((x_s - centre).abs() < 1e-9);
            }
        }
    }
}
