//! Which trigger a frame belongs to: frame id, checked against the camera's own clock.

use std::collections::VecDeque;

use lfpiv_hw::device::Frame;

use super::PairingSettings;

/// The triggers of the burst that runs or ran last: `first` up to, not including, `end`.
#[derive(Debug, Clone, Copy, Default)]
pub(super) struct Burst {
    pub first: u64,
    pub end: u64,
}

/// The time grid on which a camera's frames must lie.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) struct TimeGrid {
    pub period_ns: i128,
    /// Timestamp of frame b less that of frame a.
    pub interval_ns: i128,
    /// How exactly that is kept.
    pub interval_tolerance_ns: i128,
}

impl TimeGrid {
    /// The grid of a schedule.
    pub fn of(settings: &PairingSettings) -> Self {
        Self {
            period_ns: i128::from(settings.period_ns.max(1)),
            interval_ns: i128::from(settings.frame_interval_ns),
            interval_tolerance_ns: i128::from(settings.frame_interval_tolerance_ns),
        }
    }

    /// Whole periods in a time difference, and what is left.
    pub fn steps(&self, elapsed_ns: i128) -> (i128, i128) {
        let steps = (elapsed_ns + self.period_ns.div_euclid(2)).div_euclid(self.period_ns);
        (steps, elapsed_ns - steps * self.period_ns)
    }

    /// How far a timestamp may be off the grid. Missed triggers shift by a whole period, clocks
    /// drift by parts in 10⁴ at most: an eighth of a period tells one from the other.
    pub fn tolerance_ns(&self) -> i128 {
        self.period_ns / 8
    }

    /// Whether two timestamps are as far apart as those of one trigger's frames, and not as those
    /// of frame b and the next trigger's frame a.
    fn is_one_pair(&self, elapsed_ns: i128) -> bool {
        let other_gap_ns = self.period_ns - 2 * self.interval_ns;
        let distinct = other_gap_ns.abs() > 4 * self.interval_tolerance_ns;
        distinct && (elapsed_ns - self.interval_ns).abs() <= self.interval_tolerance_ns
    }
}

/// Where a frame belongs.
#[derive(Debug, PartialEq, Eq)]
pub(super) enum Location {
    /// To this trigger. `missed` triggers before it were found not to have been seen.
    Trigger { trigger: u64, missed: u64, disagreement: Option<String> },
    /// To an earlier burst, all of whose triggers are closed.
    Past,
}

/// What is known about one camera's stream.
#[derive(Debug, Clone, Default)]
pub(super) struct Track {
    /// Triggers the camera did not see: its frames `2m`, `2m + 1` belong to trigger `m + missed`.
    pub missed: u64,
    /// A located frame a: its trigger and its timestamp.
    pub clock: Option<(u64, i128)>,
    /// Half the id of that frame: where the camera's own count stood.
    clock_count: u64,
    /// Frames the stream reports as lost for want of a buffer, not yet charged to a trigger.
    pub underruns: u64,
    reported_underruns: u64,
    /// The camera was away, and how many triggers it has missed is not known.
    restarted: bool,
    /// 1 when the stream's first frame was a frame b, and was given the number of a frame a.
    late_start: u64,
    /// Numbers and timestamps of the last frames.
    recent: VecDeque<(u64, i128)>,
}

/// Frames among which successive ones are looked for: they overtake each other by a few places.
const RECENT: usize = 8;

impl Track {
    /// The camera was away and perhaps without power: its clock and the number of triggers it has
    /// missed are unknown. Its next frame is taken for one of the first trigger of the burst that
    /// runs then.
    pub fn restart(&mut self) {
        self.clock = None;
        self.restarted = true;
        self.late_start = 0;
        self.recent.clear();
    }

    /// 0 for a frame a, 1 for a frame b.
    pub fn half(&self, frame: &Frame) -> usize {
        ((frame.frame_id + self.late_start) % 2) as usize
    }

    /// Takes in the stream's running count of underruns.
    pub fn report_underruns(&mut self, total: u64) {
        self.underruns += total.saturating_sub(self.reported_underruns);
        self.reported_underruns = self.reported_underruns.max(total);
    }

    /// Charges a lost frame to an underrun, when one is left.
    pub fn charge_underrun(&mut self) -> bool {
        let charged = self.underruns > 0;
        self.underruns = self.underruns.saturating_sub(1);
        charged
    }

    /// Finds the trigger of a frame and moves the clock on.
    pub fn locate(&mut self, frame: &Frame, burst: Burst, grid: TimeGrid) -> Location {
        let renumbered = self.find_start(frame, grid);
        let half = self.half(frame) as i128;
        let timestamp = i128::from(frame.device_timestamp_ns) - half * grid.interval_ns;
        let count = (frame.frame_id + self.late_start) / 2;
        if renumbered && let Some((trigger, at_ns)) = self.clock {
            // Its trigger by time is right; the number of those missed follows from it.
            let timed = i128::from(trigger) + grid.steps(timestamp - at_ns).0;
            self.missed = u64::try_from(timed - i128::from(count)).unwrap_or(0);
        }
        if std::mem::take(&mut self.restarted) {
            self.missed = burst.first.saturating_sub(count);
        }
        let counted = count + self.missed;
        let location = match self.clock {
            Some(clock) if clock.0 >= burst.first => {
                self.within_burst(counted, timestamp, clock, burst, grid)
            }
            Some(clock) => self.first_of_burst(count, timestamp, clock, burst, grid),
            None => self.without_clock(count, burst),
        };
        if let Location::Trigger { trigger, missed, disagreement } = &location {
            self.missed += missed;
            let newer = self.clock.is_none_or(|(last, _)| *trigger > last);
            if newer && disagreement.is_none() && *trigger < burst.end {
                self.set_clock(*trigger, count, timestamp);
            }
        }
        location
    }

    /// Two successive frames that belong together, the first with an odd number: the numbers
    /// began with a frame b. Returns whether that is news.
    fn find_start(&mut self, frame: &Frame, grid: TimeGrid) -> bool {
        let (id, timestamp) = (frame.frame_id, i128::from(frame.device_timestamp_ns));
        let wrong_pair = self.recent.iter().any(|(other, at)| {
            let (first, elapsed_ns) =
                if *other < id { (*other, timestamp - at) } else { (id, at - timestamp) };
            other.abs_diff(id) == 1
                && (first + self.late_start) % 2 == 1
                && grid.is_one_pair(elapsed_ns)
        });
        if wrong_pair {
            self.late_start = 1 - self.late_start;
        }
        self.recent.push_back((id, timestamp));
        if self.recent.len() > RECENT {
            self.recent.pop_front();
        }
        wrong_pair
    }

    /// No frame of this camera is located yet, so that nothing but its number says where it
    /// belongs. A camera that missed the very first triggers counts from a later one: numbers of
    /// earlier bursts are taken for the present burst, and the first such shot is suspect, because
    /// a very late frame looks the same. Frames that follow show which it was.
    fn without_clock(&mut self, count: u64, burst: Burst) -> Location {
        let missed = burst.first.saturating_sub(count);
        let disagreement = (missed != self.missed)
            .then(|| format!("frame id says trigger {count}, {} was given", burst.first));
        self.missed = missed;
        Location::Trigger { trigger: count + missed, missed: 0, disagreement }
    }

    /// The clock was set in this burst: a whole number of periods has passed since.
    fn within_burst(
        &self,
        counted: u64,
        timestamp: i128,
        clock: (u64, i128),
        burst: Burst,
        grid: TimeGrid,
    ) -> Location {
        let (steps, off_grid_ns) = grid.steps(timestamp - clock.1);
        let timed = i128::from(clock.0) + steps;
        let behind = timed - i128::from(counted);
        let doubt = |words: String| Location::Trigger {
            trigger: counted,
            missed: 0,
            disagreement: Some(words),
        };
        if off_grid_ns.abs() > grid.tolerance_ns() {
            doubt(format!("timestamp is {} us off the trigger grid", off_grid_ns / 1000))
        } else if behind == 0 {
            located(counted, 0)
        } else if behind > 0 && timed < i128::from(burst.end) {
            let missed = behind.unsigned_abs() as u64;
            located(counted + missed, missed)
        } else if behind < 0
            && behind + i128::from(self.missed) >= 0
            && timed >= i128::from(burst.first)
        {
            // It was sent before a trigger that is known by now to have been missed.
            located(counted - behind.unsigned_abs() as u64, 0)
        } else {
            doubt(format!("frame id says trigger {counted}, timestamp says {timed}"))
        }
    }

    /// The clock was set in an earlier burst. The pause between bursts is of any length, so the
    /// timestamp says only whether the frame came after the earlier burst.
    fn first_of_burst(
        &mut self,
        count: u64,
        timestamp: i128,
        clock: (u64, i128),
        burst: Burst,
        grid: TimeGrid,
    ) -> Location {
        let counted = count + self.missed;
        let missed = burst.first.saturating_sub(counted);
        let trigger = counted + missed;
        let last_trigger = i128::from(burst.first) - 1;
        let earlier_burst_ns = (last_trigger - i128::from(clock.0)) * grid.period_ns;
        if timestamp - clock.1 > earlier_burst_ns + grid.tolerance_ns() {
            return located(trigger, missed);
        }
        // A later number with an earlier time is no frame of the earlier burst: the clock was set
        // back, or the camera restarted. It is a new beginning.
        let is_newer = count > self.clock_count && (missed == 0 || timestamp < clock.1);
        if !is_newer {
            return Location::Past;
        }
        self.set_clock(trigger, count, timestamp);
        let back_us = (clock.1 + earlier_burst_ns - timestamp) / 1000;
        let words = format!("the camera's clock went back by {back_us} us or more");
        Location::Trigger { trigger, missed, disagreement: Some(words) }
    }

    fn set_clock(&mut self, trigger: u64, count: u64, timestamp: i128) {
        self.clock = Some((trigger, timestamp));
        self.clock_count = count;
    }
}

fn located(trigger: u64, missed: u64) -> Location {
    Location::Trigger { trigger, missed, disagreement: None }
}
