//! Rendered micro-images, and the derivatives of pixels with respect to their parameters.

use nalgebra::{SMatrix, SVector};

use super::{
    WhiteImage,
    affine_fit::LensCentre,
    cell_light::CellLight,
    second_aperture::{Field, SecondAperture},
};
use crate::lightfield::MicroImageGrid;

/// Number of local parameters of a lens: light at the centre, its curvature, its slopes along columns and rows, and
/// the background.
const LOCAL_PARAMETERS: usize = 5;
/// Indices of the slopes.
const SLOPES: [usize; 2] = [2, 3];

/// Prior precision of the slopes, relative to the information of the pixels. Unregularised slopes fit any asymmetry
/// of a real micro-image and bias its centre: grids of real microscopes were then 0.1 px farther from those of
/// their rims. Without slopes, a gradient of 4 % over micro-images of 48 px at the edge of the field causes an
/// error of 0.05 px there; with this prior, 0.01 px.
const SLOPE_PRIOR: f64 = 0.4;

/// Number of parameters shared by all lenses: six of the grid, radius, blur, and four of the second aperture.
pub(super) const SHARED_PARAMETERS: usize = 12;

/// Half width of a rim's profile, in standard deviations of the blur.
const RIM_BLURS: f64 = 4.0;

type Local = SVector<f64, LOCAL_PARAMETERS>;
pub(super) type Shared = SVector<f64, SHARED_PARAMETERS>;

/// Parameters shared by all lenses; lengths in pixels.
#[derive(Debug, Clone)]
pub(super) struct Model {
    pub grid: MicroImageGrid,
    pub radius_px: f64,
    pub blur_px: f64,
    pub second: Option<SecondAperture>,
}

impl Model {
    /// Number of lenses from the middle of the array to its edge along i and j.
    pub fn scale(&self) -> [f64; 2] {
        self.grid.microlenses.map(|count| (count as f64 / 2.0).max(1.0))
    }
}

/// Reduced normal equations of one lens, without its local parameters.
pub(super) struct ReducedEquations {
    pub normal: SMatrix<f64, SHARED_PARAMETERS, SHARED_PARAMETERS>,
    pub right: Shared,
    pub misfit: f64,
}

/// Light of a disc with a Gaussian-blurred rim at a signed distance from the rim, positive outside, and its
/// derivatives with respect to the distance and to the blur.
#[inline]
fn disc_light(outside_px: f64, blur_px: f64) -> [f64; 3] {
    let relative = outside_px / blur_px;
    if relative.abs() > RIM_BLURS {
        return [if relative < 0.0 { 1.0 } else { 0.0 }, 0.0, 0.0];
    }
    let slope = -(-0.5 * relative * relative).exp() / (blur_px * std::f64::consts::TAU.sqrt());
    [
        0.5 * complementary_error(relative * std::f64::consts::FRAC_1_SQRT_2),
        slope,
        -relative * slope,
    ]
}

/// erfc with an error below 1.5·10⁻⁷ (Abramowitz and Stegun, equation 7.1.26).
#[inline]
fn complementary_error(x: f64) -> f64 {
    let t = 1.0 / (1.0 + 0.327_591_1 * x.abs());
    let polynomial = t
        * (0.254_829_592
            + t * (-0.284_496_736
                + t * (1.421_413_741 + t * (-1.453_152_027 + t * 1.061_405_429))));
    let tail = polynomial * (-x * x).exp();
    if x >= 0.0 { tail } else { 2.0 - tail }
}

/// One pixel: derivatives with respect to the local parameters, measured light, and derivatives of the discs that
/// reach it.
struct Pixel {
    basis: Local,
    light: f64,
    discs: Vec<DiscOnPixel>,
}

/// Contribution of the disc of a lens or of its neighbour to a pixel.
struct DiscOnPixel {
    /// Index of the neighbour; 0 is the lens itself.
    lens: usize,
    /// Basis functions of the light distribution at this pixel: 1, r², x and y.
    shape: [f64; 4],
    /// Derivatives of the disc with respect to column and row of its centre.
    by_centre: [f64; 2],
    /// With respect to radius, blur, and the second aperture's radius and shift.
    by_shape: [f64; 4],
    /// With respect to the second aperture's offset.
    by_second_offset: [f64; 2],
}

/// A model that is fitted to an image.
pub(super) struct Rendering<'a> {
    model: &'a Model,
    light: &'a CellLight,
    field: &'a Field,
    image: &'a WhiteImage,
    /// Lattice steps to neighbours whose discs may reach the unit cell; the first is the lens itself.
    neighbours: Vec<[i64; 2]>,
}

impl<'a> Rendering<'a> {
    pub fn new(
        model: &'a Model,
        light: &'a CellLight,
        field: &'a Field,
        image: &'a WhiteImage,
    ) -> Self {
        let pitch = super::pitch_px(&model.grid);
        let reach = 0.75 * pitch + model.radius_px + RIM_BLURS * model.blur_px;
        let neighbours =
            std::iter::once([0, 0]).chain(super::neighbour_numbers(&model.grid, reach)).collect();
        Self { model, light, field, image, neighbours }
    }

    /// All pixels nearer to this lens than to its neighbours. `None` if some are outside the image.
    fn pixels(&self, lens: [usize; 2]) -> Option<Vec<Pixel>> {
        let grid = &self.model.grid;
        let place = |[i, j]: [i64; 2]| {
            grid.centre_px((lens[0] as i64 + i) as f64, (lens[1] as i64 + j) as f64)
        };
        let centres: Vec<[f64; 2]> = self.neighbours.iter().map(|&n| place(n)).collect();
        let own_light = self.light.of(lens)?;
        let shares: Vec<f64> = self
            .neighbours
            .iter()
            .map(|n| self.light.of_neighbour(lens, *n).map_or(1.0, |light| light / own_light))
            .collect();
        let cell = super::cell_pixels(grid, lens, self.image.columns(), self.image.rows())?;
        let pixel = |[column, row]: [usize; 2]| {
            let at = [column as f64, row as f64];
            let mut pixel = Pixel {
                basis: Local::zeros(),
                light: self.image.at(column, row),
                discs: Vec::new(),
            };
            pixel.basis[LOCAL_PARAMETERS - 1] = 1.0;
            for (n, (centre, share)) in centres.iter().zip(&shares).enumerate() {
                self.add_disc(&mut pixel, n, at, *centre, *share);
            }
            pixel
        };
        Some(cell.into_iter().map(pixel).collect())
    }

    fn add_disc(&self, pixel: &mut Pixel, lens: usize, at: [f64; 2], centre: [f64; 2], share: f64) {
        let model = self.model;
        let from = [at[0] - centre[0], at[1] - centre[1]];
        let distance = from[0].hypot(from[1]).max(1e-9);
        let stop_outside = distance - model.radius_px;
        let towards = from.map(|place| place / distance);
        let cut = model.second.as_ref().map(|second| {
            let middle = second.centre_px(centre, self.field);
            let from = [at[0] - middle[0], at[1] - middle[1]];
            let distance = from[0].hypot(from[1]).max(1e-9);
            (second, distance - second.radius_px, from.map(|place| place / distance))
        });
        // Only the inner rim is blurred: a product of two blurred discs would be too dark where rims are close.
        let (disc_share, by_outside, by_centre, by_shape, by_second_offset);
        match cut {
            Some((second, outside, towards)) if outside > stop_outside => {
                let [light, slope, by_blur] = disc_light(outside, model.blur_px);
                let share = self.field.share(centre);
                let stretch = 1.0 + second.shift_at_corner_px / self.field.half_diagonal_px;
                (disc_share, by_outside) = (light, slope);
                by_second_offset = towards.map(|n| -n * slope);
                by_centre = by_second_offset.map(|part| part * stretch);
                let by_shift = by_second_offset[0] * share[0] + by_second_offset[1] * share[1];
                by_shape = [0.0, by_blur, -slope, by_shift];
            }
            _ => {
                let [light, slope, by_blur] = disc_light(stop_outside, model.blur_px);
                (disc_share, by_outside) = (light, slope);
                by_second_offset = [0.0; 2];
                by_centre = towards.map(|n| -n * slope);
                by_shape = [-slope, by_blur, 0.0, 0.0];
            }
        }
        if disc_share == 0.0 {
            return;
        }
        let [x, y] = from.map(|place| place / model.radius_px);
        let shape = [share, share * (x * x + y * y), share * x, share * y];
        for (basis, shape) in pixel.basis.iter_mut().zip(shape) {
            *basis += shape * disc_share;
        }
        if by_outside != 0.0 {
            pixel.discs.push(DiscOnPixel { lens, shape, by_centre, by_shape, by_second_offset });
        }
    }

    /// Fits the local parameters for given discs: inverse of the normal matrix, parameters, and root-mean-square
    /// residual relative to the lens' brightness.
    fn fit_local(
        &self,
        pixels: &[Pixel],
    ) -> Option<(SMatrix<f64, LOCAL_PARAMETERS, LOCAL_PARAMETERS>, Local, f64)> {
        let mut normal = SMatrix::<f64, LOCAL_PARAMETERS, LOCAL_PARAMETERS>::zeros();
        let mut right = Local::zeros();
        for pixel in pixels {
            normal += pixel.basis * pixel.basis.transpose();
            right += pixel.light * pixel.basis;
        }
        for slope in SLOPES {
            normal[(slope, slope)] *= 1.0 + SLOPE_PRIOR;
        }
        for n in 0..LOCAL_PARAMETERS {
            normal[(n, n)] += 1e-6 * pixels.len() as f64;
        }
        let inverse = normal.try_inverse()?;
        let local = inverse * right;
        let squares: f64 =
            pixels.iter().map(|pixel| (pixel.light - pixel.basis.dot(&local)).powi(2)).sum();
        let misfit = (squares / pixels.len() as f64).sqrt() / local[0].abs().max(f64::MIN_POSITIVE);
        (local[0] > 0.0).then_some((inverse, local, misfit))
    }

    /// Reduced normal equations of the shared parameters from one lens, normalised by its squared brightness.
    pub fn reduced(&self, lens: [usize; 2]) -> Option<ReducedEquations> {
        let pixels = self.pixels(lens)?;
        let (inverse, local, misfit) = self.fit_local(&pixels)?;
        let scale = self.model.scale();
        let mut normal = SMatrix::<f64, SHARED_PARAMETERS, SHARED_PARAMETERS>::zeros();
        let mut mixed = SMatrix::<f64, SHARED_PARAMETERS, LOCAL_PARAMETERS>::zeros();
        let mut right = Shared::zeros();
        for pixel in &pixels {
            if pixel.discs.is_empty() {
                continue;
            }
            let mut slope = Shared::zeros();
            for disc in &pixel.discs {
                let light: f64 =
                    disc.shape.iter().zip(local.iter()).map(|(s, local)| s * local).sum();
                let number = self.neighbours[disc.lens];
                let [u, v] = [0, 1]
                    .map(|axis| (lens[axis] as i64 + number[axis]) as f64 / scale[axis] - 1.0);
                let [x, y] = disc.by_centre.map(|slope| slope * light);
                for (n, part) in [x, x * u, x * v, y, y * u, y * v].into_iter().enumerate() {
                    slope[n] += part;
                }
                for n in 0..4 {
                    slope[6 + n] += light * disc.by_shape[n];
                }
                slope[10] += light * disc.by_second_offset[0];
                slope[11] += light * disc.by_second_offset[1];
            }
            normal += slope * slope.transpose();
            mixed += slope * pixel.basis.transpose();
            right += (pixel.light - pixel.basis.dot(&local)) * slope;
        }
        let brightness = local[0] * local[0];
        let normal = (normal - mixed * inverse * mixed.transpose()) / brightness;
        Some(ReducedEquations { normal, right: right / brightness, misfit })
    }

    /// Fits the centre of one lens with the shared parameters fixed. Also returns its relative residual.
    pub fn centre(&self, lens: [usize; 2]) -> Option<(LensCentre, f64)> {
        let pixels = self.pixels(lens)?;
        let (inverse, local, misfit) = self.fit_local(&pixels)?;
        let mut normal = SMatrix::<f64, 2, 2>::zeros();
        let mut mixed = SMatrix::<f64, 2, LOCAL_PARAMETERS>::zeros();
        let mut right = SVector::<f64, 2>::zeros();
        for pixel in &pixels {
            let Some(disc) = pixel.discs.iter().find(|disc| disc.lens == 0) else { continue };
            let light: f64 = disc.shape.iter().zip(local.iter()).map(|(s, local)| s * local).sum();
            let slope = SVector::<f64, 2>::from(disc.by_centre) * light;
            normal += slope * slope.transpose();
            mixed += slope * pixel.basis.transpose();
            right += (pixel.light - pixel.basis.dot(&local)) * slope;
        }
        let normal = normal - mixed * inverse * mixed.transpose();
        let step = normal.cholesky()?.solve(&right);
        let [column, row] = self.model.grid.centre_px(lens[0] as f64, lens[1] as f64);
        let brightness = local[0] * local[0];
        let information =
            [normal[(0, 0)], normal[(0, 1)], normal[(1, 1)]].map(|entry| entry / brightness);
        let centre_px = [column + step[0], row + step[1]];
        Some((LensCentre { lens, centre_px, information }, misfit))
    }
}
