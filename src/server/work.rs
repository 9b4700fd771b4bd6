//! Answers that take time or memory to make: made outside the runtime's threads, few at a time.

use std::{sync::Arc, time::Duration};

use axum::body::Bytes;
use tokio::sync::{AcquireError, OwnedSemaphorePermit, Semaphore};

use super::ApiError;

/// Answers made at the same time. The cores belong to the reconstruction.
const AT_A_TIME: usize = 2;
/// Memory of the answers that are made or on their way, in units of [`UNIT_BYTES`]: 256 MB.
const MEMORY_UNITS: usize = 4096;
const UNIT_BYTES: usize = 1 << 16;

/// See the module. Cheap to clone.
#[derive(Clone)]
pub(super) struct Work {
    hands: Arc<Semaphore>,
    memory: Arc<Semaphore>,
    patience: Duration,
}

/// Bytes that keep their share of the memory until the last of them is sent.
struct Held {
    bytes: Vec<u8>,
    _memory: OwnedSemaphorePermit,
}

impl AsRef<[u8]> for Held {
    fn as_ref(&self) -> &[u8] {
        &self.bytes
    }
}

impl Work {
    /// Requests wait for `patience` and are then told to come again.
    pub fn new(patience: Duration) -> Self {
        let semaphore = |permits| Arc::new(Semaphore::new(permits));
        Self { hands: semaphore(AT_A_TIME), memory: semaphore(MEMORY_UNITS), patience }
    }

    /// Makes an answer of about `bytes` bytes.
    pub async fn make(
        &self,
        bytes: usize,
        job: impl FnOnce() -> Result<Vec<u8>, ApiError> + Send + 'static,
    ) -> Result<Bytes, ApiError> {
        let (memory, hand) = tokio::time::timeout(self.patience, self.acquire(bytes))
            .await
            .map_err(|_| ApiError::busy("the server is busy with other large answers"))?
            .map_err(|_| ApiError::busy("the server is ending"))?;
        let made = tokio::task::spawn_blocking(move || {
            let made = job();
            drop(hand);
            made
        });
        let bytes = made
            .await
            .map_err(|error| ApiError::internal(format!("the answer cannot be made: {error}")))??;
        Ok(Bytes::from_owner(Held { bytes, _memory: memory }))
    }

    async fn acquire(
        &self,
        bytes: usize,
    ) -> Result<(OwnedSemaphorePermit, OwnedSemaphorePermit), AcquireError> {
        let units = bytes.div_ceil(UNIT_BYTES).clamp(1, MEMORY_UNITS) as u32;
        let memory = self.memory.clone().acquire_many_owned(units).await?;
        Ok((memory, self.hands.clone().acquire_owned().await?))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[tokio::test]
    async fn memory_is_given_back_when_the_answer_is_sent() {
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
    async fn a_panic_costs_its_answer_only() {
        let work = Work::new(Duration::from_secs(5));
        for _ in 0..2 * AT_A_TIME {
            let ended = work.make(1, || panic!("bug")).await.unwrap_err();
            assert!(format!("{ended:?}").contains("cannot be made"));
        }
        assert_eq!(work.make(1, || Ok(vec![7])).await.unwrap().as_ref(), [7]);
    }
}
