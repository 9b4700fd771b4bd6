//! Whether both cameras see the same particles, from their light along the common direction.
//!
//! Two cameras share the direction e = axis₁ × axis₂. A ray perpendicular to e, which meets pupil
//! and plane in focus at the same coordinate along e, sees a particle at its own coordinate along
//! e, whatever its depth. Particles are random, so the profile of light along e identifies the
//! shot: two profiles agree only if both cameras saw the same particles from the configured poses.
//! Rays that the pupil does not contain are not compared.

use lfpiv_hw::{Optics, Pose};
use nalgebra::Vector3;

use crate::{
    lightfield::{ViewLayout, ViewStack},
    reconstruction::ViewLevels,
};

/// Minimum sine of the angle between the cameras' axes. Below it, depth blurs the common direction.
const MIN_SINE: f64 = 0.3;

/// Tolerance for perpendicular rays: difference of the coordinates along e in pupil and plane in
/// focus, in pupil cells.
const ACROSS_CELLS: f64 = 0.75;

/// Pixels are clipped at this many times a particle's light: hot pixels are brighter.
const BRIGHTEST_PARTICLES: f64 = 4.0;

/// Width of the subtracted moving average, in bins: seeding and laser profile vary more slowly.
const SMOOTHED_BINS: usize = 9;

/// Minimum number of common bins.
const MIN_BINS: usize = 24;

/// Minimum number of pixels in a bin.
const MIN_WEIGHT: f64 = 0.5;

/// Largest shift between the cameras in the search, in bins.
const MAX_SHIFT_BINS: usize = 12;

/// Contribution of a column or row of microlenses to a ray's coordinate along e.
#[derive(Debug, Clone, Copy)]
struct Ray {
    /// In the plane in focus, in mm.
    along_mm: f64,
    /// Difference in the pupil, in mm.
    pupil_excess_mm: f64,
}

impl Ray {
    /// For microlenses imaged in the plane in focus at `place_mm` from the axis, seen through
    /// `pupil_mm`; `share` is the component of e along these.
    fn new(place_mm: f64, pupil_mm: f64, share: f64) -> Self {
        Self { along_mm: place_mm * share, pupil_excess_mm: (pupil_mm - place_mm) * share }
    }
}

/// Light along a direction, one bin per microlens pitch in the volume.
#[derive(Debug, Clone, PartialEq)]
pub struct CommonProfile {
    bins: Vec<Option<f64>>,
}

/// Comparison of two cameras' profiles.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Agreement {
    /// Correlation for the configured poses.
    pub direct: f64,
    /// Correlation with the second camera mirrored along the common direction.
    pub mirrored: f64,
    /// Highest correlation in the search, and the corresponding shift of the second camera, in mm.
    pub best: f64,
    pub best_shift_mm: f64,
    /// Number of common bins.
    pub bins: usize,
}

/// The common direction of two cameras, if there is one.
pub fn shared_direction(poses: &[Pose]) -> Option<Vector3<f64>> {
    let [first, second] = poses else { return None };
    let cross = first.axis.cross(&second.axis);
    (cross.norm() >= MIN_SINE).then(|| cross.normalize())
}

/// A camera's light along `direction`, in bins of `bin_mm` from -`half_mm` to `half_mm` about the world
/// point `middle`.
pub fn profile(
    optics: &Optics,
    pose: &Pose,
    layout: &ViewLayout,
    views: &ViewStack,
    levels: &ViewLevels,
    (direction, middle, half_mm, bin_mm): (&Vector3<f64>, &Vector3<f64>, f64, f64),
) -> CommonProfile {
    let (along_right, along_up) = (direction.dot(&pose.right), direction.dot(&pose.up));
    let count = (2.0 * half_mm / bin_mm).ceil() as usize;
    let (mut sums, mut weights) = (vec![0.0; count], vec![0.0; count]);
    let brightest = (BRIGHTEST_PARTICLES * levels.particle_counts) as f32;
    let from_middle_mm = (pose.origin_mm - middle).dot(direction);
    let scale = -optics.object_distance_mm / optics.image_distance_mm();
    let most_mm = ACROSS_CELLS * optics.pupil_cell_mm();
    for (n, view) in layout.views.iter().enumerate() {
        if view.is_cut() {
            continue;
        }
        let column = |i| {
            let along_mm = optics.microlens.column_centre_mm(i) * scale;
            Some(Ray::new(along_mm, layout.columns.sample(view.k, i)?.pupil_mm, along_right))
        };
        let row = |j| {
            let along_mm = optics.microlens.row_centre_mm(j) * scale;
            Some(Ray::new(along_mm, layout.rows.sample(view.l, j)?.pupil_mm, along_up))
        };
        let columns: Vec<Option<Ray>> = layout.window.columns.clone().map(column).collect();
        let mut values = views.view(n).iter();
        for row in layout.window.rows.clone().map(row) {
            for (column, &value) in columns.iter().zip(&mut values) {
                let (Some(column), Some(row)) = (column, row) else { continue };
                if (column.pupil_excess_mm + row.pupil_excess_mm).abs() > most_mm {
                    continue;
                }
                let place = from_middle_mm + column.along_mm + row.along_mm;
                // Divided between the two nearest bins: microlenses may be on the edges of bins.
                let at = (place + half_mm) / bin_mm - 0.5;
                for (bin, share) in [(at.floor(), 1.0 - at.fract()), (at.floor() + 1.0, at.fract())]
                {
                    if at >= 0.0 && bin < count as f64 {
                        sums[bin as usize] += share * f64::from(value.min(brightest));
                        weights[bin as usize] += share;
                    }
                }
            }
        }
    }
    let bins =
        sums.iter().zip(&weights).map(|(sum, &weight)| (weight > MIN_WEIGHT).then(|| sum / weight));
    CommonProfile { bins: bins.collect() }
}

impl CommonProfile {
    /// The profile minus its moving average; `None` where bins of the average are missing.
    fn detail(&self) -> Vec<Option<f64>> {
        let half = SMOOTHED_BINS / 2;
        (0..self.bins.len())
            .map(|n| {
                let around = self.bins.get(n.checked_sub(half)?..=n + half)?;
                let sum: f64 = around.iter().copied().sum::<Option<f64>>()?;
                Some(self.bins[n]? - sum / SMOOTHED_BINS as f64)
            })
            .collect()
    }

    /// Compares with the second camera's profile. `None` with too few common bins.
    pub fn compare(&self, second: &Self, bin_mm: f64) -> Option<Agreement> {
        let (first, second) = (self.detail(), second.detail());
        let mirrored: Vec<Option<f64>> = second.iter().rev().copied().collect();
        let direct = correlation(&first, &second, 0)?;
        let reach = MAX_SHIFT_BINS as i64;
        let shifted = (-reach..=reach)
            .filter_map(|shift| Some((correlation(&first, &second, shift)?, shift)))
            .max_by(|a, b| a.0.total_cmp(&b.0))?;
        Some(Agreement {
            direct,
            mirrored: correlation(&first, &mirrored, 0)?,
            best: shifted.0,
            best_shift_mm: shifted.1 as f64 * bin_mm,
            bins: first.iter().zip(&second).filter(|(a, b)| a.is_some() && b.is_some()).count(),
        })
    }
}

/// Correlation coefficient of first[n] and second[n + shift] over the common bins.
fn correlation(first: &[Option<f64>], second: &[Option<f64>], shift: i64) -> Option<f64> {
    let pairs: Vec<(f64, f64)> = first
        .iter()
        .enumerate()
        .filter_map(|(n, &a)| {
            let other = usize::try_from(n as i64 + shift).ok()?;
            Some((a?, (*second.get(other)?)?))
        })
        .collect();
    if pairs.len() < MIN_BINS {
        return None;
    }
    let n = pairs.len() as f64;
    let (a, b) = pairs.iter().fold((0.0, 0.0), |(a, b), pair| (a + pair.0, b + pair.1));
    let (a, b) = (a / n, b / n);
    let (aa, bb, ab) = pairs.iter().fold((0.0, 0.0, 0.0), |(aa, bb, ab), pair| {
        let (da, db) = (pair.0 - a, pair.1 - b);
        (aa + da * da, bb + db * db, ab + da * db)
    });
    (aa > 0.0 && bb > 0.0).then(|| ab / (aa * bb).sqrt())
}

#[cfg(test)]
mod tests {
    use super::*;
    use rand::{RngExt, SeedableRng};
    use rand_pcg::Pcg64Mcg;

    fn random(seed: u64) -> CommonProfile {
        let mut random = Pcg64Mcg::seed_from_u64(seed);
        let ramp = |n: usize| 100.0 + n as f64;
        CommonProfile {
            bins: (0..100).map(|n| Some(ramp(n) + 30.0 * random.random::<f64>())).collect(),
        }
    }

    #[test]
    fn a_profile_agrees_with_itself_mirrored_or_shifted_and_with_no_other() {
        let profile = random(1);
        let same = profile.compare(&profile, 0.1).unwrap();
        assert!(same.direct > 0.999 && same.mirrored < 0.4, "{same:?}");
        let mirrored = CommonProfile { bins: profile.bins.iter().rev().copied().collect() };
        let compared = profile.compare(&mirrored, 0.1).unwrap();
        assert!(compared.mirrored > 0.999 && compared.direct < 0.4, "{compared:?}");
        let mut shifted = profile.clone();
        shifted.bins.rotate_right(5);
        let compared = profile.compare(&shifted, 0.1).unwrap();
        assert!(
            compared.best > 0.95 && (compared.best_shift_mm - 0.5).abs() < 1e-9,
            "{compared:?}"
        );
        let other = profile.compare(&random(2), 0.1).unwrap();
        assert!(other.direct < 0.4 && other.mirrored < 0.4 && other.best < 0.5, "{other:?}");
    }

    #[test]
    fn a_profile_without_light_is_not_compared() {
        let dark = CommonProfile { bins: vec![Some(0.0); 100] };
        assert_eq!(dark.compare(&random(1), 0.1), None);
        let short = CommonProfile { bins: vec![Some(1.0); 10] };
        assert_eq!(short.compare(&short, 0.1), None);
    }
}
