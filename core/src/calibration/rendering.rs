//! Rendered micro-images: how a pixel depends on the discs whose light falls on it.

use nalgebra::{SMatrix, SVector};

use super::{
    WhiteImage,
    affine_fit::LensCentre,
    cell_light::CellLight,
    second_aperture::{Field, SecondAperture},
};
use crate::lightfield::MicroImageGrid;

/// What a lens has of its own: light at the centre, its curvature, its slopes along columns and rows, and the
/// background.
const OWN: usize = 5;
const SLOPES: [usize; 2] = [2, 3];

/// How much slopes are held back, relative to what their pixels say of them. Free ones follow whatever makes a real
/// micro-image lopsided, and take the centre along: grids of real microscopes then were 0.1 px further from
/// those of their rims. Without any, light that is 4 % brighter on one side at the edge of the field costs 0.05 px
/// there where micro-images are 48 px wide; held back like this, 0.01 px.
const SLOPE_PRIOR: f64 = 0.4;

/// Number of parameters shared by all lenses: six of the grid, radius, blur, and four of the second aperture.
pub(super) const SHARED_PARAMETERS: usize = 12;

/// A disc is as dark as its surroundings this many blurs outside of its rim.
const RIM_BLURS: f64 = 4.0;

type Own = SVector<f64, OWN>;
pub(super) type Shared = SVector<f64, SHARED_PARAMETERS>;

/// What all lenses share.
#[derive(Debug, Clone)]
pub(super) struct Model {
    pub grid: MicroImageGrid,
    pub radius_px: f64,
    pub blur_px: f64,
    pub second: Option<SecondAperture>,
}

impl Model {
    /// Lenses from the array's middle to its edge.
    pub fn scale(&self) -> [f64; 2] {
        self.grid.microlenses.map(|count| (count as f64 / 2.0).max(1.0))
    }
}

/// Sums of one lens, its own unknowns eliminated.
pub(super) struct Eliminated {
    pub normal: SMatrix<f64, SHARED_PARAMETERS, SHARED_PARAMETERS>,
    pub right: Shared,
    pub misfit: f64,
}

/// The light of one disc with a rim blurred by a Gaussian, at a distance outside of it; and its slopes by that
/// distance and by the blur.
#[inline]
fn covered(outside_px: f64, blur_px: f64) -> [f64; 3] {
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

/// erfc to 1.5·10⁻⁷ (Abramowitz and Stegun, 7.1.26).
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

/// One pixel: how it depends on the lens' own unknowns, what it has, and how all discs on it depend on
/// their centres and the shared shape.
struct Pixel {
    basis: Own,
    light: f64,
    discs: Vec<DiscOnPixel>,
}

/// What one lens' disc, at a neighbour's place or its own, does to a pixel.
struct DiscOnPixel {
    /// Number of the neighbour; 0 is the lens itself.
    lens: usize,
    /// The lens' own light at this pixel but for the discs: 1, r², x and y.
    shape: [f64; 4],
    /// Slopes of the discs' product by the centre's column and row, and by radius, blur and the second
    /// aperture's radius, shift and offset.
    by_centre: [f64; 2],
    by_shape: [f64; 4],
    by_second_offset: [f64; 2],
}

/// A model at work on an image.
pub(super) struct Rendering<'a> {
    model: &'a Model,
    light: &'a CellLight,
    field: &'a Field,
    image: &'a WhiteImage,
    /// Neighbours whose discs may reach the cell; the first is the lens itself.
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

    /// All pixels nearer to this lens than to its neighbours. `None` where some are not on the image.
    fn pixels(&self, lens: [usize; 2]) -> Option<Vec<Pixel>> {
        let grid = &self.model.grid;
        let place = |[i, j]: [i64; 2]| {
            grid.centre_px((lens[0] as i64 + i) as f64, (lens[1] as i64 + j) as f64)
        };
        let centres: Vec<[f64; 2]> = self.neighbours.iter().map(|&n| place(n)).collect();
        let own = self.light.of(lens)?;
        let shares: Vec<f64> = self
            .neighbours
            .iter()
            .map(|n| self.light.of_neighbour(lens, *n).map_or(1.0, |light| light / own))
            .collect();
        let cell = super::cell_pixels(grid, lens, self.image.columns(), self.image.rows())?;
        let pixel = |[column, row]: [usize; 2]| {
            let at = [column as f64, row as f64];
            let mut pixel =
                Pixel { basis: Own::zeros(), light: self.image.at(column, row), discs: Vec::new() };
            pixel.basis[OWN - 1] = 1.0;
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
        // Blurred after the cut: side by side, the inner one of two rims is seen alone.
        let (covering, by_outside, by_centre, by_shape, by_second_offset);
        match cut {
            Some((second, outside, towards)) if outside > stop_outside => {
                let [covered, slope, by_blur] = covered(outside, model.blur_px);
                let share = self.field.share(centre);
                let moves = 1.0 + second.shift_at_corner_px / self.field.half_diagonal_px;
                (covering, by_outside) = (covered, slope);
                by_second_offset = towards.map(|n| -n * slope);
                by_centre = by_second_offset.map(|part| part * moves);
                let by_shift = by_second_offset[0] * share[0] + by_second_offset[1] * share[1];
                by_shape = [0.0, by_blur, -slope, by_shift];
            }
            _ => {
                let [covered, slope, by_blur] = covered(stop_outside, model.blur_px);
                (covering, by_outside) = (covered, slope);
                by_second_offset = [0.0; 2];
                by_centre = towards.map(|n| -n * slope);
                by_shape = [-slope, by_blur, 0.0, 0.0];
            }
        }
        if covering == 0.0 {
            return;
        }
        let [x, y] = from.map(|place| place / model.radius_px);
        let shape = [share, share * (x * x + y * y), share * x, share * y];
        for (basis, shape) in pixel.basis.iter_mut().zip(shape) {
            *basis += shape * covering;
        }
        if by_outside != 0.0 {
            pixel.discs.push(DiscOnPixel { lens, shape, by_centre, by_shape, by_second_offset });
        }
    }

    /// The lens' own unknowns for given discs, with the root mean square of what they leave relative to the
    /// lens' brightness.
    fn own(&self, pixels: &[Pixel]) -> Option<(SMatrix<f64, OWN, OWN>, Own, f64)> {
        let mut normal = SMatrix::<f64, OWN, OWN>::zeros();
        let mut right = Own::zeros();
        for pixel in pixels {
            normal += pixel.basis * pixel.basis.transpose();
            right += pixel.light * pixel.basis;
        }
        for slope in SLOPES {
            normal[(slope, slope)] *= 1.0 + SLOPE_PRIOR;
        }
        for n in 0..OWN {
            normal[(n, n)] += 1e-6 * pixels.len() as f64;
        }
        let inverse = normal.try_inverse()?;
        let own = inverse * right;
        let squares: f64 =
            pixels.iter().map(|pixel| (pixel.light - pixel.basis.dot(&own)).powi(2)).sum();
        let misfit = (squares / pixels.len() as f64).sqrt() / own[0].abs().max(f64::MIN_POSITIVE);
        (own[0] > 0.0).then_some((inverse, own, misfit))
    }

    /// The normal equations of what is shared, from one lens, of unit brightness.
    pub fn eliminated(&self, lens: [usize; 2]) -> Option<Eliminated> {
        let pixels = self.pixels(lens)?;
        let (inverse, own, misfit) = self.own(&pixels)?;
        let scale = self.model.scale();
        let mut normal = SMatrix::<f64, SHARED_PARAMETERS, SHARED_PARAMETERS>::zeros();
        let mut crossed = SMatrix::<f64, SHARED_PARAMETERS, OWN>::zeros();
        let mut right = Shared::zeros();
        for pixel in &pixels {
            if pixel.discs.is_empty() {
                continue;
            }
            let mut slope = Shared::zeros();
            for disc in &pixel.discs {
                let light: f64 = disc.shape.iter().zip(own.iter()).map(|(s, own)| s * own).sum();
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
            crossed += slope * pixel.basis.transpose();
            right += (pixel.light - pixel.basis.dot(&own)) * slope;
        }
        let brightness = own[0] * own[0];
        let normal = (normal - crossed * inverse * crossed.transpose()) / brightness;
        Some(Eliminated { normal, right: right / brightness, misfit })
    }

    /// The centre of one lens by itself, all that is shared being known.
    pub fn centre(&self, lens: [usize; 2]) -> Option<(LensCentre, f64)> {
        let pixels = self.pixels(lens)?;
        let (inverse, own, misfit) = self.own(&pixels)?;
        let mut normal = SMatrix::<f64, 2, 2>::zeros();
        let mut crossed = SMatrix::<f64, 2, OWN>::zeros();
        let mut right = SVector::<f64, 2>::zeros();
        for pixel in &pixels {
            let Some(disc) = pixel.discs.iter().find(|disc| disc.lens == 0) else { continue };
            let light: f64 = disc.shape.iter().zip(own.iter()).map(|(s, own)| s * own).sum();
            let slope = SVector::<f64, 2>::from(disc.by_centre) * light;
            normal += slope * slope.transpose();
            crossed += slope * pixel.basis.transpose();
            right += (pixel.light - pixel.basis.dot(&own)) * slope;
        }
        let normal = normal - crossed * inverse * crossed.transpose();
        let step = normal.cholesky()?.solve(&right);
        let [column, row] = self.model.grid.centre_px(lens[0] as f64, lens[1] as f64);
        let brightness = own[0] * own[0];
        let information =
            [normal[(0, 0)], normal[(0, 1)], normal[(1, 1)]].map(|entry| entry / brightness);
        let centre_px = [column + step[0], row + step[1]];
        Some((LensCentre { lens, centre_px, information }, misfit))
    }
}
