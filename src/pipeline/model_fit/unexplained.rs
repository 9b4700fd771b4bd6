//! What the reconstruction leaves unexplained of one camera's light.

use crate::{
    lightfield::{ViewLayout, ViewStack},
    reconstruction::{ProjectedView, ViewLevels},
};

/// Share of the pixels with the largest residuals that do not count: hot pixels, a speck of dust.
const TRIMMED_SHARE: f64 = 1e-3;

/// Pixels brighter than this share of a particle's light show shot noise.
const BRIGHT_PARTICLE_SHARE: f64 = 0.5;

/// Variance of I₋ − 2 I₀ + I₊ for independent pixels of variance 1.
const SECOND_DIFFERENCE_GAIN: f64 = 6.0;

/// Median of the square of a standard normal variable.
const MEDIAN_OF_SQUARE: f64 = 0.455;

/// Fewer second differences than this say nothing about shot noise.
const LEAST_DIFFERENCES: usize = 100;

/// Residual of the `projected` views over the standard deviation of the measured light, both less
/// what noise adds: read noise, and shot noise at the gain that the views themselves show. The
/// standard deviation and not the mean square, because dense seeding adds a mean that any
/// reconstruction explains.
pub fn unexplained(
    views: &ViewStack,
    layout: &ViewLayout,
    levels: &ViewLevels,
    projected: &[&ProjectedView],
) -> f64 {
    let noise_square = levels.noise_counts.powi(2);
    let gain = counts_per_electron(views, layout, levels);
    let mut pixels: Vec<(f64, f64)> = Vec::new();
    for view in projected {
        let measured = views.view(view.id.view).iter().zip(&view.image);
        pixels.extend(measured.map(|(&measured, &modelled)| {
            (f64::from(measured - modelled).powi(2), f64::from(measured))
        }));
    }
    if pixels.is_empty() {
        return 1.0;
    }
    let kept = pixels.len() - (TRIMMED_SHARE * pixels.len() as f64) as usize;
    if kept < pixels.len() {
        pixels.select_nth_unstable_by(kept, |a, b| a.0.total_cmp(&b.0));
        pixels.truncate(kept);
    }
    let n = pixels.len() as f64;
    let (residual, sum, squares) = pixels
        .iter()
        .fold((0.0, 0.0, 0.0), |(r, s, q), &(residual, i)| (r + residual, s + i, q + i * i));
    let mean = sum / n;
    let noise = noise_square + gain * mean.max(0.0);
    let light = squares / n - mean * mean - noise;
    if light <= 0.0 { 1.0 } else { ((residual / n - noise).max(0.0) / light).sqrt() }
}

/// Counts per photo-electron, from second differences between three neighbouring views: particles
/// near focus look the same in all three, so that the median is shot noise. 0 where too few pixels
/// are bright.
fn counts_per_electron(views: &ViewStack, layout: &ViewLayout, levels: &ViewLevels) -> f64 {
    let bright = (BRIGHT_PARTICLE_SHARE * levels.particle_counts) as f32;
    let mut gains: Vec<f64> = Vec::new();
    for middle in 1..layout.views.len().saturating_sub(1) {
        let [left, centre, right] = [middle - 1, middle, middle + 1].map(|n| &layout.views[n]);
        let in_a_row = left.l == right.l && right.k - left.k == 2 && centre.l == left.l;
        // A tenth of the rows of the pupil is enough.
        if !in_a_row || centre.l.rem_euclid(8) != 0 || [left, right].iter().any(|v| v.is_cut()) {
            continue;
        }
        let [left, centre, right] = [middle - 1, middle, middle + 1].map(|n| views.view(n));
        for ((&left, &centre), &right) in left.iter().zip(centre).zip(right) {
            if left.min(centre).min(right) > bright && bright > 0.0 {
                let mean = f64::from(left + centre + right) / 3.0;
                let square = f64::from(left - 2.0 * centre + right).powi(2);
                gains.push(square / SECOND_DIFFERENCE_GAIN / mean);
            }
        }
    }
    if gains.len() < LEAST_DIFFERENCES {
        return 0.0;
    }
    let middle = gains.len() / 2;
    let (_, median, _) = gains.select_nth_unstable_by(middle, f64::total_cmp);
    let read = levels.noise_counts.powi(2) / levels.particle_counts.max(1e-9);
    (*median / MEDIAN_OF_SQUARE - read).max(0.0)
}
