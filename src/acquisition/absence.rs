//! Lost cameras: the run fires nothing without them and waits for their return.

use std::time::Instant;

use lfpiv_hw::CameraName;

use super::{AcquisitionError, controller::Run, presence::Presence};

impl Run {
    /// Whether every camera is connected.
    pub(super) fn all_connected(&self) -> bool {
        self.presence.iter().all(|camera| !camera.away)
    }

    /// Whether any camera is connected.
    pub(super) fn any_connected(&self) -> bool {
        self.presence.iter().any(|camera| !camera.away)
    }

    /// Waits, with the laser safe, until every camera is connected; false when the run is stopped
    /// meanwhile. The drivers decide how long: a driver that gives up ends the run. After a loss of the
    /// synchroniser each camera must prove its presence, or outlast its driver's detection time.
    pub(super) async fn await_cameras(&mut self) -> Result<bool, AcquisitionError> {
        if !self.all_connected() {
            self.make_safe().await?;
            tracing::warn!("firing is suspended until every camera answers again");
        }
        while !self.all_connected() || self.presence.iter().any(Presence::is_unconfirmed) {
            tokio::select! {
                () = self.stop.cancelled() => return Ok(false),
                error = self.synchroniser.fault() => return Err(error),
                () = self.heartbeat.keep_alive() => {}
                event = self.events.recv() => self.handle(event).await?,
                request = self.control.next() => self.handle_request(request).await?,
            }
        }
        if self.presence.iter().any(|camera| camera.returned) {
            self.resume_after_absence().await?;
        }
        Ok(true)
    }

    /// Reprograms the synchroniser and restarts the clock fit of each camera that was away.
    async fn resume_after_absence(&mut self) -> Result<(), AcquisitionError> {
        self.make_safe().await?;
        self.program().await?;
        for (index, camera) in self.presence.iter_mut().enumerate() {
            if std::mem::take(&mut camera.returned) {
                camera.silent = 0;
                self.pairing.camera_returned(index);
                tracing::info!(camera = %CameraName(index), "is back");
            }
        }
        Ok(())
    }

    /// After a camera fell silent: whether its driver reports a lost connection within its
    /// detection time.
    pub(super) async fn has_vanished(&mut self, camera: usize) -> Result<bool, AcquisitionError> {
        self.make_safe().await?;
        let noticed_by = Instant::now() + self.presence[camera].loss_detection_time;
        while !self.presence[camera].away && !self.presence[camera].returned {
            let left = noticed_by.saturating_duration_since(Instant::now());
            tokio::select! {
                () = self.stop.cancelled() => return Ok(true),
                error = self.synchroniser.fault() => return Err(error),
                () = self.heartbeat.keep_alive() => {}
                event = self.events.recv() => self.handle(event).await?,
                request = self.control.next() => self.handle_request(request).await?,
                () = tokio::time::sleep(left) => return Ok(false),
            }
        }
        Ok(true)
    }
}
