//! Frames for previews: the latest from memory, earlier ones from the run's raw log.

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

/// See the module. The record is read beside the run that writes it.
pub(super) struct RecordedFrames {
    board: Arc<Board>,
    run: PathBuf,
    opened: Mutex<Option<FramePlaces>>,
    /// Of a run that is over.
    last: Option<u64>,
}

impl RecordedFrames {
    pub fn new(board: Arc<Board>, run: &Path) -> Self {
        Self { board, run: run.to_owned(), opened: Mutex::new(None), last: None }
    }

    /// Of a run that is over, the last frames are those of this shot.
    pub fn with_last(self, last: Option<u64>) -> Self {
        Self { last, ..self }
    }

    /// Looks on in the record where the last look ended.
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
