//! The run writes down what it sees and decides.

use std::time::Duration;

use lfpiv_hw::{RawImage, synchroniser::line};
use lfpiv_rawlog::Record;

use super::{
    AcquisitionError,
    controller::Run,
    journal::{Entry, Offered},
};

/// How long the disk may take nothing before the run is given up.
const DISK_PATIENCE: Duration = Duration::from_secs(60);

impl Run {
    /// The time of what was seen last, for the record.
    pub(super) fn at_ns(&self) -> u64 {
        u64::try_from(self.time.as_nanos()).unwrap_or(u64::MAX)
    }

    /// Writes an entry down; its number, when a record is kept.
    pub(super) async fn note(&mut self, entry: Entry) -> Result<Option<u64>, AcquisitionError> {
        self.note_serial().await?;
        self.append(&entry, None).await
    }

    /// Writes a frame down.
    pub(super) async fn note_frame(
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
                // It is told once; what follows is the run's end.
                self.log_failed = true;
                Err(error.into())
            }
        }
    }

    /// Frames come faster than the disk takes them. Nothing is dropped: the burst ends, and the
    /// run waits.
    async fn wait_for_disk(&mut self, record: Record) -> Result<Option<u64>, AcquisitionError> {
        let mut safe = Ok(());
        // A burst may run although another schedule is asked for already.
        let may_fire = self.is_programmed || self.is_burst_open && !self.broken_off;
        if may_fire {
            tracing::warn!("the disk is slower than the cameras: the laser is made safe");
            safe = self.break_off().await;
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
                    // A laser that is not safe matters more than a record that is kept.
                    return safe.and(added.map_err(Into::into));
                }
                () = &mut given_up => break,
                () = self.heartbeat.turn() => {}
            }
        }
        self.log_failed = true;
        safe.and(Err(AcquisitionError::DiskHangs { seconds: DISK_PATIENCE.as_secs() }))
    }

    /// Bytes that went over the synchroniser's line since.
    pub(super) async fn note_serial(&mut self) -> Result<(), AcquisitionError> {
        while let Some(Ok(bytes)) = self.transcript.as_mut().map(|transcript| transcript.try_recv())
        {
            let line::Entry { host_time_ns, direction, bytes } = bytes;
            let bytes = bytes.escape_ascii().to_string();
            self.append(&Entry::Serial { host_time_ns, direction, bytes }, None).await?;
        }
        Ok(())
    }
}
