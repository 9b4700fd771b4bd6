//! A clock as a straight line against another one: offset and rate, from recent shots.
//!
//! Quartz clocks differ in rate by parts in 10⁴ at most and wander by parts in 10⁶, so over recent
//! shots their difference is a straight line. It is the line of Theil and Sen: its rate is the
//! median of the rates between all pairs of points, its offset the median of what is left. Nearly
//! three points in ten may be wrong without moving it (P. K. Sen, J. Am. Stat. Assoc. 63, 1968).
//! Pairs count by the time between them (L. A. Jaeckel, Ann. Math. Stat. 43, 1972): bursts are dense
//! and pauses long, and the rate over a pause is worth more than that between neighbours.

use std::collections::VecDeque;

use lfpiv_core::statistics::{median, weighted_median};

/// Points that a line is drawn through.
const WINDOW: usize = 32;
/// Points from which on rate and spread are believed.
const LEAST_POINTS: usize = 8;
/// By how much two clocks may differ in rate while nothing is known of them.
const UNKNOWN_RATE: f64 = 2e-4;
/// How far the rate may wander from what was measured: quartz and temperature.
const RATE_WANDER: f64 = 2e-6;
/// A residual of more spreads (standard deviations) than this is far out.
const FAR_OUT_SPREADS: f64 = 8.0;
/// So many shots far out in a row are a jump of the clock, not bad timestamps.
const JUMP_AFTER: usize = 3;
/// From the median absolute deviation to the standard deviation, of a normal distribution.
const MAD_TO_SIGMA: f64 = 1.4826;

/// A timestamp held against the line.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Residual {
    /// Timestamp less the line, in ns; 0 where there is no line yet.
    pub ns: i128,
    /// What would be far out, in ns.
    pub limit_ns: f64,
}

impl Residual {
    pub fn is_far_out(&self) -> bool {
        self.ns.unsigned_abs() as f64 > self.limit_ns
    }
}

/// How exact timestamps may be expected to be.
#[derive(Debug, Clone, Copy)]
pub(super) struct Exactness {
    /// Residuals up to this are never far out, in ns.
    pub least_ns: f64,
    /// Residuals beyond this are always far out, in ns.
    pub most_ns: f64,
}

#[derive(Debug, Clone, Copy)]
struct Point {
    at_ns: i128,
    /// The clock less the other one.
    ahead_ns: i128,
}

/// The line; see the module. Remembers [`WINDOW`] points.
#[derive(Debug, Clone, Default)]
pub(super) struct ClockFit {
    points: VecDeque<Point>,
    /// Rate less 1, once measured.
    rate: Option<f64>,
    rate_uncertainty: f64,
    /// Standard deviation of the residuals, in ns.
    spread_ns: f64,
    /// What is left of the last point's difference when it is brought onto the line, in ns.
    last_off_ns: f64,
    far_out_in_a_row: usize,
}

impl ClockFit {
    /// Whether there is a line to hold a timestamp against.
    pub fn is_begun(&self) -> bool {
        !self.points.is_empty()
    }

    /// The other clock begins anew at any time, at the same rate.
    pub fn begin_anew(&mut self) {
        self.points.clear();
        self.far_out_in_a_row = 0;
    }

    /// How far the line may be off after `elapsed_ns` without a point.
    pub fn uncertainty_ns(&self, elapsed_ns: f64) -> f64 {
        elapsed_ns.abs() * if self.rate.is_some() { self.rate_uncertainty } else { UNKNOWN_RATE }
    }

    /// Holds the timestamp `clock_ns`, taken at `at_ns` of the other clock, against the line.
    pub fn residual(&self, at_ns: i128, clock_ns: i128, exactness: Exactness) -> Residual {
        let Some(last) = self.points.back() else {
            return Residual { ns: 0, limit_ns: exactness.most_ns };
        };
        let elapsed_ns = (at_ns - last.at_ns) as f64;
        let expected_ns = self.rate.unwrap_or(0.0) * elapsed_ns - self.last_off_ns;
        let ns = clock_ns - at_ns - last.ahead_ns - expected_ns.round() as i128;
        let usual_ns = exactness.least_ns.max(FAR_OUT_SPREADS * self.spread_ns);
        let limit_ns = match self.rate {
            Some(_) => (usual_ns + self.uncertainty_ns(elapsed_ns)).min(exactness.most_ns),
            None => exactness.most_ns,
        };
        Residual { ns, limit_ns }
    }

    /// Takes a timestamp in and returns its residual against the line before. One that is far out
    /// does not move the line, until [`JUMP_AFTER`] of them in a row begin a new one.
    pub fn follow(&mut self, at_ns: i128, clock_ns: i128, exactness: Exactness) -> Residual {
        let residual = self.residual(at_ns, clock_ns, exactness);
        if residual.is_far_out() {
            self.far_out_in_a_row += 1;
            if self.far_out_in_a_row < JUMP_AFTER {
                return residual;
            }
            *self = Self::default();
        }
        self.far_out_in_a_row = 0;
        self.points.push_back(Point { at_ns, ahead_ns: clock_ns - at_ns });
        if self.points.len() > WINDOW {
            self.points.pop_front();
        }
        self.draw();
        residual
    }

    /// Draws the line through the points.
    fn draw(&mut self) {
        let Some(last) = self.points.back().copied() else { return };
        // Relative to the last point, so that no digit is lost.
        let points: Vec<(f64, f64)> = self
            .points
            .iter()
            .map(|p| ((p.at_ns - last.at_ns) as f64, (p.ahead_ns - last.ahead_ns) as f64))
            .collect();
        let enough = points.len() >= LEAST_POINTS;
        if enough {
            self.rate = weighted_median(rates(&points));
        }
        let rate = self.rate.unwrap_or(0.0);
        let mut left: Vec<f64> = points.iter().map(|(at, ahead)| ahead - rate * at).collect();
        let offset_ns = median(left.iter().copied()).unwrap_or(0.0);
        self.last_off_ns = -offset_ns;
        if enough {
            left.iter_mut().for_each(|off| *off = (*off - offset_ns).abs());
            self.spread_ns = MAD_TO_SIGMA * median(left.iter().copied()).unwrap_or(0.0);
            let first_at_ns = points.iter().map(|(at, _)| *at).fold(0.0, f64::min);
            self.rate_uncertainty = RATE_WANDER + 4.0 * self.spread_ns / first_at_ns.abs().max(1.0);
        }
    }
}

/// The rates between all pairs of points, and the time between these.
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

    const EXACTNESS: Exactness = Exactness { least_ns: 20_000.0, most_ns: 12_500_000.0 };
    const PERIOD_NS: i128 = 100_000_000;

    /// A clock that runs fast by `rate`, with uniform jitter of up to `jitter_ns` either way.
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

    fn follow(
        fit: &mut ClockFit,
        model: &mut Model,
        shots: std::ops::Range<i128>,
    ) -> Vec<Residual> {
        let shot = |n| fit.follow(n * PERIOD_NS, model.shows(n * PERIOD_NS), EXACTNESS);
        shots.map(shot).collect()
    }

    #[test]
    fn a_drift_of_100_ppm_is_followed_to_within_the_jitter() {
        for rate in [1e-4, -1e-4, 0.0] {
            let (mut fit, mut model) = (ClockFit::default(), Model::new(rate, 3000));
            let residuals = follow(&mut fit, &mut model, 0..400);
            assert!(residuals.iter().all(|residual| !residual.is_far_out()));
            // Extrapolated by one shot: jitter of the shot, and of the line's end.
            let worst = residuals[20..].iter().map(|residual| residual.ns.abs()).max();
            assert!(worst < Some(3 * 3000), "{worst:?}");
            assert!((fit.rate.unwrap() - rate).abs() < 1e-6, "{:?}", fit.rate);
        }
    }

    #[test]
    fn an_hour_without_a_shot_is_bridged_as_far_as_the_rate_is_known() {
        let (mut fit, mut model) = (ClockFit::default(), Model::new(2e-4, 1000));
        follow(&mut fit, &mut model, 0..50);
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
            let residuals = follow(&mut fit, &mut model, first..first + 1 + (burst + 9) % 12);
            assert!(residuals.iter().all(|residual| !residual.is_far_out()), "{residuals:?}");
        }
    }

    #[test]
    fn bad_timestamps_are_far_out_and_do_not_move_the_line() {
        let (mut fit, mut model) = (ClockFit::default(), Model::new(1e-4, 1000));
        follow(&mut fit, &mut model, 0..40);
        for n in 40..80_i128 {
            let wrong_ns = if n % 4 == 0 { 300_000 } else { 0 };
            let shown = model.shows(n * PERIOD_NS) + wrong_ns;
            let residual = fit.follow(n * PERIOD_NS, shown, EXACTNESS);
            assert_eq!(residual.is_far_out(), wrong_ns != 0, "{n}: {residual:?}");
            assert!((residual.ns - wrong_ns).abs() < 6000, "{n}: {residual:?}");
        }
    }

    #[test]
    fn a_jump_is_far_out_three_times_and_then_followed() {
        for jump_ns in [-4_000_000, 80_000, 4_000_000, 3_000_000_000_000] {
            let (mut fit, mut model) = (ClockFit::default(), Model::new(-1e-4, 1000));
            follow(&mut fit, &mut model, 0..40);
            model.offset_ns += jump_ns;
            let after = follow(&mut fit, &mut model, 40..90);
            let far_out: Vec<bool> = after.iter().map(Residual::is_far_out).collect();
            assert_eq!(far_out[..3], [true; 3], "{jump_ns}");
            assert!(far_out[3..].iter().all(|far| !far), "{jump_ns}: {far_out:?}");
            assert!(after[20..].iter().all(|residual| residual.ns.abs() < 6000), "{jump_ns}");
        }
    }

    #[test]
    fn a_new_beginning_keeps_the_rate() {
        let (mut fit, mut model) = (ClockFit::default(), Model::new(1e-4, 1000));
        follow(&mut fit, &mut model, 0..40);
        fit.begin_anew();
        assert!(!fit.is_begun());
        model.offset_ns += 123_456_789;
        let after = follow(&mut fit, &mut model, 100..120);
        assert_eq!(after[0].ns, 0);
        assert!(after.iter().all(|residual| residual.ns.abs() < 6000), "{after:?}");
    }
}
