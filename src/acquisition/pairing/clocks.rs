//! Clock fits of the cameras: camera 1 against the triggers of a burst, every other camera against
//! camera 1.
//!
//! The trigger grid restarts with every burst, after an arbitrary pause, at the same rate. The
//! cameras' clocks continue through the pauses. Their difference therefore shows which camera missed
//! the first trigger of a burst, unless the pause is too long for the precision of the fitted rates.

use std::time::Duration;

use lfpiv_hw::CameraName;

use super::{
    clock_fit::{ClockFit, OutlierBounds, Residual},
    track::{BurstRange, TimeGrid},
};

/// Result of comparing a shot's timestamps with the fits.
#[derive(Debug, Default)]
pub(super) struct Comparison {
    /// Residual per camera, in ns; 0 where the fit starts with this shot.
    pub residuals_ns: Vec<i64>,
    /// Outliers, described for the user.
    pub suspect: Vec<String>,
}

/// See the module.
#[derive(Debug)]
pub(super) struct CameraClocks {
    bounds: OutlierBounds,
    /// The first camera against the triggers of the burst that starts with `burst_first`.
    trigger_grid: ClockFit,
    burst_first: u64,
    /// The other cameras against the first.
    differences: Vec<ClockFit>,
    /// Whether these differences are known.
    has_differences: bool,
    compared_at: Duration,
}

impl CameraClocks {
    pub fn new(cameras: usize, grid: TimeGrid) -> Self {
        Self {
            bounds: bounds(grid),
            trigger_grid: ClockFit::default(),
            burst_first: 0,
            differences: vec![ClockFit::default(); cameras.saturating_sub(1)],
            has_differences: cameras == 1,
            compared_at: Duration::ZERO,
        }
    }

    /// The trigger rate changes; the cameras' clocks do not.
    pub fn rescheduled(&mut self, grid: TimeGrid) {
        self.bounds = bounds(grid);
        self.trigger_grid = ClockFit::default();
    }

    /// Whether the differences between the cameras' clocks are known well enough at `now` to
    /// distinguish neighbouring triggers.
    pub fn are_differences_known(&self, now: Duration) -> bool {
        let elapsed_ns = now.saturating_sub(self.compared_at).as_nanos() as f64;
        let exact = |fit: &ClockFit| fit.uncertainty_ns(elapsed_ns) < self.bounds.max_ns;
        self.has_differences && self.differences.iter().all(exact)
    }

    /// Discards the differences, which must be fitted again.
    pub fn discard_differences(&mut self) {
        self.differences.fill(ClockFit::default());
        self.has_differences = self.differences.is_empty();
    }

    /// Restarts the fits of a camera whose clock was reset.
    pub fn restart(&mut self, camera: usize) {
        if camera == 0 {
            self.trigger_grid = ClockFit::default();
        }
        self.discard_differences();
    }

    /// Timestamp of `camera` minus the expected reading of its clock when the first camera's clock
    /// shows `first_ns`; `None` while that is unknown.
    pub fn difference_ns(&self, camera: usize, first_ns: i128, timestamp_ns: i128) -> Option<i128> {
        if camera == 0 {
            return Some(0);
        }
        let fit = self.differences.get(camera - 1).filter(|_| self.has_differences)?;
        fit.has_line().then(|| fit.residual(first_ns, timestamp_ns, self.bounds).ns)
    }

    /// Compares the frame-a timestamps of a shot with the fits and updates these. Only shots
    /// without other anomalies update the fits.
    pub fn compare(
        &mut self,
        (trigger, burst, grid): (u64, BurstRange, TimeGrid),
        timestamps_ns: &[i128],
        in_order: bool,
        now: Duration,
    ) -> Comparison {
        let mut comparison = Comparison::default();
        let Some((first_ns, others_ns)) = timestamps_ns.split_first() else { return comparison };
        let residual = self.against_triggers(trigger, burst, grid, *first_ns, in_order);
        comparison.add(0, residual);
        if !self.has_differences {
            self.learn(burst, *first_ns, others_ns, in_order, now, &mut comparison);
            return comparison;
        }
        let bounds = self.bounds;
        for (index, (fit, timestamp_ns)) in self.differences.iter_mut().zip(others_ns).enumerate() {
            let residual = if in_order {
                fit.add(*first_ns, *timestamp_ns, bounds)
            } else {
                fit.residual(*first_ns, *timestamp_ns, bounds)
            };
            comparison.add(index + 1, residual);
        }
        self.compared_at = now;
        self.discard_after_jump(&mut comparison);
        comparison
    }

    fn against_triggers(
        &mut self,
        trigger: u64,
        burst: BurstRange,
        grid: TimeGrid,
        timestamp_ns: i128,
        in_order: bool,
    ) -> Residual {
        if burst.first != self.burst_first {
            self.trigger_grid.restart_reference();
            self.burst_first = burst.first;
        }
        let at_ns = (i128::from(trigger) - i128::from(burst.first)) * grid.period_ns;
        if in_order && trigger >= burst.first {
            self.trigger_grid.add(at_ns, timestamp_ns, self.bounds)
        } else {
            self.trigger_grid.residual(at_ns, timestamp_ns, self.bounds)
        }
    }

    /// Fits the differences for the first time, or after a jump, from a single shot without anomalies.
    fn learn(
        &mut self,
        burst: BurstRange,
        first_ns: i128,
        others_ns: &[i128],
        in_order: bool,
        now: Duration,
        comparison: &mut Comparison,
    ) {
        comparison.residuals_ns.resize(1 + others_ns.len(), 0);
        if burst.end - burst.first > 1 {
            let words = "the cameras' clocks have not been compared again since one of them jumped";
            comparison.suspect.push(words.into());
        } else if in_order {
            self.discard_differences();
            for (fit, timestamp_ns) in self.differences.iter_mut().zip(others_ns) {
                fit.add(first_ns, *timestamp_ns, self.bounds);
            }
            self.has_differences = true;
            self.compared_at = now;
        }
    }

    /// Discards the differences after a jump, because they could hide a missed trigger.
    fn discard_after_jump(&mut self, comparison: &mut Comparison) {
        let others_ns = comparison.residuals_ns.iter().skip(1);
        let jump_ns = others_ns.map(|ns| ns.unsigned_abs()).max().unwrap_or(0);
        if jump_ns as f64 > self.bounds.max_ns {
            self.discard_differences();
            let words = format!(
                "the difference between the cameras' clocks jumped by {} us",
                jump_ns / 1000
            );
            comparison.suspect.push(words);
        }
    }
}

impl Comparison {
    fn add(&mut self, camera: usize, residual: Residual) {
        let ns = residual.ns.clamp(i64::MIN.into(), i64::MAX.into());
        self.residuals_ns.push(ns as i64);
        if residual.is_outlier() {
            let name = CameraName(camera);
            let first = CameraName(0).to_string();
            let against = if camera == 0 { "the triggers" } else { &first };
            self.suspect.push(format!(
                "{name}: timestamp deviates by {} us from the clock fit against {against}; the \
                 outlier limit is {:.0} us",
                residual.ns / 1000,
                residual.limit_ns / 1000.0
            ));
        }
    }
}

fn bounds(grid: TimeGrid) -> OutlierBounds {
    OutlierBounds { min_ns: grid.interval_tolerance_ns as f64, max_ns: grid.tolerance_ns() as f64 }
}
