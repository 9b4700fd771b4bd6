//! Points on the circular pupil, spread evenly.

use std::f64::consts::{FRAC_PI_2, FRAC_PI_4};

use rand::{Rng, RngExt};

/// The pupil cut into `side × side` cells of equal area, one ray through each.
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

    /// A point uniform in stratum `index`; `bits` are 64 random bits, half for each coordinate.
    #[inline]
    pub(super) fn jittered(&self, index: usize, bits: u64) -> [f64; 2] {
        const TO_UNIT: f64 = 1.0 / 4_294_967_296.0;
        let cell = [index % self.side, index / self.side];
        let jitter = [(bits >> 32) as u32, bits as u32].map(|half| f64::from(half) * TO_UNIT);
        let square = std::array::from_fn(|axis| {
            2.0 * (cell[axis] as f64 + jitter[axis]) / self.side as f64 - 1.0
        });
        concentric_disc(square, self.radius_mm)
    }
}

/// The concentric map of the square [−1, 1]² onto a disc: keeps ratios of areas (Shirley and Chiu
/// 1997).
#[inline]
pub(super) fn concentric_disc([x, y]: [f64; 2], radius: f64) -> [f64; 2] {
    if x == 0.0 && y == 0.0 {
        return [0.0, 0.0];
    }
    let (r, angle) = if x.abs() > y.abs() {
        (radius * x, FRAC_PI_4 * (y / x))
    } else {
        (radius * y, FRAC_PI_2 - FRAC_PI_4 * (x / y))
    };
    let (sin, cos) = angle.sin_cos();
    [r * cos, r * sin]
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
        let strata = PupilStrata::new(2.0, 10_000);
        assert_eq!(strata.rays(), 10_000);
        let got = moments((0..10_000).map(|i| strata.jittered(i, rng.next_u64())));
        for (moment, expected) in got.iter().zip([1.0, 1.0, 0.0]) {
            assert!((moment - expected).abs() < 2e-3, "{got:?}");
        }
        let inner = (0..10_000)
            .filter(|&i| {
                let [x, y] = strata.jittered(i, 1 << 63 | 1 << 31);
                x.hypot(y) < 1.0
            })
            .count();
        assert!(inner.abs_diff(2500) <= 100, "{inner} of 10000 in a quarter of the area");
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

    proptest! {
        #[test]
        fn the_map_stays_in_the_disc_and_keeps_rings(x in -1.0..1.0_f64, y in -1.0..1.0_f64) {
            let [a, b] = concentric_disc([x, y], 3.0);
            prop_assert!((a.hypot(b) - 3.0 * x.abs().max(y.abs())).abs() < 1e-9);
        }
    }
}
