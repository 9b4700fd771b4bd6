//! Positions of the latest shots' frames in a growing record.

use std::{collections::BTreeMap, iter};

use lfpiv_rawlog::Position;

use super::{LocatedEntry, RecordedRun, RecordedRunError, RecordedShot, recorded::ShotFinder};

/// Number of shots kept.
const REMEMBERED: usize = 10_000;

/// See the module.
pub struct FramePlaces {
    run: RecordedRun,
    entries: Box<dyn Iterator<Item = Result<LocatedEntry, RecordedRunError>> + Send>,
    finder: ShotFinder,
    shots: BTreeMap<u64, RecordedShot>,
}

impl FramePlaces {
    /// Starts at the beginning of the record.
    pub fn new(run: RecordedRun) -> Self {
        let entries = Box::new(run.entries());
        Self { run, entries, finder: ShotFinder::default(), shots: BTreeMap::new() }
    }

    /// The record.
    pub fn run(&self) -> &RecordedRun {
        &self.run
    }

    /// Positions of frames a and b of each camera of a shot; `None` as for [`Self::shot`].
    pub fn of(&mut self, shot: u64) -> Option<&[[Position; 2]]> {
        self.shot(shot).map(|shot| shot.frames.as_slice())
    }

    /// A shot; `None` if the record has no such shot (yet) or it was dropped. Continues reading where the last
    /// call stopped.
    pub fn shot(&mut self, shot: u64) -> Option<&RecordedShot> {
        // After a read error, the next call tries again.
        for placed in iter::from_fn(|| self.entries.next()?.ok()) {
            if let Some(Ok(found)) = self.finder.take(placed) {
                self.shots.insert(found.trigger, found);
                if self.shots.len() > REMEMBERED {
                    self.shots.pop_first();
                }
            }
        }
        self.shots.get(&shot)
    }
}
