//! Where the card is in an image, within a microlens: the number of every mark depends on it.

use lfpiv_hw::card::Card;
use nalgebra::Point3;

use super::{camera_model::CameraModel, card_light::CardLight};

/// How far the card is looked for from where the drawing puts it, in mark spacings.
const REACH_SPACINGS: f64 = 1.6;

/// A card found.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct CoarseShift {
    /// How far the image lies from where the model puts it, in mm on the microlens plane.
    pub(super) shift_mm: [f64; 2],
    /// Correlation coefficient of the image with the card there.
    pub(super) correlation: f64,
    /// The best one at least half a spacing away: high where the fiducial is not seen.
    pub(super) next_correlation: f64,
}

/// Shifts the card over the image of the pupil's middle by whole microlenses. `None` where the image or
/// the card has no contrast.
pub(super) fn coarse_shift(
    light: &CardLight<'_>,
    model: &CameraModel,
    card: &Card,
    origin_mm: &Point3<f64>,
) -> Option<CoarseShift> {
    let view = light.middle_view();
    let [columns, rows] = light.microlenses().map(|count| count as i64);
    let face_mm = card.place_mm(origin_mm, [0.0; 2], &model.axis());
    let pitch_mm = light.optics().object_pitch_mm();
    let reach = (REACH_SPACINGS * card.spacing_mm / pitch_mm).ceil() as i64;
    let half_spacing = card.spacing_mm / pitch_mm / 2.0;
    // The card as it should be seen by each microlens, some beyond the array.
    let width = columns + 2 * reach;
    let expected: Vec<f32> = (0..width * (rows + 2 * reach))
        .map(|n| {
            let lens = [(n % width - reach) as f64, (n / width - reach) as f64];
            let met = model.meets(light.place_mm(lens), [0.0; 2], &face_mm, &card.normal());
            met.map_or(0.0, |met_mm| {
                let along_mm = met_mm - face_mm;
                let bright = card.is_bright([along_mm.dot(&card.right), along_mm.dot(&card.up)]);
                f32::from(u8::from(bright))
            })
        })
        .collect();
    let correlation = |along_i: i64, along_j: i64| {
        let pairs = (0..columns * rows).filter_map(|n| {
            let (i, j) = (n % columns, n / columns);
            let seen = view[n as usize];
            let from = (j - along_j + reach) * width + i - along_i + reach;
            seen.is_finite().then(|| [f64::from(seen), f64::from(expected[from as usize])])
        });
        correlation_coefficient(pairs)
    };
    let mut all = Vec::new();
    for along_j in -reach..=reach {
        for along_i in -reach..=reach {
            all.push(([along_i, along_j], correlation(along_i, along_j)));
        }
    }
    let (best, highest) = *all.iter().max_by(|a, b| a.1.total_cmp(&b.1))?;
    let apart = |[i, j]: [i64; 2]| ((i - best[0]) as f64).hypot((j - best[1]) as f64);
    let next =
        all.iter().filter(|(shift, _)| apart(*shift) > half_spacing).map(|(_, value)| *value);
    let (from, to) = (light.place_mm([0.0; 2]), light.place_mm(best.map(|n| n as f64)));
    (highest > 0.0).then(|| CoarseShift {
        shift_mm: [to[0] - from[0], to[1] - from[1]],
        correlation: highest,
        next_correlation: next.fold(0.0, f64::max),
    })
}

/// Pearson's coefficient; zero where one of both does not vary.
fn correlation_coefficient(pairs: impl Iterator<Item = [f64; 2]>) -> f64 {
    let (mut n, mut sums, mut products) = (0.0, [0.0; 2], [0.0; 3]);
    for [a, b] in pairs {
        n += 1.0;
        sums = [sums[0] + a, sums[1] + b];
        products = [products[0] + a * a, products[1] + b * b, products[2] + a * b];
    }
    let variance = |n_th: usize| products[n_th] * n - sums[n_th] * sums[n_th];
    let spread = (variance(0) * variance(1)).sqrt();
    if spread > 0.0 { (products[2] * n - sums[0] * sums[1]) / spread } else { 0.0 }
}
