//! Cameras that vanish: nothing is fired without them, and they are waited for.

use std::time::Instant;

use lfpiv_hw::CameraName;

use super::{AcquisitionError, controller::Run, presence::Presence};

impl Run {
    /// Whether every camera answers.
    pub(super) fn all_connected(&self) -> bool {
        self.presence.iter().all(|camera| !camera.away)
    }

    /// Whether any camera does.
    pub(super) fn any_connected(&self) -> bool {
        self.presence.iter().any(|camera| !camera.away)
    }

    /// Waits until every camera answers, laser safe; false when the run is stopped meanwhile. How
    /// long, the drivers decide: a camera that is given up ends the run. After a loss of the
    /// synchroniser each camera has to show itself, or its driver has time to notice that it is gone.
    pub(super) async fn await_cameras(&mut self) -> Result<bool, AcquisitionError> {
        if !self.all_connected() {
            self.make_safe().await?;
            tracing::warn!("nothing is fired until every camera answers again");
        }
        while !self.all_connected() || self.presence.iter().any(Presence::is_unsure) {
            tokio::select! {
                () = self.stop.cancelled() => return Ok(false),
                error = self.synchroniser.fault() => return Err(error),
                () = self.heartbeat.turn() => {}
                event = self.events.recv() => self.handle(event).await?,
                request = self.control.next() => self.handle_request(request).await?,
            }
        }
        if self.presence.iter().any(|camera| camera.returned) {
            self.take_up_again().await?;
        }
        Ok(true)
    }

    /// The unit is programmed anew, and pairing learns the clock of each camera that was away.
    async fn take_up_again(&mut self) -> Result<(), AcquisitionError> {
        self.make_safe().await?;
        self.program().await?;
        for (index, camera) in self.presence.iter_mut().enumerate() {
            if std::mem::take(&mut camera.returned) {
                camera.silent = 0;
                self.pairing.camera_returned(index);
                tracing::info!(camera = %CameraName(index), "is back and taken up again");
            }
        }
        Ok(())
    }

    /// A camera is silent: whether its driver finds, in the time it needs, that it has vanished.
    pub(super) async fn has_vanished(&mut self, camera: usize) -> Result<bool, AcquisitionError> {
        self.make_safe().await?;
        let noticed_by = Instant::now() + self.presence[camera].notices_absence_within;
        while !self.presence[camera].away && !self.presence[camera].returned {
            let left = noticed_by.saturating_duration_since(Instant::now());
            tokio::select! {
                () = self.stop.cancelled() => return Ok(true),
                error = self.synchroniser.fault() => return Err(error),
                () = self.heartbeat.turn() => {}
                event = self.events.recv() => self.handle(event).await?,
                request = self.control.next() => self.handle_request(request).await?,
                () = tokio::time::sleep(left) => return Ok(false),
            }
        }
        Ok(true)
    }
}
