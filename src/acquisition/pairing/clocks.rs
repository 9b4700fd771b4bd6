//! The cameras' clocks, fitted: cam1 against the triggers of a burst, every other camera
//! against cam1.
//!
//! The trigger grid begins anew with every burst, after a pause of any length, at a rate that
//! stays. The cameras' clocks run on through the pauses, so that their difference tells which
//! camera missed the first trigger of a burst, for as long as the pause is not too long for what
//! is known of their rates.

use std::time::Duration;

use lfpiv_hw::CameraName;

use super::{
    clock_fit::{ClockFit, Exactness, Residual},
    track::{Burst, TimeGrid},
};

/// What comes of holding a shot's timestamps against the clocks.
#[derive(Debug, Default)]
pub(super) struct Comparison {
    /// Per camera, in ns: 0 for a clock that begins with this shot.
    pub residuals_ns: Vec<i64>,
    /// What is far out, in words.
    pub suspect: Vec<String>,
}

/// See the module.
#[derive(Debug)]
pub(super) struct Clocks {
    exactness: Exactness,
    /// The first camera against the triggers of the burst that begins with `burst_first`.
    trigger_grid: ClockFit,
    burst_first: u64,
    /// The other cameras against the first.
    differences: Vec<ClockFit>,
    /// Whether those differences are known.
    compared: bool,
    compared_at: Duration,
}

impl Clocks {
    pub fn new(cameras: usize, grid: TimeGrid) -> Self {
        Self {
            exactness: exactness(grid),
            trigger_grid: ClockFit::default(),
            burst_first: 0,
            differences: vec![ClockFit::default(); cameras.saturating_sub(1)],
            compared: cameras == 1,
            compared_at: Duration::ZERO,
        }
    }

    /// Triggers come at another rate from now on; the cameras' clocks stay what they are.
    pub fn rescheduled(&mut self, grid: TimeGrid) {
        self.exactness = exactness(grid);
        self.trigger_grid = ClockFit::default();
    }

    /// Whether the differences between the cameras' clocks are known well enough at `now` to tell
    /// one trigger from the next.
    pub fn are_compared(&self, now: Duration) -> bool {
        let elapsed_ns = now.saturating_sub(self.compared_at).as_nanos() as f64;
        let exact = |fit: &ClockFit| fit.uncertainty_ns(elapsed_ns) < self.exactness.most_ns;
        self.compared && self.differences.iter().all(exact)
    }

    /// The differences have to be learnt anew.
    pub fn forget_differences(&mut self) {
        self.differences.fill(ClockFit::default());
        self.compared = self.differences.is_empty();
    }

    /// This camera's clock is not what it was.
    pub fn restart(&mut self, camera: usize) {
        if camera == 0 {
            self.trigger_grid = ClockFit::default();
        }
        self.forget_differences();
    }

    /// Timestamp of `camera` less what its clock should have shown when the first camera showed `first_ns`;
    /// `None` while that is not known.
    pub fn difference_ns(&self, camera: usize, first_ns: i128, timestamp_ns: i128) -> Option<i128> {
        if camera == 0 {
            return Some(0);
        }
        let fit = self.differences.get(camera - 1).filter(|_| self.compared)?;
        fit.is_begun().then(|| fit.residual(first_ns, timestamp_ns, self.exactness).ns)
    }

    /// Holds the frame-a timestamps of a shot against the clocks, and moves these on. Clocks learn
    /// from shots that are otherwise in order.
    pub fn compare(
        &mut self,
        (trigger, burst, grid): (u64, Burst, TimeGrid),
        timestamps_ns: &[i128],
        in_order: bool,
        now: Duration,
    ) -> Comparison {
        let mut comparison = Comparison::default();
        let Some((first_ns, others_ns)) = timestamps_ns.split_first() else { return comparison };
        let residual = self.against_triggers(trigger, burst, grid, *first_ns, in_order);
        comparison.add(0, residual);
        if !self.compared {
            self.learn(burst, *first_ns, others_ns, in_order, now, &mut comparison);
            return comparison;
        }
        let exactness = self.exactness;
        for (index, (fit, timestamp_ns)) in self.differences.iter_mut().zip(others_ns).enumerate() {
            let residual = if in_order {
                fit.follow(*first_ns, *timestamp_ns, exactness)
            } else {
                fit.residual(*first_ns, *timestamp_ns, exactness)
            };
            comparison.add(index + 1, residual);
        }
        self.compared_at = now;
        self.forget_after_a_jump(&mut comparison);
        comparison
    }

    fn against_triggers(
        &mut self,
        trigger: u64,
        burst: Burst,
        grid: TimeGrid,
        timestamp_ns: i128,
        in_order: bool,
    ) -> Residual {
        if burst.first != self.burst_first {
            self.trigger_grid.begin_anew();
            self.burst_first = burst.first;
        }
        let at_ns = (i128::from(trigger) - i128::from(burst.first)) * grid.period_ns;
        if in_order && trigger >= burst.first {
            self.trigger_grid.follow(at_ns, timestamp_ns, self.exactness)
        } else {
            self.trigger_grid.residual(at_ns, timestamp_ns, self.exactness)
        }
    }

    /// The first comparison, or the first after a jump: from a single shot that is in order.
    fn learn(
        &mut self,
        burst: Burst,
        first_ns: i128,
        others_ns: &[i128],
        in_order: bool,
        now: Duration,
        comparison: &mut Comparison,
    ) {
        comparison.residuals_ns.resize(1 + others_ns.len(), 0);
        if burst.end - burst.first > 1 {
            let words = "the cameras' clocks are not compared since they moved apart";
            comparison.suspect.push(words.into());
        } else if in_order {
            self.forget_differences();
            for (fit, timestamp_ns) in self.differences.iter_mut().zip(others_ns) {
                fit.follow(first_ns, *timestamp_ns, self.exactness);
            }
            self.compared = true;
            self.compared_at = now;
        }
    }

    /// Differences that might hide a missed trigger are worth nothing any more.
    fn forget_after_a_jump(&mut self, comparison: &mut Comparison) {
        let others_ns = comparison.residuals_ns.iter().skip(1);
        let jump_ns = others_ns.map(|ns| ns.unsigned_abs()).max().unwrap_or(0);
        if jump_ns as f64 > self.exactness.most_ns {
            self.forget_differences();
            let words = format!("the cameras' clocks moved apart by {} us", jump_ns / 1000);
            comparison.suspect.push(words);
        }
    }
}

impl Comparison {
    fn add(&mut self, camera: usize, residual: Residual) {
        let ns = residual.ns.clamp(i64::MIN.into(), i64::MAX.into());
        self.residuals_ns.push(ns as i64);
        if residual.is_far_out() {
            let name = CameraName(camera);
            let first = CameraName(0).to_string();
            let against = if camera == 0 { "the triggers" } else { &first };
            self.suspect.push(format!(
                "{name}: timestamp is {} us off its clock's line against {against}, up to \
                 {:.0} us are usual",
                residual.ns / 1000,
                residual.limit_ns / 1000.0
            ));
        }
    }
}

fn exactness(grid: TimeGrid) -> Exactness {
    Exactness { least_ns: grid.interval_tolerance_ns as f64, most_ns: grid.tolerance_ns() as f64 }
}
