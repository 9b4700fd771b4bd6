//! Estimation of a camera's point blur from the images.

use rayon::prelude::*;

use super::fit::FrameFit;
use crate::{
    model::{PointBlur, PointCamera, PointFootprint},
    parabola,
};

/// Ratio of successive trial widths.
const WIDTH_STEP: f64 = 1.4;

/// Limits of the width, as standard deviations in pixels.
const WIDTHS_PX: [f64; 2] = [0.08, 1.2];

/// Largest number of moves to a larger or smaller width.
const MAX_MOVES: usize = 6;

/// Every third particle is used.
const SUBSAMPLING: usize = 3;

/// Initial width of points, in pixels.
pub const FIRST_WIDTH_PX: f64 = 0.25;

/// Blur with the same width on the sensor and, in pixels, on the microlenses: microlenses have the working f-number of
/// the main lens, so diffraction is equal on both.
pub fn blur_of_width(width_px: f64, pixel_mm: f64) -> PointBlur {
    PointBlur { plane_mm: width_px * pixel_mm, sensor_px: width_px }
}

/// The width with the least residual of camera `c`'s image, for the particles with indices `of`.
pub fn fitted_blur(fit: &FrameFit, cameras: &[PointCamera], c: usize, of: &[usize]) -> PointBlur {
    let before = cameras[c].blur;
    let pixel_mm = before.plane_mm / before.sensor_px;
    let sampled: Vec<usize> = of.iter().copied().step_by(SUBSAMPLING).collect();
    let (mut camera, mut image) = (cameras[c].clone(), fit.images[c].clone());
    let mut misfit = |log_width: f64| {
        camera.blur = blur_of_width(log_width.exp(), pixel_mm);
        fit.render_in(&mut image, &camera, c);
        // Pixels and weights are those of the previous width for every trial width.
        let left = |footprint: &mut PointFootprint, &n: &usize| {
            cameras[c].image(fit.particles[n].at_mm, footprint);
            image.weighted_residual(&fit.images[c], &cameras[c], footprint)
        };
        let left: Vec<f64> = sampled.par_iter().map_init(PointFootprint::default, left).collect();
        left.iter().sum::<f64>()
    };
    let step = WIDTH_STEP.ln();
    let [low, high] = WIDTHS_PX.map(f64::ln);
    let mut middle = before.sensor_px.ln().clamp(low + step, high - step);
    let mut at = [-step, 0.0, step].map(|further| misfit(middle + further));
    for _ in 0..MAX_MOVES {
        if at[0] < at[1] && middle - 2.0 * step >= low {
            middle -= step;
            at = [misfit(middle - step), at[0], at[1]];
        } else if at[2] < at[1] && middle + 2.0 * step <= high {
            middle += step;
            at = [at[1], at[2], misfit(middle + step)];
        } else {
            break;
        }
    }
    blur_of_width((middle + parabola::minimum(at) * step).exp(), pixel_mm)
}
