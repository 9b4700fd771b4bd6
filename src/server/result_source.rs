//! Where results are taken from: those in memory, or the files of a run.

use crate::pipeline::{Board, Lookup};

/// Source of results.
pub trait ResultSource: Send + Sync + 'static {
    /// The result of a shot, or why there is none. May read from disk, so it is not called on the
    /// runtime's threads.
    fn result(&self, shot: u64) -> Lookup;
}

/// The results in memory.
impl ResultSource for Board {
    fn result(&self, shot: u64) -> Lookup {
        self.result(shot)
    }
}
