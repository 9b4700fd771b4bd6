//! Writes the run's events and decisions to the journal.

use std::time::Duration;

use lfpiv_hw::{RawImage, synchroniser::line};
use lfpiv_rawlog::Record;

use super::{
    AcquisitionError,
    controller::Run,
    journal::{Entry, Offered},
};

/// How long the disk may stall before the run ends.
const DISK_PATIENCE: Duration = Duration::from_secs(60);

impl Run {
    /// Time of the last event, for the journal.
    pub(super) fn at_ns(&self) -> u64 {
        u64::try_from(self.time.as_nanos()).unwrap_or(u64::MAX)
    }

    /// Writes an entry; returns its number if a record is kept.
    pub(super) async fn record(&mut self, entry: Entry) -> Result<Option<u64>, AcquisitionError> {
        self.record_serial().await?;
        self.append(&entry, None).await
    }

    /// Writes a frame.
    pub(super) async fn record_frame(
        &mut self,
        entry: Entry,
        image: &RawImage,
    ) -> Result<(), AcquisitionError> {
        self.append(&entry, Some(image)).await.map(|_| ())
    }

    async fn append(
        &mut self,
        entry: &Entry,
        image: Option<&RawImage>,
    ) -> Result<Option<u64>, AcquisitionError> {
        self.times.see(entry);
        if self.log_failed {
            return Ok(None);
        }
        match self.journal.offer(entry, image) {
            Ok(Offered::Taken(number)) => Ok(number),
            Ok(Offered::Full(record)) => self.wait_for_disk(record).await,
            Err(error) => {
                // Reported once; the run ends after this.
                self.log_failed = true;
                Err(error.into())
            }
        }
    }

    /// Handles back-pressure from the disk. Nothing is dropped: the burst ends and the run waits.
    async fn wait_for_disk(&mut self, record: Record) -> Result<Option<u64>, AcquisitionError> {
        let mut safe = Ok(());
        // A burst may be running although another schedule was already requested.
        let may_fire = self.is_programmed || self.is_burst_open && !self.is_aborted;
        if may_fire {
            tracing::warn!("the disk is slower than the cameras: the laser is made safe");
            safe = self.abort_burst().await;
        }
        let journal = self.journal.clone();
        let added = journal.add(record);
        tokio::pin!(added);
        let given_up = tokio::time::sleep(DISK_PATIENCE);
        tokio::pin!(given_up);
        loop {
            tokio::select! {
                added = &mut added => {
                    self.log_failed = added.is_err();
                    // An unsafe laser matters more than a failed record.
                    return safe.and(added.map_err(Into::into));
                }
                () = &mut given_up => break,
                () = self.heartbeat.keep_alive() => {}
            }
        }
        self.log_failed = true;
        safe.and(Err(AcquisitionError::DiskHangs { seconds: DISK_PATIENCE.as_secs() }))
    }

    /// Records the bytes on the synchroniser's line since the last call.
    pub(super) async fn record_serial(&mut self) -> Result<(), AcquisitionError> {
        while let Some(Ok(bytes)) = self.transcript.as_mut().map(|transcript| transcript.try_recv())
        {
            let line::TranscriptEntry { host_time_ns, direction, bytes } = bytes;
            let bytes = bytes.escape_ascii().to_string();
            self.append(&Entry::Serial { host_time_ns, direction, bytes }, None).await?;
        }
        Ok(())
    }
}
