//! The steps of a record. Where the record is damaged or inconsistent, bursts without a start or end
//! get one or are left out, so that triggers keep their numbers and the replay never waits for a step
//! that does not exist.

use std::sync::Arc;

use lfpiv_hw::{device::StreamStatistics, timing::PulseSchedule};
use lfpiv_rawlog::Position;

use crate::acquisition::{
    BurstStart,
    journal::{Entry, FrameHead, LocatedEntry},
};

#[derive(Debug, Clone)]
pub(super) enum Step {
    Frame {
        at_ns: u64,
        camera: usize,
        head: FrameHead,
        statistics: StreamStatistics,
        place: Position,
    },
    Stream {
        at_ns: u64,
        camera: usize,
        connected: bool,
        statistics: StreamStatistics,
    },
    Fired {
        at_ns: u64,
        shots: u64,
        schedule: Arc<PulseSchedule>,
        start: Option<BurstStart>,
    },
    BurstEnded {
        at_ns: u64,
        given: u64,
        /// The unit was lost, and its count unknown.
        lost: bool,
    },
    /// During a burst.
    SwitchingOff {
        at_ns: u64,
    },
    Stopping {
        at_ns: u64,
    },
}

impl Step {
    pub fn at_ns(&self) -> u64 {
        match self {
            Self::Frame { at_ns, .. }
            | Self::Stream { at_ns, .. }
            | Self::Fired { at_ns, .. }
            | Self::BurstEnded { at_ns, .. }
            | Self::SwitchingOff { at_ns }
            | Self::Stopping { at_ns } => *at_ns,
        }
    }
}

/// Converts entries to steps.
#[derive(Debug)]
pub(super) struct Steps {
    steps: Vec<Step>,
    cameras: usize,
    schedule: Option<Arc<PulseSchedule>>,
    /// Number of triggers of all bursts so far.
    fired: u64,
    is_burst_open: bool,
    /// Step before which entries are missing, until the next burst starts or ends.
    gap: Option<usize>,
    /// Stream counters of the cameras that are away.
    away: Vec<(usize, StreamStatistics)>,
}

impl Steps {
    /// No steps yet, for this many cameras.
    pub fn new(cameras: usize) -> Self {
        Self {
            steps: Vec::new(),
            cameras,
            schedule: None,
            fired: 0,
            is_burst_open: false,
            gap: None,
            away: Vec::new(),
        }
    }

    /// Notes missing entries.
    pub fn record_gap(&mut self) {
        self.gap = Some(self.steps.len());
    }

    pub fn take(&mut self, placed: LocatedEntry) {
        let LocatedEntry { position: place, entry } = placed;
        match entry {
            Entry::Programmed { schedule, .. } => self.schedule = Some(Arc::new(schedule)),
            Entry::Fired { at_ns, first, shots } => self.fire(at_ns, first, shots),
            Entry::BurstStarted { start: then, .. } => {
                let fired = self.steps.iter_mut().rev().find_map(|step| match step {
                    Step::Fired { start, .. } => Some(start),
                    _ => None,
                });
                if let Some(start) = fired {
                    *start = Some(then);
                }
            }
            Entry::BurstEnded { at_ns, given } => self.end_burst(at_ns, given, false),
            Entry::BurstLost { at_ns, given } => self.end_burst(at_ns, given, true),
            // The run had no such camera, so nothing would play its steps.
            Entry::Frame { camera, .. } | Entry::Stream { camera, .. }
                if camera >= self.cameras => {}
            Entry::Frame { at_ns, camera, frame: head, statistics } => {
                self.steps.push(Step::Frame { at_ns, camera, head, statistics, place });
            }
            Entry::Stream { at_ns, camera, connected, statistics } => {
                self.away.retain(|(away, _)| *away != camera);
                if !connected {
                    self.away.push((camera, statistics));
                }
                self.steps.push(Step::Stream { at_ns, camera, connected, statistics });
            }
            Entry::SwitchingOff { at_ns } if self.is_burst_open => {
                self.steps.push(Step::SwitchingOff { at_ns });
            }
            Entry::Stopping { at_ns } => self.steps.push(Step::Stopping { at_ns }),
            _ => {}
        }
    }

    pub fn finish(self) -> Vec<Step> {
        self.steps
    }

    fn fire(&mut self, at_ns: u64, first: u64, shots: u64) {
        // In an undamaged record the schedule comes first.
        let Some(schedule) = self.schedule.clone() else { return };
        let (mut at_ns, mut all) = (at_ns, shots);
        // Bursts do not nest: the end of the previous one is missing.
        if self.gap.take().is_some() || self.is_burst_open {
            let last_ns = self.steps.last().map_or(0, Step::at_ns);
            if self.is_burst_open {
                let given = self.fired.min(first);
                self.steps.push(Step::BurstEnded { at_ns: last_ns, given, lost: false });
                self.fired = given;
            }
            // Bursts are fired only while every camera is connected.
            for (camera, statistics) in std::mem::take(&mut self.away) {
                self.steps.push(Step::Stream {
                    at_ns: last_ns,
                    camera,
                    connected: true,
                    statistics,
                });
            }
            // Triggers that are missing from the record become part of this burst.
            let missing = first.saturating_sub(self.fired);
            let period_ns = (schedule.period_us * 1e3) as u64;
            at_ns = at_ns.saturating_sub(missing.saturating_mul(period_ns)).max(last_ns);
            all = all.saturating_add(missing);
        }
        self.steps.push(Step::Fired { at_ns, shots: all, schedule, start: None });
        self.fired = first.saturating_add(shots);
        self.is_burst_open = true;
    }

    fn end_burst(&mut self, at_ns: u64, given: u64, lost: bool) {
        if let Some(gap) = self.gap
            && (!self.is_burst_open || given > self.fired)
        {
            self.gap = None;
            self.insert_burst(gap, given);
        }
        // The end of a burst without a start is dropped.
        if self.is_burst_open {
            self.steps.push(Step::BurstEnded { at_ns, given, lost });
            self.fired = given;
            self.is_burst_open = false;
        }
    }

    /// Inserts the start of a burst that ends with this number of triggers, where entries are missing.
    fn insert_burst(&mut self, gap: usize, given: u64) {
        let Some(schedule) = self.schedule.clone().filter(|_| given > self.fired) else { return };
        let at_ns = gap.checked_sub(1).map_or(0, |before| self.steps[before].at_ns());
        let ended = Step::BurstEnded { at_ns, given: self.fired, lost: false };
        let shots = given - self.fired;
        let fired = Step::Fired { at_ns, shots, schedule, start: None };
        let inserted = self.is_burst_open.then_some(ended).into_iter().chain([fired]);
        self.steps.splice(gap..gap, inserted);
        self.is_burst_open = true;
    }
}

#[cfg(test)]
mod tests {
    use lfpiv_hw::{TimingSettings, device::FrameStatus};

    use super::*;

    /// Steps of entries with gaps: `None` marks a missing entry.
    fn steps(entries: Vec<Option<Entry>>) -> Vec<String> {
        let mut steps = Steps::new(2);
        let schedule = PulseSchedule::plan(&TimingSettings::default(), 100.0, 10.0).unwrap();
        let programmed = Entry::Programmed { at_ns: 0, identity: String::new(), schedule };
        let position = Position { segment: 0, offset: 0 };
        steps.take(LocatedEntry { position, entry: programmed });
        for entry in entries {
            match entry {
                Some(entry) => steps.take(LocatedEntry { position, entry }),
                None => steps.record_gap(),
            }
        }
        let named = steps.finish().into_iter().map(|step| match step {
            Step::Frame { .. } => "frame".into(),
            Step::Stream { connected, .. } => format!("connected: {connected}"),
            Step::Fired { shots, .. } => format!("{shots} fired"),
            Step::BurstEnded { given, lost: false, .. } => format!("{given} given"),
            Step::BurstEnded { given, .. } => format!("lost after {given}"),
            Step::SwitchingOff { .. } => "switching off".into(),
            Step::Stopping { .. } => "stopping".into(),
        });
        named.collect()
    }

    fn fired(first: u64, shots: u64) -> Option<Entry> {
        Some(Entry::Fired { at_ns: 1_000_000_000 * first, first, shots })
    }

    fn ended(given: u64) -> Option<Entry> {
        Some(Entry::BurstEnded { at_ns: 1_000_000_000 * given, given })
    }

    fn frame() -> Option<Entry> {
        let (at_ns, statistics) = (0, StreamStatistics::default());
        let frame = FrameHead {
            frame_id: 0,
            device_timestamp_ns: 0,
            host_timestamp_ns: 0,
            status: FrameStatus::Complete,
        };
        Some(Entry::Frame { at_ns, camera: 0, frame, statistics })
    }

    #[test]
    fn an_undamaged_record_is_replayed_unchanged() {
        let entries = vec![fired(0, 3), frame(), ended(2), fired(2, 3), frame(), ended(5)];
        let wanted = ["3 fired", "frame", "2 given", "3 fired", "frame", "5 given"];
        assert_eq!(steps(entries), wanted);
    }

    #[test]
    fn a_burst_that_was_lost_is_lost_again() {
        let lost = Entry::BurstLost { at_ns: 0, given: 2 };
        let reason = String::new();
        let unit = Entry::SynchroniserLost { at_ns: 0, reason };
        let entries = vec![fired(0, 3), frame(), Some(unit), Some(lost), fired(2, 1), ended(3)];
        let wanted = ["3 fired", "frame", "lost after 2", "1 fired", "3 given"];
        assert_eq!(steps(entries), wanted);
    }

    #[test]
    fn a_laser_is_switched_off_only_during_a_burst() {
        let off = || Some(Entry::SwitchingOff { at_ns: 0 });
        let entries = vec![off(), fired(0, 3), frame(), off(), ended(2), off()];
        assert_eq!(steps(entries), ["3 fired", "frame", "switching off", "2 given"]);
    }

    #[test]
    fn a_burst_without_its_end_ends_before_the_next() {
        let entries = vec![fired(0, 3), frame(), None, fired(2, 3), ended(5)];
        assert_eq!(steps(entries), ["3 fired", "frame", "2 given", "3 fired", "5 given"]);
    }

    #[test]
    fn a_burst_without_its_beginning_begins_where_it_is_missing() {
        let entries = vec![fired(0, 3), ended(3), None, frame(), ended(7)];
        assert_eq!(steps(entries), ["3 fired", "3 given", "4 fired", "frame", "7 given"]);
        // The end of the previous burst is missing, too.
        let entries = vec![fired(0, 3), frame(), None, frame(), ended(7)];
        assert_eq!(steps(entries), ["3 fired", "frame", "3 given", "4 fired", "frame", "7 given"]);
    }

    #[test]
    fn bursts_that_are_missing_are_part_of_the_next_and_cameras_are_back() {
        let away = Entry::Stream {
            at_ns: 0,
            camera: 0,
            connected: false,
            statistics: StreamStatistics::default(),
        };
        let entries = vec![fired(0, 3), Some(away), ended(3), None, fired(9, 2), ended(11)];
        let wanted =
            ["3 fired", "connected: false", "3 given", "connected: true", "8 fired", "11 given"];
        assert_eq!(steps(entries), wanted);
    }

    #[test]
    fn a_record_that_contradicts_itself_has_a_beginning_and_an_end_for_every_burst() {
        let entries = vec![ended(1), fired(0, 3), ended(3), ended(3), fired(3, 1), ended(4)];
        assert_eq!(steps(entries), ["3 fired", "3 given", "1 fired", "4 given"]);
        let entries = vec![fired(0, 3), frame(), fired(2, 3), ended(5)];
        assert_eq!(steps(entries), ["3 fired", "frame", "2 given", "3 fired", "5 given"]);
        let of_third = |entry| match entry {
            Some(Entry::Frame { at_ns, frame, statistics, .. }) => {
                Some(Entry::Frame { at_ns, camera: 2, frame, statistics })
            }
            other => other,
        };
        assert_eq!(steps(vec![fired(0, 1), of_third(frame()), ended(1)]), ["1 fired", "1 given"]);
    }

    #[test]
    fn a_damaged_frame_changes_nothing_else() {
        let entries = vec![fired(0, 3), frame(), None, frame(), ended(3), fired(3, 1), ended(4)];
        let wanted = ["3 fired", "frame", "frame", "3 given", "1 fired", "4 given"];
        assert_eq!(steps(entries), wanted);
    }
}
