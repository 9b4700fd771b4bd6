//! The share of one camera's light that the reconstruction does not explain.

use crate::{
    lightfield::{ViewLayout, ViewStack},
    reconstruction::{ProjectedView, ViewLevels},
    statistics::{MEDIAN_SQUARE, median},
};

/// Edge of the tiles that are assessed separately, in microlenses: contains some particles at the
/// sparsest seeding, and is small compared with a window.
const TILE: usize = 8;

/// Share of a tile's pixels with the largest residuals that is ignored: hot pixels.
const TRIMMED_SHARE: f64 = 2e-3;

/// Tiles with less than this share of the mean tile's light are dark.
const LIT_SHARE_OF_MEAN: f64 = 0.1;

/// Quantile over the lit tiles that gives the result. A wrong bench leaves light unexplained nearly
/// everywhere; a reflection, a shadow, or an object that only one camera sees affects only part of
/// the field.
const TILE_RANK: f64 = 0.25;

/// Largest ratio of a tile's brightness to the reconstruction: cameras and fields may differ in
/// brightness.
const MAX_SCALE: f64 = 5.0;

/// Pixels above this share of a particle's light are used to estimate shot noise.
const BRIGHT_PARTICLE_SHARE: f64 = 0.5;

/// Variance of I₋ − 2 I₀ + I₊ for independent pixels of variance 1.
const SECOND_DIFFERENCE_GAIN: f64 = 6.0;

/// Minimum number of second differences for an estimate of shot noise.
const MIN_DIFFERENCES: usize = 100;

/// Residual of the `projected` views relative to the standard deviation of the measured light, both
/// minus noise: read noise, and shot noise at the gain estimated from the views. The standard
/// deviation rather than the mean square, because dense seeding adds a mean that any reconstruction
/// explains. Tiles of the field are assessed separately, each at its own brightness; the result is
/// the lower quartile of the lit tiles, 0 to 1, and 1 if no tile is lit.
pub fn unexplained(
    views: &ViewStack,
    layout: &ViewLayout,
    levels: &ViewLevels,
    projected: &[&ProjectedView],
) -> f64 {
    let columns = layout.window.columns.len();
    let tiles_across = columns.div_ceil(TILE);
    let tiles = tiles_across * layout.window.rows.len().div_ceil(TILE);
    let mut pixels: Vec<Vec<Pixel>> = vec![Vec::new(); tiles];
    for view in projected {
        let measured = views.view(view.id.view).iter().zip(&view.image);
        for (n, (&measured, &modelled)) in measured.enumerate() {
            pixels[n / columns / TILE * tiles_across + n % columns / TILE]
                .push([f64::from(measured), f64::from(modelled)]);
        }
    }
    let gain = counts_per_electron(views, layout, levels);
    let noise = |mean: f64| levels.noise_counts.powi(2) + gain * mean.max(0.0);
    let tiles: Vec<Tile> = pixels.iter_mut().map(|pixels| Tile::of(pixels, &noise)).collect();
    let mean_light = tiles.iter().map(|tile| tile.light).sum::<f64>() / tiles.len().max(1) as f64;
    let shares: Vec<f64> = tiles
        .iter()
        .filter(|tile| tile.light > LIT_SHARE_OF_MEAN * mean_light && tile.light > 0.0)
        .map(|tile| (tile.residual / tile.light).sqrt().min(1.0))
        .collect();
    share_at_rank(shares)
}

/// The share at [`TILE_RANK`] of the tiles' shares in ascending order; 1 without tiles.
fn share_at_rank(mut shares: Vec<f64>) -> f64 {
    if shares.is_empty() {
        return 1.0;
    }
    let rank = (TILE_RANK * (shares.len() - 1) as f64).round() as usize;
    *shares.select_nth_unstable_by(rank, f64::total_cmp).1
}

/// Measured and modelled light, in counts.
type Pixel = [f64; 2];

/// Variance of the light of a tile, and its unexplained part, both without noise, in counts².
struct Tile {
    light: f64,
    residual: f64,
}

impl Tile {
    /// For the `pixels` of a tile in all views; `noise` is the noise variance at a mean light.
    fn of(pixels: &mut [Pixel], noise: &impl Fn(f64) -> f64) -> Self {
        let (both, modelled) =
            pixels.iter().fold((0.0, 0.0), |(both, square), [m, p]| (both + m * p, square + p * p));
        let scale = match modelled > 0.0 {
            true => (both / modelled).clamp(1.0 / MAX_SCALE, MAX_SCALE),
            false => 1.0,
        };
        let square = |[measured, modelled]: &Pixel| (measured - scale * modelled).powi(2);
        let kept = pixels.len() - (TRIMMED_SHARE * pixels.len() as f64) as usize;
        if kept < pixels.len() {
            pixels.select_nth_unstable_by(kept, |a, b| square(a).total_cmp(&square(b)));
        }
        let pixels = &pixels[..kept];
        let n = kept.max(1) as f64;
        let mean = pixels.iter().map(|[measured, _]| measured).sum::<f64>() / n;
        let variance = pixels.iter().map(|[m, _]| (m - mean).powi(2)).sum::<f64>() / n;
        let residual = pixels.iter().map(square).sum::<f64>() / n;
        let noise = noise(mean);
        Self { light: (variance - noise).max(0.0), residual: (residual - noise).max(0.0) }
    }
}

/// Counts per photo-electron, from second differences between three neighbouring views: particles
/// near focus look the same in all three, so the median is shot noise. 0 if too few pixels are
/// bright.
fn counts_per_electron(views: &ViewStack, layout: &ViewLayout, levels: &ViewLevels) -> f64 {
    let bright = (BRIGHT_PARTICLE_SHARE * levels.particle_counts) as f32;
    let mut gains: Vec<f64> = Vec::new();
    for middle in 1..layout.views.len().saturating_sub(1) {
        let [left, centre, right] = [middle - 1, middle, middle + 1].map(|n| &layout.views[n]);
        let in_a_row = left.l == right.l && right.k - left.k == 2 && centre.l == left.l;
        // A tenth of the pupil's rows is enough.
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
    if gains.len() < MIN_DIFFERENCES {
        return 0.0;
    }
    let median = median(gains).unwrap_or_default();
    let read = levels.noise_counts.powi(2) / levels.particle_counts.max(1e-9);
    (median / MEDIAN_SQUARE - read).max(0.0)
}

#[cfg(test)]
mod tests {
    use super::*;
    use rand::{RngExt, SeedableRng};
    use rand_pcg::Pcg64Mcg;

    const READ_NOISE: f64 = 3.0;

    fn no_shot_noise(_mean: f64) -> f64 {
        READ_NOISE.powi(2)
    }

    /// Pixels of which the model explains all but `unexplained` of the standard deviation.
    fn pixels(unexplained: f64, scale: f64) -> Vec<Pixel> {
        let mut random = Pcg64Mcg::seed_from_u64(5);
        // Uniform random numbers of variance 1.
        let mut normal = || (random.random::<f64>() - 0.5) * 12f64.sqrt();
        (0..20_000)
            .map(|_| {
                let (explained, other) = (100.0 * normal(), 100.0 * normal());
                let modelled = explained * (1.0 - unexplained.powi(2)).sqrt();
                [modelled + other * unexplained + READ_NOISE * normal(), modelled / scale]
            })
            .collect()
    }

    #[test]
    fn the_share_of_an_image_is_the_lower_quartile_of_its_tiles() {
        assert_eq!(share_at_rank(vec![]), 1.0);
        assert_eq!(share_at_rank(vec![0.6, 0.2]), 0.2);
        assert_eq!(share_at_rank(vec![0.5, 0.4, 0.1, 0.3, 0.2]), 0.2);
    }

    #[test]
    fn a_tile_knows_its_unexplained_share_at_any_brightness() {
        for (share, scale) in [(0.0, 1.0), (0.2, 1.0), (0.5, 1.0), (0.2, 3.0), (0.5, 0.3)] {
            let tile = Tile::of(&mut pixels(share, scale), &no_shot_noise);
            let found = (tile.residual / tile.light).sqrt();
            assert!((found - share).abs() < 0.02, "{found}, made with {share} at {scale}");
        }
    }

    #[test]
    fn hot_pixels_of_a_tile_do_not_count() {
        let mut hot = pixels(0.2, 1.0);
        for pixel in hot.iter_mut().step_by(1000) {
            pixel[0] = 4000.0;
        }
        let tile = Tile::of(&mut hot, &no_shot_noise);
        assert!(((tile.residual / tile.light).sqrt() - 0.2).abs() < 0.02);
    }
}
