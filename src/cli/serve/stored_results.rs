//! The results of a run that is over, read from its files as they are asked for.

use std::{collections::VecDeque, path::Path, sync::Arc};

use parking_lot::Mutex;

use crate::{
    archive::{ArchiveError, RunResults, ShotResult},
    pipeline::{Board, Lookup, RESULTS_IN_MEMORY, ShotRecord, Stage},
    server::ResultSource,
};

/// Results that are kept beside those on the board: who looks at a shot looks at its neighbours.
const KEPT: usize = 16;

/// Shots whose numbers are read at once, for the list of shots.
const LISTED: usize = 200;

/// See the module.
pub(super) struct StoredRun {
    results: RunResults,
    board: Option<Arc<Board>>,
    kept: Mutex<VecDeque<(u64, Arc<ShotResult>)>>,
}

impl StoredRun {
    /// Looks through the folder of a run whose voxels have this edge.
    pub fn open(run: &Path, voxel_mm: f64) -> Result<Self, ArchiveError> {
        let results = RunResults::find(run, voxel_mm)?;
        Ok(Self { results, board: None, kept: Mutex::default() })
    }

    /// Number of shots with a result.
    pub fn len(&self) -> usize {
        self.results.len()
    }

    /// Their numbers, in order.
    pub fn shots(&self) -> impl Iterator<Item = u64> {
        self.results.shots()
    }

    /// The last of them.
    pub fn last(&self) -> Option<u64> {
        self.results.shots().next_back()
    }

    /// Puts the last results on a board, and a record of every other one. What cannot be read is logged.
    pub fn put_on(&self, board: &Board) {
        let first_kept = self.len().saturating_sub(RESULTS_IN_MEMORY);
        let first_listed = self.len().saturating_sub(LISTED);
        for (n, shot) in self.shots().enumerate().skip(first_listed) {
            let read = self.read(shot).unwrap_or_else(|error| {
                tracing::warn!(shot, "{error}");
                None
            });
            board.restore(record(shot, read.as_deref()), read.filter(|_| n >= first_kept));
        }
        for shot in self.shots().take(first_listed) {
            board.restore(record(shot, None), None);
        }
    }

    /// Results on this board are not read again.
    pub fn with_board(mut self, board: Arc<Board>) -> Self {
        self.board = Some(board);
        self
    }

    fn read(&self, shot: u64) -> Result<Option<Arc<ShotResult>>, ArchiveError> {
        Ok(self.results.read(shot)?.map(Arc::new))
    }
}

impl ResultSource for StoredRun {
    fn result(&self, shot: u64) -> Lookup {
        let on_board = self.board.as_ref().map_or(Lookup::Unknown, |board| board.result(shot));
        if matches!(on_board, Lookup::Here(_)) {
            return on_board;
        }
        if let Some((_, result)) = self.kept.lock().iter().find(|(kept, _)| *kept == shot) {
            return Lookup::Here(result.clone());
        }
        match self.read(shot) {
            Ok(Some(result)) => {
                let mut kept = self.kept.lock();
                kept.push_back((shot, result.clone()));
                if kept.len() > KEPT {
                    kept.pop_front();
                }
                Lookup::Here(result)
            }
            Ok(None) => on_board,
            Err(error) => {
                tracing::warn!(shot, "{error}");
                on_board
            }
        }
    }
}

/// A shot as the board remembers it; of one that is not read, only that it has a result.
fn record(shot: u64, result: Option<&ShotResult>) -> ShotRecord {
    let measured = result.map(|result| &result.measured);
    ShotRecord {
        shot,
        stage: Stage::Done,
        message: None,
        warnings: Vec::new(),
        fit: measured.and_then(|measured| measured.fit.clone()),
        vectors: measured.map(|measured| measured.field.grid.len()),
        valid_share: measured.map(|measured| measured.field.valid_share()),
        seconds: measured.map(|measured| measured.seconds),
    }
}
