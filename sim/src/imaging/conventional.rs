//! A conventional camera: a thin lens and a sensor in its image plane, as planar PIV has it.

use lfpiv_hw::Pose;
use nalgebra::Point3;
use rayon::prelude::*;

use super::{ElectronImage, PointSource};

/// Particles imaged in parallel before they are added to the image.
const PARTICLES_PER_BATCH: usize = 4096;

/// Standard deviations of a particle's image from its centre to where it ends.
const REACH: f64 = 5.0;

/// A conventional camera. Its pose is that of the point in focus on the optical axis.
///
/// A particle's image is a Gaussian: the core of the Airy pattern, σ = 0.42 λ N (1 + |M|) (Zhang, Zerubia and
/// Olivo-Marin 2007), and out of focus also the second moment of the pupil's shadow, a disc of diameter c, σ = c/4.
/// A pixel has the integral over its area.
#[derive(Debug, Clone, PartialEq)]
pub struct ConventionalCamera {
    /// Where it is and where it looks.
    pub pose: Pose,
    /// Focal length, in mm.
    pub focal_length_mm: f64,
    /// Focal length over the pupil's diameter.
    pub f_number: f64,
    /// Magnification; negative, because a lens inverts.
    pub magnification: f64,
    /// Pixel columns and rows.
    pub pixels: [usize; 2],
    /// Pixel pitch, in µm.
    pub pixel_pitch_um: f64,
    /// Wavelength of the light, in nm.
    pub wavelength_nm: f64,
}

/// The image of one particle.
#[derive(Debug, Clone, Copy, PartialEq)]
struct Spot {
    /// Column and row of its centre, counted from the centre of the first pixel.
    centre_px: [f64; 2],
    sigma_px: f64,
    electrons: f64,
}

impl ConventionalCamera {
    /// Edge of a pixel in the plane in focus, in mm.
    pub fn object_pixel_mm(&self) -> f64 {
        self.pixel_pitch_um * 1e-3 / self.magnification.abs()
    }

    /// Distance from the plane in focus to the lens, in mm.
    pub fn object_distance_mm(&self) -> f64 {
        self.focal_length_mm * (1.0 + 1.0 / self.magnification.abs())
    }

    /// Distance from the lens to the sensor, in mm.
    pub fn image_distance_mm(&self) -> f64 {
        self.focal_length_mm * (1.0 + self.magnification.abs())
    }

    /// The light of `sources` on the sensor; what lies behind the lens is not seen. Equal for any number of
    /// threads.
    pub fn image(&self, sources: &[PointSource]) -> ElectronImage {
        let [columns, rows] = self.pixels;
        let mut image = ElectronImage::uniform(columns, rows, 0.0);
        for batch in sources.chunks(PARTICLES_PER_BATCH) {
            let patches: Vec<Option<Patch>> = batch
                .par_iter()
                .map(|source| Patch::of(&self.spot(source)?, self.pixels))
                .collect();
            // Adding in the order of the sources makes rounding independent of the threads.
            for patch in patches.into_iter().flatten() {
                patch.add_to(image.electrons_mut(), columns);
            }
        }
        image
    }

    fn spot(&self, source: &PointSource) -> Option<Spot> {
        let point = self.pose.to_camera(&Point3::from(source.position_mm));
        let (focal_mm, image_mm) = (self.focal_length_mm, self.image_distance_mm());
        let distance_mm = self.object_distance_mm() - point.depth_mm;
        if distance_mm <= focal_mm {
            return None;
        }
        let [x_mm, y_mm] = [point.xi_mm, point.eta_mm].map(|c| -c * image_mm / distance_mm);
        let focused_at_mm = focal_mm * distance_mm / (distance_mm - focal_mm);
        let pupil_mm = focal_mm / self.f_number;
        let disc_mm = pupil_mm * (image_mm / focused_at_mm - 1.0).abs();
        let airy_mm =
            0.42 * self.wavelength_nm * 1e-6 * self.f_number * (1.0 + self.magnification.abs());
        let pitch_mm = self.pixel_pitch_um * 1e-3;
        let [middle_column, middle_row] = self.pixels.map(|n| (n as f64 - 1.0) / 2.0);
        Some(Spot {
            // Rows count downwards, against `up`.
            centre_px: [middle_column + x_mm / pitch_mm, middle_row - y_mm / pitch_mm],
            sigma_px: airy_mm.hypot(disc_mm / 4.0) / pitch_mm,
            electrons: source.electrons,
        })
    }
}

/// A particle's light on the pixels about it: the product of shares of columns and of rows.
struct Patch {
    first: [usize; 2],
    shares: [Vec<f64>; 2],
    electrons: f64,
}

impl Patch {
    /// `None` for light beside the sensor.
    fn of(spot: &Spot, pixels: [usize; 2]) -> Option<Self> {
        let reach_px = REACH * spot.sigma_px + 0.5;
        let mut first = [0; 2];
        let mut shares = [Vec::new(), Vec::new()];
        for axis in 0..2 {
            let centre = spot.centre_px[axis];
            let low = (centre - reach_px).ceil().max(0.0);
            let high = (centre + reach_px).floor().min(pixels[axis] as f64 - 1.0);
            if low > high {
                return None;
            }
            first[axis] = low as usize;
            let edge = |pixel: f64| below(((pixel - 0.5) - centre) / spot.sigma_px);
            shares[axis] = (low as usize..=high as usize)
                .map(|pixel| edge(pixel as f64 + 1.0) - edge(pixel as f64))
                .collect();
        }
        Some(Self { first, shares, electrons: spot.electrons })
    }

    fn add_to(&self, electrons: &mut [f32], columns: usize) {
        for (y, of_row) in self.shares[1].iter().enumerate() {
            let start = (self.first[1] + y) * columns + self.first[0];
            for (pixel, of_column) in electrons[start..].iter_mut().zip(&self.shares[0]) {
                *pixel += (self.electrons * of_row * of_column) as f32;
            }
        }
    }
}

/// Share of a normal distribution below `x` standard deviations: Abramowitz and Stegun, equation (26.2.17), within
/// 7.5·10⁻⁸.
fn below(x: f64) -> f64 {
    const COEFFICIENTS: [f64; 5] =
        [0.319_381_530, -0.356_563_782, 1.781_477_937, -1.821_255_978, 1.330_274_429];
    let t = 1.0 / (1.0 + 0.231_641_9 * x.abs());
    let series = COEFFICIENTS.iter().rev().fold(0.0, |sum, c| (sum + c) * t);
    let above = series * (-x * x / 2.0).exp() / std::f64::consts::TAU.sqrt();
    if x < 0.0 { above } else { 1.0 - above }
}

#[cfg(test)]
mod tests {
    use nalgebra::Vector3;
    use rand::RngExt;
    use rand_distr::StandardNormal;

    use super::*;
    use crate::{
        imaging::pupil::concentric_disc,
        stream::{Purpose, random_stream},
    };

    fn camera() -> ConventionalCamera {
        ConventionalCamera {
            pose: Pose {
                right: Vector3::x(),
                up: Vector3::y(),
                axis: Vector3::z(),
                origin_mm: Vector3::new(1.0, -2.0, 0.5),
            },
            focal_length_mm: 100.0,
            f_number: 11.0,
            magnification: -0.33,
            pixels: [160, 120],
            pixel_pitch_um: 5.5,
            wavelength_nm: 532.0,
        }
    }

    fn source(position_mm: [f64; 3], electrons: f64) -> PointSource {
        PointSource { id: 0, position_mm, electrons }
    }

    /// Mean place (column, row) and variance along columns and rows of the light.
    fn moments(image: &ElectronImage) -> ([f64; 2], [f64; 2]) {
        let places = image.electrons().iter().enumerate().map(|(n, &light)| {
            let place = [n % image.columns(), n / image.columns()].map(|c| c as f64);
            (place, f64::from(light))
        });
        let total = image.total();
        let mean = |of: &dyn Fn([f64; 2]) -> f64| {
            places.clone().map(|(place, light)| light * of(place)).sum::<f64>() / total
        };
        let centre = [0, 1].map(|c| mean(&|place| place[c]));
        (centre, [0, 1].map(|c| mean(&|place| (place[c] - centre[c]).powi(2))))
    }

    /// Where rays through random points of the pupil meet the sensor, by the lens equation, as mean and variance
    /// in mm along right and up.
    fn by_rays(camera: &ConventionalCamera, [x, y, depth]: [f64; 3]) -> ([f64; 2], [f64; 2]) {
        let mut rng = random_stream(Purpose::Rays, &[1]);
        let (f, m) = (camera.focal_length_mm, camera.magnification.abs());
        let object = f + f / m - depth;
        let image = 1.0 / (1.0 / f - 1.0 / object);
        let sensor = f + f * m;
        let rays: Vec<[f64; 2]> = (0..400_000)
            .map(|_| {
                let square = [0, 1].map(|_| rng.random_range(-1.0..1.0));
                let pupil = concentric_disc(square, f / camera.f_number / 2.0);
                let sigma = 0.42 * 532e-6 * camera.f_number * (1.0 + m);
                [0, 1].map(|c| {
                    let focus = -[x, y][c] * image / object;
                    let blur: f64 = rng.sample(StandardNormal);
                    pupil[c] + (focus - pupil[c]) * sensor / image + sigma * blur
                })
            })
            .collect();
        let count = rays.len() as f64;
        let mean = [0, 1].map(|c| rays.iter().map(|ray| ray[c]).sum::<f64>() / count);
        (
            mean,
            [0, 1].map(|c| rays.iter().map(|ray| (ray[c] - mean[c]).powi(2)).sum::<f64>() / count),
        )
    }

    #[test]
    fn a_particle_is_where_rays_meet_as_wide_as_their_bundle_and_as_bright() {
        let camera = camera();
        for place in [[0.0, 0.0, 0.0], [0.61, -0.43, 0.0], [-0.8, 0.55, 1.5], [0.3, 0.7, -2.0]] {
            let position: [f64; 3] = std::array::from_fn(|c| camera.pose.origin_mm[c] + place[c]);
            let image = camera.image(&[source(position, 5000.0)]);
            assert!((image.total() / 5000.0 - 1.0).abs() < 1e-5, "{}", image.total());
            let (centre, variance) = moments(&image);
            let (expected, spread) = by_rays(&camera, place);
            let pitch = 0.0055;
            let at = [79.5 + expected[0] / pitch, 59.5 - expected[1] / pitch];
            for c in 0..2 {
                assert!((centre[c] - at[c]).abs() < 0.02, "{place:?}: {centre:?} {at:?}");
                // A pixel's own extent adds 1/12.
                let wide = spread[c] / pitch / pitch + 1.0 / 12.0;
                assert!((variance[c] / wide - 1.0).abs() < 0.01, "{place:?}: {variance:?} {wide}");
            }
        }
    }

    #[test]
    fn the_magnification_is_minus_a_third() {
        let camera = camera();
        let column = |x: f64| moments(&camera.image(&[source([1.0 + x, -2.0, 0.5], 1e4)])).0[0];
        let moved_mm = (column(0.5) - column(-0.5)) * 0.0055;
        assert!((moved_mm + 0.33).abs() < 1e-5, "{moved_mm}");
        assert!((camera.object_pixel_mm() - 1.0 / 60.0).abs() < 1e-12);
    }

    #[test]
    fn light_beside_the_sensor_is_lost_and_half_of_it_on_the_edge() {
        let camera = camera();
        let at = |column: f64| {
            let x = 1.0 - (column - 79.5) * camera.object_pixel_mm();
            camera.image(&[source([x, -2.0, 0.5], 1000.0)]).total()
        };
        assert_eq!(at(-10.0), 0.0);
        assert!((at(-0.5) / 1000.0 - 0.5).abs() < 1e-5, "{}", at(-0.5));
        assert_eq!(camera.image(&[source([1.0, -2.0, 400.0], 1000.0)]).total(), 0.0);
    }

    #[test]
    fn the_normal_distribution_is_that_of_the_tables() {
        for (x, expected) in [(0.0, 0.5), (1.0, 0.841_344_746), (-1.96, 0.024_997_895)] {
            assert!((below(x) - expected).abs() < 1e-7, "{x}: {}", below(x));
        }
    }
}
