//! Applies events and pairing decisions to the ledger, the journal and the queue.

use std::time::Duration;

use lfpiv_hw::CameraName;

use super::{
    AcquisitionError, LedgerError, Outcome, Shot,
    controller::Run,
    devices::CameraEvent,
    journal::{Entry, FrameHead, FrameKey},
    pairing::Decision,
};

impl Run {
    pub(super) async fn handle(
        &mut self,
        event: Option<CameraEvent>,
    ) -> Result<(), AcquisitionError> {
        match event {
            Some(CameraEvent::Frame { camera, frame, arrived, statistics }) => {
                // Time-dependent decisions come first, so that a replay finds them in the same order.
                self.advance_time(arrived).await?;
                self.presence[camera].delivered();
                self.last_frame = self.time;
                self.ledger.lock().set_stream_statistics(camera, statistics);
                let (at_ns, head) = (self.at_ns(), FrameHead::from(&frame));
                let entry = Entry::Frame { at_ns, camera, frame: head, statistics };
                // Even if it cannot be recorded: delivered frames are paired and accounted for.
                let recorded = self.record_frame(entry, &frame.image).await;
                self.pairing.underruns(camera, statistics.underruns);
                let decisions = self.pairing.frame(camera, frame, self.time);
                recorded.and(self.apply(decisions).await)
            }
            Some(CameraEvent::Stream { camera, connected, at, statistics }) => {
                self.advance_time(at).await?;
                {
                    let mut ledger = self.ledger.lock();
                    ledger.set_stream_statistics(camera, statistics);
                    ledger.set_connected(camera, connected);
                }
                self.presence[camera].set_connected(connected);
                let at_ns = self.at_ns();
                self.record(Entry::Stream { at_ns, camera, connected, statistics }).await?;
                Ok(())
            }
            Some(CameraEvent::Started { camera, loss_detection_time }) => {
                self.presence[camera].loss_detection_time = loss_detection_time;
                tracing::debug!(camera = %CameraName(camera), "waits for triggers");
                Ok(())
            }
            Some(CameraEvent::Failed { error }) => Err(error.into()),
            None => Err(AcquisitionError::NoCamera),
        }
    }

    /// Advances time to at least `now` and checks for overdue frames. Events of two cameras may be
    /// stamped in another order than they are received; time never goes back.
    pub(super) async fn advance_time(&mut self, now: Duration) -> Result<(), AcquisitionError> {
        self.time = self.time.max(now);
        let decisions = self.pairing.tick(self.time);
        self.apply(decisions).await
    }

    pub(super) async fn apply(&mut self, decisions: Vec<Decision>) -> Result<(), AcquisitionError> {
        // The ledger stays complete even if recording fails: the first failure is returned at the end.
        let mut ended = Ok(());
        for ruling in decisions {
            let applied = match ruling {
                Decision::Given { trigger } => self.count(trigger).await,
                Decision::Paired(shot) => self.send_on(shot).await,
                Decision::Settled { trigger, camera, outcome } => {
                    self.settle(trigger, camera, outcome).await
                }
                Decision::Withdrawn { trigger } => {
                    self.fired -= 1;
                    for camera in &mut self.presence {
                        camera.silent = camera.silent.saturating_sub(1);
                    }
                    self.record(Entry::Withdrawn { trigger }).await.map(|_| ())
                }
            };
            ended = ended.and(applied);
        }
        ended
    }

    /// Counts a trigger that is known to have been given.
    async fn count(&mut self, trigger: u64) -> Result<(), AcquisitionError> {
        {
            let mut ledger = self.ledger.lock();
            log_refusal(ledger.enter(trigger));
            ledger.set_time(trigger, self.times.expected(trigger));
        }
        self.record(Entry::Given { trigger }).await.map(|_| ())
    }

    async fn settle(
        &mut self,
        trigger: u64,
        camera: usize,
        outcome: Outcome,
    ) -> Result<(), AcquisitionError> {
        // Shedding is no fault, and there may be many shed shots at the end of a run.
        let name = CameraName(camera);
        if outcome == Outcome::Shed {
            tracing::debug!(trigger, camera = %name, "shed");
        } else {
            tracing::warn!(trigger, camera = %name, outcome = outcome.name(), "shot lost");
        }
        log_refusal(self.ledger.lock().settle(trigger, camera, outcome));
        self.record(Entry::Settled { trigger, camera, outcome }).await.map(|_| ())
    }

    async fn send_on(&mut self, mut shot: Shot) -> Result<(), AcquisitionError> {
        let trigger = shot.trigger;
        let received_ns = shot.cameras.iter().map(|[a, _]| a.host_timestamp_ns);
        shot.time = self.times.of_shot(trigger, received_ns);
        {
            let mut ledger = self.ledger.lock();
            ledger.mark_queued(trigger, &shot.suspect);
            ledger.set_time(trigger, shot.time);
        }
        let entry = Entry::Shot {
            trigger,
            frames: shot.cameras.iter().map(|ab| ab.each_ref().map(FrameKey::from)).collect(),
            residuals_ns: shot.residuals_ns.clone(),
            suspect: shot.suspect.clone(),
            dt_us: shot.dt_us,
        };
        let recorded = self.record(entry).await;
        self.journal.paired(trigger, recorded.as_ref().ok().copied().flatten());
        let shed = match self.queue.push(shot) {
            Ok(None) => return recorded.map(|_| ()),
            Ok(Some(oldest)) => oldest.trigger,
            Err(_) => trigger,
        };
        log_refusal(self.ledger.lock().settle_all(shed, Outcome::Shed));
        let recorded = recorded.and(self.record(Entry::Shed { trigger: shed }).await);
        if shed == trigger { Err(AcquisitionError::QueueClosed) } else { recorded.map(|_| ()) }
    }

    /// Handles an event during shutdown, which cannot change the result of the run.
    pub(super) async fn handle_leftover(&mut self, event: CameraEvent) {
        if let Err(error) = self.handle(Some(event)).await {
            tracing::warn!(%error, "while the run was ending");
        }
    }
}

/// A refused entry is a bug of this program: it is logged, and the run continues.
fn log_refusal(entry: Result<(), LedgerError>) {
    if let Err(error) = entry {
        tracing::error!(%error, "the ledger refused an entry (a fault of this program)");
    }
}
