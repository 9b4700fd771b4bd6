//! Shots of a run that wait until their records are on disk.

use std::{collections::BTreeMap, time::Duration};

use lfpiv_rawlog::LogWatermarks;
use parking_lot::Mutex;
use tokio::sync::{Notify, watch};

use crate::{acquisition::Journal, archive::RawLevel};

/// Numbers only: the frames are on disk, so that the backlog of a long run fits in memory.
pub(super) struct Backlog {
    journal: Journal,
    state: Mutex<State>,
    changed: Notify,
}

#[derive(Default)]
struct State {
    /// Shots whose records may not be on disk.
    waiting: BTreeMap<u64, Duration>,
    /// When the triggers of the others were due, until they are settled.
    published: BTreeMap<u64, Duration>,
    is_closed: bool,
}

/// What became of a shot's record.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Recorded {
    /// It survives a power cut.
    Synced(u64),
    /// It is gone: the disk has failed.
    Lost(u64),
}

impl Backlog {
    pub fn new(journal: Journal) -> Self {
        Self { journal, state: Mutex::default(), changed: Notify::new() }
    }

    /// A shot was taken; its trigger was due then.
    pub fn add(&self, shot: u64, due: Duration) {
        self.state.lock().waiting.insert(shot, due);
        self.changed.notify_one();
    }

    /// No more shots are taken.
    pub fn close(&self) {
        self.state.lock().is_closed = true;
        self.changed.notify_one();
    }

    /// Number of shots that [`Self::next`] has not returned.
    pub fn waiting(&self) -> usize {
        self.state.lock().waiting.len()
    }

    /// The next shot whose record is on disk, or lost; `None` once it is closed and empty.
    pub async fn next(&self) -> Option<Recorded> {
        let mut marks = self.journal.log().map(lfpiv_rawlog::RawLog::watch);
        loop {
            // Before the look, so that no sync is missed.
            if let Some(marks) = &mut marks {
                marks.borrow_and_update();
            }
            if let Some(found) = self.look() {
                return found;
            }
            tokio::select! {
                () = self.changed.notified() => {}
                () = synced(marks.as_mut()) => {}
            }
        }
    }

    fn look(&self) -> Option<Option<Recorded>> {
        let mut state = self.state.lock();
        let Some((&shot, &due)) = state.waiting.first_key_value() else {
            return state.is_closed.then_some(None);
        };
        let recorded = match self.journal.level(shot) {
            RawLevel::Acquired | RawLevel::Written => return None,
            RawLevel::Synced => Recorded::Synced(shot),
            RawLevel::Lost | RawLevel::NotKept => Recorded::Lost(shot),
        };
        state.waiting.remove(&shot);
        state.published.insert(shot, due);
        Some(Some(recorded))
    }

    /// When the trigger of a shot was due; it is settled now.
    pub fn settle(&self, shot: u64) -> Duration {
        self.state.lock().published.remove(&shot).unwrap_or_default()
    }

    /// The shots that nobody has settled.
    pub fn unsettled(&self) -> Vec<u64> {
        let state = self.state.lock();
        state.published.keys().chain(state.waiting.keys()).copied().collect()
    }
}

/// Waits for the next sync, or failure, of the record.
async fn synced(marks: Option<&mut watch::Receiver<LogWatermarks>>) {
    if let Some(marks) = marks
        && marks.changed().await.is_ok()
    {
        return;
    }
    // Once the log is closed, nothing changes any more.
    std::future::pending().await
}
