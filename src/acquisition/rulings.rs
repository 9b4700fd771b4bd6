//! What comes of a burst: camera events, rulings, the ledger, the queue.

use std::time::Instant;

use tokio::sync::mpsc;

use super::{
    AcquisitionError, LedgerError, Outcome, Shot, controller::Run, devices::CameraEvent,
    pairing::Ruling,
};

impl Run {
    pub(super) fn handle(&mut self, event: Option<CameraEvent>) -> Result<(), AcquisitionError> {
        match event {
            Some(CameraEvent::Frame { camera, frame, statistics }) => {
                self.presence[camera].silent = 0;
                self.last_frame = Instant::now();
                self.ledger.lock().streamed(camera, statistics);
                self.pairing.underruns(camera, statistics.underruns);
                let rulings = self.pairing.frame(camera, frame, self.began.elapsed());
                self.apply(rulings)
            }
            Some(CameraEvent::Stream { camera, connected, statistics }) => {
                self.ledger.lock().streamed(camera, statistics);
                self.presence[camera].tell(connected);
                Ok(())
            }
            Some(CameraEvent::Started { camera, notices_absence_within }) => {
                self.presence[camera].notices_absence_within = notices_absence_within;
                tracing::debug!(camera, "waits for triggers");
                Ok(())
            }
            Some(CameraEvent::Failed { error }) => Err(error.into()),
            None => Err(AcquisitionError::NoCamera),
        }
    }

    pub(super) fn apply(&mut self, rulings: Vec<Ruling>) -> Result<(), AcquisitionError> {
        for ruling in rulings {
            match ruling {
                Ruling::Paired(shot) => self.send_on(shot)?,
                Ruling::Settled { trigger, camera, outcome } => {
                    // What is shed was nobody's fault, and there may be many at the end of a run.
                    if outcome == Outcome::Shed {
                        tracing::debug!(trigger, camera, "shed");
                    } else {
                        tracing::warn!(trigger, camera, outcome = outcome.name(), "shot lost");
                    }
                    note(self.ledger.lock().settle(trigger, camera, outcome));
                }
                Ruling::Withdrawn { trigger } => {
                    self.fired -= 1;
                    note(self.ledger.lock().withdraw(trigger));
                }
            }
        }
        Ok(())
    }

    fn send_on(&mut self, shot: Shot) -> Result<(), AcquisitionError> {
        let trigger = shot.trigger;
        self.ledger.lock().queued(trigger, &shot.suspect);
        if let Some(place) = self.places.pop_front() {
            place.send(shot);
            return Ok(());
        }
        match self.queue.try_send(shot) {
            Ok(()) => Ok(()),
            Err(refused) => {
                note(self.ledger.lock().settle_all(trigger, Outcome::Shed));
                match refused {
                    mpsc::error::TrySendError::Full(_) => Ok(()),
                    mpsc::error::TrySendError::Closed(_) => Err(AcquisitionError::QueueClosed),
                }
            }
        }
    }

    /// Events that come while the run is torn down cannot change how it ends.
    pub(super) fn handle_leftover(&mut self, event: CameraEvent) {
        if let Err(error) = self.handle(Some(event)) {
            tracing::warn!(%error, "while the run was ending");
        }
    }
}

/// A refused entry is a fault of this program, never of the bench: it is told, and the run goes on.
pub(super) fn note(entry: Result<(), LedgerError>) {
    if let Err(error) = entry {
        tracing::error!(%error, "the ledger refused an entry");
    }
}
