//! Where the frames of the latest shots lie, in a record that grows.

use std::{collections::BTreeMap, iter};

use lfpiv_rawlog::Position;

use super::{Placed, RecordedRun, RecordedRunError, RecordedShot, recorded::ShotFinder};

/// Shots remembered.
const REMEMBERED: usize = 10_000;

/// See the module.
pub struct FramePlaces {
    run: RecordedRun,
    entries: Box<dyn Iterator<Item = Result<Placed, RecordedRunError>> + Send>,
    finder: ShotFinder,
    shots: BTreeMap<u64, RecordedShot>,
}

impl FramePlaces {
    /// Begins at the beginning of the record.
    pub fn new(run: RecordedRun) -> Self {
        let entries = Box::new(run.entries());
        Self { run, entries, finder: ShotFinder::default(), shots: BTreeMap::new() }
    }

    /// The record.
    pub fn run(&self) -> &RecordedRun {
        &self.run
    }

    /// Frames a and b of each camera of a shot; `None` where the record has no such shot (yet), or
    /// it is long past. Reads on where the last look ended.
    pub fn of(&mut self, shot: u64) -> Option<&[[Position; 2]]> {
        // A log that cannot be read on is looked at again with the next question.
        for placed in iter::from_fn(|| self.entries.next()?.ok()) {
            if let Some(Ok(found)) = self.finder.take(placed) {
                self.shots.insert(found.trigger, found);
                if self.shots.len() > REMEMBERED {
                    self.shots.pop_first();
                }
            }
        }
        self.shots.get(&shot).map(|shot| shot.frames.as_slice())
    }
}
