//! A synchroniser that does not answer any more: nothing is fired without it, and it is looked for.
//!
//! The burst in hand ends in the unit by itself. Cameras are heard until nothing more can come of
//! it; what was due and nobody saw is `not_fired`. The unit that answers again is made safe, read
//! back and programmed from scratch. Then the run waits for an operator, unless its configuration
//! lets it go on by itself.

use std::time::{Duration, Instant};

use tokio::sync::oneshot::{self, error::TryRecvError};

use super::{
    AcquisitionError, Mode,
    burst::TICK,
    controller::Run,
    journal::Entry,
    synchroniser::{Reopen, Unsafe, thread_ended},
};

/// Between looks for a unit that is lost: a plug may just have slipped.
const SOON: Duration = Duration::from_secs(1);
/// The same once it has been away for longer than [`FRESH`].
const LATER: Duration = Duration::from_secs(10);
const FRESH: Duration = Duration::from_secs(60);
/// How often the run loop turns while it waits for nothing but the unit.
const LOOK_ROUND: Duration = Duration::from_millis(100);

/// How a synchroniser that was lost is had again.
pub struct Reconnection {
    /// Opens it.
    pub open: Reopen,
    /// How long it is looked for; without end when absent.
    pub patience: Option<Duration>,
    /// Whether an operator has to say that shots may be taken again.
    pub waits_for_operator: bool,
}

/// What of it the run loop needs.
#[derive(Debug, Clone, Copy)]
pub(super) struct Waiting {
    pub patience: Option<Duration>,
    pub waits_for_operator: bool,
}

/// A unit that is away.
#[derive(Debug)]
pub(super) struct Loss {
    since: Instant,
    /// What the run does once the unit is back.
    pub then: Mode,
    /// What was said of it last.
    told: String,
    next_look: Instant,
    look: Option<oneshot::Receiver<Result<String, Unsafe>>>,
}

impl Run {
    /// Whether the run outlasts this error.
    pub(super) fn may_wait(&self, error: &AcquisitionError) -> bool {
        // A run that is played again does what it did.
        error.is_loss() && (self.waiting.is_some() || self.bursts.is_some())
    }

    /// The unit is lost: waits until it is back, safe and programmed anew. False when the run is
    /// over: it was told to stop, or there is nothing left to fire.
    ///
    /// # Errors
    ///
    /// It has not come back in time, or something else ended the run; a loss when it is lost once
    /// more.
    pub(super) async fn await_bench(
        &mut self,
        error: AcquisitionError,
    ) -> Result<bool, AcquisitionError> {
        if self.bursts.is_some() {
            self.close_lost_burst().await?;
            return self.rule_on_all().await;
        }
        self.note_loss(&error).await?;
        if !self.look_for_the_unit(error).await? {
            return Ok(false);
        }
        self.program().await?;
        self.take_up_with_the_bench();
        Ok(true)
    }

    /// Waits until every trigger is ruled on; false when the run is stopped meanwhile.
    async fn rule_on_all(&mut self) -> Result<bool, AcquisitionError> {
        while self.pairing.open_triggers() > 0 && !self.stop.is_cancelled() {
            self.look_at_the_time().await?;
            self.attend(TICK).await?;
        }
        Ok(!self.stop.is_cancelled())
    }

    async fn note_loss(&mut self, error: &AcquisitionError) -> Result<(), AcquisitionError> {
        // Nothing that was asked of the unit is known to hold.
        (self.is_programmed, self.is_armed, self.broken_off) = (false, false, true);
        self.synchroniser.forget_fault();
        let now = Instant::now();
        let reason = error.to_string();
        if let Some(loss) = &mut self.loss {
            // Lost once more before it was programmed: the next look is not at once.
            loss.next_look = now + interval(loss.since.elapsed());
            return Ok(());
        }
        for camera in &mut self.presence {
            camera.may_have_gone(now);
        }
        let then = self.awaits_operator.take().unwrap_or_else(|| self.mode());
        let told = format!("the synchroniser does not answer and is looked for: {reason}");
        tracing::error!("the bench is lost, nothing is fired. {told}");
        {
            let mut state = self.control.state.lock();
            (state.mode, state.held) = (Mode::Lost, vec![told.clone()]);
        }
        self.loss = Some(Loss { since: now, then, told, next_look: now, look: None });
        self.note(Entry::SynchroniserLost { at_ns: self.at_ns(), reason }).await.map(|_| ())
    }

    /// Looks for the unit, and meanwhile closes the books of the burst in hand.
    async fn look_for_the_unit(
        &mut self,
        error: AcquisitionError,
    ) -> Result<bool, AcquisitionError> {
        let mut identity = None;
        loop {
            self.note_serial().await?;
            self.look_at_the_time().await?;
            if self.is_burst_open && self.is_burst_past() {
                self.close_lost_burst().await?;
            }
            let settled = !self.is_burst_open && self.pairing.open_triggers() == 0;
            if self.stop.is_cancelled() || settled && self.has_nothing_left() {
                return Ok(false);
            }
            if identity.is_none() {
                identity = self.look_once()?;
            }
            if let Some(identity) = identity.take_if(|_| settled) {
                tracing::warn!(identity, "the synchroniser is back and safe");
                self.identity.clone_from(&identity);
                self.note(Entry::SynchroniserBack { at_ns: self.at_ns(), identity }).await?;
                return Ok(true);
            }
            if let Some(patience) = self.ended_patience().filter(|_| identity.is_none()) {
                let (seconds, before) = (patience.as_secs_f64(), Box::new(error));
                return Err(AcquisitionError::BenchGone { seconds, before });
            }
            self.attend(if settled { LOOK_ROUND } else { TICK }).await?;
        }
    }

    /// Begins to look when it is time, or takes what came of it: what the unit says that it is.
    fn look_once(&mut self) -> Result<Option<String>, AcquisitionError> {
        let Some(loss) = &mut self.loss else { return Ok(None) };
        let now = Instant::now();
        let Some(look) = &mut loss.look else {
            if now >= loss.next_look {
                loss.look = Some(self.synchroniser.look_for_it()?);
            }
            return Ok(None);
        };
        let found = match look.try_recv() {
            Ok(found) => found,
            Err(TryRecvError::Empty) => return Ok(None),
            Err(TryRecvError::Closed) => return Err(thread_ended()),
        };
        loss.look = None;
        loss.next_look = now + interval(now.saturating_duration_since(loss.since));
        let why = match found {
            Ok(identity) => return Ok(Some(identity)),
            Err(Unsafe { reason, .. }) => reason,
        };
        let told = format!("the synchroniser does not answer and is looked for: {why}");
        if told != loss.told {
            tracing::warn!("{told}");
            loss.told.clone_from(&told);
            self.control.state.lock().held = vec![told];
        }
        Ok(None)
    }

    /// How long the unit was to be looked for, when that is over and no look is under way.
    fn ended_patience(&self) -> Option<Duration> {
        let loss = self.loss.as_ref().filter(|loss| loss.look.is_none())?;
        self.waiting?.patience.filter(|patience| loss.since.elapsed() > *patience)
    }

    fn has_nothing_left(&self) -> bool {
        self.settings.shots.is_some_and(|shots| self.fired >= shots.get())
    }

    /// Whether no more can come of the burst in hand.
    fn is_burst_past(&self) -> bool {
        let last_sign = self.burst_ends.max(self.last_frame);
        self.pairing.open_triggers() == 0
            || self.time > last_sign + self.settings.patience
            || !self.any_connected()
    }

    /// The unit cannot be asked how many triggers of the burst it gave.
    async fn close_lost_burst(&mut self) -> Result<(), AcquisitionError> {
        if !std::mem::take(&mut self.is_burst_open) {
            return Ok(());
        }
        if self.bursts.is_some() {
            // What was due then is due now.
            self.time_passes(self.clock.now()).await?;
        }
        if !self.is_burst_begun {
            // It was not asked for it at all.
            let given = self.pairing.due_by(Duration::ZERO);
            self.note(Entry::BurstEnded { at_ns: self.at_ns(), given }).await?;
            let rulings = self.pairing.burst_ended(given)?;
            return self.apply(rulings).await;
        }
        let (given, rulings) = self.pairing.burst_lost();
        self.note(Entry::BurstLost { at_ns: self.at_ns(), given }).await?;
        self.apply(rulings).await
    }

    /// The unit is back and programmed.
    fn take_up_with_the_bench(&mut self) {
        let Some(loss) = self.loss.take() else { return };
        let waits = self.waiting.is_some_and(|waiting| waiting.waits_for_operator);
        if !waits || loss.then == Mode::Disarmed {
            tracing::warn!(mode = ?loss.then, "the bench is back: the run goes on");
            return self.set_mode(loss.then);
        }
        let words = format!(
            "the bench was lost and is back, programmed and safe; shots are taken once an operator \
             says so: kill -USR1 {} on this machine, or arm and start over HTTP",
            std::process::id()
        );
        tracing::warn!("{words}");
        self.set_mode(Mode::Disarmed);
        self.control.state.lock().held = vec![words];
        self.awaits_operator = Some(loss.then);
    }
}

/// How long after a look in vain the next one comes, when the unit has been away for so long.
fn interval(away: Duration) -> Duration {
    if away < FRESH { SOON } else { LATER }
}
