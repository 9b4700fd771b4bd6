//! Limits CPU time and memory of large responses. They are made outside the runtime's threads, a
//! few at a time.

use std::{sync::Arc, time::Duration};

use axum::body::Bytes;
use tokio::sync::{AcquireError, OwnedSemaphorePermit, Semaphore};

use super::ApiError;

/// Responses made at the same time. The cores are needed for reconstruction.
const MAX_CONCURRENT: usize = 2;
/// Memory of responses being made or sent, in units of [`UNIT_BYTES`]: 256 MB.
const MEMORY_UNITS: usize = 4096;
const UNIT_BYTES: usize = 1 << 16;

/// Permits for large responses. Cheap to clone.
#[derive(Clone)]
pub(super) struct Work {
    slots: Arc<Semaphore>,
    memory: Arc<Semaphore>,
    patience: Duration,
}

/// The bytes of a response; they hold their memory permits until they are sent.
struct HeldBytes {
    bytes: Vec<u8>,
    _memory: OwnedSemaphorePermit,
}

impl AsRef<[u8]> for HeldBytes {
    fn as_ref(&self) -> &[u8] {
        &self.bytes
    }
}

impl Work {
    /// Requests that wait for longer than `patience` are refused as busy.
    pub fn new(patience: Duration) -> Self {
        let semaphore = |permits| Arc::new(Semaphore::new(permits));
        Self { slots: semaphore(MAX_CONCURRENT), memory: semaphore(MEMORY_UNITS), patience }
    }

    /// Makes a response of about `bytes` bytes by `job`.
    pub async fn make(
        &self,
        bytes: usize,
        job: impl FnOnce() -> Result<Vec<u8>, ApiError> + Send + 'static,
    ) -> Result<Bytes, ApiError> {
        let (memory, slot) = tokio::time::timeout(self.patience, self.acquire(bytes))
            .await
            .map_err(|_| ApiError::busy("the server is busy with other large responses"))?
            .map_err(|_| ApiError::busy("the server is shutting down"))?;
        let made = tokio::task::spawn_blocking(move || {
            let made = job();
            drop(slot);
            made
        });
        let bytes = made.await.map_err(|error| {
            ApiError::internal(format!("the response cannot be made: {error}"))
        })??;
        Ok(Bytes::from_owner(HeldBytes { bytes, _memory: memory }))
    }

    async fn acquire(
        &self,
        bytes: usize,
    ) -> Result<(OwnedSemaphorePermit, OwnedSemaphorePermit), AcquireError> {
        let units = bytes.div_ceil(UNIT_BYTES).clamp(1, MEMORY_UNITS) as u32;
        let memory = self.memory.clone().acquire_many_owned(units).await?;
        Ok((memory, self.slots.clone().acquire_owned().await?))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[tokio::test]
    async fn memory_is_released_when_the_response_is_sent() {
        let work = Work::new(Duration::from_millis(50));
        let all = work.make(MEMORY_UNITS * UNIT_BYTES, || Ok(vec![1, 2, 3])).await.unwrap();
        let part = all.slice(1..);
        drop(all);
        let refused = work.make(1, || Ok(Vec::new())).await.unwrap_err();
        assert!(format!("{refused:?}").contains("busy"), "{refused:?}");
        assert_eq!(part.as_ref(), [2, 3]);
        drop(part);
        assert!(work.make(1, || Ok(Vec::new())).await.is_ok());
    }

    #[tokio::test]
    async fn a_panic_fails_its_own_response_only() {
        let work = Work::new(Duration::from_secs(5));
        for _ in 0..2 * MAX_CONCURRENT {
            let ended = work.make(1, || panic!("bug")).await.unwrap_err();
            assert!(format!("{ended:?}").contains("cannot be made"));
        }
        assert_eq!(work.make(1, || Ok(vec![7])).await.unwrap().as_ref(), [7]);
    }
}
