//! Evenly distributed points on the circular pupil.

use std::f64::consts::FRAC_PI_4;

use rand::{Rng, RngExt};

/// The pupil divided into `side × side` cells of equal area, with one ray through each.
#[derive(Debug, Clone)]
pub(super) struct PupilStrata {
    radius_mm: f64,
    side: usize,
}

impl PupilStrata {
    /// At least `rays` strata (at least one), rounded up to a square number.
    pub(super) fn new(radius_mm: f64, rays: usize) -> Self {
        let side = (rays.max(1) as f64).sqrt().ceil() as usize;
        Self { radius_mm, side }
    }

    /// Number of strata.
    pub(super) fn rays(&self) -> usize {
        self.side * self.side
    }

    /// Calls `each` with one uniformly distributed point per stratum; neighbouring strata follow
    /// each other.
    pub(super) fn jittered(&self, rng: &mut impl Rng, mut each: impl FnMut([f64; 2])) {
        let step = 2.0 / self.side as f64;
        for row in 0..self.side {
            for column in 0..self.side {
                // Half of 64 random bits for each coordinate.
                let bits = rng.next_u64();
                let x = (column as f64 + unit((bits >> 32) as u32)) * step - 1.0;
                let y = (row as f64 + unit(bits as u32)) * step - 1.0;
                each(concentric_disc([x, y], self.radius_mm));
            }
        }
    }
}

/// 32 random bits as a number in [0, 1).
#[inline]
fn unit(bits: u32) -> f64 {
    f64::from(bits) * (1.0 / 4_294_967_296.0)
}

/// The concentric map of the square [−1, 1]² onto a disc, which preserves area ratios (Shirley and
/// Chiu 1997).
#[inline]
pub(super) fn concentric_disc([x, y]: [f64; 2], radius: f64) -> [f64; 2] {
    if x == 0.0 && y == 0.0 {
        return [0.0, 0.0];
    }
    if x.abs() > y.abs() {
        let (sin, cos) = sin_cos_of_octant(FRAC_PI_4 * (y / x));
        [radius * x * cos, radius * x * sin]
    } else {
        let (sin, cos) = sin_cos_of_octant(FRAC_PI_4 * (x / y));
        [radius * y * sin, radius * y * cos]
    }
}

/// Sine and cosine for |angle| ≤ π/4 by Taylor series. The error of 2e-9 is far below a pixel's
/// width; the library's functions would take a third of the tracing time.
#[inline]
fn sin_cos_of_octant(angle: f64) -> (f64, f64) {
    let square = angle * angle;
    let sin = angle
        * (1.0
            + square
                * (-1.0 / 6.0
                    + square
                        * (1.0 / 120.0 + square * (-1.0 / 5040.0 + square * (1.0 / 362_880.0)))));
    let cos = 1.0
        + square
            * (-0.5
                + square
                    * (1.0 / 24.0
                        + square
                            * (-1.0 / 720.0
                                + square * (1.0 / 40_320.0 - square * (1.0 / 3_628_800.0)))));
    (sin, cos)
}

/// Additive sequence in the unit cube whose steps are powers of 1/φ, φ the root of
/// φ^(D+1) = φ + 1 (Roberts 2018, "The unreasonable effectiveness of quasirandom sequences").
#[derive(Debug, Clone)]
pub(super) struct LowDiscrepancy<const D: usize> {
    shift: [f64; D],
    step: [f64; D],
}

impl<const D: usize> LowDiscrepancy<D> {
    /// The sequence from a random start.
    pub(super) fn shifted(rng: &mut impl Rng) -> Self {
        let root = (0..64).fold(2.0_f64, |x, _| (1.0 + x).powf(1.0 / (D as f64 + 1.0)));
        Self {
            shift: std::array::from_fn(|_| rng.random()),
            step: std::array::from_fn(|axis| root.powi(-(axis as i32 + 1))),
        }
    }

    /// Point number `index`, each coordinate in [0, 1).
    #[inline]
    pub(super) fn point(&self, index: u64) -> [f64; D] {
        std::array::from_fn(|axis| (self.shift[axis] + index as f64 * self.step[axis]).fract())
    }

    /// All points in sequence, each computed from its predecessor: faster, and equal within
    /// rounding for millions of points.
    #[inline]
    pub(super) fn points(&self) -> impl Iterator<Item = [f64; D]> + use<D> {
        let Self { shift, step } = self.clone();
        std::iter::successors(Some(shift), move |point| {
            Some(std::array::from_fn(|axis| {
                let next = point[axis] + step[axis];
                if next < 1.0 { next } else { next - 1.0 }
            }))
        })
    }
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;
    use crate::stream::{Purpose, random_stream};

    /// A uniform disc has second moment R²/4 along each axis and no cross moment.
    fn moments(points: impl Iterator<Item = [f64; 2]>) -> [f64; 3] {
        let (mut sums, mut count) = ([0.0; 3], 0.0);
        for [x, y] in points {
            sums = [sums[0] + x * x, sums[1] + y * y, sums[2] + x * y];
            count += 1.0;
        }
        sums.map(|sum| sum / count)
    }

    #[test]
    fn strata_fill_the_disc_evenly() {
        let mut rng = random_stream(Purpose::Rays, &[0]);
        let strata = PupilStrata::new(2.0, 9_999);
        let mut points = Vec::new();
        strata.jittered(&mut rng, |point| points.push(point));
        assert_eq!((points.len(), strata.rays()), (10_000, 10_000));
        let inner = points.iter().filter(|[x, y]| x.hypot(*y) < 1.0).count();
        assert!(inner.abs_diff(2500) <= 60, "{inner} of 10000 in a quarter of the area");
        let got = moments(points.into_iter());
        for (moment, expected) in got.iter().zip([1.0, 1.0, 0.0]) {
            assert!((moment - expected).abs() < 2e-3, "{got:?}");
        }
    }

    #[test]
    fn the_additive_sequence_is_even_in_every_pair_of_dimensions() {
        let sequence = LowDiscrepancy::<5>::shifted(&mut random_stream(Purpose::Box, &[3]));
        for (i, j) in [(0, 1), (0, 4), (2, 3)] {
            let mut counts = [0_u32; 16];
            for index in 0..16_000 {
                let point = sequence.point(index);
                counts[(point[i] * 4.0) as usize * 4 + (point[j] * 4.0) as usize] += 1;
            }
            // Independent draws would scatter by 30.
            assert!(counts.iter().all(|count| count.abs_diff(1000) < 20), "{counts:?}");
        }
    }

    #[test]
    fn the_iterator_gives_the_points_of_the_sequence() {
        let sequence = LowDiscrepancy::<4>::shifted(&mut random_stream(Purpose::White, &[2]));
        for (index, point) in (0..100_000).zip(sequence.points()) {
            let expected = sequence.point(index);
            // The sequence is periodic, so a difference of one is zero.
            let apart = |axis: usize| (point[axis] - expected[axis] + 0.5).rem_euclid(1.0) - 0.5;
            assert!((0..4).all(|axis| apart(axis).abs() < 1e-9), "point {index}");
            assert!(point.iter().all(|coordinate| (0.0..1.0).contains(coordinate)));
        }
    }

    proptest! {
        #[test]
        fn the_map_stays_in_the_disc_and_keeps_rings(x in -1.0..1.0_f64, y in -1.0..1.0_f64) {
            let [a, b] = concentric_disc([x, y], 3.0);
            prop_assert!((a.hypot(b) - 3.0 * x.abs().max(y.abs())).abs() < 1e-8);
        }

        #[test]
        fn the_series_are_sine_and_cosine(angle in -FRAC_PI_4..FRAC_PI_4) {
            let (sin, cos) = sin_cos_of_octant(angle);
            prop_assert!((sin - angle.sin()).abs() < 2e-9);
            prop_assert!((cos - angle.cos()).abs() < 2e-9);
        }
    }
}
