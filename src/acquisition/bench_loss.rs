//! Loss of the synchroniser: the run fires nothing without it and searches for it.
//!
//! The unit ends the current burst by itself. Frames are accepted until no more can arrive;
//! triggers that were due and that no camera saw are `not_fired`. A unit that answers again is made
//! safe, read back and programmed from scratch. The run then waits for an operator, unless
//! the configuration lets it resume by itself.

use std::time::{Duration, Instant};

use tokio::sync::oneshot::error::TryRecvError;

use super::{
    AcquisitionError, Mode,
    burst::TICK,
    controller::Run,
    journal::Entry,
    loss::Loss,
    synchroniser::{UnsafeState, thread_ended},
};

/// Interval between search attempts at first: a plug may just have slipped.
const EARLY_INTERVAL: Duration = Duration::from_secs(1);
/// The interval once the unit has been lost for longer than [`EARLY_PHASE`].
const LATE_INTERVAL: Duration = Duration::from_secs(10);
const EARLY_PHASE: Duration = Duration::from_secs(60);
/// Poll interval of the run loop while it waits for the unit only.
const POLL_INTERVAL: Duration = Duration::from_millis(100);

impl Run {
    /// Whether the run survives this error.
    pub(super) fn survives(&self, error: &AcquisitionError) -> bool {
        // A replayed run does what the recorded run did.
        error.is_loss() && (self.waiting.is_some() || self.bursts.is_some())
    }

    /// Handles a lost unit: waits until it is back, safe and programmed. False when the run is over: it
    /// was stopped, or nothing is left to fire.
    ///
    /// # Errors
    ///
    /// The unit did not return in time, or another error ended the run. A loss error when the unit was
    /// lost again.
    pub(super) async fn await_bench(
        &mut self,
        error: AcquisitionError,
    ) -> Result<bool, AcquisitionError> {
        if self.bursts.is_some() {
            self.close_lost_burst().await?;
            return self.settle_all_triggers().await;
        }
        self.record_loss(&error).await?;
        if !self.search_unit(error).await? {
            return Ok(false);
        }
        self.program().await?;
        self.resume_with_bench();
        Ok(true)
    }

    /// Waits until every trigger has an outcome; false when the run is stopped meanwhile.
    async fn settle_all_triggers(&mut self) -> Result<bool, AcquisitionError> {
        while self.pairing.open_triggers() > 0 && !self.stop.is_cancelled() {
            self.tick().await?;
            self.handle_next_event(TICK).await?;
        }
        Ok(!self.stop.is_cancelled())
    }

    async fn record_loss(&mut self, error: &AcquisitionError) -> Result<(), AcquisitionError> {
        // The state of the unit is unknown.
        (self.is_programmed, self.is_armed, self.is_aborted) = (false, false, true);
        self.synchroniser.forget_fault();
        let now = Instant::now();
        let reason = error.to_string();
        if let Some(loss) = &mut self.loss {
            // Lost again before it was programmed: the next attempt is not immediate.
            loss.next_attempt = now + interval(loss.since.elapsed());
            return Ok(());
        }
        for camera in &mut self.presence {
            camera.suspect_loss(now);
        }
        let resume_mode = self.awaits_operator.take().unwrap_or_else(|| self.mode());
        let last_message = format!("the synchroniser does not answer; searching for it: {reason}");
        tracing::error!("the bench is lost and firing is suspended. {last_message}");
        {
            let mut state = self.control.state.lock();
            (state.mode, state.held) = (Mode::Lost, vec![last_message.clone()]);
        }
        self.loss =
            Some(Loss { since: now, resume_mode, last_message, next_attempt: now, attempt: None });
        self.record(Entry::SynchroniserLost { at_ns: self.at_ns(), reason }).await.map(|_| ())
    }

    /// Searches for the unit and meanwhile finishes the accounts of the current burst.
    async fn search_unit(&mut self, error: AcquisitionError) -> Result<bool, AcquisitionError> {
        let mut identity = None;
        loop {
            self.record_serial().await?;
            self.tick().await?;
            if self.is_burst_open && self.is_burst_over() {
                self.close_lost_burst().await?;
            }
            let settled = !self.is_burst_open && self.pairing.open_triggers() == 0;
            if self.stop.is_cancelled() || settled && self.has_fired_all() {
                return Ok(false);
            }
            if identity.is_none() {
                identity = self.poll_attempt()?;
            }
            if let Some(identity) = identity.take_if(|_| settled) {
                tracing::warn!(identity, "the synchroniser is back and safe");
                self.identity.clone_from(&identity);
                self.record(Entry::SynchroniserBack { at_ns: self.at_ns(), identity }).await?;
                return Ok(true);
            }
            if let Some(patience) = self.expired_patience().filter(|_| identity.is_none()) {
                let (seconds, before) = (patience.as_secs_f64(), Box::new(error));
                return Err(AcquisitionError::NotReconnected { seconds, before });
            }
            self.handle_next_event(if settled { POLL_INTERVAL } else { TICK }).await?;
        }
    }

    /// Starts a search attempt when it is due, or collects its result: the unit's identity.
    fn poll_attempt(&mut self) -> Result<Option<String>, AcquisitionError> {
        let Some(loss) = &mut self.loss else { return Ok(None) };
        let now = Instant::now();
        let Some(attempt) = &mut loss.attempt else {
            if now >= loss.next_attempt {
                loss.attempt = Some(self.synchroniser.start_search()?);
            }
            return Ok(None);
        };
        let found = match attempt.try_recv() {
            Ok(found) => found,
            Err(TryRecvError::Empty) => return Ok(None),
            Err(TryRecvError::Closed) => return Err(thread_ended()),
        };
        loss.attempt = None;
        loss.next_attempt = now + interval(now.saturating_duration_since(loss.since));
        let why = match found {
            Ok(identity) => return Ok(Some(identity)),
            Err(UnsafeState { reason, .. }) => reason,
        };
        let last_message = format!("the synchroniser does not answer; searching for it: {why}");
        if last_message != loss.last_message {
            tracing::warn!("{last_message}");
            loss.last_message.clone_from(&last_message);
            self.control.state.lock().held = vec![last_message];
        }
        Ok(None)
    }

    /// The search time limit, if it has passed and no attempt is running.
    fn expired_patience(&self) -> Option<Duration> {
        let loss = self.loss.as_ref().filter(|loss| loss.attempt.is_none())?;
        self.waiting?.patience.filter(|patience| loss.since.elapsed() > *patience)
    }

    fn has_fired_all(&self) -> bool {
        self.settings.shots.is_some_and(|shots| self.fired >= shots.get())
    }

    /// Whether no more frames of the current burst can arrive.
    fn is_burst_over(&self) -> bool {
        let last_sign = self.burst_ends.max(self.last_frame);
        self.pairing.open_triggers() == 0
            || self.time > last_sign + self.settings.patience
            || !self.any_connected()
    }

    /// Closes a burst whose trigger count cannot be queried.
    async fn close_lost_burst(&mut self) -> Result<(), AcquisitionError> {
        if !std::mem::take(&mut self.is_burst_open) {
            return Ok(());
        }
        if self.bursts.is_some() {
            // What was due by then is due now.
            self.advance_time(self.clock.now()).await?;
        }
        if !self.is_burst_accepted {
            // The unit was never asked to fire.
            let given = self.pairing.due_by(Duration::ZERO);
            self.record(Entry::BurstEnded { at_ns: self.at_ns(), given }).await?;
            let decisions = self.pairing.burst_ended(given)?;
            return self.apply(decisions).await;
        }
        let (given, decisions) = self.pairing.burst_lost();
        self.record(Entry::BurstLost { at_ns: self.at_ns(), given }).await?;
        self.apply(decisions).await
    }

    /// Resumes with the unit back and programmed.
    fn resume_with_bench(&mut self) {
        let Some(loss) = self.loss.take() else { return };
        let waits = self.waiting.is_some_and(|waiting| waiting.waits_for_operator);
        if !waits || loss.resume_mode == Mode::Disarmed {
            tracing::warn!(mode = ?loss.resume_mode, "the bench is back: the run continues");
            return self.set_mode(loss.resume_mode);
        }
        let words = format!(
            "the bench was lost and is back, programmed and safe; firing resumes when an operator \
             permits it: kill -USR1 {} on this machine, or arm and start over HTTP",
            std::process::id()
        );
        tracing::warn!("{words}");
        self.set_mode(Mode::Disarmed);
        self.control.state.lock().held = vec![words];
        self.awaits_operator = Some(loss.resume_mode);
    }
}

/// Interval to the next search attempt, for a unit that has been lost this long.
fn interval(away: Duration) -> Duration {
    if away < EARLY_PHASE { EARLY_INTERVAL } else { LATE_INTERVAL }
}
