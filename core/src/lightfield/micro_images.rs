//! Measurement of the positions of micro-images from an image of particles.
//!
//! A micro-image is an image of the round aperture. Averaged over many particles it is bright in its middle and
//! dark at its corners. Column sums of a raw image are therefore a periodic signal with the period of the
//! micro-images. The period with the highest power near the configured one is their pitch, and the phase in the
//! middle of the light gives their offset. The phases of several bands of rows give the rotation of the array.

use lfpiv_hw::{Optics, RawImage};

use crate::parabola;

/// Number of bands along the other axis. The micro-images of a rotated array shift from band to band.
const BANDS: usize = 6;

/// Half width of the search range of the pitch, relative to the configured one.
const PITCH_RANGE: f64 = 0.04;

/// Search steps per spectral line width of the periodogram (the inverse of the number of periods).
const STEPS_PER_LINE: f64 = 8.0;

/// Least contrast of the periodic part of the light. Micro-images of a round pupil that fill their pitch have a
/// higher contrast; random particles have a much lower one.
const MIN_CONTRAST: f64 = 0.05;

/// Measured micro-images relative to the configured ones, along columns and rows.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct MicroImages {
    /// Ratio of the pitch to the configured pitch, minus 1: along columns, along rows.
    pub pitch_excess: [f64; 2],
    /// Offset of the micro-images in the middle of the light, modulo a pitch, in pixels to the
    /// right and upwards.
    pub offset_px: [f64; 2],
    /// Rotation of the array on the sensor, counter-clockwise, in rad: from the columns and from
    /// the rows.
    pub turned_rad: [f64; 2],
    /// Largest distance of a lit micro-image from its configured position, along columns and rows, in
    /// pixels.
    pub farthest_px: [f64; 2],
}

/// One axis of the sensor.
struct Axis {
    /// Position of each pixel along the axis, in mm.
    place_mm: Vec<f64>,
    /// Position of each band's middle along the other axis, in mm.
    band_mm: [f64; BANDS],
    /// Light of each pixel along the axis in each band, minus its mean, which would leak into the period of the
    /// micro-images. There is no window function: its slope would weight both sides of an out-of-focus particle
    /// differently and bias the offset for a small volume by some pixels.
    bands: Vec<Vec<f64>>,
    /// Sum of the squared light of all bands.
    light_square: f64,
    /// Half width of a uniform light distribution with the same standard deviation, in mm.
    reach_mm: f64,
    /// Configured position of a micro-image in the middle of the light, in mm.
    middle_mm: f64,
    pitch_mm: f64,
}

/// Fourier component of one period: real and imaginary part.
type Phasor = [f64; 2];

impl MicroImages {
    /// Measures the micro-images in a raw image. `None` if their contrast is too low.
    pub fn find(optics: &Optics, image: &RawImage) -> Option<Self> {
        let sensor = &optics.sensor;
        let [of_columns, of_rows] = band_sums(image);
        let magnification = optics.micro_image_magnification();
        let lens = &optics.microlens;
        let columns = Axis::new(
            optics,
            (0..sensor.columns).map(|c| sensor.column_centre_mm(c)).collect(),
            |band| sensor.row_centre_mm((2 * band + 1) * sensor.rows / (2 * BANDS)),
            &of_columns,
            lens.column_centre_mm(lens.columns / 2) * magnification,
        );
        let rows = Axis::new(
            optics,
            (0..sensor.rows).map(|r| sensor.row_centre_mm(r)).collect(),
            |band| sensor.column_centre_mm((2 * band + 1) * sensor.columns / (2 * BANDS)),
            &of_rows,
            lens.row_centre_mm(lens.rows / 2) * magnification,
        );
        let (x, y) = (columns.find()?, rows.find()?);
        let pixel_mm = optics.pixel_pitch_mm();
        Some(Self {
            pitch_excess: [x.pitch_excess, y.pitch_excess],
            offset_px: [x.offset_mm / pixel_mm, y.offset_mm / pixel_mm],
            turned_rad: [-x.slope, y.slope],
            farthest_px: [x.farthest_mm / pixel_mm, y.farthest_mm / pixel_mm],
        })
    }
}

/// Sums of each column in bands of rows, and of each row in bands of columns, in counts above the
/// darkest sum, which approximates the black level.
fn band_sums(image: &RawImage) -> [Vec<Vec<f64>>; 2] {
    let (nx, ny) = (image.columns(), image.rows());
    let mut of_columns = vec![vec![0.0; nx]; BANDS];
    let mut of_rows = vec![vec![0.0; ny]; BANDS];
    for row in 0..ny {
        let counts = image.row(row);
        for (sum, &count) in of_columns[row * BANDS / ny].iter_mut().zip(counts) {
            *sum += f64::from(count);
        }
        for (n, part) in of_rows.iter_mut().enumerate() {
            let span = &counts[n * nx / BANDS..(n + 1) * nx / BANDS];
            part[row] = span.iter().map(|&count| u64::from(count)).sum::<u64>() as f64;
        }
    }
    for band in of_columns.iter_mut().chain(&mut of_rows) {
        let darkest = band.iter().copied().fold(f64::INFINITY, f64::min);
        band.iter_mut().for_each(|sum| *sum -= darkest);
    }
    [of_columns, of_rows]
}

/// Fit of the phases along one axis.
struct AxisFit {
    pitch_excess: f64,
    offset_mm: f64,
    /// Shift along this axis per distance along the other one.
    slope: f64,
    farthest_mm: f64,
}

impl Axis {
    fn new(
        optics: &Optics,
        place_mm: Vec<f64>,
        band_mm: impl Fn(usize) -> f64,
        bands: &[Vec<f64>],
        middle_mm: f64,
    ) -> Self {
        let less_mean = |band: &Vec<f64>| -> Vec<f64> {
            let mean = band.iter().sum::<f64>() / band.len() as f64;
            band.iter().map(|light| light - mean).collect()
        };
        let pitch_mm = optics.micro_image_pitch_mm();
        let moment = |power: i32| -> f64 {
            let of_band = |band: &Vec<f64>| -> f64 {
                band.iter().zip(&place_mm).map(|(light, place)| light * place.powi(power)).sum()
            };
            bands.iter().map(of_band).sum()
        };
        let light = moment(0).max(f64::MIN_POSITIVE);
        let centre_mm = moment(1) / light;
        Self {
            // The micro-image nearest to the centroid of the light.
            middle_mm: middle_mm + ((centre_mm - middle_mm) / pitch_mm).round() * pitch_mm,
            reach_mm: (3.0 * (moment(2) / light - centre_mm * centre_mm).max(0.0)).sqrt(),
            light_square: bands.iter().map(|band| band.iter().sum::<f64>().powi(2)).sum(),
            bands: bands.iter().map(less_mean).collect(),
            band_mm: std::array::from_fn(band_mm),
            pitch_mm,
            place_mm,
        }
    }

    fn find(&self) -> Option<AxisFit> {
        let pitch_mm = self.strongest_period()?;
        let phasors: Vec<Phasor> =
            (0..BANDS).map(|band| self.phasor(&self.bands[band], pitch_mm)).collect();
        // Shifts of the bands, unwrapped from band to band.
        let mut shifts: Vec<f64> = Vec::with_capacity(BANDS);
        for phasor in &phasors {
            let shift = phasor[1].atan2(phasor[0]) / std::f64::consts::TAU * pitch_mm;
            let before = shifts.last().copied().unwrap_or(0.0);
            shifts.push(shift - ((shift - before) / pitch_mm).round() * pitch_mm);
        }
        let weights: Vec<f64> = phasors.iter().map(|p| p[0].hypot(p[1])).collect();
        let (offset_mm, slope) = weighted_line(&self.band_mm, &shifts, &weights);
        // The phase is ambiguous by whole pitches: assume the smallest offset.
        let offset_mm = offset_mm - (offset_mm / self.pitch_mm).round() * self.pitch_mm;
        let pitch_excess = pitch_mm / self.pitch_mm - 1.0;
        let across_mm = self.band_mm.iter().fold(0.0f64, |most, place| most.max(place.abs()));
        let farthest_mm =
            offset_mm.abs() + (pitch_excess * self.reach_mm).abs() + (slope * across_mm).abs();
        Some(AxisFit { pitch_excess, offset_mm, slope, farthest_mm })
    }

    /// The period near the configured one with the largest total power of all bands, in mm.
    fn strongest_period(&self) -> Option<f64> {
        let length_mm =
            self.place_mm.iter().fold(0.0f64, |most, place| most.max(place.abs())) * 2.0;
        let step = self.pitch_mm / length_mm / STEPS_PER_LINE;
        let steps = (PITCH_RANGE / step).ceil() as i64;
        let power = |excess: f64| -> f64 {
            let period_mm = self.pitch_mm * (1.0 + excess);
            self.bands.iter().map(|band| square(self.phasor(band, period_mm))).sum()
        };
        let best = (-steps..=steps)
            .max_by(|&a, &b| power(a as f64 * step).total_cmp(&power(b as f64 * step)))?;
        let middle = best as f64 * step;
        let powers = [-step, 0.0, step].map(|d| power(middle + d));
        let stands_out =
            self.light_square > 0.0 && powers[1] > MIN_CONTRAST * MIN_CONTRAST * self.light_square;
        stands_out.then(|| self.pitch_mm * (1.0 + middle + parabola::maximum(powers) * step))
    }

    /// Fourier component Σ I exp(i 2π (x − x₀)/P) with the configured centre x₀. Its phase is the shift of the
    /// micro-images from their configured positions. The exponential of evenly spaced pixels is computed by
    /// repeated rotation.
    fn phasor(&self, light: &[f64], period_mm: f64) -> Phasor {
        let per_mm = std::f64::consts::TAU / period_mm;
        let [first, second] = [self.place_mm[0], self.place_mm.get(1).copied().unwrap_or(0.0)];
        let (turn_im, turn_re) = ((second - first) * per_mm).sin_cos();
        let (mut at_im, mut at_re) = ((first - self.middle_mm) * per_mm).sin_cos();
        let mut sum = [0.0; 2];
        for light in light {
            sum[0] += light * at_re;
            sum[1] += light * at_im;
            (at_re, at_im) = (at_re * turn_re - at_im * turn_im, at_re * turn_im + at_im * turn_re);
        }
        sum
    }
}

fn square([re, im]: Phasor) -> f64 {
    re * re + im * im
}

/// Weighted least-squares line through (x, y): its value at 0 and its slope.
fn weighted_line(x: &[f64], y: &[f64], weights: &[f64]) -> (f64, f64) {
    let mut sums = [0.0; 5];
    for ((x, y), w) in x.iter().zip(y).zip(weights) {
        for (sum, term) in sums.iter_mut().zip([*w, w * x, w * y, w * x * x, w * x * y]) {
            *sum += term;
        }
    }
    let [w, x, y, xx, xy] = sums;
    let determinant = w * xx - x * x;
    if determinant <= 0.0 {
        return (if w > 0.0 { y / w } else { 0.0 }, 0.0);
    }
    ((xx * y - x * xy) / determinant, (w * xy - x * y) / determinant)
}

#[cfg(test)]
mod tests {
    use lfpiv_hw::{MicrolensArray, Sensor};
    use rand::{RngExt, SeedableRng};
    use rand_pcg::Pcg64Mcg;

    use super::*;
    use crate::test_bench;

    fn optics() -> Optics {
        let microlens = MicrolensArray { columns: 43, rows: 33, ..test_bench::optics().microlens };
        let sensor = Sensor { columns: 784, rows: 602, pixel_pitch_um: 5.5 };
        Optics { microlens, sensor, ..test_bench::optics() }
    }

    /// Round micro-images, half of them lit at random, on an array with a pitch larger by the share `excess`,
    /// shifted by `shift_px` and rotated by `turn` rad; black level 64.
    fn image(optics: &Optics, excess: f64, shift_px: [f64; 2], turn: f64) -> RawImage {
        let mut random = Pcg64Mcg::seed_from_u64(4);
        let (nx, ny) = (optics.sensor.columns, optics.sensor.rows);
        let pitch = optics.micro_image_pitch_mm() * (1.0 + excess);
        let pixel = optics.pixel_pitch_mm();
        let lights: Vec<f64> = (0..64 * 64)
            .map(
                |_| if random.random::<f64>() < 0.5 { 0.0 } else { 900.0 * random.random::<f64>() },
            )
            .collect();
        let (sin, cos) = turn.sin_cos();
        let mut counts = Vec::with_capacity(nx * ny);
        for row in 0..ny {
            for column in 0..nx {
                let x = optics.sensor.column_centre_mm(column) - shift_px[0] * pixel;
                let y = optics.sensor.row_centre_mm(row) - shift_px[1] * pixel;
                let (x, y) = (cos * x + sin * y, cos * y - sin * x);
                let nearest = [x, y].map(|place| (place / pitch).round());
                let from_middle = (x - nearest[0] * pitch).hypot(y - nearest[1] * pitch);
                let lens = (nearest[1] + 32.0) as usize * 64 + (nearest[0] + 32.0) as usize;
                let light = if from_middle < 0.5 * pitch { lights[lens] } else { 0.0 };
                counts.push((64.0 + light) as u16);
            }
        }
        RawImage::new(nx, ny, counts).unwrap()
    }

    #[test]
    fn pitch_shift_and_turn_are_found_together() {
        let optics = optics();
        for (excess, shift_px, turn) in [
            (0.0, [0.0, 0.0], 0.0),
            (0.005, [0.0, 0.0], 0.0),
            (-0.004, [3.0, -2.0], 0.0),
            (0.002, [-4.0, 1.5], 0.003),
        ] {
            let found =
                MicroImages::find(&optics, &image(&optics, excess, shift_px, turn)).unwrap();
            for axis in 0..2 {
                let case = (excess, shift_px, turn, found);
                assert!((found.pitch_excess[axis] - excess).abs() < 5e-4, "{case:?}");
                assert!((found.offset_px[axis] - shift_px[axis]).abs() < 0.3, "{case:?}");
                assert!((found.turned_rad[axis] - turn).abs() < 5e-4, "{case:?}");
            }
        }
    }

    #[test]
    fn one_microlens_more_shifts_by_half_a_pitch() {
        let optics = optics();
        let mut wrong = optics.clone();
        wrong.microlens.rows += 1;
        let found = MicroImages::find(&wrong, &image(&optics, 0.0, [0.0; 2], 0.0)).unwrap();
        let half_pitch_px = optics.micro_image_pitch_mm() / optics.pixel_pitch_mm() / 2.0;
        assert!((found.offset_px[1].abs() - half_pitch_px).abs() < 0.3, "{found:?}");
        assert!(found.offset_px[0].abs() < 0.3, "{found:?}");
    }

    #[test]
    fn no_micro_images_are_found_in_an_image_without_them() {
        let optics = optics();
        let (nx, ny) = (optics.sensor.columns, optics.sensor.rows);
        let black = RawImage::new(nx, ny, vec![64; nx * ny]).unwrap();
        assert_eq!(MicroImages::find(&optics, &black), None);
        let mut random = Pcg64Mcg::seed_from_u64(5);
        let noise = (0..nx * ny).map(|_| random.random_range(40..90)).collect();
        assert_eq!(MicroImages::find(&optics, &RawImage::new(nx, ny, noise).unwrap()), None);
    }
}
