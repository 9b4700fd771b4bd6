//! Durability of each shot's raw data.

use std::collections::VecDeque;

use lfpiv_rawlog::LogWatermarks;
use serde::Serialize;

use crate::archive::RawLevel;

/// Record number of a shot whose record was lost.
pub(super) const LOST: u64 = u64::MAX;

/// Number of shots kept individually.
const REMEMBERED: usize = 10_000;

/// Number of shots per durability level (acquired, paired, written, synced).
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq, Serialize)]
pub struct ShotMarks {
    /// Paired: all frames arrived and belong together.
    pub paired: u64,
    /// Written to the operating system: survives the end of this process.
    pub written: u64,
    /// Synced to disk: survives a power cut.
    pub synced: u64,
    /// The highest synced shot number.
    pub last_synced: Option<u64>,
}

/// Record number of each shot.
#[derive(Debug, Default)]
pub(super) struct Levels {
    /// Shot and record number, in the order of the records.
    shots: VecDeque<(u64, u64)>,
    forgotten: u64,
    /// The highest dropped shot; all up to it are synced.
    last_forgotten: Option<u64>,
}

impl Levels {
    pub fn paired(&mut self, shot: u64, record: Option<u64>) {
        let Some(record) = record else { return };
        self.shots.push_back((shot, record));
        while self.shots.len() > REMEMBERED {
            let oldest = self.shots.pop_front().map(|(shot, _)| shot);
            self.last_forgotten = self.last_forgotten.max(oldest);
            self.forgotten += 1;
        }
    }

    pub fn level(&self, shot: u64, marks: LogWatermarks, failed: bool) -> RawLevel {
        match self.shots.iter().rev().find(|(number, _)| *number == shot) {
            Some((_, LOST)) => RawLevel::Lost,
            Some((_, record)) if *record < marks.synced => RawLevel::Synced,
            Some((_, record)) if *record < marks.written => RawLevel::Written,
            Some(_) if failed => RawLevel::Lost,
            Some(_) => RawLevel::Acquired,
            None if self.last_forgotten.is_some_and(|last| shot <= last) => RawLevel::Synced,
            None => RawLevel::NotKept,
        }
    }

    pub fn marks(&self, marks: LogWatermarks) -> ShotMarks {
        let before = |limit: u64| self.shots.partition_point(|(_, record)| *record < limit);
        let synced = before(marks.synced);
        let highest = self.shots.iter().take(synced).map(|(shot, _)| *shot).max();
        ShotMarks {
            paired: self.forgotten + self.shots.len() as u64,
            written: self.forgotten + before(marks.written) as u64,
            synced: self.forgotten + synced as u64,
            last_synced: highest.max(self.last_forgotten),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn marks(written: u64, synced: u64) -> LogWatermarks {
        LogWatermarks { appended: 100, written, synced, ..LogWatermarks::default() }
    }

    #[test]
    fn a_shot_is_as_durable_as_its_record() {
        let mut levels = Levels::default();
        for (shot, record) in [(0, 4), (2, 9), (1, 14)] {
            levels.paired(shot, Some(record));
        }
        let at = |shot, written, synced| levels.level(shot, marks(written, synced), false);
        assert_eq!(at(0, 4, 4), RawLevel::Acquired);
        assert_eq!(at(0, 5, 4), RawLevel::Written);
        assert_eq!(at(0, 5, 5), RawLevel::Synced);
        assert_eq!(at(1, 14, 5), RawLevel::Acquired);
        assert_eq!(levels.level(1, marks(14, 5), true), RawLevel::Lost);
        assert_eq!(levels.level(0, marks(14, 5), true), RawLevel::Synced);
        assert_eq!(at(7, 14, 5), RawLevel::NotKept);
        let expected = ShotMarks { paired: 3, written: 2, synced: 1, last_synced: Some(0) };
        assert_eq!(levels.marks(marks(14, 5)), expected);
        assert_eq!(levels.marks(marks(15, 10)).last_synced, Some(2));
    }

    #[test]
    fn memory_is_bounded_and_counts_are_kept() {
        let mut levels = Levels::default();
        let shots = REMEMBERED as u64 + 50;
        (0..shots).for_each(|shot| levels.paired(shot, Some(shot)));
        assert_eq!(levels.shots.len(), REMEMBERED);
        let all = marks(shots, shots);
        assert_eq!(levels.marks(all).synced, shots);
        assert_eq!(levels.level(3, all, false), RawLevel::Synced);
    }
}
