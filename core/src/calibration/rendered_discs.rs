//! Second estimator: rendered micro-images, fitted to all pixels.
//!
//! A micro-image is rendered as the intersection of the stop's disc and the second aperture's disc with a blurred
//! rim, times a smooth light distribution; neighbours are added. Grid, radii and blur are common to all lenses and
//! are fitted together. Brightness, curvature, slopes and background are local parameters of each lens. They are
//! eliminated lens by lens (variable projection; Golub and Pereyra, SIAM J. Numer. Anal. 10, 1973).

use nalgebra::SMatrix;
use rayon::prelude::*;

use super::{
    WhiteImage,
    affine_fit::LensCentre,
    cell_light::CellLight,
    rendering::{Model, ReducedEquations, Rendering, SHARED_PARAMETERS, Shared},
    second_aperture::{Field, SecondAperture},
    start::Start,
};
use crate::lightfield::MicroImageGrid;

/// Largest number of lenses, distributed over the field, for the fit of shared parameters.
const MOST_LENSES: usize = 900;

/// Largest number of Gauss-Newton steps.
pub(super) const ROUNDS: usize = 40;

/// Initial and least blur, in pixels.
const FIRST_BLUR_PX: f64 = 0.8;
const LEAST_BLUR_PX: f64 = 0.25;

/// Limit of a step of any parameter, in pixels.
const LARGEST_STEP_PX: f64 = 1.0;

/// Result of the fit; lengths in pixels.
#[derive(Debug, Clone)]
pub(super) struct Discs {
    pub grid: MicroImageGrid,
    pub radius_px: f64,
    pub blur_px: f64,
    pub second: Option<SecondAperture>,
    pub centres: Vec<LensCentre>,
    /// Root-mean-square residual of each micro-image in `centres`, relative to its brightness.
    pub misfits: Vec<f64>,
}

/// Fits the shared parameters to lenses distributed over the field, then the centre of every lens. `None` if the
/// pixels do not determine the parameters.
pub(super) fn fit(
    image: &WhiteImage,
    start: &Start,
    light: &CellLight,
    lenses: &[[usize; 2]],
    mut round_ended: impl FnMut(),
) -> Option<Discs> {
    let field = Field::of(image.columns(), image.rows());
    let mut model = Model {
        grid: start.grid.clone(),
        radius_px: start.radius_px,
        blur_px: FIRST_BLUR_PX,
        second: start.second,
    };
    // The stride is odd: a common divisor with the row length would leave out columns.
    let stride = lenses.len().div_ceil(MOST_LENSES).max(1) | 1;
    let some: Vec<[usize; 2]> = lenses.iter().copied().step_by(stride).collect();
    for _ in 0..ROUNDS {
        let largest_step = model.improve(image, light, &field, &some)?;
        round_ended();
        if largest_step < 1e-4 {
            break;
        }
    }
    let rendering = Rendering::new(&model, light, &field, image);
    let found: Vec<(LensCentre, f64)> =
        lenses.par_iter().filter_map(|&lens| rendering.centre(lens)).collect();
    let (centres, misfits) = found.into_iter().unzip();
    let Model { grid, radius_px, blur_px, second } = model;
    Some(Discs { grid, radius_px, blur_px, second, centres, misfits })
}

impl Model {
    /// One Gauss-Newton step of limited length. Returns the largest change of a parameter before the limit.
    fn improve(
        &mut self,
        image: &WhiteImage,
        light: &CellLight,
        field: &Field,
        lenses: &[[usize; 2]],
    ) -> Option<f64> {
        let rendering = Rendering::new(self, light, field, image);
        let sums: Vec<ReducedEquations> =
            lenses.par_iter().filter_map(|&lens| rendering.reduced(lens)).collect();
        let typical = super::median(sums.iter().map(|sum| sum.misfit));
        let mut normal = SMatrix::<f64, SHARED_PARAMETERS, SHARED_PARAMETERS>::zeros();
        let mut right = Shared::zeros();
        for sum in &sums {
            // Lenses with large residuals have dust or unexpected light.
            let weight = (2.0 * typical / sum.misfit.max(f64::MIN_POSITIVE)).min(1.0).powi(4);
            normal += weight * sum.normal;
            right += weight * sum.right;
        }
        let used = if self.second.is_some() { SHARED_PARAMETERS } else { 8 };
        for n in 0..SHARED_PARAMETERS {
            if n < used {
                normal[(n, n)] *= 1.0 + 1e-6;
            } else {
                (normal[(n, n)], right[n]) = (1.0, 0.0);
            }
        }
        let step = normal.cholesky()?.solve(&right);
        let largest = step.iter().fold(0.0f64, |most, part| most.max(part.abs()));
        let step = step * (LARGEST_STEP_PX / largest.max(LARGEST_STEP_PX));
        self.moved(&step);
        Some(largest)
    }

    fn moved(&mut self, step: &Shared) {
        let scale = self.scale();
        let moved = |affine: [f64; 3], at: usize| {
            let (by_u, by_v) = (step[at + 1], step[at + 2]);
            [
                affine[0] + step[at] - by_u - by_v,
                affine[1] + by_u / scale[0],
                affine[2] + by_v / scale[1],
            ]
        };
        self.grid.column_px = moved(self.grid.column_px, 0);
        self.grid.row_px = moved(self.grid.row_px, 3);
        self.radius_px += step[6];
        self.blur_px = (self.blur_px + step[7]).max(LEAST_BLUR_PX);
        if let Some(second) = &mut self.second {
            second.radius_px += step[8];
            second.shift_at_corner_px += step[9];
            second.offset_px = [second.offset_px[0] + step[10], second.offset_px[1] + step[11]];
        }
    }
}
