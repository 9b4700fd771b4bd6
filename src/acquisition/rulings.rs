//! What comes of a burst: camera events, rulings, the ledger, the queue.

use std::time::Duration;

use lfpiv_hw::CameraName;

use super::{
    AcquisitionError, LedgerError, Outcome, Shot,
    controller::Run,
    devices::CameraEvent,
    journal::{Entry, FrameHead, FrameKey},
    pairing::Ruling,
};

impl Run {
    pub(super) async fn handle(
        &mut self,
        event: Option<CameraEvent>,
    ) -> Result<(), AcquisitionError> {
        match event {
            Some(CameraEvent::Frame { camera, frame, arrived, statistics }) => {
                // What time alone decides comes first: a replay, too, finds it decided.
                self.time_passes(arrived).await?;
                self.presence[camera].delivered();
                self.last_frame = self.time;
                self.ledger.lock().streamed(camera, statistics);
                let (at_ns, head) = (self.at_ns(), FrameHead::from(&frame));
                let entry = Entry::Frame { at_ns, camera, frame: head, statistics };
                // Even where it cannot be kept: what was delivered is paired and accounted for.
                let noted = self.note_frame(entry, &frame.image).await;
                self.pairing.underruns(camera, statistics.underruns);
                let rulings = self.pairing.frame(camera, frame, self.time);
                noted.and(self.apply(rulings).await)
            }
            Some(CameraEvent::Stream { camera, connected, at, statistics }) => {
                self.time_passes(at).await?;
                self.ledger.lock().streamed(camera, statistics);
                self.presence[camera].tell(connected);
                let at_ns = self.at_ns();
                self.note(Entry::Stream { at_ns, camera, connected, statistics }).await?;
                Ok(())
            }
            Some(CameraEvent::Started { camera, notices_absence_within }) => {
                self.presence[camera].notices_absence_within = notices_absence_within;
                tracing::debug!(camera = %CameraName(camera), "waits for triggers");
                Ok(())
            }
            Some(CameraEvent::Failed { error }) => Err(error.into()),
            None => Err(AcquisitionError::NoCamera),
        }
    }

    /// It is `now` at least: looks for frames that will not come. Events of two cameras may be
    /// stamped in another order than they are seen; time does not go back for that.
    pub(super) async fn time_passes(&mut self, now: Duration) -> Result<(), AcquisitionError> {
        self.time = self.time.max(now);
        let rulings = self.pairing.tick(self.time);
        self.apply(rulings).await
    }

    pub(super) async fn apply(&mut self, rulings: Vec<Ruling>) -> Result<(), AcquisitionError> {
        // The ledger is complete even where the record fails: the first failure is reported last.
        let mut ended = Ok(());
        for ruling in rulings {
            let applied = match ruling {
                Ruling::Given { trigger } => self.count(trigger).await,
                Ruling::Paired(shot) => self.send_on(shot).await,
                Ruling::Settled { trigger, camera, outcome } => {
                    self.settle(trigger, camera, outcome).await
                }
                Ruling::Withdrawn { trigger } => {
                    self.fired -= 1;
                    for camera in &mut self.presence {
                        camera.silent = camera.silent.saturating_sub(1);
                    }
                    self.note(Entry::Withdrawn { trigger }).await.map(|_| ())
                }
            };
            ended = ended.and(applied);
        }
        ended
    }

    /// A trigger is known to have been given.
    async fn count(&mut self, trigger: u64) -> Result<(), AcquisitionError> {
        {
            let mut ledger = self.ledger.lock();
            note(ledger.enter(trigger));
            ledger.timed(trigger, self.times.expected(trigger));
        }
        self.note(Entry::Given { trigger }).await.map(|_| ())
    }

    async fn settle(
        &mut self,
        trigger: u64,
        camera: usize,
        outcome: Outcome,
    ) -> Result<(), AcquisitionError> {
        // What is shed was nobody's fault, and there may be many at the end of a run.
        let name = CameraName(camera);
        if outcome == Outcome::Shed {
            tracing::debug!(trigger, camera = %name, "shed");
        } else {
            tracing::warn!(trigger, camera = %name, outcome = outcome.name(), "shot lost");
        }
        note(self.ledger.lock().settle(trigger, camera, outcome));
        self.note(Entry::Settled { trigger, camera, outcome }).await.map(|_| ())
    }

    async fn send_on(&mut self, mut shot: Shot) -> Result<(), AcquisitionError> {
        let trigger = shot.trigger;
        let received_ns = shot.cameras.iter().map(|[a, _]| a.host_timestamp_ns);
        shot.time = self.times.of_shot(trigger, received_ns);
        {
            let mut ledger = self.ledger.lock();
            ledger.queued(trigger, &shot.suspect);
            ledger.timed(trigger, shot.time);
        }
        let entry = Entry::Shot {
            trigger,
            frames: shot.cameras.iter().map(|ab| ab.each_ref().map(FrameKey::from)).collect(),
            residuals_ns: shot.residuals_ns.clone(),
            suspect: shot.suspect.clone(),
            dt_us: shot.dt_us,
        };
        let noted = self.note(entry).await;
        self.journal.paired(trigger, noted.as_ref().ok().copied().flatten());
        let shed = match self.queue.push(shot) {
            Ok(None) => return noted.map(|_| ()),
            Ok(Some(oldest)) => oldest.trigger,
            Err(_) => trigger,
        };
        note(self.ledger.lock().settle_all(shed, Outcome::Shed));
        let noted = noted.and(self.note(Entry::Shed { trigger: shed }).await);
        if shed == trigger { Err(AcquisitionError::QueueClosed) } else { noted.map(|_| ()) }
    }

    /// Events that come while the run is torn down cannot change how it ends.
    pub(super) async fn handle_leftover(&mut self, event: CameraEvent) {
        if let Err(error) = self.handle(Some(event)).await {
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
