//! Frames for previews: the latest ones from memory, earlier ones from the run's raw log.

use std::{
    path::{Path, PathBuf},
    sync::Arc,
};

use lfpiv_hw::RawImage;
use parking_lot::Mutex;

use crate::{
    acquisition::journal::{FramePlaces, RecordedRun},
    pipeline::Board,
    server::FrameSource,
};

/// Source of frames. It may read the record while the run writes it.
pub(super) struct RecordedFrames {
    board: Arc<Board>,
    run: PathBuf,
    opened: Mutex<Option<FramePlaces>>,
    /// The last shot of a finished run.
    last: Option<u64>,
}

impl RecordedFrames {
    pub fn new(board: Arc<Board>, run: &Path) -> Self {
        Self { board, run: run.to_owned(), opened: Mutex::new(None), last: None }
    }

    /// Sets the shot that counts as the latest of a finished run.
    pub fn with_last(self, last: Option<u64>) -> Self {
        Self { last, ..self }
    }

    /// Reads a frame from the record, continuing where the last search ended.
    fn recorded(&self, shot: u64, camera: usize, half: usize) -> Option<RawImage> {
        let mut opened = self.opened.lock();
        if opened.is_none() {
            *opened = Some(FramePlaces::new(RecordedRun::open(&self.run).ok()?));
        }
        let places = opened.as_mut()?;
        let place = places.of(shot)?.get(camera)?[half];
        places.run().image(place).ok()
    }
}

impl FrameSource for RecordedFrames {
    fn frame(&self, shot: u64, camera: usize, half: usize) -> Option<RawImage> {
        let latest = self.board.gallery().frame(shot, camera, half);
        latest.or_else(|| self.recorded(shot, camera, half))
    }

    fn latest(&self) -> Option<u64> {
        self.board.gallery().latest_frames().or(self.last)
    }
}
