//! Noise of pixels, estimated from the residual image.

use crate::statistics::{MEDIAN_SQUARE, median};

/// Noise of a pixel with an expected value of m counts: its variance is
/// `dark` + `gain` m + (`misfit` m)², in counts².
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct PixelNoise {
    /// Variance of a pixel without light from particles.
    pub dark: f32,
    /// Counts per photo-electron: shot noise.
    pub gain: f32,
    /// Relative error of the model: footprint, and missing or false particles.
    pub misfit: f32,
}

impl PixelNoise {
    /// Variance of a pixel with an expected value of `model` counts above black, in counts².
    #[inline(always)]
    pub fn variance(&self, model: f32) -> f32 {
        let lit = model.max(0.0);
        self.dark + lit * (self.gain + self.misfit * self.misfit * lit)
    }
}

/// Every seventh pixel is used: 7 has no common factor with the length of the images' rows.
const SUBSAMPLING: usize = 7;

/// Levels of light, each twice as bright as the one before; the first ends at this many counts.
const LEVELS: usize = 12;
const FIRST_LEVEL_COUNTS: f32 = 4.0;

/// Least number of pixels of a level.
const LEAST_PIXELS: usize = 200;

/// Noise of pixels with this model and residual; `dark` is known. Medians are robust against pixels of missing or
/// misplaced particles.
pub fn noise_of(pixels: impl Iterator<Item = (f32, f32)>, dark: f32) -> PixelNoise {
    let mut squares: Vec<Vec<f32>> = vec![Vec::new(); LEVELS];
    let mut levels = vec![0.0f64; LEVELS];
    for (model, residual) in pixels.step_by(SUBSAMPLING) {
        if model < 1.0 {
            continue;
        }
        let level = (model / FIRST_LEVEL_COUNTS).log2().max(-1.0) as i32 + 1;
        let level = (level.max(0) as usize).min(LEVELS - 1);
        squares[level].push(residual * residual);
        levels[level] += f64::from(model);
    }
    // Least squares for v − dark = g m + q² m², each level by its relative error.
    let (mut mm, mut mq, mut qq, mut mv, mut qv) = (0.0, 0.0, 0.0, 0.0, 0.0);
    for (squares, sum) in squares.iter().zip(levels) {
        let count = squares.len();
        if count < LEAST_PIXELS {
            continue;
        }
        let m = sum / count as f64;
        let seen = median(squares.iter().copied()).unwrap_or_default() / MEDIAN_SQUARE;
        let weight = (count as f64).sqrt() / (seen + f64::from(dark)).powi(2).max(1e-9);
        let above = seen - f64::from(dark);
        mm += weight * m * m;
        mq += weight * m.powi(3);
        qq += weight * m.powi(4);
        mv += weight * m * above;
        qv += weight * m * m * above;
    }
    let determinant = mm * qq - mq * mq;
    let (gain, square) = if determinant > 1e-12 * mm * qq {
        ((qq * mv - mq * qv) / determinant, (mm * qv - mq * mv) / determinant)
    } else {
        (mv / f64::max(mm, 1e-12), 0.0)
    };
    let (gain, square) = match (gain >= 0.0, square >= 0.0) {
        (true, true) => (gain, square),
        (false, _) => (0.0, (qv / f64::max(qq, 1e-12)).max(0.0)),
        (_, false) => ((mv / f64::max(mm, 1e-12)).max(0.0), 0.0),
    };
    PixelNoise { dark, gain: gain as f32, misfit: square.sqrt() as f32 }
}

#[cfg(test)]
mod tests {
    use rand::{RngExt, SeedableRng};
    use rand_pcg::Pcg64Mcg;

    use super::*;

    #[test]
    fn noise_is_found_although_particles_are_missing() {
        let mut random = Pcg64Mcg::seed_from_u64(5);
        let pixels = (0..400_000).map(|n| {
            let model = 2.0f32 * 500.0f32.powf(random.random());
            let normal = (0..12).map(|_| random.random::<f32>()).sum::<f32>() - 6.0;
            let deviation = (36.0 + 0.8 * model + (0.05 * model).powi(2)).sqrt();
            let missing = if n % 20 == 0 { 300.0 } else { 0.0 };
            (model, deviation * normal + missing)
        });
        let noise = noise_of(pixels, 36.0);
        // What is missing still counts as noise in part.
        assert!((noise.gain - 0.8).abs() < 0.3, "{noise:?}");
        assert!((noise.misfit - 0.05).abs() < 0.015, "{noise:?}");
    }
}
