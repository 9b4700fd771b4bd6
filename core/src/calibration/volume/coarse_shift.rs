//! Location of the card in a camera's images within one microlens, which the numbering of the marks requires.

use lfpiv_hw::card::Card;
use nalgebra::Point3;
use rayon::prelude::*;

use super::{
    camera_model::CameraModel,
    card_light::CardLight,
    fiducial::{CardPlace, resolved_by_fiducial},
};

/// Search range around the predicted location of the card, in mark spacings.
const REACH_SPACINGS: f64 = 1.6;

/// Largest deviation of the shift at one position from the common shift, in microlenses. A rotated camera displaces
/// the card differently at different depths.
const MOST_DEVIATION: i64 = 3;

/// Shifts of the card at all positions.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct CoarseShifts {
    /// Shift of each image from its prediction, in mm on the microlens plane.
    pub(super) shifts_mm: Vec<[f64; 2]>,
    /// Correlation coefficient of each image with the shifted card.
    pub(super) correlations: Vec<f64>,
    /// Significance of the alignment by the fiducial, in standard errors.
    pub(super) significance: f64,
}

/// Finds the shift with the highest correlation, in whole microlenses, for all positions together, so that one
/// visible fiducial suffices. `None` without images.
pub(super) fn coarse_shifts(
    positions: &[(&CardLight<'_>, Point3<f64>)],
    model: &CameraModel,
    card: &Card,
) -> Option<CoarseShifts> {
    let (light, _) = positions.first()?;
    let pitch_mm = light.optics().object_pitch_mm();
    let reach = (REACH_SPACINGS * card.spacing_mm / pitch_mm).ceil() as i64;
    let side = 2 * reach + 1;
    let all: Vec<Vec<f64>> = positions
        .par_iter()
        .map(|(light, origin_mm)| correlations(light, model, card, origin_mm, reach))
        .collect();
    let shift = |n: usize| [n as i64 % side - reach, n as i64 / side - reach];
    let mean = |n: usize| all.iter().map(|of| of[n]).sum::<f64>() / all.len() as f64;
    let means: Vec<f64> = (0..(side * side) as usize).map(mean).collect();
    let best = (0..means.len()).max_by(|&a, &b| means[a].total_cmp(&means[b]))?;
    let (common, significance) = resolved_by_fiducial(positions, model, card, shift(best));
    let near: Vec<usize> = (0..means.len())
        .filter(|&n| (0..2).all(|axis| (shift(n)[axis] - common[axis]).abs() <= MOST_DEVIATION))
        .collect();
    let mut found = CoarseShifts { shifts_mm: Vec::new(), correlations: Vec::new(), significance };
    for (of, (light, _)) in all.iter().zip(positions) {
        let best = near.iter().copied().max_by(|&a, &b| of[a].total_cmp(&of[b]))?;
        let (from, to) = (light.place_mm([0.0; 2]), light.place_mm(shift(best).map(|n| n as f64)));
        found.shifts_mm.push([to[0] - from[0], to[1] - from[1]]);
        found.correlations.push(of[best]);
    }
    Some(found)
}

/// Correlation coefficients of one image with the predicted card at all shifts up to `reach` microlenses.
fn correlations(
    light: &CardLight<'_>,
    model: &CameraModel,
    card: &Card,
    origin_mm: &Point3<f64>,
    reach: i64,
) -> Vec<f64> {
    let view = light.middle_view();
    let [columns, rows] = light.microlenses().map(|count| count as i64);
    let place = CardPlace { light, model, card, origin_mm };
    // Predicted light of each microlens, with a margin of `reach` around the array.
    let width = columns + 2 * reach;
    let expected: Vec<f32> = (0..width * (rows + 2 * reach))
        .map(|n| {
            let met_mm = place.met_mm([(n % width - reach) as f64, (n / width - reach) as f64]);
            f32::from(u8::from(met_mm.is_some_and(|along_mm| card.is_bright(along_mm))))
        })
        .collect();
    let side = 2 * reach + 1;
    (0..side * side)
        .into_par_iter()
        .map(|shift| {
            let (along_i, along_j) = (shift % side - reach, shift / side - reach);
            let pairs = (0..columns * rows).filter_map(|n| {
                let (i, j) = (n % columns, n / columns);
                let measured = view[n as usize];
                let from = (j - along_j + reach) * width + i - along_i + reach;
                measured
                    .is_finite()
                    .then(|| [f64::from(measured), f64::from(expected[from as usize])])
            });
            correlation_coefficient(pairs)
        })
        .collect()
}

/// Pearson's correlation coefficient; 0 if one of the variables is constant.
fn correlation_coefficient(pairs: impl Iterator<Item = [f64; 2]>) -> f64 {
    let (mut n, mut sums, mut products) = (0.0, [0.0; 2], [0.0; 3]);
    for [a, b] in pairs {
        n += 1.0;
        sums = [sums[0] + a, sums[1] + b];
        products = [products[0] + a * a, products[1] + b * b, products[2] + a * b];
    }
    let variance = |index: usize| products[index] * n - sums[index] * sums[index];
    let spread = (variance(0) * variance(1)).sqrt();
    if spread > 0.0 { (products[2] * n - sums[0] * sums[1]) / spread } else { 0.0 }
}
