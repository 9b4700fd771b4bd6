//! Assigns frames to triggers by frame id, checked against the camera's own clock.

use std::collections::VecDeque;

use lfpiv_hw::device::Frame;

use super::PairingSettings;

/// The current or last burst: triggers `first` to `end - 1`.
#[derive(Debug, Clone, Copy, Default)]
pub(super) struct BurstRange {
    pub first: u64,
    pub end: u64,
}

/// The expected time grid of a camera's frames.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) struct TimeGrid {
    pub period_ns: i128,
    /// Timestamp of frame b minus that of frame a.
    pub interval_ns: i128,
    /// Tolerance of the interval.
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

    /// Whole periods in a time difference, and the remainder.
    pub fn steps(&self, elapsed_ns: i128) -> (i128, i128) {
        let steps = (elapsed_ns + self.period_ns.div_euclid(2)).div_euclid(self.period_ns);
        (steps, elapsed_ns - steps * self.period_ns)
    }

    /// Tolerance of a timestamp against the grid. Missed triggers shift by whole periods, and
    /// clocks drift by at most parts in 10⁴, so an eighth of a period separates them.
    pub fn tolerance_ns(&self) -> i128 {
        self.period_ns / 8
    }

    /// Whether two timestamps fit the two frames of one trigger better than frame b and the next
    /// frame a.
    fn is_one_pair(&self, elapsed_ns: i128) -> bool {
        let other_gap_ns = self.period_ns - 2 * self.interval_ns;
        let distinct = other_gap_ns.abs() > 4 * self.interval_tolerance_ns;
        distinct && (elapsed_ns - self.interval_ns).abs() <= self.interval_tolerance_ns
    }
}

/// The trigger of a frame.
#[derive(Debug, PartialEq, Eq)]
pub(super) enum Location {
    /// This trigger. `missed` triggers before it turned out not to have been seen.
    Trigger { trigger: u64, missed: u64, disagreement: Option<String> },
    /// An earlier burst, all of whose triggers are closed.
    Past,
}

/// State of one camera's stream.
#[derive(Debug, Clone, Default)]
pub(super) struct StreamTrack {
    /// Triggers the camera did not see: its frames `2m`, `2m + 1` belong to trigger `m + missed`.
    pub missed: u64,
    /// Trigger and timestamp of a located frame a.
    pub clock: Option<(u64, i128)>,
    /// Half the id of that frame: the camera's own shot count.
    clock_count: u64,
    /// Underruns reported by the stream and not yet attributed to a trigger.
    pub underruns: u64,
    reported_underruns: u64,
    /// The camera was away, and the number of triggers it missed is unknown.
    restarted: bool,
    /// 1 if the stream's first frame was a frame b with the number of a frame a.
    late_start: u64,
    /// Numbers and timestamps of the last frames.
    recent: VecDeque<(u64, i128)>,
}

/// Number of frames searched for a successive pair: frames overtake each other by a few places.
const RECENT: usize = 8;

impl StreamTrack {
    /// The camera was away and perhaps without power: its clock and the number of missed triggers are
    /// unknown. Its next frame is assigned to the first trigger of the burst running then.
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

    /// Updates the stream's total of underruns.
    pub fn report_underruns(&mut self, total: u64) {
        self.underruns += total.saturating_sub(self.reported_underruns);
        self.reported_underruns = self.reported_underruns.max(total);
    }

    /// Attributes a lost frame to an underrun, if one is left.
    pub fn charge_underrun(&mut self) -> bool {
        let charged = self.underruns > 0;
        self.underruns = self.underruns.saturating_sub(1);
        charged
    }

    /// Finds the trigger of a frame and updates the clock.
    pub fn locate(&mut self, frame: &Frame, burst: BurstRange, grid: TimeGrid) -> Location {
        let renumbered = self.find_start(frame, grid);
        let half = self.half(frame) as i128;
        let timestamp = i128::from(frame.device_timestamp_ns) - half * grid.interval_ns;
        let count = (frame.frame_id + self.late_start) / 2;
        if renumbered && let Some((trigger, at_ns)) = self.clock {
            // The trigger by time is right; the number of missed ones follows from it.
            let timed = i128::from(trigger) + grid.steps(timestamp - at_ns).0;
            self.missed = u64::try_from(timed - i128::from(count)).unwrap_or(0);
        }
        if std::mem::take(&mut self.restarted) {
            self.missed = burst.first.saturating_sub(count);
        }
        let counted = count + self.missed;
        let location = match self.clock {
            Some(clock) if clock.0 >= burst.first => {
                self.locate_within_burst(counted, timestamp, clock, burst, grid)
            }
            Some(clock) => self.locate_after_pause(count, timestamp, clock, burst, grid),
            None => self.locate_without_clock(count, burst),
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

    /// Detects two successive frames of one trigger of which the first has an odd number: the numbering
    /// started with a frame b. Returns whether this is new.
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

    /// No frame of this camera is located yet, so only its number is known. A camera that missed
    /// the very first triggers counts from a later one: numbers of earlier bursts are then assigned
    /// to the current burst, and the first such shot is suspect, because a very late frame looks
    /// the same. Later frames resolve the ambiguity.
    fn locate_without_clock(&mut self, count: u64, burst: BurstRange) -> Location {
        let missed = burst.first.saturating_sub(count);
        let disagreement = (missed != self.missed)
            .then(|| format!("frame id says trigger {count}, {} was given", burst.first));
        self.missed = missed;
        Location::Trigger { trigger: count + missed, missed: 0, disagreement }
    }

    /// The last located frame is in this burst: a whole number of periods has passed since.
    fn locate_within_burst(
        &self,
        counted: u64,
        timestamp: i128,
        clock: (u64, i128),
        burst: BurstRange,
        grid: TimeGrid,
    ) -> Location {
        let (steps, off_grid_ns) = grid.steps(timestamp - clock.1);
        let timed = i128::from(clock.0) + steps;
        let behind = timed - i128::from(counted);
        let disagree = |words: String| Location::Trigger {
            trigger: counted,
            missed: 0,
            disagreement: Some(words),
        };
        if off_grid_ns.abs() > grid.tolerance_ns() {
            disagree(format!("timestamp is {} us off the trigger grid", off_grid_ns / 1000))
        } else if behind == 0 {
            located(counted, 0)
        } else if behind > 0 && timed < i128::from(burst.end) {
            let missed = behind.unsigned_abs() as u64;
            located(counted + missed, missed)
        } else if behind < 0
            && behind + i128::from(self.missed) >= 0
            && timed >= i128::from(burst.first)
        {
            // It was sent before a trigger that is now known to have been missed.
            located(counted - behind.unsigned_abs() as u64, 0)
        } else {
            disagree(format!("frame id says trigger {counted}, timestamp says {timed}"))
        }
    }

    /// The last located frame is in an earlier burst. The pause between bursts is arbitrary, so the
    /// timestamp only shows whether the frame was taken after that burst.
    fn locate_after_pause(
        &mut self,
        count: u64,
        timestamp: i128,
        clock: (u64, i128),
        burst: BurstRange,
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
        // A later number with an earlier time cannot belong to the earlier burst: the clock was set
        // back, or the camera restarted. The track restarts here.
        let is_newer = count > self.clock_count && (missed == 0 || timestamp < clock.1);
        if !is_newer {
            return Location::Past;
        }
        self.set_clock(trigger, count, timestamp);
        let back_us = (clock.1 + earlier_burst_ns - timestamp) / 1000;
        let words = format!("the camera's clock was set back by {back_us} us or more");
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
