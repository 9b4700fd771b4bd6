//! Light levels of a raw image, estimated from the image itself.
//!
//! At one particle per microlens hardly any pixel inside the micro-images is dark. However, the image of the round
//! aperture does not reach the four corners of a square micro-image. These corners give black level and noise at
//! any seeding density. Pixels with an open pupil interval then give the uniform background.

use lfpiv_hw::{Optics, RawImage};
use rayon::prelude::*;

use super::{GridSampling, ImageSettings, LightLevels, ViewLayout, sampling::AxisSampling};

/// Least distance of a dark pixel's pupil cell from the pupil's centre, in pupil radii: diffraction at the
/// microlens extends about one pixel beyond the edge.
const DARK_RADII: f64 = 1.12;

/// Least number of dark pixels; with fewer, the darkest lit pixels are used instead.
const MIN_CORNERS: u64 = 500;

/// Least number of pixels at the highest count of a saturated image.
const MIN_SATURATED: u64 = 16;

/// Least saturation count (8 bits). A peak of the histogram below it is the black level of an empty image.
const MIN_SATURATION_COUNTS: usize = 255;

/// Least excess of a pixel with light of a particle over pixels without, in standard deviations of the noise.
const BRIGHT_NOISE_WIDTHS: f64 = 6.0;

/// Noise of an ideal sensor, by rounding to integers, in counts.
const ROUNDING_NOISE_COUNTS: f64 = 0.289;

/// The parts of a micro-image that are used for photometry.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Zone {
    Dark,
    Lit,
}

/// The pixels that are dark by geometry, and those with a fully open pupil interval.
#[derive(Debug, Clone)]
pub enum PhotometricZones {
    /// For an array along the sensor's axes: least and greatest |U| of the pupil interval of each pixel column and
    /// row, in mm.
    Axes { columns: Vec<Option<(f64, f64)>>, rows: Vec<Option<(f64, f64)>>, radius_mm: f64 },
    /// For an arbitrarily oriented array: the zone of each pixel.
    Pixels(Vec<Option<Zone>>),
}

impl Zone {
    /// Zone of a pixel whose pupil interval has its centre at (u, v), both not negative, and the half width `half`,
    /// in mm.
    fn new(u: f64, v: f64, half: f64, radius_mm: f64) -> Option<Self> {
        let extents = |middle: f64| ((middle - half).max(0.0), middle + half);
        Self::of_extents(extents(u), extents(v), radius_mm)
    }

    /// Zone of a pixel from the least and greatest |U| and |V| of its pupil interval, in mm.
    fn of_extents(
        (u_near, u_far): (f64, f64),
        (v_near, v_far): (f64, f64),
        radius_mm: f64,
    ) -> Option<Self> {
        let dark_mm = radius_mm * DARK_RADII;
        if u_far * u_far + v_far * v_far < radius_mm * radius_mm {
            Some(Self::Lit)
        } else if u_near * u_near + v_near * v_near > dark_mm * dark_mm {
            Some(Self::Dark)
        } else {
            None
        }
    }
}

impl PhotometricZones {
    /// The zones of a camera whose array lies along the sensor's axes.
    pub fn new(optics: &Optics, columns: &AxisSampling, rows: &AxisSampling) -> Self {
        Self::Axes {
            columns: pupil_extents(columns, optics.sensor.columns),
            rows: pupil_extents(rows, optics.sensor.rows),
            radius_mm: optics.pupil_diameter_mm() / 2.0,
        }
    }

    /// The zones of images decoded with `layout`.
    pub fn of(optics: &Optics, layout: &ViewLayout) -> Self {
        match &layout.grid {
            Some(grid) => Self::on_grid(optics, grid),
            None => Self::new(optics, &layout.columns, &layout.rows),
        }
    }

    /// The zones of an arbitrarily oriented array.
    fn on_grid(optics: &Optics, grid: &GridSampling) -> Self {
        let (columns, rows) = (optics.sensor.columns, optics.sensor.rows);
        let radius_mm = optics.pupil_diameter_mm() / 2.0;
        let zone = |pixel: usize| {
            let [u, v] = grid.pupil_of_pixel_mm(pixel % columns, pixel / columns)?;
            Zone::new(u.abs(), v.abs(), grid.cell_mm / 2.0, radius_mm)
        };
        Self::Pixels((0..columns * rows).into_par_iter().map(zone).collect())
    }

    /// Histograms of the dark and of the lit pixels.
    fn histograms(&self, image: &RawImage) -> (Histogram, Histogram) {
        let (mut dark, mut lit) = (Histogram::default(), Histogram::default());
        let mut add = |zone: Option<Zone>, count: u16| match zone {
            Some(Zone::Lit) => lit.add(count),
            Some(Zone::Dark) => dark.add(count),
            None => {}
        };
        match self {
            Self::Axes { columns, rows, radius_mm } => {
                for (row, v) in rows.iter().enumerate() {
                    let Some(v) = v else { continue };
                    for (&count, u) in image.row(row).iter().zip(columns) {
                        add(u.and_then(|u| Zone::of_extents(u, *v, *radius_mm)), count);
                    }
                }
            }
            Self::Pixels(zones) => {
                for (&count, &zone) in image.counts().iter().zip(zones) {
                    add(zone, count);
                }
            }
        }
        (dark, lit)
    }

    /// The light levels of an image; configured levels take precedence.
    pub fn levels(&self, image: &RawImage, settings: &ImageSettings) -> LightLevels {
        let (dark, lit) = self.histograms(image);
        let zero = if dark.total >= MIN_CORNERS { &dark } else { &lit };
        let middle = if dark.total >= MIN_CORNERS { 0.5 } else { 0.01 };
        let median = zero.quantile(middle);
        let offset_counts = settings.offset_counts.unwrap_or(median);
        // From the upper quantiles, because a black level of 0 clips the lower ones.
        let spread = dark.quantile(0.841) - dark.quantile(0.5);
        let noise_counts = settings.read_noise_counts.unwrap_or(spread).max(ROUNDING_NOISE_COUNTS);
        let background_counts = background(&lit, offset_counts, noise_counts);
        let black = offset_counts + background_counts;
        let saturation_counts = settings.saturation_counts.or_else(|| lit.saturation_peak());
        let saturated = saturation_counts.map_or(0, |level| lit.at_least(level));
        let bright = lit.above(bright_level(&lit, noise_counts.max(spread)));
        LightLevels {
            offset_counts,
            background_counts,
            noise_counts,
            saturation_counts,
            saturated_share: saturated as f64 / lit.total.max(1) as f64,
            mean_signal_counts: (lit.mean() - black).max(0.0),
            bright_share: bright as f64 / lit.total.max(1) as f64,
        }
    }
}

fn pupil_extents(axis: &AxisSampling, pixels: usize) -> Vec<Option<(f64, f64)>> {
    let mut extents = vec![None; pixels];
    for k in -axis.reach..=axis.reach {
        for sample in (0..axis.microlenses).filter_map(|i| axis.sample(k, i)) {
            let (middle, half) = (sample.pupil_mm.abs(), axis.cell_mm / 2.0);
            extents[sample.pixel as usize] = Some(((middle - half).max(0.0), middle + half));
        }
    }
    extents
}

/// Uniform light between the particles, in counts above the black level. The darkest 2 % of lit pixels contain no
/// light of particles. If a share f of pixels is without such light, they are its 2 %/f quantile: 1.8 standard
/// deviations below its mean at f = 0.3, and within half a standard deviation of that for any f from 0.1 to 1.
fn background(lit: &Histogram, offset_counts: f64, noise_counts: f64) -> f64 {
    let level = lit.quantile(0.02) + 1.8 * noise_counts - offset_counts;
    if level > 2.5 * noise_counts { level } else { 0.0 }
}

/// Upper limit of pixels without light of particles, in counts. Uniform light has shot noise, which dark pixels do
/// not have. The noise is therefore also estimated from the lit pixels: for Gaussian noise their 0.1 % and 2 %
/// quantiles are 3.09 and 2.05 standard deviations below the mean. Particles raise both quantiles; their own light
/// is well above.
fn bright_level(lit: &Histogram, noise_counts: f64) -> f64 {
    let darkest = lit.quantile(0.02);
    let noise = noise_counts.max((darkest - lit.quantile(0.001)) / 1.04);
    darkest + (2.05 + BRIGHT_NOISE_WIDTHS) * noise
}

/// A histogram of counts.
#[derive(Debug, Default)]
struct Histogram {
    bins: Vec<u64>,
    total: u64,
}

impl Histogram {
    fn add(&mut self, count: u16) {
        let bin = usize::from(count);
        if bin >= self.bins.len() {
            self.bins.resize(bin + 1, 0);
        }
        self.bins[bin] += 1;
        self.total += 1;
    }

    /// Quantile in counts, with a uniform distribution inside each bin; 0 for an empty histogram.
    fn quantile(&self, share: f64) -> f64 {
        let target = share * self.total as f64;
        let mut below = 0.0;
        for (bin, &n) in self.bins.iter().enumerate() {
            let n = n as f64;
            if n > 0.0 && below + n >= target {
                return (bin as f64 - 0.5 + (target - below) / n).max(0.0);
            }
            below += n;
        }
        0.0
    }

    fn mean(&self) -> f64 {
        let sum: f64 = self.bins.iter().enumerate().map(|(bin, &n)| bin as f64 * n as f64).sum();
        sum / self.total.max(1) as f64
    }

    fn at_least(&self, level: u16) -> u64 {
        self.bins.iter().skip(usize::from(level)).sum()
    }

    fn above(&self, level: f64) -> u64 {
        self.bins.iter().skip(level.max(0.0) as usize + 1).sum()
    }

    /// The highest count, if it is a saturation peak: its pixels are more than twice those in the hundredth of
    /// the range just below it.
    fn saturation_peak(&self) -> Option<u16> {
        let top = self.bins.len().checked_sub(1)?;
        let below = top.saturating_sub((top / 100).max(8));
        let neighbours: u64 = self.bins[below..top].iter().sum();
        let piled = self.bins[top];
        (top >= MIN_SATURATION_COUNTS && piled >= MIN_SATURATED && piled > 2 * neighbours)
            .then_some(top as u16)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{lightfield::MicroImageGrid, test_bench};
    use rand::{RngExt, SeedableRng};
    use rand_pcg::Pcg64Mcg;

    /// An image whose lit pixels have `lit` counts and whose dark pixels have none, plus an offset and nearly
    /// Gaussian noise.
    fn image(lit: impl Fn(&mut Pcg64Mcg) -> f64, offset: f64, noise: f64) -> RawImage {
        let optics = test_bench::optics();
        let mut random = Pcg64Mcg::seed_from_u64(7);
        let PhotometricZones::Axes { columns, rows, radius_mm } = zones() else {
            panic!("the bench's array lies along the axes");
        };
        let mut counts = Vec::new();
        for row in &rows {
            for column in &columns {
                let inside = match (column, row) {
                    (Some((u, _)), Some((v, _))) => u.hypot(*v) < radius_mm,
                    _ => false,
                };
                let normal = (0..12).map(|_| random.random::<f64>()).sum::<f64>() - 6.0;
                let signal = if inside { lit(&mut random) } else { 0.0 };
                let level = (offset + signal + noise * normal).round();
                counts.push(level.clamp(0.0, 4095.0) as u16);
            }
        }
        RawImage::new(optics.sensor.columns, optics.sensor.rows, counts).unwrap()
    }

    fn zones() -> PhotometricZones {
        let optics = test_bench::optics();
        PhotometricZones::new(
            &optics,
            &AxisSampling::columns(&optics),
            &AxisSampling::rows(&optics),
        )
    }

    /// Both descriptions of an ideal array give the same zones, except for pixels shared by
    /// micro-images.
    #[test]
    fn zones_of_a_nominal_array_agree_for_both_samplings() {
        let optics = test_bench::optics();
        let sampling = GridSampling::new(&optics, &MicroImageGrid::nominal(&optics));
        let on_grid = PhotometricZones::on_grid(&optics, &sampling);
        let image = image(|_| 200.0, 64.0, 0.0);
        let [along_axes, on_grid] = [zones(), on_grid].map(|zones| zones.histograms(&image));
        for (a, b) in [(along_axes.0, on_grid.0), (along_axes.1, on_grid.1)] {
            assert!(a.total.abs_diff(b.total) < a.total / 50, "{} {}", a.total, b.total);
            assert!((a.mean() - b.mean()).abs() < 2.0, "{} {}", a.mean(), b.mean());
        }
    }

    #[test]
    fn black_level_and_noise_are_correct_when_few_lit_pixels_are_dark() {
        for offset in [0.0, 64.0] {
            let bright = image(|r| if r.random::<f64>() < 0.15 { 0.0 } else { 300.0 }, offset, 4.0);
            let levels = zones().levels(&bright, &ImageSettings::default());
            assert!((levels.offset_counts - offset).abs() < 0.5, "{levels:?}");
            assert!((levels.noise_counts - 4.0).abs() < 0.5, "{levels:?}");
            assert_eq!(levels.background_counts, 0.0);
            assert_eq!(levels.saturation_counts, None);
            assert!((levels.mean_signal_counts - 255.0).abs() < 2.0);
        }
    }

    #[test]
    fn uniform_background_is_separated_from_the_black_level() {
        let scene = image(|r| if r.random::<f64>() < 0.4 { 40.0 } else { 300.0 }, 64.0, 4.0);
        let levels = zones().levels(&scene, &ImageSettings::default());
        assert!((levels.background_counts - 40.0).abs() < 3.0, "{levels:?}");
    }

    #[test]
    fn noise_alone_has_no_bright_pixels_and_few_particles_have_some() {
        // Gaussian noise of `width`, as the shot noise of uniform light through the aperture.
        let uniform = |level: f64, width: f64| {
            move |r: &mut Pcg64Mcg| {
                level + width * ((0..12).map(|_| r.random::<f64>()).sum::<f64>() - 6.0)
            }
        };
        for offset in [0.0, 64.0] {
            for (level, width) in [(0.0, 0.0), (3.0, 1.7), (30.0, 5.5), (400.0, 20.0)] {
                let levels = zones()
                    .levels(&image(uniform(level, width), offset, 4.0), &ImageSettings::default());
                assert!(levels.bright_share < 1e-4, "{offset}, {level}: {levels:?}");
            }
            let sparse = image(|r| if r.random::<f64>() < 0.99 { 0.0 } else { 60.0 }, offset, 4.0);
            let levels = zones().levels(&sparse, &ImageSettings::default());
            assert!((levels.bright_share - 0.01).abs() < 1e-3, "{levels:?}");
            let dense = image(|r| 100.0 + 900.0 * r.random::<f64>().powi(2), offset, 4.0);
            let levels = zones().levels(&dense, &ImageSettings::default());
            assert!(levels.bright_share > 0.5, "{levels:?}");
        }
    }

    #[test]
    fn saturation_is_a_peak_at_the_highest_count_at_any_bit_depth() {
        let clipped = image(|r| (r.random::<f64>() * 2000.0).min(936.0), 64.0, 0.0);
        let levels = zones().levels(&clipped, &ImageSettings::default());
        assert_eq!(levels.saturation_counts, Some(1000));
        assert!((levels.saturated_share - 0.532).abs() < 0.02, "{levels:?}");
    }

    #[test]
    fn an_all_zero_image_has_no_signal_and_finite_levels() {
        let optics = test_bench::optics();
        let (nx, ny) = (optics.sensor.columns, optics.sensor.rows);
        let black = RawImage::new(nx, ny, vec![0; nx * ny]).unwrap();
        let levels = zones().levels(&black, &ImageSettings::default());
        assert_eq!((levels.mean_signal_counts, levels.bright_share), (0.0, 0.0));
        assert_eq!(levels.saturation_counts, None);
        assert!(levels.noise_counts > 0.0 && levels.offset_counts == 0.0);
    }
}
