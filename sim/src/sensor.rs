//! From photo-electrons to the counts in a file.

use garde::Validate;
use lfpiv_hw::{RawImage, check::finite};
use rand::{Rng, RngExt};
use rand_distr::{Normal, Poisson};
use rayon::prelude::*;
use serde::{Deserialize, Serialize};

use crate::{
    imaging::ElectronImage,
    stream::{Purpose, random_stream},
};

/// How the sensor turns light into counts: the `[simulation.sensor]` table.
///
/// Counts are round(offset + gain × (electrons + background, as a Poisson draw where shot noise
/// is on, + Gaussian read noise)), cut to 0 … 2^bits − 1. With `shot_noise` off and read noise 0
/// nothing is random and only rounding and clipping remain.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, Validate)]
#[serde(deny_unknown_fields, default)]
pub struct SensorSettings {
    /// Bits per pixel: 8, 10 or 12.
    #[garde(custom(known_depth))]
    pub bits: u8,
    /// Counts per photo-electron.
    #[garde(custom(finite), range(min = 1e-6, max = 1000.0))]
    pub gain_counts_per_electron: f64,
    /// Black level, in counts.
    #[garde(custom(finite), range(min = 0.0, max = 4095.0))]
    pub offset_counts: f64,
    /// Light that falls evenly on every pixel, in photo-electrons; it has shot noise, too.
    #[garde(custom(finite), range(min = 0.0, max = 1e7))]
    pub background_electrons: f64,
    /// Whether photo-electrons are Poisson distributed.
    #[garde(skip)]
    pub shot_noise: bool,
    /// Standard deviation of the read noise, in electrons.
    #[garde(custom(finite), range(min = 0.0, max = 1e5))]
    pub read_noise_electrons: f64,
}

impl Default for SensorSettings {
    fn default() -> Self {
        Self {
            bits: 12,
            gain_counts_per_electron: 1.0,
            offset_counts: 64.0,
            background_electrons: 0.0,
            shot_noise: true,
            read_noise_electrons: 5.0,
        }
    }
}

impl SensorSettings {
    /// The same sensor without anything random.
    pub fn noise_free(self) -> Self {
        Self { shot_noise: false, read_noise_electrons: 0.0, ..self }
    }

    /// Largest count, 2^bits − 1.
    pub fn saturation_counts(&self) -> u16 {
        ((1_u32 << self.bits.min(16)) - 1) as u16
    }

    /// The raw image of one exposure. Every pixel row draws from a random stream of its own,
    /// named by `stream` and the row, so threads do not matter.
    pub fn expose(&self, image: &ElectronImage, stream: &[u64]) -> RawImage {
        let (columns, rows) = (image.columns(), image.rows());
        let mut counts = vec![0_u16; columns * rows];
        let by_row = counts.par_chunks_mut(columns).zip(image.electrons().par_chunks(columns));
        by_row.enumerate().for_each(|(row, (counts, electrons))| {
            let key: Vec<u64> = stream.iter().copied().chain([row as u64]).collect();
            let mut rng = random_stream(Purpose::Sensor, &key);
            for (count, &electrons) in counts.iter_mut().zip(electrons) {
                *count = self.count(f64::from(electrons), &mut rng);
            }
        });
        RawImage::new(columns, rows, counts).expect("one count per pixel of the image")
    }

    fn count(&self, mean_electrons: f64, rng: &mut impl Rng) -> u16 {
        let mean_electrons = mean_electrons + self.background_electrons;
        let mut electrons = mean_electrons;
        if self.shot_noise
            && let Ok(poisson) = Poisson::new(mean_electrons)
        {
            // A mean of zero is no Poisson distribution to the library; it stays zero.
            electrons = rng.sample(poisson);
        }
        if self.read_noise_electrons > 0.0
            && let Ok(read_noise) = Normal::new(0.0, self.read_noise_electrons)
        {
            electrons += rng.sample(read_noise);
        }
        let counts = self.offset_counts + self.gain_counts_per_electron * electrons;
        // `as` drops decimals and what is below zero; `round` would be a function call on processors without SSE 4.1.
        // The upper cut is the converter's.
        ((counts + 0.5) as u16).min(self.saturation_counts())
    }
}

fn known_depth(bits: &u8, _: &()) -> garde::Result {
    if [8, 10, 12].contains(bits) { Ok(()) } else { Err(garde::Error::new("allowed: 8, 10 or 12")) }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn flat(columns: usize, rows: usize, electrons: f32) -> ElectronImage {
        ElectronImage::uniform(columns, rows, electrons)
    }

    fn mean_and_variance(image: &RawImage) -> (f64, f64) {
        let count = image.counts().len() as f64;
        let mean = image.counts().iter().map(|&c| f64::from(c)).sum::<f64>() / count;
        let square = image.counts().iter().map(|&c| (f64::from(c) - mean).powi(2)).sum::<f64>();
        (mean, square / (count - 1.0))
    }

    #[test]
    fn shot_and_read_noise_have_their_variances() {
        let sensor = SensorSettings {
            gain_counts_per_electron: 0.5,
            offset_counts: 100.0,
            background_electrons: 100.0,
            shot_noise: true,
            read_noise_electrons: 8.0,
            ..SensorSettings::default()
        };
        let (mean, variance) = mean_and_variance(&sensor.expose(&flat(400, 250, 700.0), &[1]));
        assert!((mean - 500.0).abs() < 0.3, "mean {mean}");
        // Gain² × (800 electrons of light + 8² of reading) + 1/12 of rounding.
        let expected = 0.25 * (800.0 + 64.0) + 1.0 / 12.0;
        assert!((variance / expected - 1.0).abs() < 0.03, "{variance} instead of {expected}");
    }

    #[test]
    fn a_dark_pixel_has_read_noise_only() {
        let sensor = SensorSettings { read_noise_electrons: 4.0, ..SensorSettings::default() };
        let (mean, variance) = mean_and_variance(&sensor.expose(&flat(400, 250, 0.0), &[2]));
        assert!((mean - 64.0).abs() < 0.1, "mean {mean}");
        assert!((variance / (16.0 + 1.0 / 12.0) - 1.0).abs() < 0.03, "variance {variance}");
    }

    #[test]
    fn without_noise_counts_are_rounded_and_clipped() {
        let sensor = SensorSettings { bits: 8, offset_counts: 10.0, ..SensorSettings::default() }
            .noise_free();
        for (electrons, expected) in [(0.0, 10), (20.4, 30), (20.6, 31), (1e6, 255)] {
            let image = sensor.expose(&flat(3, 2, electrons), &[3]);
            assert_eq!(image.counts(), [expected; 6]);
        }
        assert_eq!(SensorSettings { bits: 10, ..sensor }.saturation_counts(), 1023);
    }

    #[test]
    fn noise_below_zero_is_cut_at_zero() {
        let sensor = SensorSettings {
            offset_counts: 0.0,
            read_noise_electrons: 10.0,
            ..SensorSettings::default()
        };
        let image = sensor.expose(&flat(100, 100, 0.0), &[4]);
        let zeros = image.counts().iter().filter(|&&count| count == 0).count();
        // Half below zero, and those that round to zero.
        assert!(zeros.abs_diff(5200) < 200, "{zeros}");
    }

    #[test]
    fn streams_choose_the_noise() {
        let sensor = SensorSettings::default();
        let image = flat(50, 50, 200.0);
        assert_eq!(sensor.expose(&image, &[5, 1]), sensor.expose(&image, &[5, 1]));
        assert_ne!(sensor.expose(&image, &[5, 1]), sensor.expose(&image, &[5, 2]));
    }

    #[test]
    fn unknown_depths_and_negative_noise_are_refused() {
        let refused = |sensor: SensorSettings| sensor.validate().unwrap_err().to_string();
        let usual = SensorSettings::default;
        assert!(usual().validate().is_ok());
        assert!(refused(SensorSettings { bits: 16, ..usual() }).contains("8, 10 or 12"));
        assert!(
            refused(SensorSettings { read_noise_electrons: -1.0, ..usual() })
                .contains("read_noise_electrons")
        );
        assert!(
            refused(SensorSettings { offset_counts: f64::NAN, ..usual() })
                .contains("offset_counts")
        );
    }
}
