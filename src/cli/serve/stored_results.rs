//! Results of a finished run, read from its files on request.

use std::{collections::VecDeque, path::Path, sync::Arc};

use parking_lot::Mutex;

use crate::{
    archive::{ArchiveError, RunResults, ShotResult},
    pipeline::{Board, Lookup, RESULTS_IN_MEMORY, ShotRecord, Stage},
    server::ResultSource,
};

/// Results cached in addition to those on the board, because users move between neighbouring shots.
const CACHED: usize = 16;

/// Number of last shots whose results are read at the start for the list of shots.
const LISTED: usize = 200;

/// The stored results of a run, with a cache.
pub(super) struct StoredRun {
    results: RunResults,
    board: Option<Arc<Board>>,
    kept: Mutex<VecDeque<(u64, Arc<ShotResult>)>>,
}

impl StoredRun {
    /// Indexes the folder of a run; `voxel_mm` is its voxel size.
    pub fn open(run: &Path, voxel_mm: f64) -> Result<Self, ArchiveError> {
        let results = RunResults::find(run, voxel_mm)?;
        Ok(Self { results, board: None, kept: Mutex::default() })
    }

    /// Number of shots with a result.
    pub fn len(&self) -> usize {
        self.results.len()
    }

    /// The shots with a result, ascending.
    pub fn shots(&self) -> impl Iterator<Item = u64> {
        self.results.shots()
    }

    /// The last shot with a result.
    pub fn last(&self) -> Option<u64> {
        self.results.shots().next_back()
    }

    /// Puts the last results, and a record of every shot, on a board. Unreadable results are
    /// logged.
    pub fn fill(&self, board: &Board) {
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

    /// Sets the board whose results need not be read again.
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
                if kept.len() > CACHED {
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

/// The board's record of a shot; without a result it states only that there is one.
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
