//! Linear fit of one clock against another: offset and rate, from recent shots.
//!
//! Quartz clocks differ in rate by at most parts in 10⁴ and drift by parts in 10⁶, so over recent
//! shots their difference is a straight line. It is fitted with the Theil–Sen estimator: the rate is
//! the median of the rates between all pairs of points, the offset the median of the residuals. Up to
//! 29 % of the points may be outliers (P. K. Sen, J. Am. Stat. Assoc. 63, 1968). Pairs are weighted by
//! the time between them (L. A. Jaeckel, Ann. Math. Stat. 43, 1972): points are dense within bursts
//! and sparse between them, and a rate over a pause is more precise than one between neighbours.

use std::collections::VecDeque;

use lfpiv_core::statistics::{median, weighted_median};

/// Number of points in the fit.
const WINDOW: usize = 32;
/// Points needed to trust the fitted rate and spread.
const MIN_POINTS: usize = 8;
/// Bound of the relative rate difference of two clocks before any measurement.
const UNKNOWN_RATE: f64 = 2e-4;
/// Bound of the drift of a measured rate, by temperature and ageing.
const RATE_WANDER: f64 = 2e-6;
/// Outlier threshold in standard deviations.
const OUTLIER_SPREADS: f64 = 8.0;
/// This many outliers in a row are a jump of the clock, not bad timestamps.
const JUMP_AFTER: usize = 3;
/// Factor from median absolute deviation to standard deviation for a normal distribution.
const MAD_TO_SIGMA: f64 = 1.4826;

/// Residual of a timestamp.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Residual {
    /// Timestamp minus the fitted line, in ns; 0 while there is no line yet.
    pub ns: i128,
    /// Outlier limit, in ns.
    pub limit_ns: f64,
}

impl Residual {
    pub fn is_outlier(&self) -> bool {
        self.ns.unsigned_abs() as f64 > self.limit_ns
    }
}

/// Bounds of the outlier limit.
#[derive(Debug, Clone, Copy)]
pub(super) struct OutlierBounds {
    /// Residuals up to this are never outliers, in ns.
    pub min_ns: f64,
    /// Residuals beyond this are always outliers, in ns.
    pub max_ns: f64,
}

#[derive(Debug, Clone, Copy)]
struct Point {
    at_ns: i128,
    /// Difference of the two clocks.
    difference_ns: i128,
}

/// The fit; see the module. Keeps [`WINDOW`] points.
#[derive(Debug, Clone, Default)]
pub(super) struct ClockFit {
    points: VecDeque<Point>,
    /// Relative rate difference, once measured.
    rate: Option<f64>,
    rate_uncertainty: f64,
    /// Standard deviation of the residuals, in ns.
    spread_ns: f64,
    /// Residual of the last point, in ns.
    last_residual_ns: f64,
    consecutive_outliers: usize,
}

impl ClockFit {
    /// Whether there is a line to compare a timestamp with.
    pub fn has_line(&self) -> bool {
        !self.points.is_empty()
    }

    /// Restarts the fit when the reference clock restarts at an arbitrary time with the same rate.
    pub fn restart_reference(&mut self) {
        self.points.clear();
        self.consecutive_outliers = 0;
    }

    /// Bound of the line's error after `elapsed_ns` without a point.
    pub fn uncertainty_ns(&self, elapsed_ns: f64) -> f64 {
        elapsed_ns.abs() * if self.rate.is_some() { self.rate_uncertainty } else { UNKNOWN_RATE }
    }

    /// Residual of the timestamp `clock_ns`, taken at `at_ns` on the reference clock.
    pub fn residual(&self, at_ns: i128, clock_ns: i128, bounds: OutlierBounds) -> Residual {
        let Some(last) = self.points.back() else {
            return Residual { ns: 0, limit_ns: bounds.max_ns };
        };
        let elapsed_ns = (at_ns - last.at_ns) as f64;
        let expected_ns = self.rate.unwrap_or(0.0) * elapsed_ns - self.last_residual_ns;
        let ns = clock_ns - at_ns - last.difference_ns - expected_ns.round() as i128;
        let usual_ns = bounds.min_ns.max(OUTLIER_SPREADS * self.spread_ns);
        let limit_ns = match self.rate {
            Some(_) => (usual_ns + self.uncertainty_ns(elapsed_ns)).min(bounds.max_ns),
            None => bounds.max_ns,
        };
        Residual { ns, limit_ns }
    }

    /// Adds a timestamp and returns its residual against the line before. An outlier does not
    /// change the line, until [`JUMP_AFTER`] of them in a row restart the fit.
    pub fn add(&mut self, at_ns: i128, clock_ns: i128, bounds: OutlierBounds) -> Residual {
        let residual = self.residual(at_ns, clock_ns, bounds);
        if residual.is_outlier() {
            self.consecutive_outliers += 1;
            if self.consecutive_outliers < JUMP_AFTER {
                return residual;
            }
            *self = Self::default();
        }
        self.consecutive_outliers = 0;
        self.points.push_back(Point { at_ns, difference_ns: clock_ns - at_ns });
        if self.points.len() > WINDOW {
            self.points.pop_front();
        }
        self.fit();
        residual
    }

    /// Fits the line through the points.
    fn fit(&mut self) {
        let Some(last) = self.points.back().copied() else { return };
        // Relative to the last point, to preserve precision.
        let points: Vec<(f64, f64)> = self
            .points
            .iter()
            .map(|p| ((p.at_ns - last.at_ns) as f64, (p.difference_ns - last.difference_ns) as f64))
            .collect();
        let enough = points.len() >= MIN_POINTS;
        if enough {
            self.rate = weighted_median(rates(&points));
        }
        let rate = self.rate.unwrap_or(0.0);
        let mut left: Vec<f64> = points.iter().map(|(at, ahead)| ahead - rate * at).collect();
        let offset_ns = median(left.iter().copied()).unwrap_or(0.0);
        self.last_residual_ns = -offset_ns;
        if enough {
            left.iter_mut().for_each(|off| *off = (*off - offset_ns).abs());
            self.spread_ns = MAD_TO_SIGMA * median(left.iter().copied()).unwrap_or(0.0);
            let first_at_ns = points.iter().map(|(at, _)| *at).fold(0.0, f64::min);
            self.rate_uncertainty = RATE_WANDER + 4.0 * self.spread_ns / first_at_ns.abs().max(1.0);
        }
    }
}

/// The rate between each pair of points, with the time between them as weight.
fn rates(points: &[(f64, f64)]) -> Vec<(f64, f64)> {
    let pairs =
        points.iter().enumerate().flat_map(|(n, a)| points[..n].iter().map(move |b| (a, b)));
    let apart = pairs.filter(|(a, b)| a.0 != b.0);
    apart.map(|(a, b)| ((a.1 - b.1) / (a.0 - b.0), (a.0 - b.0).abs())).collect()
}

#[cfg(test)]
mod tests {
    use rand::{RngExt, SeedableRng};
    use rand_pcg::Pcg64Mcg;

    use super::*;

    const EXACTNESS: OutlierBounds = OutlierBounds { min_ns: 20_000.0, max_ns: 12_500_000.0 };
    const PERIOD_NS: i128 = 100_000_000;

    /// A clock that is fast by `rate`, with uniform jitter of ±`jitter_ns`.
    struct Model {
        rate: f64,
        jitter_ns: i128,
        offset_ns: i128,
        random: Pcg64Mcg,
    }

    impl Model {
        fn new(rate: f64, jitter_ns: i128) -> Self {
            let random = Pcg64Mcg::seed_from_u64(5);
            Self { rate, jitter_ns, offset_ns: 9_000_000_000_000_000, random }
        }

        fn shows(&mut self, at_ns: i128) -> i128 {
            let jitter_ns = self.random.random_range(-self.jitter_ns..=self.jitter_ns);
            at_ns + (at_ns as f64 * self.rate) as i128 + self.offset_ns + jitter_ns
        }
    }

    fn add(fit: &mut ClockFit, model: &mut Model, shots: std::ops::Range<i128>) -> Vec<Residual> {
        let shot = |n| fit.add(n * PERIOD_NS, model.shows(n * PERIOD_NS), EXACTNESS);
        shots.map(shot).collect()
    }

    #[test]
    fn a_drift_of_100_ppm_is_followed_to_within_the_jitter() {
        for rate in [1e-4, -1e-4, 0.0] {
            let (mut fit, mut model) = (ClockFit::default(), Model::new(rate, 3000));
            let residuals = add(&mut fit, &mut model, 0..400);
            assert!(residuals.iter().all(|residual| !residual.is_outlier()));
            // Extrapolation by one shot: jitter of that shot, and error of the line's end.
            let worst = residuals[20..].iter().map(|residual| residual.ns.abs()).max();
            assert!(worst < Some(3 * 3000), "{worst:?}");
            assert!((fit.rate.unwrap() - rate).abs() < 1e-6, "{:?}", fit.rate);
        }
    }

    #[test]
    fn an_hour_without_a_shot_is_bridged_as_far_as_the_rate_is_known() {
        let (mut fit, mut model) = (ClockFit::default(), Model::new(2e-4, 1000));
        add(&mut fit, &mut model, 0..50);
        let at_ns = 36_000 * PERIOD_NS;
        let residual = fit.residual(at_ns, model.shows(at_ns), EXACTNESS);
        assert!((residual.ns.abs() as f64) < fit.uncertainty_ns(at_ns as f64), "{residual:?}");
        assert!(fit.uncertainty_ns(at_ns as f64) < 20e6, "{}", fit.uncertainty_ns(at_ns as f64));
    }

    #[test]
    fn bursts_with_long_pauses_between_them_lie_on_one_line() {
        let (mut fit, mut model) = (ClockFit::default(), Model::new(-2e-4, 3000));
        for burst in 0..20 {
            let first = burst * 5000;
            let residuals = add(&mut fit, &mut model, first..first + 1 + (burst + 9) % 12);
            assert!(residuals.iter().all(|residual| !residual.is_outlier()), "{residuals:?}");
        }
    }

    #[test]
    fn bad_timestamps_are_far_out_and_do_not_move_the_line() {
        let (mut fit, mut model) = (ClockFit::default(), Model::new(1e-4, 1000));
        add(&mut fit, &mut model, 0..40);
        for n in 40..80_i128 {
            let wrong_ns = if n % 4 == 0 { 300_000 } else { 0 };
            let shown = model.shows(n * PERIOD_NS) + wrong_ns;
            let residual = fit.add(n * PERIOD_NS, shown, EXACTNESS);
            assert_eq!(residual.is_outlier(), wrong_ns != 0, "{n}: {residual:?}");
            assert!((residual.ns - wrong_ns).abs() < 6000, "{n}: {residual:?}");
        }
    }

    #[test]
    fn a_jump_is_far_out_three_times_and_then_followed() {
        for jump_ns in [-4_000_000, 80_000, 4_000_000, 3_000_000_000_000] {
            let (mut fit, mut model) = (ClockFit::default(), Model::new(-1e-4, 1000));
            add(&mut fit, &mut model, 0..40);
            model.offset_ns += jump_ns;
            let after = add(&mut fit, &mut model, 40..90);
            let far_out: Vec<bool> = after.iter().map(Residual::is_outlier).collect();
            assert_eq!(far_out[..3], [true; 3], "{jump_ns}");
            assert!(far_out[3..].iter().all(|far| !far), "{jump_ns}: {far_out:?}");
            assert!(after[20..].iter().all(|residual| residual.ns.abs() < 6000), "{jump_ns}");
        }
    }

    #[test]
    fn a_new_beginning_keeps_the_rate() {
        let (mut fit, mut model) = (ClockFit::default(), Model::new(1e-4, 1000));
        add(&mut fit, &mut model, 0..40);
        fit.restart_reference();
        assert!(!fit.has_line());
        model.offset_ns += 123_456_789;
        let after = add(&mut fit, &mut model, 100..120);
        assert_eq!(after[0].ns, 0);
        assert!(after.iter().all(|residual| residual.ns.abs() < 6000), "{after:?}");
    }
}
