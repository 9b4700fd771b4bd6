//! Placeholder until the raw log lands: keeps nothing, says that everything is safe.

use std::{sync::Arc, time::Duration};

use lfpiv_hw::RawImage;
use parking_lot::Mutex;
use thiserror::Error;
use tokio::sync::watch;

#[derive(Debug, Clone)]
pub struct Record {
    pub head: Vec<u8>,
    pub image: Option<RawImage>,
}

#[derive(Debug, Clone, Copy, Default, PartialEq, Eq)]
pub struct Watermarks {
    pub appended: u64,
    pub written: u64,
    pub synced: u64,
    pub bytes_in: u64,
    pub bytes_written: u64,
    pub segments: u64,
}

#[derive(Debug, Error)]
#[error("raw log")]
pub struct RawLogError;

#[derive(Debug)]
pub enum AppendError {
    Full(Record),
    Failed(Arc<RawLogError>),
}

#[derive(Debug, Clone)]
pub struct RawLog {
    marks: Arc<Mutex<Watermarks>>,
    watch: watch::Sender<Watermarks>,
}

impl RawLog {
    pub fn try_append(&self, _record: Record) -> Result<u64, AppendError> {
        let mut marks = self.marks.lock();
        marks.appended += 1;
        Ok(marks.appended - 1)
    }
    pub async fn append(&self, _record: Record) -> Result<u64, Arc<RawLogError>> {
        tokio::time::sleep(Duration::ZERO).await;
        Err(Arc::new(RawLogError))
    }
    pub fn watermarks(&self) -> Watermarks {
        *self.marks.lock()
    }
    pub fn watch(&self) -> watch::Receiver<Watermarks> {
        self.watch.subscribe()
    }
    pub fn reserve(&self, _bytes: u64) -> Result<(), Arc<RawLogError>> {
        Ok(())
    }
    pub fn failure(&self) -> Option<Arc<RawLogError>> {
        None
    }
}
